// npm run bench -- generate: measures how long a warp takes to generate, for several numbers of builder nodes, and how long the first
// warp waits for warpjet to load. The input is p5.warp's "complex" stress test: sines of random coordinates with random constants, added
// to random components.
import { compile, compileWarp } from '../../dist/warpjet.js'
import { stackedSines } from '../../tests/warps/stress.js'
import { median, medianTime, time, timesInTurn } from '../lib/median.mjs'
import { plainGraph, sineWarp } from './generate/plain-graph.mjs'
import { measureStartUp } from './generate/start-up.mjs'

/** The number of builder nodes per sine, counted as in the paper. */
const nodesPerSine = 5

function measureSize(sines, runs) {
  const { warp } = stackedSines(sines)
  const { code } = compileWarp(warp)
  const nodes = nodesPerSine * sines
  const median = medianTime(runs, () => compileWarp(warp))
  return {
    'builder nodes': nodes,
    'median ms': Number(median.toFixed(2)),
    'ns per node': Math.round((median * 1e6) / nodes),
    characters: code.length,
    sin: code.match(/\bsin\(/g).length,
    cos: code.match(/\bcos\(/g).length,
  }
}

function compareSize(sines, runs) {
  const methods = {
    warpjet: () => time(() => compileWarp(sineWarp(sines))),
    plain: () => time(() => plainGraph(sines)),
  }
  const { warpjet, plain } = timesInTurn(methods, runs, 12)
  return {
    'builder nodes': 3 * nodesPerSine * sines + 6,
    'warpjet ms': Number(median(warpjet).toFixed(2)),
    'plain ms': Number(median(plain).toFixed(2)),
    ratio: Number((median(warpjet) / median(plain)).toFixed(2)),
  }
}

/** Returns a function that applies `step` to x `count` times, and differentiates the result. */
const repeat = (count, step) => (glsl) => {
  let v = glsl.param('x')
  for (let i = 0; i < count; i++) v = step(v)
  return { v, slope: glsl.derivative(v, glsl.param('x')) }
}
const oneSine = ({ glsl, position, millis }) => glsl.vec3(position.y.add(millis).sin(), 0, 0)

const singleCases = {
  'a warp of one sine': [3000, () => compileWarp(oneSine)],
  'v = v * v + v, 40 times': [5, () => compile(repeat(40, (v) => v.mult(v).add(v)))],
  'a chain of 100,000 sines': [5, () => compile(repeat(100_000, (v) => v.sin()))],
}

/** Prints a row per size. `runs` maps a number of sines → how many times it is measured. */
const printSizes = (measureRow, runs) =>
  console.table(Object.entries(runs).map(([sines, count]) => measureRow(Number(sines), count)))

export async function measure() {
  printSizes(measureSize, { 30: 300, 300: 100, 600: 60, 6000: 15, 60000: 5 })
  console.log(
    '\nIn turn with a plain graph in JavaScript (.scripts/bench/generate/plain-graph.mjs)',
  )
  printSizes(compareSize, { 10: 200, 100: 100, 200: 60, 2000: 15 })
  for (const [name, [runs, work]] of Object.entries(singleCases))
    console.log(`${name}: ${medianTime(runs, work).toFixed(3)} ms`)
  console.log('\nStart-up, medians in ms')
  console.table(await measureStartUp())
}
