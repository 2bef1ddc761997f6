// npm run bench -- gpu [--size 1200] [--seconds 480] [--software] [--warp NAME …]: times frames with normals at vertices, at pixels, and
// by four evaluations at each pixel, for the warps of the gallery. `pixel` does not fade noise; `faded`, the default, does, and is
// measured if it differs. Without a GPU, or with --software, SwiftShader draws, for which a smaller --size suffices.
import { parseArgs } from 'node:util'
import { compileWarp } from '../../dist/warpjet.js'
import { servePages } from '../../tests/support/browser/server.js'
import { sketchWarps } from '../../tests/warps/sketches.js'
import { threeWarps } from '../../tests/warps/three-sketches.js'
import { Stop, say } from '../lib/terminal.mjs'
import { launchFastest } from './frames/browsers.mjs'
import { shadersOf } from './gpu/shaders.mjs'
import { warps as plainWarps } from './pixels.mjs'

function readOptions(args) {
  const { values } = parseArgs({
    args,
    options: {
      size: { type: 'string', default: '1200' },
      seconds: { type: 'string', default: '480' },
      software: { type: 'boolean', default: false },
      warp: { type: 'string', multiple: true },
    },
  })
  const [size, seconds] = [Number(values.size), Number(values.seconds)]
  if (!(Number.isInteger(size) && size > 0 && size <= 4096))
    throw new Stop(`Expected a whole number up to 4096 for --size, got ${values.size}.`)
  if (!(seconds > 0))
    throw new Stop(`Expected a positive number for --seconds, got ${values.seconds}.`)
  return { size, seconds, software: values.software, names: values.warp }
}

/** Compiles all warps. Returns [{ name, shaders, characters, auto }]. */
async function compileAll(names) {
  const plainEntries = Object.entries(plainWarps).map(([name, source]) => [
    name,
    (0, eval)(source),
    {},
  ])
  const gallery = [...(await sketchWarps()), ...threeWarps()]
  const galleryWarps = gallery
    .filter(({ warp }) => warp)
    .map(({ name, warp, options }) => [name, warp, options?.uniforms])
  const all = [...plainEntries, ...galleryWarps].map(([name, offset, uniforms]) => {
    const options = { perFrame: true, surfaceVariation: true, uniforms }
    const warp = compileWarp(offset, { ...options, normals: 'vertex' })
    const plain = compileWarp(offset, { ...options, normals: false })
    const faded = warp.emitFragment()
    // Differences do not fade either.
    const fragment = compileWarp(offset, { ...options, fadeNoise: false }).emitFragment()
    return {
      name,
      shaders: shadersOf(warp, plain, fragment, faded),
      characters: fragment.code.length + fragment.declarations.length,
      auto: compileWarp(offset, { ...options, normals: 'auto' }).normals,
    }
  })
  // After the plain warps, the gallery's are in order of cost: if time is short, most of them are still measured.
  const first = all.splice(0, plainEntries.length)
  const sorted = [...first, ...all.sort((a, b) => a.characters - b.characters)]
  const unknown = names?.filter((name) => !sorted.some((each) => each.name === name)) ?? []
  if (unknown.length) throw new Stop(`Expected names of warps for --warp, got ${unknown}.`)
  return sorted.filter(({ name }) => !names || names.includes(name))
}

