// Runs a program in a vertex shader of WebGL 1, which can only draw: each point becomes a pixel of a float texture, which is then read. A
// draw returns four floats of each point. An infinite float is returned as NaN, since the rasterizer multiplies it by zero. Runs in the
// page.
import { totalSize } from './text.js'
import {
  bindImages,
  bindPoints,
  collectResults,
  declareImages,
  link,
  vertexParts,
} from './webgl.js'

/** The width of the float texture, in pixels. */
const width = 1024

const vertexSource = ({ declarations, images }, { attributes, body }) => `
precision highp float;
${attributes.map((name) => `attribute vec4 ${name};`).join('\n')}
attribute float pointIndex;
uniform float pointCount, rowCount;
uniform int pass;
varying highp vec4 result0;
${declareImages(images)}
${declarations}
void main() {
${body}
float pixel = float(pass) * pointCount + pointIndex;
float row = floor((pixel + 0.5) / ${width}.0);
vec2 place = vec2(pixel - ${width}.0 * row, row) + 0.5;
gl_Position = vec4(place / vec2(${width}.0, rowCount) * 2.0 - 1.0, 0.0, 1.0);
gl_PointSize = 1.0;
}`

const fragmentSource = `
precision highp float;
varying highp vec4 result0;
void main() { gl_FragColor = result0; }`

export function open() {
  const gl = document.createElement('canvas').getContext('webgl', { antialias: false })
  if (!gl) throw new Error('There is no WebGL 1 here.')
  for (const name of ['OES_texture_float', 'WEBGL_color_buffer_float'])
    if (!gl.getExtension(name)) throw new Error(`WebGL 1 has no ${name} here.`)
  return (program, points) => run(gl, program, points)
}

/** Makes a float texture of `rows` rows the target of draws. Returns a function that deletes it. */
function bindTarget(gl, rows) {
  const texture = gl.createTexture()
  gl.bindTexture(gl.TEXTURE_2D, texture)
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, rows, 0, gl.RGBA, gl.FLOAT, null)
  const framebuffer = gl.createFramebuffer()
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer)
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0)
  if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
    throw new Error('WebGL 1 cannot draw floats here.')
  gl.viewport(0, 0, width, rows)
  return () => {
    gl.deleteFramebuffer(framebuffer)
    gl.deleteTexture(texture)
  }
}

function run(gl, program, points) {
  const size = totalSize(program.inputs)
  const count = points.length / size
  const parts = vertexParts(program, 1)
  const linked = link(gl, vertexSource(program, parts), fragmentSource)
  gl.useProgram(linked)
  const rows = Math.ceil((parts.passes * count) / width)
  const discardTarget = bindTarget(gl, rows)
  const indices = Float32Array.from({ length: count }, (_, i) => i)
  const unbindInputs = [
    bindImages(gl, linked, program.images),
    bindPoints(gl, linked, parts.attributes, points, size),
    bindPoints(gl, linked, ['pointIndex'], indices, 1),
  ]
  const uniform = (name) => gl.getUniformLocation(linked, name)
  gl.uniform1f(uniform('pointCount'), count)
  gl.uniform1f(uniform('rowCount'), rows)
  for (let pass = 0; pass < parts.passes; pass++) {
    gl.uniform1i(uniform('pass'), pass)
    gl.drawArrays(gl.POINTS, 0, count)
  }
  const pixels = new Float32Array(4 * width * rows)
  gl.readPixels(0, 0, width, rows, gl.RGBA, gl.FLOAT, pixels)
  const error = gl.getError()
  if (error) throw new Error(`WebGL 1 reports the error ${error}.`)
  for (const discard of [...unbindInputs, discardTarget]) discard()
  gl.deleteProgram(linked)
  return collectResults(
    count,
    totalSize(program.outputs),
    (point, vector, k) => pixels[4 * (vector * count + point) + k],
  )
}
