// A warp in the vertex stage of a material of WebGPURenderer, on both its backends: positions, normals, tangents, and positions in the
// previous frame, for velocities.
import type { BufferGeometry } from 'three'
import { shaderNames, variationAttribute, variationNames } from '../../compile/hosts.js'
import { nameOf } from '../describe.js'
import { warnOfVertices } from '../notes.js'
import type { ThreeWarp, VertexStage } from '../three-warp.js'
import type { Builder } from './builder.js'
import { otherPlaces, parameterNames, parametersOf } from './function.js'
import { instancesOf, isPosed, isSkinned, withoutInstances } from './instances.js'
import { pixelNormalsFor, type NormalMaterial, type PixelNormals } from './pixel.js'
import { local, world, type Space } from './spaces.js'
import { tsl, type AnyNode } from './tsl.js'
import type { NodesByName } from './uniforms.js'
import { vertexNormalsFor, type VertexNormals } from './vertex-normals.js'
import { nodesOf } from './warp-nodes.js'

/** The source of normals at pixels: the warp, or the interpolation of vertices. */
interface Normals {
  pixel?: PixelNormals | undefined
  vertex?: VertexNormals | undefined
}

/**
 * Adds a warp to the vertex that is being built. `setup` is three.js' own method, which applies morph targets, bones, the
 * displacement map, the matrices of instances, and the material's `positionNode`, in this order. The warp comes after all of these,
 * with two exceptions. In the space 'rest' it comes first. In the space 'local' of an object with instances, it comes before the matrices
 * of instances and the `positionNode`. `displaceExactly` applies a `positionNode` with exact normals, which `setup` leaves out.
 */
export function setupWarped(
  warp: ThreeWarp,
  builder: Builder,
  material: NormalMaterial,
  setup: () => void,
  displaceExactly?: () => void,
) {
  const { object } = builder
  const { space } = warp.settings
  const instances = space === 'local' ? instancesOf(object) : undefined
  const isDisplacedLater = displaceExactly && (space === 'rest' || instances)
  const vertexNormals = vertexNormalsFor(builder, material)
  // Called after `vertexNormalsFor`, whose normals it replaces.
  const pixel = pixelNormalsFor(warp, builder, material, {
    obstacle: isDisplacedLater && 'a positionNode with exactNormals changes normals after the warp',
  })
  const vertex = pixel ? undefined : vertexNormals
  const normals = { pixel, vertex }
  orientFaces(warp, builder)
  if (space === 'rest') moveVertex(warp, builder, local(tsl.positionPrevious), normals)
  if (instances) withoutInstances(builder, material, setup)
  else {
    setup()
    displaceExactly?.()
  }
  // True if `displaceExactly` has assigned `positionPrevious`.
  const isDisplaced = displaceExactly !== undefined && !instances
  if (space === 'world') moveVertex(warp, builder, world(isDisplaced || isPosed(object)), normals)
  if (space === 'local') {
    const previous = isDisplaced || isSkinned(object) ? tsl.positionPrevious : tsl.positionLocal
    moveVertex(warp, builder, local(previous), normals)
  }
  instances?.(object)
  pixel?.passMatrix()
  if (instances && material.positionNode)
    (displaceExactly ?? (() => displace(builder, material.positionNode)))()
  pixel?.replaceNormals()
  vertex?.pass()
}

/** Applies a `positionNode` like three.js, and assumes that it displaced the vertex in the previous frame as it does now. */
function displace(builder: Builder, positionNode: unknown) {
  const before = tsl.positionLocal.toVar()
  tsl.positionLocal.assign(tsl.subBuild(positionNode, 'POSITION', 'vec3'))
  if (builder.needsPreviousData()) tsl.positionPrevious.addAssign(tsl.positionLocal.sub(before))
}

/** Swaps front and back if the warp mirrors all of space: then the renderer takes the outer side of a triangle for its back. */
function orientFaces(warp: ThreeWarp, builder: Builder) {
  if (warp.mirrors === false || Object.hasOwn(builder, 'getFrontFacing')) return
  const getFrontFacing = builder.getFrontFacing.bind(builder)
  const orientation = nodesOf(warp).uniforms[shaderNames.orientation]!
  builder.getFrontFacing = () =>
    `( ${getFrontFacing()} == ( ${orientation.build(builder, 'float')} > 0.0 ) )`
}

/** Nodes of the variables of the shader that a warp reads by name: their values in this frame and in the previous one. */
export interface OuterNodes {
  now: NodesByName
  before: NodesByName
}

const noOuterNodes: OuterNodes = { now: {}, before: {} }

export interface MoveOptions extends Normals {
  outer?: OuterNodes
  /** The new position, if another node computes it. */
  position?: AnyNode | undefined
  /** The variables that get the other results of the warp (`ThreeWarp.otherNames`), in order. */
  others?: readonly { node: AnyNode; size: number }[]
}

const stageOf = (geometry: BufferGeometry): VertexStage =>
  geometry.hasAttribute('tangent')
    ? 'tangent'
    : geometry.hasAttribute('normal')
      ? 'normal'
      : 'position'

