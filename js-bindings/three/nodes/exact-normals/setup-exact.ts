// Adds the position and the exact normal of a material with `exactNormals` to the vertex shader that three.js is building.
import type { Material } from 'three'
import { variationAttribute } from '../../../compile/hosts.js'
import { WarpError } from '../../../errors/errors.js'
import { surfaceVariation } from '../../../mesh/surface-variation.js'
import { Place } from '../../../options/place.js'
import { nameOf, nameOfMaterial } from '../../describe.js'
import type { ThreeWarp } from '../../three-warp.js'
import { addVariation } from '../../variation.js'
import type { Builder } from '../builder.js'
import { isPosed } from '../instances.js'
import { pixelNormalsFor, type NormalMaterial } from '../pixel.js'
import { geometrySpace, local } from '../spaces.js'
import { tsl, type AnyNode } from '../tsl.js'
import { vertexNormalsFor } from '../vertex-normals.js'
import { moveVertex, roomForOthers } from '../vertex.js'
import type { ExactNodeMaterial } from './exact-node-materials.js'
import { ExactWarp } from './exact-warp.js'
import { previousValues } from './previous-values.js'
import { readPosition, siblingOf, sizeOfEffects, type PositionSource } from './read-position.js'
import { endWarmUp } from './warm-up.js'

const place = new Place('exactNormals')
const { method } = place

/**
 * Adds a material's `positionNode` to the vertex shader that is being built, as three.js does: after morph targets, bones, the displacement
 * map and the matrices of instances. If we cannot read the node, it moves the vertex as it would without `exactNormals`, and a console
 * warning gives the reason.
 * If the object also has a `warp`, normals are computed at vertices.
 */
export function displaceExactly(
  exact: ExactNodeMaterial,
  builder: Builder,
  material: NormalMaterial,
  positionNode: AnyNode,
  warp?: ThreeWarp,
) {
  // Shadows have no normals.
  if (!(material as { isShadowPassMaterial?: boolean }).isShadowPassMaterial) {
    try {
      return moveExactly(exact, builder, material, positionNode, warp)
    } catch (error) {
      if (!(error instanceof WarpError)) throw error
      warnOnce(
        exact,
        `the normals of ${nameOfMaterial(builder.material)} of ${nameOf(builder.object)} stay as they are: ${place.withoutMethod(error.message)}`,
      )
    }
  }
  tsl.positionLocal.assign(tsl.subBuild(positionNode, 'POSITION', 'vec3'))
}

function moveExactly(
  exact: ExactNodeMaterial,
  builder: Builder,
  material: NormalMaterial,
  positionNode: AnyNode,
  other: ThreeWarp | undefined,
) {
  endWarmUp()
  const source = readPosition(method, siblingOf(builder), positionNode)
  const warp = warpFor(exact, source, builder)
  checkBase(builder, source.base, warp, other)
  // Without operations and effects, the warp reads no result of the loop.
  if (warp.cutOff && (warp.operations() > 0 || warp.otherNames.length > 0))
    warnOnce(exact, `${nameOfMaterial(builder.material)} cuts off a loop: ${warp.cutOff}`)
  if (warp.varies) ensureVariation(builder)
  for (const node of source.updated) {
    builder.addNode(node)
    builder.addSequentialNode(node)
  }
  // The nodes of the values that the source reads from outside, in this frame.
  const current = warp.outerNodes(source)
  // If the object has another warp, the shader reads the normals of that warp.
  const vertexNormals = other ? undefined : vertexNormalsFor(builder, material)
  // Overwrites the normals that `vertexNormalsFor` has set.
  const pixel = pixelNormalsFor(warp, builder, material, {
    outer: current,
    obstacle: other && 'the mesh has a warp, too',
  })
  const vertex = pixel ? undefined : vertexNormals
  const space = source.base === 'geometry' ? geometrySpace() : local(tsl.positionPrevious)
  const { effects } = source
  // True if the function of the warp also returns the effects.
  const hasEffects = warp.otherNames.length > 0
  // If it does not return them, the shader must also evaluate the original node, which assigns these variables.
  const position =
    effects.length > 0 && !hasEffects
      ? tsl.subBuild(positionNode, 'POSITION', 'vec3').toVar()
      : undefined
  moveVertex(warp, builder, space, {
    pixel,
    vertex,
    outer: { now: current, before: previousValues(current) },
    position,
    others: hasEffects ? effects.map(({ node, variable }) => ({ node, size: variable!.size })) : [],
  })
  pixel?.replaceNormals()
  vertex?.pass()
}

