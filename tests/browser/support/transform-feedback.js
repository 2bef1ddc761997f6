// Runs vertex shaders on the real pipeline and reads back what they computed, by transform feedback.
import { layout, stride } from './dense-mesh.js'

const uniformTypes = { millis: 'float', mouse: 'vec2', size: 'vec2', pixelDensity: 'float' }

/** A vertex shader around a compiled warp; its results are movedPosition and turnedNormal. */
export function vertexShader({ code, declarations }, target, params = {}) {
  const modern = target === 'glsl300'
  const ownTypes = Object.entries(params).map(([name, value]) => [
    name,
    typeName([value].flat().length),
  ])
  const declare = (qualifier, [name, type]) => `${qualifier} ${type} ${name};`
  return [
    `#version ${modern ? '300 es' : '100'}`,
    'precision highp float;',
    ...Object.entries(layout).map(([name, size]) =>
      declare(modern ? 'in' : 'attribute', [name, typeName(size)]),
    ),
    ...[...Object.entries(uniformTypes), ...ownTypes].map((entry) => declare('uniform', entry)),
    `${modern ? 'out' : 'varying'} vec3 movedPosition, turnedNormal;`,
    declarations,
    'void main() {',
    code,
    'movedPosition = warpedPosition;',
    'turnedNormal = warpedNormal;',
    'gl_Position = vec4(0.0);',
    '}',
  ].join('\n')
}

const typeName = (size) => (size === 1 ? 'float' : `vec${size}`)

/** A page with a WebGL2 context, or with a WebGL 1 context, which can only link shaders. */
export async function openPipeline(browser, contextName = 'webgl2') {
  const page = await browser.newPage()
  await page.evaluate(prepare, { contextName, layout, stride })
  const link = (source) => page.evaluate((source) => void pipeline.link(source), source)
  const load = (mesh) =>
    page.evaluate((text) => pipeline.load(text), Buffer.from(mesh.buffer).toString('base64'))

  /** One draw for each set of uniforms → for each a Float32Array with six numbers a vertex. */
  async function run(source, draws) {
    const results = await page.evaluate(
      ([source, draws]) => pipeline.run(source, draws),
      [source, draws],
    )
    return results.map(
      (text) => new Float32Array(Uint8Array.from(Buffer.from(text, 'base64')).buffer),
    )
  }
  return { link, load, run, close: () => page.close() }
}

/** Runs in the page. */
function prepare({ contextName, layout, stride }) {
  const gl = document.createElement('canvas').getContext(contextName)
  let vertexCount
  // The last two: a warp is often run on many meshes, with and without an accurate sine, and compiling takes long.
  const programs = new Map()

  function programOf(source) {
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
        ['movedPosition', 'turnedNormal'],
        gl.INTERLEAVED_ATTRIBS,
      )
    gl.linkProgram(program)
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(`${gl.getProgramInfoLog(program)}\n${source}`)
    return program
  }

  const toBase64 = (bytes) => {
    let text = ''
    for (let i = 0; i < bytes.length; i += 8192)
      text += String.fromCharCode(...bytes.subarray(i, i + 8192))
    return btoa(text)
  }

  function load(text) {
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0))
    vertexCount = bytes.length / 4 / stride
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer())
    gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.STATIC_DRAW)
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, gl.createBuffer())
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, vertexCount * 24, gl.STREAM_READ)
  }

  function run(source, draws) {
    const program = programOf(source)
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
    const results = draws.map((uniforms) => {
      for (const [name, value] of Object.entries(uniforms)) {
        const values = [value].flat()
        gl[`uniform${values.length}fv`](gl.getUniformLocation(program, name), values)
      }
      gl.enable(gl.RASTERIZER_DISCARD)
      gl.beginTransformFeedback(gl.POINTS)
      gl.drawArrays(gl.POINTS, 0, vertexCount)
      gl.endTransformFeedback()
      const bytes = new Uint8Array(vertexCount * 24)
      gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, bytes)
      return toBase64(bytes)
    })
    return results
  }

  window.pipeline = { link, load, run }
}
