// npm run bench -- gpu [--size 1200] [--seconds 480] [--software] [--warp NAME …]: times frames of the gallery's warps with four methods:
// - `vertex`: exact normals at vertices;
// - `pixel`: exact normals at pixels, where noise does not fade;
// - `faded`: exact normals at pixels with the option fadeNoise, the default, if its code is different;
// - `differences`: normals at pixels by central differences, which evaluate the offset four times.
// Without a GPU, or with --software, SwiftShader draws, for which a smaller --size suffices.
import { compileWarp } from '../../dist/warpjet.js'
import { servePages } from '../../tests/support/browser/server.js'
import { sketchWarps } from '../../tests/warps/sketches.js'
import { threeWarps } from '../../tests/warps/three-sketches.js'
import { parseOptions } from '../lib/options.mjs'
import { openShaderPage } from '../lib/shader-page.mjs'
import { Stop, say } from '../lib/terminal.mjs'
import { launchFastest } from './frames/browsers.mjs'
import { createShaders } from './gpu/shaders.mjs'

/** Offset functions of a sphere of radius 1. */
const plainWarps = {
  twist: ({ glsl, position: p }) => glsl.rotateY(p.y().mult(1.5)).mult(p).sub(p),
  wave: ({ glsl, position: p }) => glsl.vec3(p.y().mult(7).sin().mult(0.05), 0, 0),
  'three sines': ({ glsl, position: p }) =>
    glsl.vec3(p.y().mult(7).sin(), p.z().mult(7).sin(), p.x().mult(7).sin()).mult(0.05),
  simplex: ({ glsl, position: p }) => p.mult(glsl.simplex(p.mult(2)).mult(0.2)),
  worley: ({ glsl, position: p }) => p.mult(glsl.worley(p.mult(2)).x().mult(0.2)),
  fbm: ({ glsl, position: p }) => p.mult(glsl.fbm(p.mult(2)).mult(0.3)),
  'fbm of fbm': ({ glsl, position: p }) => p.mult(glsl.fbm(p.add(glsl.fbm(p.mult(2)))).mult(0.3)),
}

/**
 * Compiles all warps. Returns [{ name, shaders, characters, auto }]. `characters` is the length of the fragment code, `auto` the stage that
 * `normals: 'auto'` selects.
 */
async function compileAll(names) {
  const gallery = [...(await sketchWarps()), ...threeWarps()]
  const galleryWarps = gallery
    .filter(({ warp }) => warp)
    .map(({ name, warp, options }) => [name, warp, options?.uniforms])
  const all = [...Object.entries(plainWarps), ...galleryWarps].map(([name, offset, uniforms]) => {
    const options = { perFrame: true, surfaceVariation: true, uniforms }
    const warp = compileWarp(offset, { ...options, normals: 'vertex' })
    const plain = compileWarp(offset, { ...options, normals: false })
    const faded = warp.emitFragment()
    // Differences do not fade noise, so they are compared with this code.
    const fragment = compileWarp(offset, { ...options, fadeNoise: false }).emitFragment()
    return {
      name,
      shaders: createShaders(warp, plain, fragment, faded),
      characters: fragment.code.length + fragment.declarations.length,
      auto: compileWarp(offset, { ...options, normals: 'auto' }).normals,
    }
  })
  // The warps of the gallery follow the plain ones, in order of cost, so that a run that ends early has measured most of them.
  const plainOnes = all.splice(0, Object.keys(plainWarps).length)
  const sorted = [...plainOnes, ...all.sort((a, b) => a.characters - b.characters)]
  const unknown = names?.filter((name) => !sorted.some((each) => each.name === name)) ?? []
  if (unknown.length) throw new Stop(`Expected names of warps for --warp, got ${unknown}.`)
  return sorted.filter(({ name }) => !names || names.includes(name))
}

