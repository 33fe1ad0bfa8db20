// node indoor.mjs MODULE.wasm: the time of a run of all inertial filters, ms; the same method as indoor.rs.
import { readFileSync } from 'node:fs'

const PASSES = 300

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]))
const { indoor } = instance.exports

// The first builds the recording.
indoor()
let least = Infinity
for (let pass = 0; pass < PASSES; pass++) {
  const begin = process.hrtime.bigint()
  indoor()
  least = Math.min(least, Number(process.hrtime.bigint() - begin) / 1e6)
}
console.log(least)
