// A warp for three.js, whatever it is put on: texts for both renderers, and the same warp on the CPU, at the time of `update`.
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

/** The last of position, normal and tangent that a text computes. */
export type VertexStage = 'position' | 'normal' | 'tangent'

/** The results of a text in the vertex stage, or in the fragment stage. */
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
  /** In milliseconds. */
  readonly millis = { value: 0 }
  /** `true` if it mirrors all of space with the present uniforms. */
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
    /** Present if the offset may read variables of the shader that are not uniforms. Has those whose types matter. */
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

  /** The numbers that the place of a vertex depends on now. */
  numbers(): number[] {
    return this.state(this.given)
  }

  frameNow(): FrameConstants {
    return this.frame(this.given)
  }

  /** Moves vertices with the present uniforms. Some may have numbers that are not finite. */
  evaluateNow(vertices: Vertices) {
    return this.evaluate(vertices, this.given)
  }

  /** Bounds of the places that the warp makes of a box now, or of how far it moves them. */
  boundsNow(place: 'position' | 'offset', box: Box) {
    return this.quickBounds(place, box, this.given)
  }

  /** Warps with equal code have equal keys, if it was recorded equally. */
  get key(): string {
    return (this.hash ??= this.hashOfModule())
  }

  /** The names in the vertex stage of the numbers that the offset function has computed beside the offset. */
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

  /** The values of a draw call now. */
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

/** 64 bits, of two hashes that begin and multiply differently. */
function hash(words: readonly number[]) {
  let [low, high] = [0x811c9dc5, 0x9747b28c]
  for (const word of words) {
    low = Math.imul(low ^ word, 0x01000193)
    high = Math.imul(high ^ word, 0x5bd1e995)
    high ^= high >>> 13
  }
  return `${(low >>> 0).toString(36)}${(high >>> 0).toString(36)}`
}
