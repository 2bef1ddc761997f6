/**
 * Normals at each pixel with WebGPURenderer, on both its backends. The vertex stage passes the inputs of the warp as varyings. Before the
 * material's own nodes for normals run, the normal of the geometry is replaced by that of the warp at the interpolated inputs, so that
 * normal maps, both sides of faces and clearcoats use the warp's normal.
 */
import type { Texture } from 'three'
import { shaderNames } from '../../compile/hosts.js'
import { nameOf, nameOfMaterial } from '../describe.js'
import { warnOfVertices } from '../notes.js'
import type { Stage, ThreeWarp } from '../three-warp.js'
import type { Builder } from './builder.js'
import { normalizeOr, onBack } from './facing.js'
import { inputsOfStage, parameterNames, parametersOf } from './function.js'
import { instanceMatrixOf, instancesAfter, isSkinned } from './instances.js'
import { PackedVaryings, type VectorSize } from './packed-varyings.js'
import { tsl, type AnyNode } from './tsl.js'
import type { NodesByName } from './uniforms.js'
import { nodesOf } from './warp-nodes.js'

/** The part of a NodeMaterial that we use. */
export interface NormalMaterial {
  positionNode: unknown
  setupNormal(builder: Builder): unknown
}

/** Properties of a material that decide whether it reads normals, and vertex tangents. */
interface Maps {
  normalNode?: unknown
  normalMap?: unknown
  clearcoatNormalMap?: unknown
  anisotropy?: number
  anisotropyNode?: unknown
  isShadowPassMaterial?: boolean
}

interface PixelOptions {
  /** The nodes of variables of the shader that the warp reads by name. */
  outer?: NodesByName
  /** The reason, for a message, why normals stay at vertices; `undefined` if there is none. */
  obstacle?: string | false | undefined
}

/** Returns the object that computes a material's normals at each pixel; `undefined` if they are computed at vertices. */
export function pixelNormalsFor(
  warp: ThreeWarp,
  builder: Builder,
  material: NormalMaterial,
  options: PixelOptions = {},
): PixelNormals | undefined {
  const { geometry, object } = builder
  const hasNormals = geometry.hasAttribute('normal') && !builder.isFlatShading()
  // Facets stay facets, and shadows have no normals.
  if (warp.normals === 'vertex' || !hasNormals || (material as Maps).isShadowPassMaterial)
    return undefined
  const pixel = new PixelNormals(warp, builder, material, options.outer ?? {})
  const obstacle = options.obstacle || obstacleFor(warp, builder, material, pixel)
  if (!obstacle) return pixel
  if (warp.settings.normals === 'pixel')
    beforeNormals(builder, () =>
      warnOfVertices(warp, `${nameOfMaterial(builder.material)} of ${nameOf(object)}`, obstacle),
    )
  return undefined
}

/** Calls `work` when the material sets up its normals; never if the material reads no normals. */
function beforeNormals({ context }: Builder, work: () => void) {
  const setupNormal = context.setupNormal as () => unknown
  context.setupNormal = () => {
    work()
    return setupNormal()
  }
}

/** Returns the maximum number of varyings that the material's own nodes have. If the user added nodes, this is an estimate. */
function varyingsOfThree(material: NormalMaterial, hasTangents: boolean): number {
  const textures = Object.values(material).filter((value) => (value as Partial<Texture>)?.isTexture)
  const channels = new Set(textures.map(({ channel }: Texture) => channel))
  // Positions, the normal, colours, the first uv, and one for the user; the tangent and the bitangent; other uvs.
  return 6 + (hasTangents ? 2 : 0) + Math.max(0, channels.size - 1)
}

function obstacleFor(
  warp: ThreeWarp,
  { object, geometry, renderer: { backend } }: Builder,
  material: NormalMaterial,
  pixel: PixelNormals,
): string | undefined {
  const isChanged = isSkinned(object) || geometry.morphAttributes.normal || material.positionNode
  if (warp.settings.space === 'rest' && isChanged)
    return "bones, morph targets or a positionNode change normals after a warp in the space 'rest'"
  if (instancesAfter(warp.settings, object) && !instanceMatrixOf(object))
    return 'its shader has no room for the matrices of instances'
  const left = maxVaryings(backend) - varyingsOfThree(material, pixel.hasTangents)
  return pixel.varyingCount > left
    ? `it passes ${pixel.varyingCount} vectors to pixels, of which this device has ${left} left`
    : undefined
}

const maxVaryings = ({ device, gl }: Builder['renderer']['backend']): number =>
  device?.limits?.maxInterStageShaderVariables ??
  (gl ? (gl.getParameter(gl.MAX_VARYING_VECTORS) as number) : 16)

export class PixelNormals {
  private readonly stage: Stage
  private readonly isWebGPU: boolean
  readonly hasTangents: boolean
  /** The inputs of the warp. The fourth component of the normal is its length, since interpolation shortens the vector. */
  private readonly varyings: PackedVaryings
  /** The columns of the instance's matrix, which are the same at all vertices of the instance. */
  private readonly matrix: PackedVaryings | undefined

