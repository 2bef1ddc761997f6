// Runs vertex shaders on a browser's WebGL pipeline, and reads their results by transform feedback.
import { serveBytes } from './bytes.js'
import { layout, stride } from './dense-mesh.js'

const uniformTypes = { millis: 'float', mouse: 'vec2', size: 'vec2', pixelDensity: 'float' }

/** Returns a vertex shader with the code of a compiled warp. Its outputs are `movedPosition` and `movedNormal`. */
export function vertexShader({ code, declarations }, target, params = {}) {
  const isES3 = target === 'glsl300'
  const paramTypes = Object.entries(params).map(([name, value]) => [
    name,
    typeName([value].flat().length),
  ])
  const declare = (qualifier, [name, type]) => `${qualifier} ${type} ${name};`
  return [
    `#version ${isES3 ? '300 es' : '100'}`,
    'precision highp float;',
    ...Object.entries(layout).map(([name, size]) =>
      declare(isES3 ? 'in' : 'attribute', [name, typeName(size)]),
    ),
    ...[...Object.entries(uniformTypes), ...paramTypes].map((entry) => declare('uniform', entry)),
    `${isES3 ? 'out' : 'varying'} vec3 movedPosition, movedNormal;`,
    declarations,
    'void main() {',
    code,
    'movedPosition = warpedPosition;',
    'movedNormal = warpedNormal;',
    'gl_Position = vec4(0.0);',
    '}',
  ].join('\n')
}

const typeName = (size) => (size === 1 ? 'float' : `vec${size}`)

/**
 * Opens a page with a context of WebGL. Returns { link, load, run, close }. With WebGL 1, which has no transform feedback, only `link` and
 * `close` work.
 */
export async function openPipeline(browser, contextName = 'webgl2') {
  const server = await serveBytes()
  const page = await browser.newPage()
  // This happens also when the browser closes.
  page.once('close', () => server.close())
  await page.goto(server.url)
  await page.evaluate(prepare, { contextName, layout, stride })
  const link = (source) => page.evaluate((source) => void pipeline.link(source), source)

  async function load(mesh) {
    server.give(new Uint8Array(mesh.buffer, mesh.byteOffset, mesh.byteLength))
    await page.evaluate(() => pipeline.load())
  }

  /** Draws once for each set of uniforms. Returns a list with a Float32Array for each set, with six numbers per vertex. */
  async function run(source, draws) {
    await page.evaluate(([source, draws]) => pipeline.run(source, draws), [source, draws])
    const numbers = new Float32Array(server.take())
    const length = numbers.length / draws.length
    return draws.map((_, i) => numbers.subarray(i * length, (i + 1) * length))
  }

  return { link, load, run, close: () => page.close() }
}

/** Defines `window.pipeline`; runs in the page. */
function prepare({ contextName, layout, stride }) {
  const gl = document.createElement('canvas').getContext(contextName)
  let vertexCount
  // Caches the last two programs, since compiling takes long: many meshes use the same two, with and without an accurate sine.
  const programs = new Map()

  function getProgram(source) {
    const program = programs.get(source) ?? link(source)
    programs.delete(source)
    programs.set(source, program)
    if (programs.size > 2) {
      const [oldest] = programs.keys()
      gl.deleteProgram(programs.get(oldest))
      programs.delete(oldest)
    }
    return program
  }

  function compile(type, source) {
    const shader = gl.createShader(type)
    gl.shaderSource(shader, source)
    gl.compileShader(shader)
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
      throw new Error(`${gl.getShaderInfoLog(shader)}\n${source}`)
    return shader
  }

  function link(source) {
    const version = source.split('\n', 1)[0]
    const program = gl.createProgram()
    gl.attachShader(program, compile(gl.VERTEX_SHADER, source))
    gl.attachShader(program, compile(gl.FRAGMENT_SHADER, `${version}\nvoid main() {}`))
    if (contextName === 'webgl2')
      gl.transformFeedbackVaryings(
        program,
        ['movedPosition', 'movedNormal'],
        gl.INTERLEAVED_ATTRIBS,
      )
    gl.linkProgram(program)
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(`${gl.getProgramInfoLog(program)}\n${source}`)
    return program
  }

  const [meshBuffer, resultBuffer] = [gl.createBuffer(), gl.createBuffer()]

  async function load() {
    const bytes = await (await fetch('/given')).arrayBuffer()
    vertexCount = bytes.byteLength / 4 / stride
    gl.bindBuffer(gl.ARRAY_BUFFER, meshBuffer)
    gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.STATIC_DRAW)
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, resultBuffer)
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, vertexCount * 24, gl.STREAM_READ)
  }

  async function run(source, draws) {
    const program = getProgram(source)
    gl.useProgram(program)
    let offset = 0
    for (const [name, size] of Object.entries(layout)) {
      const location = gl.getAttribLocation(program, name)
      if (location >= 0) {
        gl.enableVertexAttribArray(location)
        gl.vertexAttribPointer(location, size, gl.FLOAT, false, stride * 4, offset * 4)
      }
      offset += size
    }
    const size = vertexCount * 24
    const results = new Uint8Array(draws.length * size)
    draws.forEach((uniforms, i) => {
      for (const [name, value] of Object.entries(uniforms)) {
        const values = [value].flat()
        gl[`uniform${values.length}fv`](gl.getUniformLocation(program, name), values)
      }
      gl.enable(gl.RASTERIZER_DISCARD)
      gl.beginTransformFeedback(gl.POINTS)
      gl.drawArrays(gl.POINTS, 0, vertexCount)
      gl.endTransformFeedback()
      gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, results, i * size, size)
    })
    // A blob, since Playwright does not log its contents.
    await fetch('/taken', { method: 'POST', body: new Blob([results]) })
  }

  window.pipeline = { link, load, run }
}
