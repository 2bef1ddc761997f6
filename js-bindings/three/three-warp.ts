// A warp for three.js, of an object or a material: shader code for both renderers, and evaluation on the CPU at the time of the last
// `update`.
import {
  HostWarp,
  otherName,
  shaderNames,
  type FrameConstants,
  type HostOptions,
  type HostText,
  type NormalStage,
  type OffsetFunction,
  type Result,
  type Target,
  type Vertices,
} from '../compile/hosts.js'
import { Place } from '../options/place.js'
import { remembered } from './remembered.js'
import type { Settings } from './settings.js'
import { handlesOf, type UniformHandle } from './uniforms.js'
import { three } from './values.js'

/**
 * The last result of the code in the vertex stage: `'normal'` comes with the position, and `'tangent'` with the position and the normal.
 */
export type VertexStage = 'position' | 'normal' | 'tangent'

/** The results of the code in the vertex stage or in the fragment stage. */
export type Stage = VertexStage | 'normal of pixel' | 'tangent of pixel'

const resultsOf: Record<Stage, readonly Result[]> = {
  position: ['offset', 'position'],
  normal: ['offset', 'position', 'normal'],
  tangent: ['offset', 'position', 'normal', 'tangent'],
  'normal of pixel': ['normal'],
  'tangent of pixel': ['normal', 'tangent'],
}

interface Box {
  min: number[]
  max: number[]
  uvs?: { min: number[]; max: number[] } | undefined
}

/** Maps a variable of the shader that an offset reads by name → its type. */
export type OuterTypes = ReadonlyMap<string, string>

export class ThreeWarp extends HostWarp {
  /** Maps the user's names to uniforms, as three.js has them. */
  readonly handles: Readonly<Record<string, UniformHandle<unknown>>>
  /** The stage that computes normals. */
  readonly normals: NormalStage
  /** The input `millis`, in milliseconds. */
  readonly millis = { value: 0 }
  /** Returns whether the warp mirrors all of space with the current uniforms. */
  readonly isMirroredNow = remembered(
    () => this.numbers(),
    () => this.isMirrored(this.given),
  )
  private readonly texts = new Map<string, HostText>()
  private hash: string | undefined

  /** Calls the offset function. */
  constructor(
    offset: OffsetFunction,
    readonly settings: Settings,
    /** Present if the offset may read variables of the shader that are not uniforms. Contains those whose types the warp needs. */
    readonly outerTypes?: OuterTypes,
    others?: HostOptions['others'],
  ) {
    super(new Place(settings.method), offset, {
      host: outerTypes ? { ...three, hasParameters: true } : three,
      uniforms: settings.uniforms,
      target: 'glsl300',
      names: { millis: shaderNames.millis },
      fadeNoise: settings.fadeNoise,
      tangents: true,
      others,
      surfaceVariation: settings.surfaceVariation ?? true,
    })
    this.handles = handlesOf(settings.method, this.uniforms)
    this.normals = this.stageOfNormals(settings.normals)
  }

  textFor(target: Target, stage: Stage, names: Record<string, string>): HostText {
    const key = JSON.stringify([target, stage, names])
    let text = this.texts.get(key)
    if (!text) this.texts.set(key, (text = this.writeText(target, stage, names)))
    return text
  }

  /** Returns the current values of the inputs on which the position of a vertex depends. */
  numbers(): number[] {
    return this.state(this.given)
  }

  frameNow(): FrameConstants {
    return this.frame(this.given)
  }

  /** Warps vertices with the current uniforms. Results may contain numbers that are not finite. */
  evaluateNow(vertices: Vertices) {
    return this.evaluate(vertices, this.given)
  }

  /** Returns bounds of the warped positions, or of the offsets, of all points in a box, with the current uniforms. */
  boundsNow(result: 'position' | 'offset', box: Box) {
    return this.quickBounds(result, box, this.given)
  }

  /** Equal for warps that were recorded equally, and so have equal code. */
  get key(): string {
    return (this.hash ??= this.hashOfModule())
  }

  /** The names, in the vertex stage, of the numbers that the offset function computes in addition to the offset. */
  get otherNames(): readonly string[] {
    return this.others.map(otherName)
  }

  private get others(): Result[] {
    return Array.from({ length: this.recorded.otherCount }, (_, i): Result => `other${i}`)
  }

  private writeText(target: Target, stage: Stage, names: Record<string, string>): HostText {
    return stage === 'normal of pixel' || stage === 'tangent of pixel'
      ? this.fragmentText(target, resultsOf[stage], { names })
      : this.text(target, [...resultsOf[stage], ...this.others], { names })
  }

  /** The current values of the inputs of a draw call. */
  get given() {
    return { millis: this.millis.value }
  }

  private hashOfModule() {
    const types = this.uniforms.inShader.map(({ type }) => type)
    const outer = [...(this.outerTypes?.values() ?? [])]
    const { space, fadeNoise } = this.settings
    const { module, settings } = this.recorded
    const rest = [space, fadeNoise, settings.surfaceVariation, types, outer].join('\n')
    return hash([...module, ...Array.from(rest, (letter) => letter.charCodeAt(0))])
  }
}

/** Returns 64 bits: two hashes with different start values and factors. */
function hash(words: readonly number[]) {
  let [low, high] = [0x811c9dc5, 0x9747b28c]
  for (const word of words) {
    low = Math.imul(low ^ word, 0x01000193)
    high = Math.imul(high ^ word, 0x5bd1e995)
    high ^= high >>> 13
  }
  return `${(low >>> 0).toString(36)}${(high >>> 0).toString(36)}`
}
