// The spaces in which a warp moves the vertex of WebGPURenderer.
import { tsl, type AnyNode } from './tsl.js'

/** Converts the vertex into the space of the warp and back. */
export interface Space {
  isLocal: boolean
  position: AnyNode
  normal: () => AnyNode
  tangent: () => AnyNode
  /** The position in the previous frame, without the warp. */
  previous: () => AnyNode
  assignPrevious: (position: AnyNode) => void
  assign: (position: AnyNode, normal?: AnyNode, tangent?: AnyNode) => void
}

/** The space of three's `positionLocal`. */
export const local = (previous: AnyNode): Space => ({
  isLocal: true,
  position: tsl.positionLocal,
  normal: () => tsl.normalLocal,
  tangent: () => tsl.tangentLocal,
  previous: () => previous,
  assignPrevious: (position) => void tsl.positionPrevious.assign(position),
  assign(position, normal, tangent) {
    if (normal) tsl.normalLocal.assign(normal)
    if (tangent) tsl.tangentLocal.assign(tangent)
    tsl.positionLocal.assign(position)
  },
})

/** The space of three's `positionGeometry`, before morph targets, bones and instances. */
export const geometrySpace = (): Space => ({
  ...local(tsl.positionGeometry),
  position: tsl.positionGeometry,
  normal: () => tsl.normalGeometry,
  tangent: () => tsl.tangentGeometry.xyz,
})

/** The space of the world. `isPosed` is true if three.js has applied matrices of the previous frame to `positionPrevious`. */
export function world(isPosed: boolean): Space {
  const linear = () => tsl.mat3(tsl.modelWorldMatrix)
  const transform = (matrix: AnyNode, position: AnyNode) => matrix.mul(tsl.vec4(position, 1)).xyz
  const toWorldBefore = () => tsl.velocity.previousModelWorldMatrix
  return {
    isLocal: false,
    position: transform(tsl.modelWorldMatrix, tsl.positionLocal),
    // The length is 1, as for WebGLRenderer and rays; a zero normal stays zero.
    normal() {
      const normal = tsl.modelNormalMatrix.mul(tsl.normalLocal)
      return normal.div(tsl.max(tsl.length(normal), 1e-30))
    },
    tangent: () => linear().mul(tsl.tangentLocal),
    previous: () => transform(toWorldBefore(), isPosed ? tsl.positionPrevious : tsl.positionLocal),
    assignPrevious: (position) =>
      void tsl.positionPrevious.assign(transform(tsl.inverse(toWorldBefore()), position)),
    assign(position, normal, tangent) {
      if (normal) tsl.normalLocal.assign(linear().transpose().mul(normal))
      if (tangent) tsl.tangentLocal.assign(tsl.mat3(tsl.modelWorldMatrixInverse).mul(tangent))
      tsl.positionLocal.assign(transform(tsl.modelWorldMatrixInverse, position))
    },
  }
}