/**
 * Maps the options and the code of a position without textures → its warp, or the message that says why it cannot be read as a
 * warp. Materials with the same displacement share its warp, since making it takes several milliseconds.
 */
const sharedWarps = new Map<string, ExactWarp | string>()
const maxShared = 32

const ids = new WeakMap<object, number>()
let nextId = 0

/** Returns a unique number for each object. */
function idOf(object: object): number {
  if (!ids.has(object)) ids.set(object, nextId++)
  return ids.get(object)!
}

/**
 * Returns the warp of a source. The warp also computes the effects if the result of its function has room for them and they can be
 * differentiated; otherwise it computes only the position.
 */
function warpFor(exact: ExactNodeMaterial, source: PositionSource, { geometry }: Builder) {
  const { textWithEffects: text, effects } = source
  if (text && sizeOfEffects(effects)! <= roomForOthers(geometry)) {
    const warp = cachedWarp(exact, source, text)
    // If this failed, the effects may read values that have no derivative. We try again without the effects.
    if (typeof warp !== 'string') return warp
  }
  const warp = cachedWarp(exact, source)
  if (typeof warp === 'string') throw new WarpError(warp)
  return warp
}

function cachedWarp(exact: ExactNodeMaterial, source: PositionSource, withEffects?: string) {
  const { functions, textures } = source
  // The source without its functions, whose order varies.
  const others = functions.reduce(
    (text, each) => text.replace(each, ''),
    withEffects ?? source.text,
  )
  // The warp reads the nodes of its textures, which may differ between sources with the same text.
  const key = [
    exact.key,
    ...[...functions].sort(),
    others,
    ...Array.from(textures.values(), idOf),
  ].join('\n')
  const warps = textures.size > 0 ? exact.warps : sharedWarps
  let warp = warps.get(key)
  if (!warp) warps.set(key, (warp = compile(exact, source, withEffects)))
  if (sharedWarps.size > maxShared) sharedWarps.delete(sharedWarps.keys().next().value!)
  return warp
}

/** Returns the warp of a source, or the message that says why it cannot be one. */
function compile({ settings }: ExactNodeMaterial, source: PositionSource, withEffects?: string) {
  try {
    return new ExactWarp(source, settings, withEffects)
  } catch (error) {
    if (error instanceof WarpError) return error.message
    throw error
  }
}

/**
 * Throws for some positions if something else moves the vertex first: bones, morph targets, a displacement map, instances or a warp. Such a
 * position must not read the vertex both before and after that, and its normals must not need the gradients of the moved normal or uv,
 * which are unknown.
 */
function checkBase(
  { object, geometry, material }: Builder,
  base: string,
  warp: ExactWarp,
  other: ThreeWarp | undefined,
) {
  const { displacementMap } = material as Material & { displacementMap?: unknown }
  const isWarpedBefore = other?.settings.space === 'rest'
  if (!isPosed(object) && !geometry.morphAttributes.position && !displacementMap && !isWarpedBefore)
    return
  if (base === 'both')
    throw new WarpError(
      `${method}: the positionNode reads both the vertex of the geometry and the one that bones, morph targets, a displacement map, instances or a warp have moved; expected one of them: positionLocal and normalLocal, or positionGeometry and normalGeometry.`,
    )
  if (warp.varies && base === 'posed')
    throw new WarpError(
      `${method}: the positionNode depends on normal or uv where bones, morph targets, a displacement map, instances or a warp have moved the vertex, and how these vary there is unknown; expected a function of the position, or of positionGeometry, normalGeometry and uv.`,
    )
}

/** Adds the gradients of normal and uv to the geometry, if it does not have them yet. */
function ensureVariation({ geometry }: Builder) {
  if (!geometry.hasAttribute(variationAttribute('normalXGradient')))
    addVariation(geometry, surfaceVariation)
}

function warnOnce({ warned }: ExactNodeMaterial, message: string) {
  if (warned.has(message)) return
  warned.add(message)
  console.warn(`${method}: ${message}`)
}
