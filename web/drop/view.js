/** Draws a warped model with WebGL 2: call `show` with a mesh, `use` with a warp, then `draw`. */
import { boxVertex, lineFragment, litFragment, modelVertex } from './shaders.js'

const BACK = [0x15 / 255, 0x18 / 255, 0x23 / 255, 1]
/** The depth offset of the wireframe, in normalized device coordinates (-1 to 1). */
const NEARER = 3e-4
const attributes = { position: 3, normal: 3, uv: 2, color: 4 }
const arrays = { position: 'positions', normal: 'normals', uv: 'uvs', color: 'colors' }
/** glTF's defaults for missing attributes: white, and the texture's first corner. */
const defaults = { uv: [0, 0, 0, 0], color: [1, 1, 1, 1] }

// prettier-ignore
const boxEdges = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7]
  .flatMap((corner) => [corner & 1, (corner >> 1) & 1, corner >> 2])

export class View {
  constructor(canvas) {
    const gl = canvas.getContext('webgl2', { antialias: true })
    if (!gl)
      throw new Error('This page needs WebGL 2, which this browser lacks: open it in another one.')
    this.gl = gl
    this.canvas = canvas
    this.boxProgram = this.link(boxVertex, lineFragment)
    this.box = this.buffer(gl.ARRAY_BUFFER, new Float32Array(boxEdges))
    gl.enable(gl.DEPTH_TEST)
    gl.enable(gl.BLEND)
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE)
    gl.clearColor(...BACK)
  }

  /** Uploads a mesh of `loadMesh`. @param picture the decoded texture, if there is one */
  show(mesh, picture) {
    const { gl } = this
    const vertices = mesh.positions.length / 3
    const limit = 4 * gl.getParameter(gl.MAX_ELEMENT_INDEX)
    if (vertices > limit)
      throw new Error(
        `The model is too large for this GPU: expected at most ${limit} vertices, got ${vertices}.`,
      )
    const buffers = {}
    for (const [name, array] of Object.entries(arrays))
      if (mesh[array]) buffers[name] = this.buffer(gl.ARRAY_BUFFER, mesh[array])
    if (mesh.indices) buffers.indices = this.buffer(gl.ELEMENT_ARRAY_BUFFER, mesh.indices)
    const isOutOfMemory = gl.getError() === gl.OUT_OF_MEMORY
    // Discard the previous buffers only now: they stay if the new ones do not fit.
    this.discard(isOutOfMemory ? buffers : this.buffers)
    if (isOutOfMemory) throw new Error('The GPU has too little memory for this model.')
    this.buffers = buffers
    this.mesh = mesh
    this.baseColor = mesh.material?.baseColor ?? [1, 1, 1, 1]
    this.count = mesh.indices?.length ?? vertices
    this.setPicture(picture)
  }

  discard(buffers = {}) {
    for (const buffer of Object.values(buffers)) this.gl.deleteBuffer(buffer)
  }

  setPicture(picture) {
    const { gl } = this
    gl.deleteTexture(this.texture ?? null)
    this.texture = gl.createTexture()
    gl.bindTexture(gl.TEXTURE_2D, this.texture)
    const white = new Uint8Array([255, 255, 255, 255])
    const format = [gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8]
    if (picture) gl.texImage2D(...format, gl.RGBA, gl.UNSIGNED_BYTE, picture)
    else gl.texImage2D(...format, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, white)
    gl.generateMipmap(gl.TEXTURE_2D)
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR)
  }

  /** @param warp the result of `compileWarp` with target glsl300 */
  use(warp) {
    const programs = [litFragment, lineFragment].map((fragment) =>
      this.link(modelVertex(warp), fragment),
    )
    for (const program of this.programs ?? []) this.gl.deleteProgram(program)
    this.programs = programs
  }

  /**
   * @param uniforms the warp's uniforms
   * @param view the result of the camera's `view`
   * @param options { normals, wires, box }: whether normals are shown as colours, whether edges are drawn, and the box to draw, { min, max
   * }, if any
   */
  draw(uniforms, view, { normals, wires, box }) {
    const { gl } = this
    this.resize()
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    const [lit, lines] = this.programs
    gl.enable(gl.POLYGON_OFFSET_FILL)
    gl.polygonOffset(1, 2)
    this.prepare(lit, {
      ...uniforms,
      ...view,
      baseColor: this.baseColor,
      showNormals: Number(normals),
      nearer: 0,
    })
    if (this.buffers.indices) gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0)
    else gl.drawArrays(gl.TRIANGLES, 0, this.count)

    if (wires) {
      this.buffers.wires ??= this.buffer(gl.ELEMENT_ARRAY_BUFFER, edgesOf(this.mesh))
      this.prepare(lines, {
        ...uniforms,
        ...view,
        lineColor: [0.02, 0.03, 0.06, 0.5],
        nearer: NEARER,
      })
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.buffers.wires)
      gl.drawElements(gl.LINES, 2 * this.count, gl.UNSIGNED_INT, 0)
    }
    if (box) {
      this.prepare(
        this.boxProgram,
        { ...view, low: box.min, high: box.max, lineColor: [0.914, 0.769, 0.416, 1] },
        { position: this.box },
      )
      gl.drawArrays(gl.LINES, 0, boxEdges.length / 3)
    }
  }

  /** Resizes the canvas to the screen's resolution, but to no more than two pixels per CSS pixel in each direction. */
  resize() {
    const { canvas, gl } = this
    const scale = Math.min(devicePixelRatio, 2)
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((x) =>
      Math.max(1, Math.round(x * scale)),
    )
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height })
    gl.viewport(0, 0, width, height)
  }

  /** Uses a program with these values of uniforms and these buffers. */
  prepare(program, values, buffers = this.buffers) {
    const { gl } = this
    gl.useProgram(program)
    for (const [name, value] of Object.entries(values)) {
      const location = gl.getUniformLocation(program, name)
      if (name === 'matrix') gl.uniformMatrix4fv(location, false, value)
      else if (name === 'showNormals') gl.uniform1i(location, value)
      else if (location) gl[`uniform${value.length ?? 1}fv`](location, [value].flat())
    }
    for (const [name, size] of Object.entries(attributes)) {
      const location = gl.getAttribLocation(program, name)
      if (location < 0) continue
      if (buffers[name]) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffers[name])
        gl.enableVertexAttribArray(location)
        gl.vertexAttribPointer(location, size, gl.FLOAT, false, 0, 0)
      } else {
        gl.disableVertexAttribArray(location)
        gl.vertexAttrib4fv(location, defaults[name])
      }
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers.indices ?? null)
  }

  buffer(target, data) {
    const { gl } = this
    const buffer = gl.createBuffer()
    gl.bindBuffer(target, buffer)
    gl.bufferData(target, data, gl.STATIC_DRAW)
    return buffer
  }

  link(vertex, fragment) {
    const { gl } = this
    const program = gl.createProgram()
    const sources = [
      [gl.VERTEX_SHADER, vertex],
      [gl.FRAGMENT_SHADER, fragment],
    ]
    for (const [type, source] of sources) {
      const shader = gl.createShader(type)
      gl.shaderSource(shader, source)
      gl.compileShader(shader)
      gl.attachShader(program, shader)
    }
    gl.linkProgram(program)
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error('This GPU cannot compile the warp.')
    return program
  }
}

/** Returns the index pairs of each triangle's three edges. */
function edgesOf({ positions, indices }) {
  const count = indices?.length ?? positions.length / 3
  const ends = new Uint32Array(2 * count)
  const corner = (i) => (indices ? indices[i] : i)
  for (let i = 0; i < count; i++) {
    ends[2 * i] = corner(i)
    ends[2 * i + 1] = corner(i % 3 === 2 ? i - 2 : i + 1)
  }
  return ends
}
