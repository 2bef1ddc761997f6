/**
 * Types for the parts of p5 that the addon uses, which are the same on 2.x and 1.11 unless a comment says otherwise. We don't use
 * p5's own types: 1.11 ships none, and using warpjet must not require them.
 */
import type { Texture } from './sampling.js'

export interface Uniform {
  readonly isArray?: boolean
  /** The WebGL enum of the type. */
  readonly type?: number
  /** The byte offset in the uniform buffer (WebGPU only). */
  readonly offset?: number
  readonly offsetEnd?: number
  /** Present on a mat3 (WebGPU only). */
  readonly packInPlace?: boolean
  /** The texture that p5 made of the image, once an image was set. */
  readonly texture?: Texture
}

/** The argument of p5's `modify`: hook name → source of the hook, and other entries such as declarations. */
export type Modifications = Record<string, unknown>

export interface Shader {
  readonly hooks: {
    readonly declarations?: string
    readonly vertex: Readonly<Record<string, string>>
    readonly fragment: Readonly<Record<string, string>>
    /** Hooks that `modify` has replaced. */
    readonly modified: Record<'vertex' | 'fragment', Readonly<Record<string, boolean>>>
  }
  readonly uniforms: Record<string, Uniform | undefined>
  /** Present on 2.x; `GL` on WebGL only, `getNextBindingIndex` on WebGPU only. */
  readonly _renderer?: {
    readonly GL: { disableVertexAttribArray(location: number): void }
    readonly device?: unknown
    readonly registerEnabled: Set<number>
    getNextBindingIndex?(sources: { vert: string; frag: string }): number
  }
  /** The source before hooks are inserted (2.x only). */
  _vertSrc?: string
  readonly _fragSrc?: string
  bindShader?: (...args: unknown[]) => void
  vertSrc(): string
  fragSrc(): string
  modify(hooks: Modifications): Shader
  /** Takes a canvas on 1.11. */
  ensureCompiledOnContext?(canvas: object): void
  setUniform(name: string, value: unknown): unknown
}

/** A p5.Vector, or an object like it. */
export interface Vector {
  x: number
  y: number
  z: number
  /** Present on a p5.Vector. */
  copy?(): Vector
}

/** The members of a p5.Geometry that the addon uses. */
export interface Shape {
  gid?: string
  vertices: Vector[]
  vertexNormals: Vector[]
  uvs: number[] | number[][]
  faces: number[][]
}

interface MaterialState {
  readonly userFillShader?: Shader | null
  readonly userStrokeShader?: Shader | null
  /** 1.11 only. */
  readonly userPointShader?: Shader | null
  readonly curStrokeColor?: unknown
  readonly _useNormalMaterial?: boolean
  // Each call of fill(), texture() and the other materials makes a new value for one of these.
  readonly curFillColor?: unknown
  readonly curAmbientColor?: unknown
  readonly curEmissiveColor?: unknown
  readonly curSpecularColor?: unknown
  readonly _tex?: unknown
}

/** The state that push() and pop() save and restore on 2.x. */
interface States extends MaterialState {
  readonly strokeColor?: unknown
  setValue(name: string, value: unknown): void
}

/** p5's RenderBuffer: it passes an attribute of shapes to shaders. */
export interface ShapeBuffer {
  readonly attr?: string
}

/** p5's GeometryBuilder: it collects shapes while buildGeometry() runs. */
export interface GeometryBuilder {
  readonly geometry: BuiltShape
  addGeometry(shape: BuiltShape): void
}

export interface BuiltShape extends Shape {
  vertexColors: number[]
}

