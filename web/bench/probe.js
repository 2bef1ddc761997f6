/** Reads back from the GPU the normals that a method computes, with their places on the unwarped mesh. */
import { probeShader, vertexShader } from './shaders.js'

/** Picks every n-th vertex, `limit` at most. Returns { positions, normals }. */
export function sampleVertices({ positions, normals }, limit) {
  const count = positions.length / 3
  const step = Math.ceil(count / limit)
  const chosen = Array.from({ length: Math.ceil(count / step) }, (_, i) => i * step)
  const pick = (values) =>
    Float32Array.from(chosen.flatMap((i) => [...values.subarray(3 * i, 3 * i + 3)]))
  return { positions: pick(positions), normals: pick(normals) }
}

const triples = (values) =>
  Array.from({ length: values.length / 3 }, (_, i) => [...values.subarray(3 * i, 3 * i + 3)])

/** Compiles a program for `probeVertices`. */
export const compileVertexProbe = (scene, parts) =>
  scene.program(vertexShader(parts), '#version 300 es\nvoid main() {}', ['surfaceNormal'])

/** Reads the normals that the vertex shader computes. Returns [{ position, normal, measured }]. */
export function probeVertices(scene, program, sample, uniforms) {
  const { gl } = scene
  const count = sample.positions.length / 3
  scene.use(program, uniforms)

  const before = gl.getParameter(gl.VERTEX_ARRAY_BINDING)
  const array = gl.createVertexArray()
  gl.bindVertexArray(array)
  const buffers = [sample.positions, sample.normals].map((data, location) => {
    const buffer = gl.createBuffer()
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer)
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW)
    gl.enableVertexAttribArray(location)
    gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 0, 0)
    return buffer
  })
  const results = gl.createBuffer()
  gl.bindBuffer(gl.ARRAY_BUFFER, null)
  gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, results)
  gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, count * 12, gl.STREAM_READ)
  gl.enable(gl.RASTERIZER_DISCARD)
  gl.beginTransformFeedback(gl.POINTS)
  gl.drawArrays(gl.POINTS, 0, count)
  gl.endTransformFeedback()
  gl.disable(gl.RASTERIZER_DISCARD)
  const measured = new Float32Array(count * 3)
  gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, measured)

  gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null)
  gl.bindVertexArray(before)
  gl.deleteVertexArray(array)
  for (const buffer of [...buffers, results]) gl.deleteBuffer(buffer)

  const positions = triples(sample.positions)
  const normals = triples(sample.normals)
  return triples(measured).map((normal, i) => ({
    position: positions[i],
    normal: normals[i],
    measured: normal,
  }))
}

/**
 * Reads the normals that light the pixels, for a method that computes them in the fragment stage. Returns up to `limit`
 * [{ position, normal, measured }], where `position` and `normal` are interpolated from the unwarped mesh.
 */
export function probePixels(scene, parts, millis, limit) {
  const { gl } = scene
  if (!gl.getExtension('EXT_color_buffer_float')) return []
  const { width, height } = gl.canvas
  const program = scene.program(vertexShader(parts), probeShader(true))
  const framebuffer = gl.createFramebuffer()
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer)
  const attachBuffer = (format, attachment) => {
    const buffer = gl.createRenderbuffer()
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer)
    gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height)
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer)
    return buffer
  }
  const attachments = [0, 1, 2].map((i) => gl.COLOR_ATTACHMENT0 + i)
  const buffers = attachments.map((attachment) => attachBuffer(gl.RGBA32F, attachment))
  buffers.push(attachBuffer(gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT))
  gl.drawBuffers(attachments)
  const color = gl.getParameter(gl.COLOR_CLEAR_VALUE)
  gl.clearColor(0, 0, 0, 0)
  scene.draw(program, { millis })
  gl.clearColor(...color)
  const [measured, positions, normals] = attachments.map((attachment) => {
    const values = new Float32Array(width * height * 4)
    gl.readBuffer(attachment)
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, values)
    return values
  })
  gl.bindFramebuffer(gl.FRAMEBUFFER, null)
  gl.deleteFramebuffer(framebuffer)
  for (const buffer of buffers) gl.deleteRenderbuffer(buffer)
  gl.deleteProgram(program)

  const covered = Array.from({ length: width * height }, (_, i) => i).filter(
    (i) => measured[4 * i + 3] === 1,
  )
  const step = Math.ceil(covered.length / limit)
  const readVector = (values, i) => [...values.subarray(4 * i, 4 * i + 3)]
  return covered
    .filter((_, i) => i % step === 0)
    .map((i) => ({
      position: readVector(positions, i),
      normal: readVector(normals, i),
      measured: readVector(measured, i),
    }))
}
