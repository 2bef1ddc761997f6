// A warp in the vertex stage of a material of WebGPURenderer, on both its backends: positions, normals, tangents, and where the
// vertex was in the frame before, for velocities.
import type { Material, Mesh } from 'three'
import { shaderNames, variationAttribute, variationNames } from '../../compile/hosts.js'
import { functionFor, parameterNames, parametersOf } from './function.js'
import { type NodesByName, previousUniformsOf, uniformsOf } from './uniforms.js'
import type { ThreeWarp, Turned } from '../three-warp.js'
import { type Space, local, world } from './spaces.js'
import { type AnyNode, type Call, tsl } from './tsl.js'

/** The part of three's NodeBuilder that we use. It builds the shaders of an object. */
export interface Builder {
  context: Record<string, unknown>
  getFrontFacing(): string
  needsPreviousData(): boolean
  object: Mesh
  geometry: Mesh['geometry']
  material: Material
  renderer: { backend: { isWebGPUBackend?: boolean } }
}

/** The nodes of a warp, shared by all shaders that it is in. */
class WarpNodes {
  readonly uniforms: NodesByName
  private readonly functions = new Map<string, Call>()
  private previous: NodesByName | undefined

  constructor(private readonly warp: ThreeWarp) {
    this.uniforms = uniformsOf(warp)
  }

  get previousUniforms(): NodesByName {
    return (this.previous ??= { ...this.uniforms, ...previousUniformsOf(this.warp) })
  }

  call(turned: Turned, isWebGPU: boolean): Call {
    const key = `${isWebGPU} ${turned}`
    if (!this.functions.has(key)) this.functions.set(key, functionFor(this.warp, turned, isWebGPU))
    return this.functions.get(key)!
  }
}

const known = new WeakMap<ThreeWarp, WarpNodes>()

function nodesOf(warp: ThreeWarp): WarpNodes {
  let nodes = known.get(warp)
  if (!nodes) known.set(warp, (nodes = new WarpNodes(warp)))
  return nodes
}

/**
 * Adds a warp to the vertex that is being built. `setup` is what three.js does in its place: morph targets, bones,
 * displacement map, matrices of instances, and the material's `positionNode`, in this order. The warp follows all of them, but
 * in the space of the geometry it comes before the matrices of instances and the `positionNode` behind these, and in the space
 * 'rest' it comes first.
 */
export function setupWarped(
  warp: ThreeWarp,
  builder: Builder,
  material: { positionNode: unknown },
  setup: () => void,
) {
  const { object } = builder
  const { space } = warp.settings
  orientFaces(warp, builder)
  const instances = space === 'local' ? instancesOf(object) : undefined
  if (space === 'rest') moveVertex(warp, builder, local(tsl.positionPrevious))
  if (instances) withoutInstances(builder, material, setup)
  else setup()
  if (space === 'world') moveVertex(warp, builder, world(isPosed(object)))
  if (space === 'local')
    moveVertex(warp, builder, local(isSkinned(object) ? tsl.positionPrevious : tsl.positionLocal))
  if (!instances) return
  instances(object)
  if (material.positionNode) displace(builder, material.positionNode)
}

/** Applies a `positionNode` like three.js, and assumes that it displaced the vertex in the frame before as it does now. */
function displace(builder: Builder, positionNode: unknown) {
  const before = tsl.positionLocal.toVar()
  tsl.positionLocal.assign(tsl.subBuild(positionNode, 'POSITION', 'vec3'))
  if (builder.needsPreviousData()) tsl.positionPrevious.addAssign(tsl.positionLocal.sub(before))
}

/** Sets up all that comes before the matrices of instances, which three.js applies in its own `setup`. */
function withoutInstances(
  builder: Builder,
  material: { positionNode: unknown },
  setup: () => void,
) {
  const { object } = builder
  const { positionNode } = material
  const isNone = { value: false }
  builder.object = Object.create(object, { isInstancedMesh: isNone, isBatchedMesh: isNone })
  material.positionNode = null
  try {
    setup()
  } finally {
    builder.object = object
    material.positionNode = positionNode
  }
}

interface Kind {
  isSkinnedMesh?: boolean
  isInstancedMesh?: boolean
  isBatchedMesh?: boolean
  instanceMatrix?: { isInstancedBufferAttribute?: boolean }
}

const isSkinned = (object: object) => (object as Kind).isSkinnedMesh === true

/** Tests whether three.js has applied matrices of the frame before to `positionPrevious`. */
const isPosed = (object: object) => isSkinned(object) || instancesOf(object) !== undefined

