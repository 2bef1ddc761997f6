// npm run bench:generate: measures how long a warp takes to generate, for several numbers of builder nodes, and how long
// the first warp waits for warpjet to load. The input is p5.warp's "complex" stress test: sines of random coordinates with
// random constants, added to random components.
import { performance } from 'node:perf_hooks'
import { plainGraph, stackedSines as stackOfThree } from './bench/plain-graph.mjs'
import { measureStartUp } from './bench/start-up.mjs'
import { build } from './build.mjs'
import { median } from './lib/median.mjs'

await build()
const { compileWarp, compile } = await import('../dist/warpjet.js')
const { stackedSines } = await import('../tests/warps/stress.js')

/** The number of builder nodes per sine, counted as in the paper. */
const NODES_OF_A_SINE = 5
const WARM_UP = 12

function medianMilliseconds(work, runs) {
  work()
  const times = Array.from({ length: runs }, () => {
    const start = performance.now()
    work()
    return performance.now() - start
  })
  return median(times)
}

/** Returns the median time of each function in `works`. They run in turn, so that other load on the machine slows all of them alike. */
function mediansInTurn(works, runs) {
  const times = Object.fromEntries(Object.keys(works).map((name) => [name, []]))
  for (let i = -WARM_UP; i < runs; i++)
    for (const [name, work] of Object.entries(works)) {
      const start = performance.now()
      work()
      if (i >= 0) times[name].push(performance.now() - start)
    }
  return Object.fromEntries(Object.entries(times).map(([name, all]) => [name, median(all)]))
}

function square(repeats) {
  return (glsl) => {
    let v = glsl.param('x')
    for (let i = 0; i < repeats; i++) v = v.mult(v).add(v)
    return { v, slope: glsl.derivative(v, glsl.param('x')) }
  }
}

function sineChain(length) {
  return (glsl) => {
    let v = glsl.param('x')
    for (let i = 0; i < length; i++) v = v.sin()
    return { v, slope: glsl.derivative(v, glsl.param('x')) }
  }
}

console.log('builder nodes   median ms   ns per node   characters    sin    cos')
for (const [sines, runs] of [
  [30, 300],
  [300, 100],
  [600, 60],
  [6000, 15],
  [60000, 5],
]) {
  const { warp } = stackedSines(sines)
  const { code } = compileWarp(warp)
  const count = (pattern) => String(code.match(pattern)?.length ?? 0).padStart(7)
  const time = medianMilliseconds(() => compileWarp(warp), runs)
  console.log(
    String(NODES_OF_A_SINE * sines).padStart(13),
    time.toFixed(2).padStart(11),
    ((time * 1e6) / (NODES_OF_A_SINE * sines)).toFixed(0).padStart(13),
    String(code.length).padStart(12),
    count(/\bsin\(/g),
    count(/\bcos\(/g),
  )
}

console.log('\nin turn with a plain graph in JavaScript (.scripts/bench/plain-graph.mjs)')
console.log('builder nodes  warpjet ms    plain ms    ratio')
for (const [sines, runs] of [
  [10, 200],
  [100, 100],
  [200, 60],
  [2000, 15],
]) {
  const { ours, plain } = mediansInTurn(
    { ours: () => compileWarp(stackOfThree(sines)), plain: () => plainGraph(sines) },
    runs,
  )
  console.log(
    String(3 * NODES_OF_A_SINE * sines + 6).padStart(13),
    ours.toFixed(2).padStart(11),
    plain.toFixed(2).padStart(11),
    (ours / plain).toFixed(2).padStart(8),
  )
}

const oneSine = ({ glsl, position, millis }) => glsl.vec3(position.y.add(millis).sin(), 0, 0)
console.log(
  '\na warp of one sine:',
  medianMilliseconds(() => compileWarp(oneSine), 3000).toFixed(3),
  'ms',
)
const report = (name, callback) =>
  console.log(name, medianMilliseconds(() => compile(callback), 5).toFixed(2), 'ms')
report('v = v * v + v, 40 times:', square(40))
report('a chain of 100,000 sines:', sineChain(100_000))

console.log('\nstart-up, median ms of 15')
for (const { where, stages } of await measureStartUp()) {
  console.log(where)
  for (const [stage, time] of Object.entries(stages))
    console.log(`  ${stage.padEnd(16)} ${time.toFixed(1).padStart(6)}`)
}