  constructor(
    private readonly warp: ThreeWarp,
    private readonly builder: Builder,
    private readonly material: NormalMaterial,
    /** The nodes of variables of the shader that the warp reads by name. */
    private readonly outer: NodesByName,
  ) {
    const { renderer, geometry, object } = builder
    const maps = material as Maps
    this.isWebGPU = renderer.backend.isWebGPUBackend === true
    this.hasTangents =
      geometry.hasAttribute('tangent') &&
      !!(
        maps.normalNode ||
        maps.normalMap ||
        maps.clearcoatNormalMap ||
        maps.anisotropy ||
        maps.anisotropyNode
      )
    this.stage = this.hasTangents ? 'tangent of pixel' : 'normal of pixel'
    this.varyings = new PackedVaryings(
      'warpjetPixel',
      new Map(
        inputsOfStage(warp, this.stage, this.isWebGPU).map(([input, type]) => [
          input,
          input === 'normal' ? 4 : sizes[type]!,
        ]),
      ),
    )
    if (instancesAfter(warp.settings, object))
      this.matrix = new PackedVaryings('warpjetInstance', columnSizes)
  }

  get varyingCount(): number {
    return this.varyings.count + (this.matrix?.count ?? 0)
  }

  /** Passes the inputs, in the vertex stage. */
  pass(inputs: Readonly<Record<string, unknown>>) {
    const read = inputsOfStage(this.warp, this.stage, this.isWebGPU)
    this.varyings.pass(
      new Map(
        read.map(([input]) => {
          const value = inputs[parameterNames[input]!] as AnyNode
          return [input, input === 'normal' ? tsl.vec4(value, tsl.length(value)) : value]
        }),
      ),
    )
  }

  /** Passes the matrix of the instance, in the vertex stage, after three.js has applied it. */
  passMatrix() {
    if (!this.matrix) return
    const matrix = instanceMatrixOf(this.builder.object)!().toVar()
    this.matrix.pass(
      new Map([...columnSizes.keys()].map((name, i) => [name, matrix.element(i).xyz])),
    )
  }

  /** Replaces the normals of the geometry before the material's own nodes for normals run. */
  replaceNormals() {
    const { builder, material } = this
    const { context } = builder
    let node: AnyNode | undefined
    const withNormals = tsl.Fn(() => {
      this.assignNormals()
      return material.setupNormal(builder)
    })
    context.setupNormal = () => (node ??= tsl.subBuild(withNormals(), 'NORMAL', 'vec3'))
  }

  private assignNormals() {
    const { builder } = this
    const result = this.call().toVar()
    const [normal, tangent] = this.hasTangents
      ? [result.element(0), result.element(1)]
      : [result, undefined]
    const viewNormal = this.toView(normal).toVar()
    const facing = normalizeOr(tsl.normalFlat, tsl.vec3(0, 0, 1))
    // Three.js negates the normals of back faces later.
    tsl.normalViewGeometry.assign(normalizeOr(viewNormal, onBack(builder, facing)))
    if (!tangent) return
    const viewTangent = this.tangentToView(tangent).toVar()
    const side = tsl.tangentGeometry.w.mul(this.orientation)
    const viewBitangent = viewNormal.cross(viewTangent).mul(side)
    tsl.tangentView.assign(onBack(builder, normalizeOr(viewTangent, tsl.vec3(1, 0, 0))))
    tsl.bitangentView.assign(onBack(builder, normalizeOr(viewBitangent, tsl.vec3(0, 1, 0))))
  }

  /** Returns the normal, or a matrix of normal and tangent, in the space of the offset. */
  private call(): AnyNode {
    const nodes = nodesOf(this.warp)
    const inputs: Record<string, unknown> = { ...nodes.uniforms, ...this.outer }
    for (const [input, value] of this.varyings.read())
      inputs[parameterNames[input]!] = input === 'normal' ? restoreLength(value.toVar()) : value
    const names = parametersOf(this.warp, this.stage, this.isWebGPU).map(([name]) => name)
    const call = nodes.call(this.stage, this.isWebGPU)
    return call(Object.fromEntries(names.map((name) => [name, inputs[name]])))
  }

  private toView(normal: AnyNode): AnyNode {
    if (this.warp.settings.space === 'world') return tsl.mat3(tsl.cameraViewMatrix).mul(normal)
    if (!this.matrix) return tsl.transformNormalToView(normal)
    const [x, y, z] = this.columns as [AnyNode, AnyNode, AnyNode]
    // The matrix that transforms normals is, up to scale, the matrix of cofactors.
    const cofactors = tsl.mat3(y.cross(z), z.cross(x), x.cross(y))
    const sign = tsl.sign(x.dot(y.cross(z)))
    return tsl.transformNormalToView(cofactors.mul(normal).mul(sign).normalize())
  }

  private tangentToView(tangent: AnyNode): AnyNode {
    if (this.warp.settings.space === 'world') return tsl.mat3(tsl.cameraViewMatrix).mul(tangent)
    const instanceTangent = this.matrix ? tsl.mat3(...this.columns).mul(tangent) : tangent
    return tsl.modelViewMatrix.mul(tsl.vec4(instanceTangent, 0)).xyz
  }

  private get columns(): AnyNode[] {
    return [...this.matrix!.read().values()]
  }

  private get orientation(): unknown {
    return this.warp.mirrors === false ? 1 : nodesOf(this.warp).uniforms[shaderNames.orientation]
  }
}

const sizes: Record<string, VectorSize> = { vec2: 2, vec3: 3, vec4: 4 }
const columnSizes = new Map<string, VectorSize>([
  ['x', 3],
  ['y', 3],
  ['z', 3],
])

const restoreLength = (normal: AnyNode) =>
  normal.xyz.mul(normal.w.div(tsl.max(tsl.length(normal.xyz), 1e-30)))