/** On 1.11 the material's fields are in the renderer itself, on 2.x in its `states`. */
export interface Renderer extends MaterialState {
  readonly isP3D?: boolean
  readonly GL?: { readonly MAX_VARYING_VECTORS: number; getParameter(name: number): number }
  readonly webglVersion?: string
  /** WebGPU only. */
  readonly device?: { readonly limits?: { readonly maxInterStageShaderVariables?: number } }
  readonly states?: States
  /** 1.11 only. */
  readonly _doStroke?: boolean
  _getPointShader?(): Shader
  readonly geometryBuilder?: GeometryBuilder
  /** Attributes of shapes; 2.x has them here, 1.11 in `retainedMode`. */
  readonly buffers?: { readonly fill: ShapeBuffer[] }
  readonly retainedMode?: {
    readonly buffers: { readonly fill: ShapeBuffer[] }
    readonly geometry: Record<string, { readonly model?: unknown }>
  }
}

/** Something a sketch draws on: the sketch itself or a p5.Graphics. */
export interface Canvas {
  readonly _renderer?: Renderer
  readonly _pInst?: Canvas
  readonly _isGlobal?: boolean
  readonly frameCount?: number
  readonly width: number
  readonly height: number
  readonly mouseX: number
  readonly mouseY: number
  millis(): number
  pixelDensity(): number
  baseMaterialShader(): Shader
  /** Missing on WebGPU. */
  baseNormalShader(): Shader
  baseColorShader(): Shader
  baseStrokeShader(): Shader
  shader(shader: Shader): unknown
  /** 2.x only; on 1.11 `shader` recognizes shaders of strokes. */
  strokeShader?(shader: Shader): unknown
  noStroke(): unknown
}

/** Returns the sketch that a p5.Graphics belongs to; only a sketch has a clock and a mouse. */
export const sketchOf = (canvas: Canvas): Canvas => canvas._pInst ?? canvas

export const stateOf = (renderer: Renderer): MaterialState => renderer.states ?? renderer

/** Sets a field of the material such that pop() restores the previous value. */
export function setState(renderer: Renderer, name: keyof MaterialState, value: unknown) {
  if (renderer.states) renderer.states.setValue(name, value)
  else Object.assign(renderer, { [name]: value })
}

/** Returns the shader of points on 1.11; `undefined` on 2.x, which draws points as lines. */
export const pointShaderOf = (renderer: Renderer) => renderer._getPointShader?.()

/** Maps a shader of a warp that draws normals → the other fields of the material when the shader was applied. */
const materialBesideNormals = new WeakMap<Shader, unknown[]>()

/** Records that a warp's shader was applied under `normalMaterial()`. */
export function rememberNormals(renderer: Renderer, shader: Shader) {
  materialBesideNormals.set(shader, otherFieldsOf(stateOf(renderer)))
}

/**
 * Returns whether the sketch draws by `normalMaterial()`. p5 resets that flag when it applies a shader, such as a warp's, and pop()
 * restores the shader without the flag. Hence `normalMaterial()` holds while the shader is in use and no other material was set.
 */
export function drawsNormals(renderer: Renderer): boolean {
  const material = stateOf(renderer)
  if (material._useNormalMaterial) return true
  const others = material.userFillShader && materialBesideNormals.get(material.userFillShader)
  return others?.every((value, i) => value === otherFieldsOf(material)[i]) ?? false
}

const otherFieldsOf = (material: MaterialState) => [
  material.curFillColor,
  material.curAmbientColor,
  material.curEmissiveColor,
  material.curSpecularColor,
  material._tex,
]

/** p5's name of the shape between beginShape() and endShape(), which is a different one each time. */
export const immediateShape = '__IMMEDIATE_MODE_GEOMETRY__'

const removed = new WeakSet<Canvas>()

/** Records that p5 removed the sketch: its renderer stays in place after `remove()`, so p5's life cycle calls this. */
export function markSketchRemoved(this: Canvas) {
  removed.add(this)
}

/** Returns the 3D renderer that `canvas` currently draws with; `undefined` if it has none. */
export function rendererOf(canvas: Canvas): Renderer | undefined {
  const renderer = removed.has(sketchOf(canvas)) ? undefined : canvas._renderer
  return renderer?.isP3D && (renderer.GL || renderer.device) ? renderer : undefined
}
