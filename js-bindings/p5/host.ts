/**
 * What the addon touches of p5, the same on 2.x and 1.11 unless a comment says otherwise. p5's own types are not used:
 * 1.11 ships none, and nobody should need p5's types to use warpjet.
 */
import type { Texture } from './sampling.js'

export interface Uniform {
  readonly isArray?: boolean
  /** WebGL's number of the type. */
  readonly type?: number
  /** On WebGPU, where it lies among all, in bytes. */
  readonly offset?: number
  readonly offsetEnd?: number
  /** On WebGPU, of a mat3. */
  readonly packInPlace?: boolean
  /** Of an image that was set: what p5 draws with. */
  readonly texture?: Texture
}

/** What `modify` takes: the texts of hooks by their names, and more for which p5 has other names. */
export type Modifications = Record<string, unknown>

export interface Shader {
  readonly hooks: {
    readonly declarations?: string
    readonly vertex: Readonly<Record<string, string>>
    readonly fragment: Readonly<Record<string, string>>
    /** Those that `modify` has put there. */
    readonly modified: Record<'vertex' | 'fragment', Readonly<Record<string, boolean>>>
  }
  readonly uniforms: Record<string, Uniform | undefined>
  /** On 2.x; `GL` in WebGL, `getNextBindingIndex` on WebGPU. */
  readonly _renderer?: {
    readonly GL: { disableVertexAttribArray(location: number): void }
    readonly device?: unknown
    readonly registerEnabled: Set<number>
    getNextBindingIndex?(sources: { vert: string; frag: string }): number
  }
  /** On 2.x, before hooks. */
  _vertSrc?: string
  readonly _fragSrc?: string
  bindShader?: (...args: unknown[]) => void
  vertSrc(): string
  modify(hooks: Modifications): Shader
  /** On 1.11 takes a canvas. */
  ensureCompiledOnContext?(canvas: object): void
  setUniform(name: string, value: unknown): unknown
}

/** Such as a p5.Vector. */
export interface Vector {
  x: number
  y: number
  z: number
  /** Present on a p5.Vector. */
  copy?(): Vector
}

/** What is used of a p5.Geometry. */
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
  /** On 1.11. */
  readonly userPointShader?: Shader | null
  readonly curStrokeColor?: unknown
  readonly _useNormalMaterial?: boolean
  // Each call of fill, texture and the other materials makes one of these anew.
  readonly curFillColor?: unknown
  readonly curAmbientColor?: unknown
  readonly curEmissiveColor?: unknown
  readonly curSpecularColor?: unknown
  readonly _tex?: unknown
}

/** On 2.x, what push() and pop() keep. */
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

/** On 1.11 the material is a set of fields of the renderer itself, on 2.x it lies in `states`. */
export interface Renderer extends MaterialState {
  readonly isP3D?: boolean
  readonly GL?: unknown
  readonly webglVersion?: string
  /** On WebGPU. */
  readonly device?: unknown
  readonly states?: States
  /** On 1.11. */
  readonly _doStroke?: boolean
  _getPointShader?(): Shader
  readonly geometryBuilder?: GeometryBuilder
  /** What shapes hand to shaders: on 2.x, and on 1.11 for shapes that p5 keeps. */
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
  /** Not on WebGPU. */
  baseNormalShader(): Shader
  baseColorShader(): Shader
  baseStrokeShader(): Shader
  shader(shader: Shader): unknown
  /** On 2.x; 1.11's `shader` knows the kind. */
  strokeShader?(shader: Shader): unknown
  noStroke(): unknown
}

/** The sketch that a p5.Graphics belongs to: only it has a clock and a mouse. */
export const sketchOf = (canvas: Canvas): Canvas => canvas._pInst ?? canvas

export const stateOf = (renderer: Renderer): MaterialState => renderer.states ?? renderer

/** So that pop() brings back what was. */
export function setState(renderer: Renderer, name: keyof MaterialState, value: unknown) {
  if (renderer.states) renderer.states.setValue(name, value)
  else Object.assign(renderer, { [name]: value })
}

/** On 1.11, where points are not lines. */
export const pointShaderOf = (renderer: Renderer) => renderer._getPointShader?.()

/** For a warp's shader that p5 draws normals with: what else of the material there was then. */
const besideNormals = new WeakMap<Shader, unknown[]>()

/** To be called when a warp's shader was put on under `normalMaterial()`. */
export function rememberNormals(renderer: Renderer, shader: Shader) {
  besideNormals.set(shader, othersOf(stateOf(renderer)))
}

/**
 * Whether the sketch draws by `normalMaterial()`. p5 forgets it where a shader is put on, such as a warp's, and pop()
 * brings that shader back without it: so it holds as long as the shader is there and no other material came.
 */
export function drawsNormals(renderer: Renderer): boolean {
  const material = stateOf(renderer)
  if (material._useNormalMaterial) return true
  const others = material.userFillShader && besideNormals.get(material.userFillShader)
  return others?.every((value, i) => value === othersOf(material)[i]) ?? false
}

const othersOf = (material: MaterialState) => [
  material.curFillColor,
  material.curAmbientColor,
  material.curEmissiveColor,
  material.curSpecularColor,
  material._tex,
]

const removed = new WeakSet<Canvas>()

/** `remove()` leaves the renderer of a sketch in place, so the addon is told of it by p5's life cycle. */
export function sketchRemoved(this: Canvas) {
  removed.add(this)
}

/** The 3D renderer that `canvas` draws with at this moment, if it has one. */
export function rendererOf(canvas: Canvas): Renderer | undefined {
  const renderer = removed.has(sketchOf(canvas)) ? undefined : canvas._renderer
  return renderer?.isP3D && (renderer.GL || renderer.device) ? renderer : undefined
}
