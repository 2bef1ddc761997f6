// Runs a program in a vertex shader of WebGL 2, whose outputs are read by transform feedback. Runs in the page.
import { totalSize } from './text.js'
import {
  bindImages,
  bindPoints,
  collectResults,
  declareImages,
  link,
  vertexParts,
} from './webgl.js'

/** The number of vec4s that a draw returns for each point. With more, SwiftShader needs more time to compile than it saves in draws. */
const width = 2
const names = Array.from({ length: width }, (_, i) => `result${i}`)

const vertexSource = ({ declarations, images }, { attributes, body }) => `#version 300 es
precision highp float;
${attributes.map((name) => `in vec4 ${name};`).join('\n')}
uniform int pass;
out vec4 ${names.join(', ')};
${declareImages(images)}
${declarations}
void main() {
${names.map((name) => `${name} = vec4(0.0);`).join('\n')}
${body}
gl_Position = vec4(0.0);
}`

const fragmentSource = '#version 300 es\nvoid main() {}'

export function open() {
  const gl = document.createElement('canvas').getContext('webgl2')
  if (!gl) throw new Error('There is no WebGL 2 here.')
  gl.enable(gl.RASTERIZER_DISCARD)
  return (program, points) => run(gl, program, points)
}

function run(gl, program, points) {
  const size = totalSize(program.inputs)
  const count = points.length / size
  const parts = vertexParts(program, width)
  const source = vertexSource(program, parts)
  const linked = link(gl, source, fragmentSource, (unlinked) =>
    gl.transformFeedbackVaryings(unlinked, names, gl.INTERLEAVED_ATTRIBS),
  )
  gl.useProgram(linked)
  const discardImages = bindImages(gl, linked, program.images)
  const discardInputs = bindPoints(gl, linked, parts.attributes, points, size)
  const outputs = gl.createBuffer()
  gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, outputs)
  const results = new Float32Array(parts.passes * count * width * 4)
  gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, results.byteLength, gl.STREAM_READ)
  const bytes = results.byteLength / parts.passes
  for (let pass = 0; pass < parts.passes; pass++) {
    gl.uniform1i(gl.getUniformLocation(linked, 'pass'), pass)
    gl.bindBufferRange(gl.TRANSFORM_FEEDBACK_BUFFER, 0, outputs, pass * bytes, bytes)
    gl.beginTransformFeedback(gl.POINTS)
    gl.drawArrays(gl.POINTS, 0, count)
    gl.endTransformFeedback()
  }
  gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, results)
  const error = gl.getError()
  if (error) throw new Error(`WebGL 2 reports the error ${error}.`)
  discardInputs()
  discardImages()
  gl.deleteBuffer(outputs)
  gl.deleteProgram(linked)
  return collectResults(count, totalSize(program.outputs), (point, vector, k) => {
    const row = Math.floor(vector / width) * count + point
    return results[4 * (row * width + (vector % width)) + k]
  })
}
