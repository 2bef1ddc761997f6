// npm run bench -- generate: measures how long it takes to generate the code of warps, for several numbers of builder nodes (calls of
// operations). The warp is p5.warp's "complex" stress test: sines of random coordinates with random constants, added to random components.
import { compile, compileWarp } from '../../dist/warpjet.js'
import { stackedSines } from '../../tests/warps/stress.js'
import { medianTime } from '../lib/median.mjs'

/** The number of builder nodes per sine, counted as in the paper on p5.warp. */
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

/** Maps a number of sines → how many times its generation is measured. */
const sizes = { 30: 300, 300: 100, 600: 60, 6000: 15, 60000: 5 }

export async function measure() {
  console.table(Object.entries(sizes).map(([sines, runs]) => measureSize(Number(sines), runs)))
  for (const [name, [runs, work]] of Object.entries(singleCases))
    console.log(`${name}: ${medianTime(runs, work).toFixed(3)} ms`)
}