/** Applies the matrices of instances; `undefined` for an object that has none. */
function instancesOf(object: object) {
  const { isBatchedMesh, isInstancedMesh, instanceMatrix } = object as Kind
  if (isBatchedMesh) return tsl.batch
  // Three.js leaves other matrices to the user, such as those that compute shaders write.
  const isOfThree = isInstancedMesh && instanceMatrix?.isInstancedBufferAttribute
  return isOfThree ? tsl.instancedMesh : undefined
}

/** Swaps front and back if the warp mirrors all of space: the renderer takes the outer side of a triangle for its back then. */
function orientFaces(warp: ThreeWarp, builder: Builder) {
  if (warp.mirrors === false || Object.hasOwn(builder, 'getFrontFacing')) return
  const getFrontFacing = builder.getFrontFacing.bind(builder)
  const orientation = nodesOf(warp).uniforms[shaderNames.orientation]!
  builder.getFrontFacing = () =>
    `( ${getFrontFacing()} == ( ${orientation.build(builder, 'float')} > 0.0 ) )`
}

function moveVertex(warp: ThreeWarp, builder: Builder, space: Space) {
  const { geometry, renderer } = builder
  const isWebGPU = renderer.backend.isWebGPUBackend === true
  const turned: Turned = geometry.hasAttribute('tangent')
    ? 'tangent'
    : geometry.hasAttribute('normal')
      ? 'normal'
      : 'position'
  const nodes = nodesOf(warp)
  const call = nodes.call(turned, isWebGPU)
  const parameters = parametersOf(warp, turned, isWebGPU)
  const resultFor = (position: AnyNode, uniforms: NodesByName) => {
    const inputs: Record<string, unknown> = {
      ...uniforms,
      ...inputsOf(builder, uniforms, space.isLocal),
      [parameterNames.position!]: position,
      ...(turned !== 'position' && { [parameterNames.normal!]: space.normal() }),
      ...(turned === 'tangent' && { [parameterNames.tangent!]: space.tangent() }),
    }
    return call(Object.fromEntries(parameters.map(([name]) => [name, inputs[name]])))
  }
  const position = (result: AnyNode) => (turned === 'position' ? result : result.element(0))
  if (builder.needsPreviousData())
    space.assignPrevious(position(resultFor(space.previous(), nodes.previousUniforms)))
  const result = resultFor(space.position, nodes.uniforms)
  space.assign(
    position(result),
    turned === 'position' ? undefined : result.element(1),
    turned === 'tangent' ? result.element(2) : undefined,
  )
}

/** Makes the arguments that are neither position, normal nor tangent. */
function inputsOf({ geometry, material }: Builder, uniforms: NodesByName, isLocal: boolean) {
  const { color } = geometry.attributes
  const variation = variationNames.map((name) => {
    const attribute = variationAttribute(name)
    const isThere = isLocal && geometry.hasAttribute(attribute)
    const node = isThere ? tsl.attribute(attribute, 'vec3') : tsl.vec3(0, 0, 0)
    return [parameterNames[name], node] as const
  })
  return {
    [parameterNames.uv!]: geometry.hasAttribute('uv') ? tsl.uv() : tsl.vec3(0, 0, 0),
    // Without colours of vertices the colour is the material's, as in WebGL.
    [parameterNames.color!]:
      color && material.vertexColors ? colorOf(color.itemSize) : uniforms.warpjetColor!,
    ...Object.fromEntries(variation),
  }
}

const colorOf = (size: number) => {
  const color = tsl.attribute('color', size === 4 ? 'vec4' : 'vec3')
  return size === 4 ? color : tsl.vec4(color, 1)
}

/**
 * A node for the `positionNode` of any material. Where the whole `positionNode` is such a node, `setupWarped` is used instead;
 * this is for one that is a part of other nodes.
 */
export const nodeFor = (warp: ThreeWarp): AnyNode =>
  tsl.Fn((builder: Builder) => {
    const { object } = builder
    const isWorld = warp.settings.space === 'world'
    const instances = isWorld ? undefined : instancesOf(object)
    orientFaces(warp, builder)
    if (instances) restoreGeometry(builder)
    moveVertex(warp, builder, isWorld ? world(isPosed(object)) : local(tsl.positionLocal))
    // Three.js has applied these matrices already, which come after the warp.
    instances?.(object)
    return tsl.positionLocal
  })()

function restoreGeometry({ geometry }: Builder) {
  tsl.positionLocal.assign(tsl.positionGeometry)
  if (geometry.hasAttribute('normal')) tsl.normalLocal.assign(tsl.normalGeometry)
  if (geometry.hasAttribute('tangent')) tsl.tangentLocal.assign(tsl.tangentGeometry.xyz)
}
