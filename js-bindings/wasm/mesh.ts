// The wasm module of meshes: it starts when it is first used, and holds nothing between two calls.
import { WarpError } from '../errors/errors.js'
import {
  type ByteArray,
  type FloatArray,
  type IndexArray,
  byteArrays,
  floatArrays,
  indexArrays,
} from './mesh-tables.js'
import factory from '../generated/mesh.js'
import inlined from '../generated/mesh-wasm.js'
import { anyNumber, firstWrong, inWords } from '../options/numbers.js'
import { instantiate } from './start.js'

/** mesh.cpp. Addresses and counts above 2 GB come as negative numbers. */
interface MeshModule {
  _openJob(): number
  _closeJob(job: number): void
  _resizeArray(job: number, array: number, count: number): number
  _arrayAddress(job: number, array: number): number
  _arrayCount(job: number, array: number): number
  _textCount(job: number): number
  _textAddress(job: number, i: number): number
  _textSize(job: number, i: number): number
  _hasMaterial(job: number): number
  _baseColor(job: number): number
  _keepFile(job: number): number
  _findFiles(job: number): number
  _findPacked(job: number): number
  _openPacked(job: number, part: number): number
  _keepPiece(job: number): number
  _unpack(job: number, part: number): number
  _loadFile(job: number): number
  _checkMesh(job: number): number
  _addNormals(job: number): number
  _addVariation(job: number): number
  _writeFile(job: number): number
  _refine(job: number, tolerance: number, angle: number, maxTriangles: number): number
  _refineUniformly(job: number, levels: number, maxTriangles: number): number
  _memoryInUse(): number

  /** .cmake/mesh.js. Never throws. */
  evaluateWarp?: (job: number) => number

  /** Whether a trap left its memory in any state, so that nothing in it may run again. */
  isBroken?: boolean

  readonly HEAPU8: Uint8Array
  readonly HEAPU32: Uint32Array
  readonly HEAPF32: Float32Array
}

/** What can be done with a job: those without numbers of their own. */
export type Action =
  | 'keepFile'
  | 'findFiles'
  | 'findPacked'
  | 'keepPiece'
  | 'loadFile'
  | 'checkMesh'
  | 'addNormals'
  | 'addVariation'
  | 'writeFile'

/** Memory only grows, so an instance that has grown beyond this is given up. */
const mostKeptBytes = 2 ** 26

let present: MeshModule | undefined

const getModule = () => (present ??= instantiate<MeshModule>(factory, inlined))

/**
 * How many bytes the mesh module holds inside its wasm: between two calls always the same. For tests, not for users.
 * @internal
 */
export function meshMemoryInUse(): number {
  return getModule()._memoryInUse() >>> 0
}

/** What enters and leaves one call of `method`. */
export class Job {
  constructor(
    readonly method: string,
    private readonly wasm: MeshModule,
    private readonly job: number,
  ) {
    if (!job) this.refuseMemory()
  }

  close() {
    this.wasm._closeJob(this.job)
  }

  /** Numbers only, though NaN and infinity may be among them: `size` a vertex. */
  setFloats(name: FloatArray, numbers: ArrayLike<number>, size = 3) {
    const at = this.resize(floatArrays[name], numbers.length)
    const wrong = firstWrong(numbers, anyNumber)
    if (wrong >= 0)
      throw new WarpError(
        `${this.method}: ${name}[${wrong}], of vertex ${Math.floor(wrong / size)}, must be a finite number, but is ${inWords(numbers[wrong])}.`,
      )
    this.wasm.HEAPF32.set(numbers, at / 4)
  }

  setIndices(numbers: ArrayLike<number>) {
    const at = this.resize(indexArrays.indices, numbers.length)
    this.wasm.HEAPU32.set(numbers, at / 4)
  }

  setBytes(name: ByteArray, bytes: Uint8Array) {
    const at = this.resize(byteArrays[name], bytes.length)
    this.wasm.HEAPU8.set(bytes, at)
  }

  setText(name: ByteArray, text: string) {
    this.setBytes(name, new TextEncoder().encode(text))
  }

  setBaseColor(color: ArrayLike<number>) {
    this.wasm.HEAPF32.set(color, (this.wasm._baseColor(this.job) >>> 0) / 4)
  }

  floats(name: FloatArray): Float32Array {
    const [at, count] = this.place(floatArrays[name])
    return this.wasm.HEAPF32.slice(at / 4, at / 4 + count)
  }

  indices(name: IndexArray = 'indices'): Uint32Array {
    const [at, count] = this.place(indexArrays[name])
    return this.wasm.HEAPU32.slice(at / 4, at / 4 + count)
  }

  bytes(name: ByteArray): Uint8Array {
    const [at, count] = this.place(byteArrays[name])
    return this.wasm.HEAPU8.slice(at, at + count)
  }

  triangleCount(): number {
    const indices = this.place(indexArrays.indices)[1]
    return Math.floor((indices || this.place(floatArrays.positions)[1] / 3) / 3)
  }

