// Passes the arrays of one call to the mesh wasm module and back.
import { anyNumber, describeNumber, firstWrong } from '../options/numbers.js'
import type { Place } from '../options/place.js'
import type { ByteArray, FloatArray, IndexArray } from '../wasm/mesh-tables.js'
import {
  MeshFailure,
  MeshStartFailure,
  meshes,
  type Mesh,
  type MeshModule,
  type Outcome,
} from '../wasm/mesh.js'

/** The actions of a job that have no parameters. */
type Action =
  | 'findFiles'
  | 'findPacked'
  | 'keepPiece'
  | 'loadFile'
  | 'checkMesh'
  | 'addNormals'
  | 'addVariation'
  | 'normalizeNormals'
  | 'writeFile'

/** The data of one call, in wasm memory. */
export class Job {
  constructor(
    readonly place: Place,
    private readonly mesh: Mesh,
    private readonly module: MeshModule,
  ) {}

  /** Copies numbers into the module, `size` per vertex. Throws if an element is no number; NaN and infinity are allowed here. */
  setFloats(name: FloatArray, numbers: ArrayLike<number>, size = 3) {
    // The memory is allocated first, so that an oversized array fails before its numbers are read.
    this.expect(this.mesh.resizeFloats(name, numbers))
    const wrongIndex = firstWrong(numbers, anyNumber)
    if (wrongIndex >= 0)
      throw this.place
        .part(`${name}[${wrongIndex}], of vertex ${Math.floor(wrongIndex / size)}`)
        .expected('a finite number', describeNumber(numbers[wrongIndex]))
    this.expect(this.mesh.setFloats(name, numbers))
  }

  setIndices(numbers: ArrayLike<number>) {
    this.expect(this.mesh.setIndices('indices', numbers))
  }

  setBytes(name: ByteArray, bytes: Uint8Array) {
    this.expect(this.mesh.setBytes(name, bytes))
  }

  setText(name: ByteArray, text: string) {
    this.setBytes(name, new TextEncoder().encode(text))
  }

  setBaseColor(color: ArrayLike<number>) {
    this.mesh.setBaseColor(color)
  }

  floats(name: FloatArray): Float32Array {
    return this.mesh.floats(name).slice()
  }

  indices(name: IndexArray = 'indices'): Uint32Array {
    return this.mesh.indices(name).slice()
  }

  bytes(name: ByteArray): Uint8Array {
    return this.mesh.bytes(name).slice()
  }

  text(name: ByteArray): string {
    return new TextDecoder().decode(this.bytes(name))
  }

  triangleCount(): number {
    return this.mesh.triangleCount()
  }

  baseColor(): number[] | undefined {
    const color = this.mesh.baseColor()
    return color.length ? [...color] : undefined
  }

  /** Runs an action in C++ and returns its strings. Throws a `WarpError` if it fails. */
  act(action: Action): string[] {
    return this.expect(this.mesh[action]())
  }

  /** Adds a file that the model refers to. */
  addFile(name: string, contents: Uint8Array) {
    this.setBytes('transfer', contents)
    this.expect(this.mesh.keepFile(name))
  }

  /** Returns the bytes of a compressed part of the file, after `findPacked`. */
  packedBytes(part: number): Uint8Array {
    this.expect(this.mesh.openPacked(part))
    return this.bytes('transfer')
  }

  /** Replaces a compressed part by its decoded bytes, the concatenation of the pieces. */
  unpack(part: number, pieces: readonly Uint8Array[]) {
    for (const piece of pieces) {
      this.setBytes('transfer', piece)
      this.act('keepPiece')
    }
    this.expect(this.mesh.unpack(part))
  }

  /** Splits each triangle into four, `levels` times. Returns warnings. */
  refineUniformly(levels: number, maxTriangles: number): string[] {
    return this.expect(this.mesh.refineUniformly(levels, maxTriangles))
  }

  /**
   * Splits edges until the warped triangles are within the tolerance. Returns warnings. `warp` moves the vertices of the job passed to
   * it; errors that it throws are rethrown.
   */
  refine(
    tolerance: number,
    angle: number,
    maxTriangles: number,
    warp: (vertices: Job) => void,
  ): string[] {
    let problem: { error: unknown } | undefined
    const evaluate = (vertices: Mesh) => {
      try {
        warp(new Job(this.place, vertices, this.module))
        // The warp may have used this wasm instance too and broken it, even if it caught the error.
        if (this.module.isBroken) throw tooLarge(this.place)
        return true
      } catch (error) {
        problem = { error }
        return false
      }
    }
    try {
      return this.expect(this.mesh.refine(tolerance, angle, maxTriangles, evaluate))
    } catch (error) {
      // The warp's own error is more specific.
      throw problem ? problem.error : error
    }
  }

  /** Returns the strings of an outcome; throws if it has a problem. */
  private expect({ problem, texts }: Outcome): string[] {
    if (problem) throw this.place.error(problem)
    return texts
  }
}

/** Runs `work` with a job, which is always deleted afterwards. */
export function withJob<Result>(place: Place, work: (job: Job) => Result): Result {
  try {
    return meshes.use(
      ({ Mesh }) => new Mesh(),
      (mesh, module) => work(new Job(place, mesh, module)),
    )
  } catch (error) {
    if (error instanceof MeshFailure) throw tooLarge(place)
    if (!(error instanceof MeshStartFailure)) throw error
    throw Object.assign(
      place.error(
        'meshes need WebAssembly with exceptions, which this browser lacks; every current browser has it.',
      ),
      { cause: error.cause },
    )
  }
}

const tooLarge = (place: Place) => place.error('the mesh is too large or too deeply nested.')
