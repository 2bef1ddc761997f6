// npm run bench -- evaluate: measures how many vertices per second (positions and normals) a warp moves on the CPU: with warp.evaluate,
// with its interpreter (for engines that forbid compiling), and with the same function written by hand in JavaScript; and how long
// generating the machine code takes. The function by hand writes into arrays of the caller, as `evaluate` does with its option `out`;
// without it, `evaluate` creates new arrays in each call.
import { compileWarp } from '../../dist/warpjet.js'
import { median, time, timesInTurn } from '../lib/median.mjs'
import { rows, warps } from './evaluate/rows.mjs'

/** Loads the library once more and makes it interpret warps: after its own module, compiling another one throws. */
async function interpretedLibrary(offset) {
  const library = await import('../../dist/warpjet.min.js')
  const warp = library.compileWarp(offset)
  const once = () => warp.evaluateAt([1, 2, 3], { uniforms: { millis: 0 } })
  once()
  const { Module } = WebAssembly
  WebAssembly.Module = function () {
    throw new WebAssembly.CompileError('forbidden')
  }
  once()
  WebAssembly.Module = Module
  return library
}

export async function measure() {
  const interpreted = await interpretedLibrary(warps.twist.warp)
  console.log('Millions of vertices a second, and median ratios of neighbours.')
  console.table(rows.map((row) => measureRow(row, interpreted)))
  console.log(
    '\nMilliseconds until the first vertex is moved, and microseconds for each further one.',
  )
  console.table(
    Object.fromEntries(
      Object.entries(warps).map(([name, { warp }]) => [name, measureStartUp(warp)]),
    ),
  )
}

/** Times all methods in turn, so that other load on the machine slows all of them alike. */
function measureRow({ name, vertices, rounds }, interpreted) {
  const { warp: offset, byHand } = warps[name]
  const warp = compileWarp(offset)
  const interpretedWarp = interpreted.compileWarp(offset)
  const mesh = createSphere(vertices)
  const uniforms = { millis: 1234 }
  const arrays = () => ({
    positions: new Float32Array(3 * vertices),
    normals: new Float32Array(3 * vertices),
  })
  const results = arrays()
  const out = arrays()
  let moved
  const methods = {
    evaluate: () => time(() => (moved = warp.evaluate(mesh, { uniforms }))),
    'into out': () => time(() => warp.evaluate(mesh, { uniforms, out })),
    interpreter: () => time(() => interpretedWarp.evaluate(mesh, { uniforms })),
    'by hand': () => time(() => byHand(mesh, 1234, results)),
  }
  // Warms up until the engine has used its optimizing compiler.
  for (let i = vertices > 100_000 ? 2 : 20; i > 0; i--) {
    methods.evaluate()
    methods['into out']()
  }
  const times = timesInTurn(methods, rounds)
  const speeds = Object.entries(times).map(([method, milliseconds]) => [
    method,
    (vertices / median(milliseconds) / 1000).toFixed(2),
  ])
  const ratio = (a, b) => median(times[a].map((took, i) => took / times[b][i])).toFixed(2)
  return {
    warp: name,
    vertices,
    ...Object.fromEntries(speeds),
    'by hand / into out': ratio('by hand', 'into out'),
    'interpreter / into out': ratio('interpreter', 'into out'),
    'largest difference': largestDifference(moved, results).toExponential(1),
  }
}

/**
 * Returns the shortest times of the first call, which is interpreted, of the second, which generates the machine code, and of later calls.
 */
function measureStartUp(offset) {
  const options = { normal: [0, 1, 0], uniforms: { millis: 1234 } }
  const best = {
    'machine code, ms': Infinity,
    'interpreter, ms': Infinity,
    'evaluateAt, µs': Infinity,
  }
  const keepMin = (name, value) => (best[name] = Math.min(best[name], value))
  for (let round = 0; round < 15; round++) {
    const warp = compileWarp(offset)
    const once = () => warp.evaluateAt([1, 2, 3], options)
    // Prepares the evaluation, so that the loop does not time it.
    warp.evaluateAt([1, 2, 3], { uniforms: options.uniforms })
    keepMin('interpreter, ms', time(once))
    keepMin('machine code, ms', time(once))
    keepMin('evaluateAt, µs', 2 * time(() => { for (let i = 0; i < 500; i++) once() })) // prettier-ignore
  }
  return best
}

/** Returns vertices on a spiral around a sphere of radius 100, with normals that point outwards. */
function createSphere(vertices) {
  const positions = new Float32Array(3 * vertices)
  const normals = new Float32Array(3 * vertices)
  for (let i = 0; i < vertices; i++) {
    const z = 1 - (2 * (i + 0.5)) / vertices
    const angle = i * 2.399963229728653
    const r = Math.sqrt(1 - z * z)
    normals.set([r * Math.cos(angle), r * Math.sin(angle), z], 3 * i)
    for (let k = 0; k < 3; k++) positions[3 * i + k] = 100 * normals[3 * i + k]
  }
  return { positions, normals }
}

/** Returns the largest difference of positions and normals, relative to the size of the mesh. */
function largestDifference(moved, results) {
  const maxDifference = (name, size) =>
    results[name].reduce((max, x, i) => Math.max(max, Math.abs(moved[name][i] - x) / size), 0)
  return Math.max(maxDifference('positions', 100), maxDifference('normals', 1))
}
