/**
 * What the addon touches of p5, the same on 2.x and 1.11 unless a comment says otherwise. p5's own types are not used:
 * 1.11 ships none, and nobody should need p5's types to use warpjet.
 */

export interface Uniform {
  readonly isArray?: boolean
  /** WebGL's number of the type. */
  readonly type?: number
  /** Of an image that was set: what p5 draws with. */
  readonly texture?: { readonly width: number; readonly height: number }
}

export interface Shader {
  readonly hooks: { readonly vertex: Record<string, string> }
  readonly uniforms: Record<string, Uniform | undefined>
  /** On 2.x. */
  readonly _renderer?: {
    readonly GL: { disableVertexAttribArray(location: number): void }
    readonly registerEnabled: Set<number>
  }
  bindShader?: (...args: unknown[]) => void
  vertSrc(): string
  modify(hooks: Record<string, string>): Shader
  setUniform(name: string, value: unknown): unknown
}

interface MaterialState {
  readonly userFillShader?: Shader | null
  readonly _useNormalMaterial?: boolean
}

/** On 1.11 the material is a set of fields of the renderer itself, on 2.x it lies in `states`. */
export interface Renderer extends MaterialState {
  readonly isP3D?: boolean
  readonly GL?: unknown
  readonly webglVersion?: string
  readonly states?: MaterialState
}

/** Something a sketch draws on: the sketch itself or a p5.Graphics. */
export interface Canvas {
  readonly _renderer?: Renderer
  readonly _pInst?: Canvas
  readonly width: number
  readonly height: number
  readonly mouseX: number
  readonly mouseY: number
  millis(): number
  pixelDensity(): number
  baseMaterialShader(): Shader
  baseNormalShader(): Shader
  shader(shader: Shader): unknown
  noStroke(): unknown
}

/** The sketch that a p5.Graphics belongs to: only it has a clock and a mouse. */
export const sketchOf = (canvas: Canvas): Canvas => canvas._pInst ?? canvas

export const materialOf = (renderer: Renderer): MaterialState => renderer.states ?? renderer

const removed = new WeakSet<Canvas>()

/** `remove()` leaves the renderer of a sketch in place, so the addon is told of it by p5's life cycle. */
export function sketchRemoved(this: Canvas) {
  removed.add(this)
}

/** The WebGL renderer that `canvas` draws with at this moment, if it has one. */
export function webglOf(canvas: Canvas): Renderer | undefined {
  const renderer = removed.has(sketchOf(canvas)) ? undefined : canvas._renderer
  return renderer?.isP3D && renderer.GL ? renderer : undefined
}
