// node field.mjs MODULE.wasm: the time of a field, raw, projected and of one more anchor, ms, one a line; the same method as field.rs.
import { readFileSync } from 'node:fs'

const PASSES = 60

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]))
const { field } = instance.exports

for (const which of [0, 1, 2]) {
  let least = Infinity
  for (let pass = 0; pass < PASSES; pass++) {
    const begin = process.hrtime.bigint()
    field(which)
    least = Math.min(least, Number(process.hrtime.bigint() - begin) / 1e6)
  }
  console.log(least)
}
