// node track.mjs MODULE.wasm: the time of a step of each case, ns, one a line; the same method as track.rs.
import { readFileSync } from 'node:fs'

const BATCH_NS = 50_000
const BATCHES = 1000

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]))
const { cases, start, steps } = instance.exports

function time(count) {
  const begin = process.hrtime.bigint()
  steps(count)
  return Number(process.hrtime.bigint() - begin)
}

for (let index = 0; index < cases(); index++) {
  start(index)
  // The compiler of the browser needs to see a function run before it optimizes it.
  for (let spent = 0; spent < 300e6; ) spent += time(10)
  const count = Math.max(1, Math.round(BATCH_NS / (time(20) / 20)))
  const batches = Array.from({ length: BATCHES }, () => time(count) / count)
  console.log(Math.min(...batches))
}
