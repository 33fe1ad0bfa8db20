// node indoor.mjs MODULE.wasm: the time of a run of all inertial filters, ms, by the same method as indoor.rs; then what it
// gives, all digits.
import { readFileSync } from 'node:fs'

const PASSES = 300

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]))
const { indoor } = instance.exports

// The first builds the recording.
const sum = indoor()
let least = Infinity
for (let pass = 0; pass < PASSES; pass++) {
  const begin = process.hrtime.bigint()
  indoor()
  least = Math.min(least, Number(process.hrtime.bigint() - begin) / 1e6)
}
console.log(least)
console.log(sum)
