// npm run bench:evaluate: how many vertices a second a warp moves on the CPU, positions and normals, by warp.evaluate, by the
// interpreter that it has where an engine compiles nothing, by the same function written by hand in JavaScript, and by the same
// C++ compiled natively with -O3; and how long making the machine code takes. The last two write into arrays that are there, as
// `evaluate` does with its option `out`; without it, it makes new ones at each call.
import { spawnSync } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { performance } from 'node:perf_hooks'
import { build } from './build.mjs'
import { cmakeBuild } from './lib/cmake.mjs'
import { path } from './lib/files.mjs'
import { median } from './lib/median.mjs'
import { main } from './lib/terminal.mjs'

/** The library once more, where the engine compiles nothing after what the library itself consists of. */
async function interpretedLibrary(offset) {
  const library = await import('../dist/warpjet.min.js')
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

await main(async () => {
  await build()
  await cmakeBuild('release', 'warpjet_bench_evaluate')
  const { compileWarp } = await import('../dist/warpjet.js')
  const { rows, warps } = await import('./bench/evaluate-rows.mjs')
  const interpreted = await interpretedLibrary(warps.twist.warp)

  console.log('Millions of vertices a second, positions and normals; medians of rounds in turn.\n')
  console.log(
    'warp               vertices   evaluate   into out  interpreter    by hand     native   into out / by hand   native / into out   native / evaluate   native / interpreter   largest difference',
  )
  for (const { name, vertices, rounds } of rows) {
    const { warp: offset, byHand } = warps[name]
    const warp = compileWarp(offset)
    const plain = interpreted.compileWarp(offset)
    const mesh = randomMesh(vertices)
    const uniforms = { millis: 1234 }
    const arrays = () => ({
      positions: new Float32Array(3 * vertices),
      normals: new Float32Array(3 * vertices),
    })
    const results = arrays()
    const out = arrays()
    const native = nativeRunner(warp, mesh, 1234)

    const times = { evaluate: [], into: [], interpreter: [], byHand: [], native: [] }
    const warmUps = vertices > 100_000 ? 2 : 20 // until the engine has taken its best compiler
    let moved
    for (let round = -warmUps; round < rounds; round++) {
      const evaluate = seconds(() => (moved = warp.evaluate(mesh, { uniforms })))
      const into = seconds(() => warp.evaluate(mesh, { uniforms, out }))
      if (round < -1) continue
      const interpreter = seconds(() => plain.evaluate(mesh, { uniforms }))
      const hand = seconds(() => byHand(mesh, 1234, results))
      const compiled = native.seconds()
      if (round < 0) continue
      times.evaluate.push(evaluate)
      times.into.push(into)
      times.interpreter.push(interpreter)
      times.byHand.push(hand)
      times.native.push(compiled)
    }
    native.end()
    const ratio = (a, b) => median(times[a].map((time, i) => time / times[b][i])).toFixed(2)
    const speed = (method) => (vertices / median(times[method]) / 1e6).toFixed(2).padStart(11)
    console.log(
      name.padEnd(16),
      vertices.toLocaleString('en').padStart(10),
      speed('evaluate'),
      speed('into'),
      speed('interpreter').padStart(12),
      speed('byHand'),
      speed('native'),
      ratio('byHand', 'into').padStart(20),
      ratio('into', 'native').padStart(19),
      ratio('evaluate', 'native').padStart(19),
      ratio('interpreter', 'native').padStart(22),
      largestDifference(moved, results).toExponential(1).padStart(20),
    )
  }

  console.log(
    '\nMilliseconds until the first vertex is moved, and microseconds of one more by evaluateAt.\n',
  )
  console.log('warp               machine code   interpreter   evaluateAt')
  for (const [name, { warp: offset }] of Object.entries(warps))
    console.log(name.padEnd(18), ...startUp(compileWarp, offset))
})

/** By machine code, which the second call makes, and by the interpreter, which the first has; the shortest of some. */
function startUp(compileWarp, offset) {
  const at = { normal: [0, 1, 0], uniforms: { millis: 1234 } }
  const best = { interpreter: Infinity, code: Infinity, next: Infinity }
  const keep = (name, work) => (best[name] = Math.min(best[name], 1000 * seconds(work)))
  for (let round = 0; round < 15; round++) {
    const warp = compileWarp(offset)
    const once = () => warp.evaluateAt([1, 2, 3], at)
    // What depends on the inputs is found before.
    warp.evaluateAt([1, 2, 3], { uniforms: at.uniforms })
    keep('interpreter', once)
    keep('code', once)
    const many = 500
    keep('next', () => {
      for (let i = 0; i < many; i++) once()
    })
    best.many = many
  }
  return [
    best.code.toFixed(2).padStart(12),
    best.interpreter.toFixed(2).padStart(13),
    ((1000 * best.next) / best.many).toFixed(1).padStart(12),
  ]
}

function seconds(work) {
  const start = performance.now()
  work()
  return (performance.now() - start) / 1000
}

/** Vertices on a sphere of radius 100, whose normals point outwards. */
function randomMesh(vertices) {
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

/** Relative to the size of the mesh, positions and normals. */
function largestDifference(moved, results) {
  let largest = 0
  for (const [name, size] of [
    ['positions', 100],
    ['normals', 1],
  ])
    for (let i = 0; i < results[name].length; i++)
      largest = Math.max(largest, Math.abs(moved[name][i] - results[name][i]) / size)
  return largest
}

/** The program and the mesh in a file; each run of the native program times one pass over the mesh. */
function nativeRunner(warp, { positions, normals }, millis) {
  const program = warp[Symbol.for('warpjet.program')].program()
  const folder = mkdtempSync(join(tmpdir(), 'warpjet-'))
  const file = join(folder, 'program')
  const sizes = program.inputs.map(({ shape: [columns, rows] }) => columns * rows)
  const header = new Uint32Array([
    program.words.length,
    program.instructions,
    sizes.length,
    program.inputs.findIndex((input) => input.name === 'millis'),
    ...sizes,
  ])
  const time = new Float32Array([millis])
  const parts = [
    header,
    program.words,
    new Uint32Array([positions.length / 3]),
    positions,
    normals,
    time,
  ]
  writeFileSync(file, Buffer.concat(parts.map((part) => Buffer.from(part.buffer))))
  return {
    seconds() {
      const { stdout, status, stderr } = spawnSync(path('.build/release/warpjet_bench_evaluate'), [
        file,
      ])
      if (status !== 0) throw new Error(`${stderr}`)
      return Number(stdout)
    },
    end: () => rmSync(folder, { recursive: true }),
  }
}
