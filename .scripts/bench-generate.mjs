// npm run bench:generate: how long a warp takes to generate, by the number of builder nodes. The work is p5.warp's
// "complex" stress test: sums of sines of one coordinate with random constants, one warp of three such sums.
import { performance } from 'node:perf_hooks'
import { build } from './build.mjs'

await build()
const { compileWarp, compile } = await import('../dist/warpjet.js')

/** Five operations a sine, three sines a round; the last three divide. */
const nodesOf = (rounds) => rounds * 15 + 6

function stackedSines(rounds, seed = 1) {
  const random = (low, high) => {
    seed = (seed * 16807) % 2147483647
    return low + (seed / 2147483647) * (high - low)
  }
  return ({ glsl, millis, position }) => {
    const inputs = [position.x(), position.y(), position.z()]
    const offsets = [0, 1, 2].map(() => glsl.val(0))
    for (let i = 0; i < rounds; i++)
      for (let axis = 0; axis < 3; axis++)
        offsets[axis] = offsets[axis].add(
          inputs[Math.floor(random(0, 3))]
            .mult(random(0.0001, 0.001))
            .add(millis.mult(random(0.0001, 0.01)))
            .sin()
            .mult(random(1, 500)),
        )
    return glsl.vec3(...offsets.map((offset) => offset.div(rounds)))
  }
}

function medianMilliseconds(work, runs) {
  work()
  const times = Array.from({ length: runs }, () => {
    const start = performance.now()
    work()
    return performance.now() - start
  })
  return times.sort((a, b) => a - b)[runs >> 1]
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
for (const [rounds, runs] of [
  [10, 300],
  [100, 100],
  [200, 60],
  [2000, 15],
  [20000, 5],
]) {
  const offset = stackedSines(rounds)
  const { code } = compileWarp(offset)
  const count = (pattern) => String(code.match(pattern)?.length ?? 0).padStart(7)
  const time = medianMilliseconds(() => compileWarp(offset), runs)
  console.log(
    String(nodesOf(rounds)).padStart(13),
    time.toFixed(2).padStart(11),
    ((time * 1e6) / nodesOf(rounds)).toFixed(0).padStart(13),
    String(code.length).padStart(12),
    count(/\bsin\(/g),
    count(/\bcos\(/g),
  )
}
const report = (name, callback) =>
  console.log(name, medianMilliseconds(() => compile(callback), 5).toFixed(2), 'ms')
report('v = v * v + v, 40 times:', square(40))
report('a chain of 100,000 sines:', sineChain(100_000))