/** Runs in the page, and defines `measureDraw` and `measureWarp`. */
function prepare(size) {
  const canvas = new OffscreenCanvas(size, size)
  const gl = canvas.getContext('webgl2', { antialias: false })
  const cells = 100
  const indices = new Uint32Array(6 * cells * cells)
  for (let i = 0; i < cells * cells; i++) {
    const corner = Math.floor(i / cells) * (cells + 1) + (i % cells)
    indices.set(
      [0, 1, cells + 1, cells + 1, 1, cells + 2].map((step) => corner + step),
      6 * i,
    )
  }
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer())
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW)
  gl.viewport(0, 0, size, size)

  function compile({ vertex, fragment }) {
    const program = gl.createProgram()
    for (const [type, source] of [
      [gl.VERTEX_SHADER, vertex],
      [gl.FRAGMENT_SHADER, fragment],
    ]) {
      const shader = gl.createShader(type)
      gl.shaderSource(shader, source)
      gl.compileShader(shader)
      gl.attachShader(program, shader)
    }
    gl.linkProgram(program)
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      const logs = gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader))
      throw new Error(gl.getProgramInfoLog(program) + logs.join(''))
    }
    return program
  }

  /** Sets all uniforms to 0.7. The cost does not depend on their values. */
  function setUniforms(program) {
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS)
    for (let i = 0; i < count; i++) {
      const { name, type } = gl.getActiveUniform(program, i)
      const location = gl.getUniformLocation(program, name)
      const kinds = { [gl.FLOAT]: 1, [gl.FLOAT_VEC2]: 2, [gl.FLOAT_VEC3]: 3, [gl.FLOAT_VEC4]: 4 }
      if (kinds[type]) gl[`uniform${kinds[type]}fv`](location, Array(kinds[type]).fill(0.7))
    }
  }

  const pixel = new Uint8Array(4)
  const finish = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel)
  const time = (program, count, length = indices.length) => {
    gl.useProgram(program)
    const start = performance.now()
    for (let i = 0; i < count; i++) gl.drawElements(gl.TRIANGLES, length, gl.UNSIGNED_INT, 0)
    finish()
    return (performance.now() - start) / count
  }

  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2')

  /** Returns the share of a batch's time in which the GPU works, by its own clock; `undefined` if the browser has no timer for it. */
  async function measureGpuShare(program, count) {
    if (!timer) return undefined
    const query = gl.createQuery()
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query)
    const total = count * time(program, count)
    gl.endQuery(timer.TIME_ELAPSED_EXT)
    gl.flush()
    for (let i = 0; i < 100; i++) {
      await new Promise((next) => setTimeout(next, 2))
      if (gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE))
        return gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6 / total
    }
    return undefined
  }

  function countPixels() {
    const data = new Uint8Array(4 * size * size)
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, data)
    let count = 0
    for (let i = 3; i < data.length; i += 4) count += data[i] > 0
    return count
  }

  /** A batch of frames takes about this many milliseconds, but has at most `maxCount` frames. */
  const [batchTime, maxCount] = [50, 1000]

  /**
   * Returns how many frames a batch has. Reading a pixel back takes longer than drawing a short frame, so one frame cannot be timed alone.
   */
  function countFrames(program) {
    let count = 1
    for (;;) {
      const total = count * time(program, count)
      if (total >= batchTime / 2 || count === maxCount)
        return Math.min(maxCount, Math.ceil((count * batchTime) / total))
      count = Math.min(maxCount, 4 * count)
    }
  }

  const median = (times) => times.sort((a, b) => a - b)[times.length >> 1]

  /** Returns the milliseconds that a draw takes when the GPU has nothing to do. */
  window.measureDraw = () => {
    const program = compile({
      vertex: '#version 300 es\nvoid main() { gl_Position = vec4(2.0, 2.0, 0.0, 1.0); }',
      fragment:
        '#version 300 es\nprecision highp float;\nout vec4 color_;\nvoid main() { color_ = vec4(1.0); }',
    })
    time(program, 1, 3)
    return median(Array.from({ length: 9 }, () => time(program, maxCount, 3)))
  }

  window.measureWarp = async (shaders, milliseconds) => {
    const end = performance.now() + milliseconds
    const methods = Object.entries(shaders).map(([name, sources]) => {
      gl.clear(gl.COLOR_BUFFER_BIT)
      const start = performance.now()
      const program = compile(sources)
      gl.useProgram(program)
      setUniforms(program)
      time(program, 1)
      const first = performance.now() - start
      if (countPixels() < 0.99 * size * size) throw new Error(`${name} does not cover the picture`)
      return { name, program, first, count: countFrames(program), times: [] }
    })
    let rounds = 0
    do {
      for (const { program, count, times } of methods) times.push(time(program, count))
      rounds++
    } while (rounds < 9 && performance.now() < end)
    const results = {}
    for (const { name, program, first, count, times } of methods) {
      results[name] = {
        first,
        frame: median(times),
        share: await measureGpuShare(program, count),
        rounds,
      }
      gl.deleteProgram(program)
    }
    return results
  }
}

const round = (x) => Number(x.toPrecision(3))

const rowOf = ({ vertex, pixel, faded, differences }, { characters, auto }) => ({
  'ms, vertex': round(vertex.frame),
  'ms, pixel': round(pixel.frame),
  ...(faded && { 'ms, faded': round(faded.frame) }),
  'ms, differences': round(differences.frame),
  'pixel / vertex': round(pixel.frame / vertex.frame),
  'pixel / differences': round(pixel.frame / differences.frame),
  'first, vertex': round(vertex.first),
  'first, pixel': round(pixel.first),
  ...(vertex.share && {
    'GPU, vertex': `${Math.round(100 * vertex.share)} %`,
    'GPU, pixel': `${Math.round(100 * pixel.share)} %`,
  }),
  characters,
  rounds: pixel.rounds,
  auto,
})

export async function measure(args) {
  const { size, seconds, software, names } = readOptions(args)
  const start = performance.now()
  const browser = await launchFastest(software)
  const server = await servePages()
  const page = await browser.newPage()
  await page.goto(server.page('<!doctype html>'))
  await page.evaluate(prepare, size)
  const idle = await page.evaluate(() => measureDraw())

  const all = await compileAll(names)
  const rows = {}
  for (const [i, warp] of all.entries()) {
    const remaining = 1000 * seconds - (performance.now() - start)
    if (remaining < 0) break
    const budget = remaining / (all.length - i)
    const results = await page.evaluate(
      ([shaders, ms]) => measureWarp(shaders, ms),
      [warp.shaders, budget],
    )
    rows[warp.name] = rowOf(results, warp)
    process.stderr.write(`${i + 1}/${all.length} ${warp.name}\n`)
  }
  await browser.close()
  await server.close()
  say(`A draw of one triangle outside of the picture takes ${round(idle)} ms.`)
  say(`A sheet of 20,000 triangles that covers ${size} × ${size} pixels; medians, in turn:`)
  console.table(rows)
  const skipped = all.slice(Object.keys(rows).length).map(({ name }) => name)
  if (skipped.length) say(`Not measured, since ${seconds} s were over: ${skipped.join(', ')}.`)
}
