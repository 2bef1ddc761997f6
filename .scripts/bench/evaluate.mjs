// npm run bench -- evaluate: measures how many vertices per second (positions and normals) a warp moves on the CPU, and how long it takes to
// generate the machine code. Compares four methods: `evaluate` creates new arrays in each call; with its option `out` it writes into the
// caller's arrays; its interpreter is used in engines that forbid compiling; the same function by hand, in JavaScript, also writes into the
// caller's arrays.
import { compileWarp } from '../../dist/warpjet.js'
import { median, time, timesInTurn } from '../lib/median.mjs'
import { rows, warps } from './evaluate/rows.mjs'

/**
 * Loads the library again, and makes it interpret warps: after it has compiled its own module, compiling a module for a warp throws.
 */
async function loadInterpretingLibrary(offset) {
  const library = await import('../../dist/warpjet.min.js')
  const warp = library.compileWarp(offset)
  const evaluateOnce = () => warp.evaluateAt([1, 2, 3], { uniforms: { millis: 0 } })
  evaluateOnce()
  const { Module } = WebAssembly
  WebAssembly.Module = function () {
    throw new WebAssembly.CompileError('forbidden')
  }
  evaluateOnce()
  WebAssembly.Module = Module
  return library
}

export async function measure() {
  const interpreted = await loadInterpretingLibrary(warps.twist.warp)
  console.log(
    'Median speed in millions of vertices per second, and medians of the ratios of times measured in the same round.',
  )
  console.table(rows.map((row) => measureRow(row, interpreted)))
  console.log(
    '\nMilliseconds of the first call, which is interpreted, and of the second, which generates machine code; microseconds of each later call.',
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
  const createArrays = () => ({
    positions: new Float32Array(3 * vertices),
    normals: new Float32Array(3 * vertices),
  })
  const resultsByHand = createArrays()
  const out = createArrays()
  let results
  const methods = {
    evaluate: () => time(() => (results = warp.evaluate(mesh, { uniforms }))),
    'into out': () => time(() => warp.evaluate(mesh, { uniforms, out })),
    interpreter: () => time(() => interpretedWarp.evaluate(mesh, { uniforms })),
    'by hand': () => time(() => byHand(mesh, 1234, resultsByHand)),
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
  const ratio = (a, b) =>
    median(times[a].map((milliseconds, i) => milliseconds / times[b][i])).toFixed(2)
  return {
    warp: name,
    vertices,
    ...Object.fromEntries(speeds),
    'by hand / into out': ratio('by hand', 'into out'),
    'interpreter / into out': ratio('interpreter', 'into out'),
    'largest difference': largestDifference(results, resultsByHand).toExponential(1),
  }
}

/**
 * Returns the shortest times of the first call with a normal, which is interpreted, of the second, which generates the machine code, and of
 * later calls.
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
    const evaluateOnce = () => warp.evaluateAt([1, 2, 3], options)
    // Prepares the evaluation, which is not to be measured.
    warp.evaluateAt([1, 2, 3], { uniforms: options.uniforms })
    keepMin('interpreter, ms', time(evaluateOnce))
    keepMin('machine code, ms', time(evaluateOnce))
    // ms per 500 calls → µs per call
    keepMin('evaluateAt, µs', 2 * time(() => { for (let i = 0; i < 500; i++) evaluateOnce() })) // prettier-ignore
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
function largestDifference(results, resultsByHand) {
  const maxDifference = (name, size) =>
    results[name].reduce(
      (max, x, i) => Math.max(max, Math.abs(resultsByHand[name][i] - x) / size),
      0,
    )
  return Math.max(maxDifference('positions', 100), maxDifference('normals', 1))
}