/** Runs in the page: creates the scene, and defines `measureWarp`. */
function preparePage(size) {
  const scene = new Scene(document.createElement('canvas'), size)
  const { gl } = scene
  gl.disable(gl.DEPTH_TEST)
  const cells = 100
  const indices = new Uint32Array(6 * cells * cells)
  for (let i = 0; i < cells * cells; i++) {
    const corner = Math.floor(i / cells) * (cells + 1) + (i % cells)
    indices.set(
      [0, 1, cells + 1, cells + 1, 1, cells + 2].map((step) => corner + step),
      6 * i,
    )
  }
  // The shaders compute the positions from the index of the vertex.
  const unreadValues = new Float32Array(3 * (cells + 1) ** 2)
  scene.load({ positions: unreadValues, normals: unreadValues, indices })

  /** Sets all uniforms to 0.7. The cost does not depend on their values. */
  function setUniforms(program) {
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS)
    for (let i = 0; i < count; i++) {
      const { name, type } = gl.getActiveUniform(program, i)
      const location = gl.getUniformLocation(program, name)
      const sizes = { [gl.FLOAT]: 1, [gl.FLOAT_VEC2]: 2, [gl.FLOAT_VEC3]: 3, [gl.FLOAT_VEC4]: 4 }
      if (sizes[type]) gl[`uniform${sizes[type]}fv`](location, Array(sizes[type]).fill(0.7))
    }
  }

  /** Draws `count` frames, and returns the milliseconds per frame. */
  const time = (program, count) => {
    gl.useProgram(program)
    const start = performance.now()
    for (let i = 0; i < count; i++) gl.drawElements(gl.TRIANGLES, scene.count, gl.UNSIGNED_INT, 0)
    scene.finish()
    return (performance.now() - start) / count
  }

  /** Returns the number of pixels that are drawn. */
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
   * Returns how many frames a batch has. One frame cannot be timed alone, because the pixel that is read back to wait for the GPU may take
   * longer than the frame.
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

  /**
   * Maps each method → { first, frame, rounds }: the milliseconds until the first frame is drawn, the median milliseconds of a frame, and the
   * number of rounds.
   */
  window.measureWarp = (shaders, milliseconds) => {
    const end = performance.now() + milliseconds
    const methods = Object.entries(shaders).map(([name, sources]) => {
      gl.clearColor(0, 0, 0, 0)
      gl.clear(gl.COLOR_BUFFER_BIT)
      const start = performance.now()
      const program = scene.program(sources.vertex, sources.fragment)
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
    for (const { program } of methods) gl.deleteProgram(program)
    return Object.fromEntries(
      methods.map(({ name, first, times }) => [name, { first, frame: quantile(times), rounds }]),
    )
  }
}

const round = (x) => Number(x.toPrecision(3))

const createRow = ({ vertex, pixel, faded, differences }, { characters, auto }) => ({
  'ms, vertex': round(vertex.frame),
  'ms, pixel': round(pixel.frame),
  ...(faded && { 'ms, faded': round(faded.frame) }),
  'ms, differences': round(differences.frame),
  'pixel / vertex': round(pixel.frame / vertex.frame),
  'pixel / differences': round(pixel.frame / differences.frame),
  'first, vertex': round(vertex.first),
  'first, pixel': round(pixel.first),
  characters,
  rounds: pixel.rounds,
  auto,
})

export async function measure(args) {
  const options = { software: { type: 'boolean' }, warp: { type: 'string', multiple: true } }
  const {
    size,
    seconds,
    software,
    warp: names,
  } = parseOptions(args, { size: 1200, seconds: 480 }, options)
  const start = performance.now()
  const browser = await launchFastest(software)
  const server = await servePages()
  const page = await openShaderPage(browser, server)
  await page.evaluate(preparePage, size)
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
    rows[warp.name] = createRow(results, warp)
    process.stderr.write(`${i + 1}/${all.length} ${warp.name}\n`)
  }
  await browser.close()
  await server.close()
  say(
    `A sheet of 20,000 triangles that covers ${size} × ${size} pixels; medians of methods that were measured in turn:`,
  )
  console.table(rows)
  const skipped = all.slice(Object.keys(rows).length).map(({ name }) => name)
  if (skipped.length) say(`Not measured within ${seconds} s: ${skipped.join(', ')}.`)
}
