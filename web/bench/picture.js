/** Draws one row with one method and measures its cost. */
import { computeExactNormals, errorsOf, findBestStep, pixelErrors } from './accuracy.js'
import { openClock } from './clock.js'
import { frameMesh } from './framing.js'
import { orbit } from './orbit.js'
import { compileVertexProbe, probePixels, probeVertices, sampleVertices } from './probe.js'
import { Scene } from './scene.js'
import { fragmentShader, nextNumber, vertexShader } from './shaders.js'

/** The number of vertices or pixels whose normals are compared: few enough to do so while the picture moves. */
const SAMPLES = 300
/** Opening a clock takes tens of frames. If a frame takes this many milliseconds or more, the previous row's clock is reused. */
const SLOW = 250

export class Picture {
  constructor(canvas, size) {
    this.scene = new Scene(canvas, size)
    this.direction = orbit(canvas)
  }

  /** Makes the workload's mesh. Call `use` before drawing. */
  load(workload) {
    this.#discardPrograms()
    this.workload = workload
    this.mesh = workload.mesh()
    this.scene.load(this.mesh)
    this.sample = sampleVertices(this.mesh, SAMPLES)
    this.framing = frameMesh(workload, this.mesh)
    this.isClockForRow = false
  }

  /**
   * Compiles the method for the row and draws a first frame.
   * @returns { first, generation } in milliseconds: from the program's source to the end of that frame, and from the offset
   * function to the source; `generation` is undefined for methods that generate nothing
   */
  async use(method, uniforms) {
    this.#discardPrograms()
    if (method.name === 'by hand' && !this.workload.handwritten)
      throw new Error('This row has no handwritten derivatives: choose another method or row.')
    const { scene } = this
    // Discard the first run, in which the JavaScript engine has not optimized the compiler yet.
    method.program(this.workload)
    const parts = method.program(this.workload)
    this.method = method
    const unique = nextNumber()
    this.#aim(uniforms)
    scene.finish()
    const start = performance.now()
    try {
      this.program = scene.program(vertexShader(parts, unique), fragmentShader(method.flat, unique))
    } catch ({ message }) {
      throw new Error(`The shader of ${method.name} does not compile here: ${message}`)
    }
    scene.draw(this.program, uniforms)
    scene.finish()
    const first = performance.now() - start

    if (!method.flat) this.probe = compileVertexProbe(scene, parts)
    this.parts = parts
    if (!this.isClockForRow && (first < SLOW || !this.clock)) {
      this.clock = await openClock(scene, () => scene.draw(this.program, uniforms))
      this.isClockForRow = true
    }
    return { first, generation: parts.generation }
  }

  draw(uniforms) {
    this.#aim(uniforms)
    this.scene.draw(this.program, uniforms)
  }

  /** Draws a frame and returns the milliseconds until the GPU is done. */
  frameTime(uniforms) {
    this.#aim(uniforms)
    // Exclude work that was submitted earlier.
    this.scene.finish()
    return this.clock.time(() => this.scene.draw(this.program, uniforms))
  }

  /** Returns { largest, median } of the normals' errors, in degrees. */
  error(uniforms) {
    const { scene, workload, method, parts, probe, sample } = this
    const { millis } = uniforms
    if (method.flat)
      return pixelErrors(workload, probePixels(scene, parts, millis, SAMPLES), millis)
    const places = probeVertices(scene, probe, sample, uniforms)
    return errorsOf(places, computeExactNormals(workload, places, millis))
  }

  /** Finds the step of finite differences whose largest error is smallest. */
  bestStep(millis) {
    const { scene, workload, method, probe, sample } = this
    return findBestStep(scene, workload, { probe, sample, steps: method.steps, millis }).h
  }

  /** Makes the camera follow the mesh. */
  #aim({ millis }) {
    const { distance, middleAt } = this.framing
    const middle = this.method.name === 'no warp' ? [0, 0, 0] : middleAt(millis)
    const direction = this.direction()
    this.scene.lookFrom(
      middle.map((value, i) => value + distance * direction[i]),
      middle,
    )
  }

  #discardPrograms() {
    for (const program of [this.program, this.probe])
      if (program) this.scene.gl.deleteProgram(program)
    this.program = this.probe = this.method = undefined
  }
}
