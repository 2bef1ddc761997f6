// Warnings about inputs of a displacement that are treated as constant over the surface.
import type { BufferGeometry, Mesh, Object3D } from 'three'
import { variationAttribute, variationNames } from '../../compile/hosts.js'
import { noteApproximation } from '../../errors/notes.js'
import type { Displacement, ExactSettings } from './displacement.js'

/** The members of an ExactMaterial that warnings need. */
interface Noting {
  settings: ExactSettings
  warn: (message: string) => void
}

const instanceAttributes = new Set(['instanceMatrix', 'instanceColor', 'gl_InstanceID'])

const isInstanced = (attribute: object | undefined) => {
  const { isInstancedBufferAttribute, data } = (attribute ?? {}) as {
    isInstancedBufferAttribute?: boolean
    data?: { isInstancedInterleavedBuffer?: boolean }
  }
  return isInstancedBufferAttribute === true || data?.isInstancedInterleavedBuffer === true
}

/** Warns if the normals of an object are only approximate, since it is unknown how an attribute varies over the surface. */
export function noteConstants(
  exact: Noting,
  { warp, parameters }: Displacement,
  object: Object3D | undefined,
) {
  const { method, surfaceVariation } = exact.settings
  if (surfaceVariation === false) return
  const { attributes } = (object as Partial<Mesh> | undefined)?.geometry ?? ({} as BufferGeometry)
  const hasVariation = variationNames.some((name) => variationAttribute(name) in (attributes ?? {}))
  if (warp.varies && attributes && !hasVariation)
    noteApproximation(method, 'await addSurfaceVariation(geometry)')
  const isPerVertex = (name: string) =>
    attributes !== undefined && !instanceAttributes.has(name) && !isInstanced(attributes[name])
  const [first] = parameters.filter(({ isAttribute, name }) => isAttribute && isPerVertex(name))
  if (first)
    exact.warn(
      `moves vertices by the attribute ${first.name}, which counts as constant over the surface, so that its normals are approximate where that varies; surfaceVariation: false silences this.`,
    )
}