  text(name: ByteArray): string {
    return new TextDecoder().decode(this.bytes(name))
  }

  baseColor(): number[] | undefined {
    if (!this.wasm._hasMaterial(this.job)) return undefined
    const at = (this.wasm._baseColor(this.job) >>> 0) / 4
    return [...this.wasm.HEAPF32.subarray(at, at + 4)]
  }

  /** Does something in C++, or throws what is wrong. */
  act(action: Action) {
    this.expect(this.wasm[`_${action}`](this.job))
  }

  /** The bytes of a compressed part of the file, after `findPacked`. */
  packedBytes(part: number): Uint8Array {
    this.expect(this.wasm._openPacked(this.job, part))
    return this.bytes('contents')
  }

  /** Puts decoded bytes in the place of a compressed part. */
  unpack(part: number, pieces: readonly Uint8Array[]) {
    for (const piece of pieces) {
      this.setBytes('contents', piece)
      this.act('keepPiece')
    }
    this.expect(this.wasm._unpack(this.job, part))
  }

  refineUniformly(levels: number, maxTriangles: number) {
    this.expect(this.wasm._refineUniformly(this.job, levels, maxTriangles))
  }

  /** `warp` moves the vertices of the job that it is given; what it throws is thrown on. */
  refine(tolerance: number, angle: number, maxTriangles: number, warp: (vertices: Job) => void) {
    let problem: { error: unknown } | undefined
    // A warp may itself subdivide something.
    const outer = this.wasm.evaluateWarp
    this.wasm.evaluateWarp = (address) => {
      try {
        warp(new Job(this.method, this.wasm, address))
        // What the warp did with meshes may have ended this instance, even if it caught the error.
        if (this.wasm.isBroken) throw new WarpError(trapSentence(this.method))
        return 1
      } catch (error) {
        problem = { error }
        return 0
      }
    }
    try {
      const done = this.wasm._refine(this.job, tolerance, angle, maxTriangles)
      if (!problem) this.expect(done)
    } catch (error) {
      // A trap on the way out of a warp that failed, whose own error says more.
      if (problem) giveUp(this.wasm)
      else throw error
    } finally {
      this.wasm.evaluateWarp = outer
    }
    if (problem) throw new Foreign(problem.error)
  }

  private expect(done: number) {
    if (!done) throw new WarpError(`${this.method}: ${this.texts()[0]}`)
  }

  /** What the last action left. */
  texts(): string[] {
    return Array.from({ length: this.wasm._textCount(this.job) }, (_, i) => {
      const at = this.wasm._textAddress(this.job, i) >>> 0
      const bytes = this.wasm.HEAPU8.subarray(at, at + this.wasm._textSize(this.job, i))
      return new TextDecoder().decode(bytes)
    })
  }

  private place(array: number): [at: number, count: number] {
    return [
      this.wasm._arrayAddress(this.job, array) >>> 0,
      this.wasm._arrayCount(this.job, array) >>> 0,
    ]
  }

  private resize(array: number, count: number): number {
    const at = this.wasm._resizeArray(this.job, array, count) >>> 0
    if (!at && count) this.refuseMemory()
    return at
  }

  private refuseMemory(): never {
    throw new WarpError(`${this.method}: there is not enough memory for so large a mesh.`)
  }
}

/** Does `work` with a job, and closes it whatever happens. */
export function withJob<Result>(method: string, work: (job: Job) => Result): Result {
  const wasm = start(method)
  let job: Job | undefined
  try {
    job = new Job(method, wasm, wasm._openJob())
    return work(job)
  } catch (error) {
    if (error instanceof Foreign) throw error.error
    if (!isTrap(error)) throw error
    giveUp(wasm)
    throw new WarpError(trapSentence(method))
  } finally {
    if (!wasm.isBroken) job?.close()
    if (present && present.HEAPU8.length > mostKeptBytes) present = undefined
  }
}

/** The next call gets a new instance. */
function giveUp(wasm: MeshModule) {
  wasm.isBroken = true
  if (present === wasm) present = undefined
}

const trapSentence = (method: string) =>
  `${method}: the mesh is too large or too deeply nested to be handled here.`

function start(method: string): MeshModule {
  try {
    return getModule()
  } catch (cause) {
    if (cause instanceof WarpError) throw cause
    const error = new WarpError(
      `${method}: meshes need WebAssembly with exceptions, which every current browser has and this one lacks.`,
    )
    throw Object.assign(error, { cause })
  }
}

/** What a warp threw, which says nothing about this module, whatever it is. */
class Foreign {
  constructor(readonly error: unknown) {}
}

/** What stops a wasm module: a trap, no more stack, no more memory, or an exception of C++ that nothing caught. */
const isTrap = (error: unknown) =>
  error instanceof WebAssembly.RuntimeError ||
  error instanceof RangeError ||
  error instanceof WebAssembly.Exception
