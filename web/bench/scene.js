/** Draws one mesh on one WebGL 2 canvas with interchangeable programs. */
import { mat4 } from 'gl-matrix'

/** In units of the mesh, which is entirely in the picture from here. Rows are measured from this position. */
export const defaultEye = [0, 120, 330]

export class Scene {
  /** @param size width and height in pixels */
  constructor(canvas, size) {
    canvas.width = canvas.height = size
    this.gl = canvas.getContext('webgl2', { antialias: false })
    if (!this.gl)
      throw new Error('The benchmark needs WebGL 2: open it in a browser with WebGL 2 enabled.')
    this.gl.enable(this.gl.DEPTH_TEST)
    // The page's background colour, so that the canvas has no visible edge.
    this.gl.clearColor(0x15 / 255, 0x18 / 255, 0x23 / 255, 1)
    this.lookFrom(defaultEye)
  }

  /** @param eye in units of the mesh, not straight above or below `middle` @param middle the point the camera looks at */
  lookFrom(eye, middle = [0, 0, 0]) {
    this.eye = eye
    this.camera = mat4.lookAt([], eye, middle, [0, 1, 0])
    mat4.multiply(this.camera, mat4.perspective([], 0.75, 1, 10, 2000), this.camera)
  }

  /** The renderer's name, as the driver reports it. */
  get renderer() {
    const { gl } = this
    const names = gl.getExtension('WEBGL_debug_renderer_info')
    return gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER)
  }

  /** Replaces the previous mesh. */
  load({ positions, normals, indices }) {
    const { gl } = this
    for (const buffer of this.buffers ?? []) gl.deleteBuffer(buffer)
    gl.bindVertexArray((this.vertices ??= gl.createVertexArray()))
    this.buffers = [
      this.#attribute(0, positions),
      this.#attribute(1, normals),
      this.#upload(gl.ELEMENT_ARRAY_BUFFER, indices),
    ]
    this.count = indices.length
  }

  #upload(target, data) {
    const { gl } = this
    const buffer = gl.createBuffer()
    gl.bindBuffer(target, buffer)
    gl.bufferData(target, data, gl.STATIC_DRAW)
    return buffer
  }

  #attribute(location, data) {
    const { gl } = this
    const buffer = this.#upload(gl.ARRAY_BUFFER, data)
    gl.enableVertexAttribArray(location)
    gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 0, 0)
    return buffer
  }

  /** Compiles and links; `captured` names the outputs that transform feedback captures. */
  program(vertexSource, fragmentSource, captured = []) {
    const { gl } = this
    const program = gl.createProgram()
    for (const [type, source] of [
      [gl.VERTEX_SHADER, vertexSource],
      [gl.FRAGMENT_SHADER, fragmentSource],
    ]) {
      const shader = gl.createShader(type)
      gl.shaderSource(shader, source)
      gl.compileShader(shader)
      gl.attachShader(program, shader)
      gl.deleteShader(shader)
    }
    gl.bindAttribLocation(program, 0, 'position')
    gl.bindAttribLocation(program, 1, 'normal')
    if (captured.length) gl.transformFeedbackVaryings(program, captured, gl.SEPARATE_ATTRIBS)
    gl.linkProgram(program)
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      const [vertex] = gl.getAttachedShaders(program)
      throw new Error(`${gl.getProgramInfoLog(program)}${gl.getShaderInfoLog(vertex)}`)
    }
    return program
  }

  /** @param h the step of finite differences, for programs that have one */
  use(program, { millis, h = 0 }) {
    const { gl, camera, eye } = this
    gl.useProgram(program)
    gl.uniformMatrix4fv(gl.getUniformLocation(program, 'camera'), false, camera)
    gl.uniform1f(gl.getUniformLocation(program, 'millis'), millis)
    gl.uniform1f(gl.getUniformLocation(program, 'h'), h)
    gl.uniform3fv(gl.getUniformLocation(program, 'eye'), eye)
  }

  draw(program, uniforms) {
    const { gl } = this
    this.use(program, uniforms)
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0)
  }

  /** Returns when the GPU has finished all submitted work, by reading back a pixel. */
  finish() {
    const { gl } = this
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))
  }
}
