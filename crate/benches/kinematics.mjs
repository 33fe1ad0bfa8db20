// node kinematics.mjs MODULE.wasm COUNT: for each of COUNT estimators of relative kinematics the time of one estimate, ms, by
// the same method as kinematics.rs; then what it gives, all digits.
import { readFileSync } from 'node:fs'

const PASSES = 100

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]))
const { kinematics } = instance.exports

for (let name = 0; name < Number(process.argv[3]); name++) {
  // The first builds the record.
  const value = kinematics(name)
  let least = Infinity
  for (let pass = 0; pass < PASSES; pass++) {
    const begin = process.hrtime.bigint()
    kinematics(name)
    least = Math.min(least, Number(process.hrtime.bigint() - begin) / 1e6)
  }
  console.log(least)
  console.log(value)
}