/** Calls the warp in the vertex stage and assigns what it returns. */
export function moveVertex(
  warp: ThreeWarp,
  builder: Builder,
  space: Space,
  { pixel, vertex, outer = noOuterNodes, position, others = [] }: MoveOptions,
) {
  const { geometry, renderer } = builder
  const isWebGPU = renderer.backend.isWebGPUBackend === true
  const stage = stageOf(geometry)
  const nodes = nodesOf(warp)
  const inputsFor = (position: AnyNode, uniforms: NodesByName): Record<string, unknown> => ({
    ...uniforms,
    ...inputsOf(builder, uniforms, space.isLocal),
    [parameterNames.position!]: position,
    ...(stage !== 'position' && { [parameterNames.normal!]: space.normal() }),
    ...(stage === 'tangent' && { [parameterNames.tangent!]: space.tangent() }),
  })
  const resultFor = (position: AnyNode, uniforms: NodesByName) => {
    const inputs = inputsFor(position, uniforms)
    const names = parametersOf(warp, stage, isWebGPU).map(([name]) => name)
    return nodes.call(
      stage,
      isWebGPU,
    )(Object.fromEntries(names.map((name) => [name, inputs[name]])))
  }
  const hasOthers = warp.otherNames.length > 0
  const columnOf = (result: AnyNode, i: number) =>
    hasOthers ? result.element(i).xyz : stage === 'position' ? result : result.element(i)
  const positionOf = (result: AnyNode) => columnOf(result, 0)
  if (builder.needsPreviousData()) {
    const uniforms = { ...nodes.previousUniforms, ...outer.before }
    space.assignPrevious(positionOf(resultFor(space.previous(), uniforms)))
  }
  const uniforms = { ...nodes.uniforms, ...outer.now }
  pixel?.pass(inputsFor(space.position, uniforms))
  // Pixels compute their own normals.
  if (position && (pixel || stage === 'position')) return space.assign(position)
  const rest = stage === 'position' ? undefined : space.normal().toVar()
  const call = resultFor(space.position, uniforms)
  // Assigning the position changes the argument of the call.
  const result = hasOthers ? call.toVar() : call
  if (rest) vertex?.mark(columnOf(result, 1), rest)
  space.assign(
    position ?? positionOf(result),
    stage === 'position' ? undefined : columnOf(result, 1),
    stage === 'tangent' ? columnOf(result, 2) : undefined,
  )
  if (hasOthers && !position) assignOthers(result, stage, others)
}

/** The number of vectors that the function returns. */
const vectorCounts: Record<VertexStage, number> = { position: 1, normal: 2, tangent: 3 }

/** The number of other results, each a float, that the function for a geometry can return. */
export const roomForOthers = (geometry: BufferGeometry) =>
  otherPlaces(vectorCounts[stageOf(geometry)]).length

function assignOthers(
  result: AnyNode,
  stage: VertexStage,
  variables: readonly { node: AnyNode; size: number }[],
) {
  const places = otherPlaces(vectorCounts[stage]).values()
  for (const { node, size } of variables) {
    const numbers = Array.from({ length: size }, () => {
      const [column, row] = places.next().value!
      return result.element(column)[(['x', 'y', 'z', 'w'] as const)[row]!]
    })
    node.assign(size === 1 ? numbers[0] : tsl[`vec${size as 2 | 3 | 4}`](...numbers))
  }
}

/** Makes the arguments that are neither position, normal nor tangent. */
function inputsOf({ geometry, material }: Builder, uniforms: NodesByName, isLocal: boolean) {
  const { color } = geometry.attributes
  const variation = variationNames.map((name) => {
    const attribute = variationAttribute(name)
    const isPresent = isLocal && geometry.hasAttribute(attribute)
    const node = isPresent ? tsl.attribute(attribute, 'vec3') : tsl.vec3(0, 0, 0)
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
 * Returns a node for the `positionNode` of any material. It is evaluated only where it is a part of other nodes: if it is the whole
 * `positionNode`, `setupWarped` is used instead.
 */
export const nodeFor = (warp: ThreeWarp): AnyNode =>
  tsl.Fn((builder: Builder) => {
    const { object } = builder
    const isWorld = warp.settings.space === 'world'
    const instances = isWorld ? undefined : instancesOf(object)
    if (warp.settings.normals === 'pixel')
      warnOfVertices(warp, nameOf(object), 'its node is only a part of a positionNode')
    orientFaces(warp, builder)
    if (instances) restoreGeometry(builder)
    moveVertex(warp, builder, isWorld ? world(isPosed(object)) : local(tsl.positionLocal), {})
    // Three.js has applied the matrices of instances already, but they belong after the warp.
    instances?.(object)
    return tsl.positionLocal
  })()

function restoreGeometry({ geometry }: Builder) {
  tsl.positionLocal.assign(tsl.positionGeometry)
  if (geometry.hasAttribute('normal')) tsl.normalLocal.assign(tsl.normalGeometry)
  if (geometry.hasAttribute('tangent')) tsl.tangentLocal.assign(tsl.tangentGeometry.xyz)
}
