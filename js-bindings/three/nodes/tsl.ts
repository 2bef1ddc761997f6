// The nodes of 'three/tsl' that a warp uses, with looser types: three.js' types depend on the type of a node's value, which is not known
// for a function that is written as shader code.
import type { Mesh, Texture } from 'three'
import * as TSL from 'three/tsl'

/** A node of three.js. */
export interface AnyNode {
  build(builder: unknown, type: string): string
  assign(value: unknown): AnyNode
  addAssign(value: unknown): AnyNode
  sub(value: unknown): AnyNode
  mul(value: unknown): AnyNode
  div(value: unknown): AnyNode
  element(i: number): AnyNode
  transpose(): AnyNode
  toVar(): AnyNode
  toStack(): AnyNode
  cross(value: unknown): AnyNode
  dot(value: unknown): AnyNode
  negate(): AnyNode
  greaterThan(value: unknown): AnyNode
  normalize(): AnyNode
  mod(value: unknown): AnyNode
  add(value: unknown): AnyNode
  x: AnyNode
  y: AnyNode
  z: AnyNode
  xz: AnyNode
  xyz: AnyNode
  w: AnyNode
}

/** The object that three.js passes to updates of nodes, one per renderer. */
export interface Frame {
  frameId: number
  object: Mesh
}

/** A node that calls a function with arguments by name. */
export type Call = (inputs: Record<string, unknown>) => AnyNode

interface Nodes {
  positionLocal: AnyNode
  positionPrevious: AnyNode
  positionGeometry: AnyNode
  normalLocal: AnyNode
  normalGeometry: AnyNode
  tangentLocal: AnyNode
  tangentGeometry: AnyNode
  modelWorldMatrix: AnyNode
  modelWorldMatrixInverse: AnyNode
  modelNormalMatrix: AnyNode
  modelViewMatrix: AnyNode
  cameraViewMatrix: AnyNode
  normalViewGeometry: AnyNode
  normalFlat: AnyNode
  tangentView: AnyNode
  bitangentView: AnyNode
  faceDirection: AnyNode
  instanceIndex: AnyNode
  drawIndex: AnyNode
  time: AnyNode
  /** Missing in older versions. */
  batchIndirectIndex: AnyNode | undefined
  referenceAttribute: ((name: string, type: string) => AnyNode) | undefined
  varyingProperty(type: string, name: string): AnyNode
  transformNormalToView(normal: AnyNode): AnyNode
  select(condition: AnyNode, value: unknown, other: unknown): AnyNode
  sign(value: unknown): AnyNode
  int(value: unknown): AnyNode
  ivec2(...values: unknown[]): AnyNode
  textureLoad(texture: Texture, at?: AnyNode): AnyNode
  textureSize(texture: AnyNode, level: number): AnyNode
  velocity: { previousModelWorldMatrix: AnyNode }
  Fn(work: (builder: never) => unknown): () => AnyNode
  Loop(range: object, body: (counters: { i: AnyNode }) => void): AnyNode
  float(value: unknown): AnyNode
  sin(value: unknown): AnyNode
  mx_cell_noise_float(at: unknown): AnyNode
  mx_noise_float(at: unknown): AnyNode
  wgslFn(code: string, includes?: unknown[]): Call
  glslFn(code: string, includes?: unknown[]): Call
  wgsl(code: string): unknown
  glsl(code: string): unknown
  uniform(value: unknown): {
    onObjectUpdate(work: (frame: Frame, self: { value: unknown }) => unknown): AnyNode
  }
  texture(texture: Texture): AnyNode
  attribute(name: string, type: string): AnyNode
  uv(): AnyNode
  length(value: unknown): AnyNode
  max(...values: unknown[]): AnyNode
  inverse(matrix: unknown): AnyNode
  vec2(...values: unknown[]): AnyNode
  vec3(...values: unknown[]): AnyNode
  vec4(...values: unknown[]): AnyNode
  mat3(...values: unknown[]): AnyNode
  subBuild(node: unknown, name: string, type: string): AnyNode
  instancedMesh(object: unknown): AnyNode
  batch(object: unknown): AnyNode
}

export const tsl = TSL as unknown as Nodes
