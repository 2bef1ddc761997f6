// `bakeNormalMap`: applies a warp to a mesh on the CPU, and writes the exact warped normals between the vertices into an image.
import { encode } from 'fast-png'
import { snapshotUniforms } from '../core/inputs/declared-uniforms.js'
import type { Uniforms } from '../core/inputs/vertices.js'
import type { EvaluationOptions } from '../cpu/cpu-warp.js'
import { warpProgram } from '../cpu/warp-program.js'
import { anything, oneOf, wholeNumber } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import { warpMesh, type WarpedMesh } from './bake.js'
import { warpKind, type Evaluates } from './evaluates.js'
import { withJob } from './job.js'
import { putMesh, type Mesh, type MeshOrGeometry } from './mesh-arrays.js'
import { coverTexels } from './normal-map/cover.js'
import { fillEmptyTexels } from './normal-map/fill.js'
import type { FrameKind } from './normal-map/frames.js'
import { paintNormals } from './normal-map/paint.js'
import { splitByTangents, type Surface } from './normal-map/surface.js'
import { UvTriangles } from './normal-map/uv-triangles.js'

export interface NormalMapOptions extends EvaluationOptions {
  /**
   * The width and height of the image in texels, from 1 to 8192.
   * @default 1024
   */
  size?: number | undefined
  /**
   * The way in which the program that draws the mesh interpolates the mesh's tangent frame between vertices. `'normalized'`, for three.js:
   * computes the bitangents of vertices, and normalizes tangent, bitangent and normal at each pixel. `'mikktspace'`, for Blender: computes
   * the bitangent at the pixel, and normalizes none of the three. The finer the mesh, the less the two ways differ.
   * @default 'normalized'
   */
  frames?: FrameKind | undefined
}

/** The range of `size`: some GPUs support no larger texture. */
export const sizeRange = { min: 1, max: 8192 }

export const frameKind = oneOf(['normalized', 'mikktspace'], 'normalized')

const place = new Place('bakeNormalMap')
const bakedWarp = warpKind()
const optionsKind = object({
  size: wholeNumber({ ...sizeRange, default: 1024 }),
  frames: frameKind,
  uniforms: anything<Uniforms>(),
} satisfies KindsOf<NormalMapOptions>)

/**
 * The max fraction of the covered texels that may belong to several triangles. A larger overlap is no mere inaccuracy of the unwrapping.
 */
const maxOverlap = 0.01

/**
 * Returns the warped mesh as `bakeWarp` does, with a normal map that holds the exact warped normals between its vertices: the texel at a
 * point of the surface has the normal that the warp computes for the interpolated rest position, normal, uv and colour of this point. So
 * a coarse mesh is lit like a fine one after `exportGLB`, in any program.
 *
 * The map is a PNG in `material.normalTexture`, which replaces an earlier one; it is in tangent space, in glTF's conventions. `tangents`
 * are those of MikkTSpace for the warped mesh; a vertex is duplicated where its triangles have different tangents, at the border of
 * mirrored uvs for example, and vertices without a triangle are left out. For a geometry of three.js the result is a mesh too, since a
 * geometry has no material; its morph targets are left out.
 *
 * The uvs must not overlap, since each texel has one normal; a small overlap causes a warning in `warnings`. Between the parts of the
 * image that triangles cover, normals are continued, so that filtering and mipmaps blend in no other colours. A normal more than 90
 * degrees from the interpolated one cannot be stored; the nearest storable normal is stored. 8 bits per channel round normals by up to
 * 0.4 degrees.
 *
 * Throws a `WarpError` where `bakeWarp` does, and for a mesh without triangles or uvs, for uvs that overlap at more than 1% of the texels
 * or cover none, and for a warp that has no finite value at the centre of a texel.
 *
 * @example
 * const baked = bakeNormalMap(mesh, warp, { size: 1024, uniforms: { millis: 1200 } })
 * const bytes = exportGLB(baked)
 */
export function bakeNormalMap(
  mesh: MeshOrGeometry,
  warp: Evaluates,
  options?: NormalMapOptions,
): Mesh {
  bakedWarp.read(warp, place.part('the warp'))
  const { size, frames, uniforms: values } = optionsKind.read(options, place)
  const uniforms = snapshotUniforms(place, warp[warpProgram]?.declared, values)
  const surface = unwrappedSurface(warpMesh(place, mesh, warp, uniforms))
  const triangles = new UvTriangles(surface.warped.uvs, surface.warped.indices, size)
  const { owners, covered, overlapping } = coverTexels(triangles)
  if (!covered)
    throw place.error(
      `the uvs cover no texel of ${size} × ${size}; ${adviceToUnwrap}, or raise the size.`,
    )
  const overlap = overlapping / covered
  if (overlap > maxOverlap)
    throw place.error(
      `expected uvs that do not overlap, since each texel has one normal, got ${percentOf(overlap)} of the texels with several triangles; ${adviceToUnwrap}.`,
    )
  const texels = paintNormals({ place, surface, triangles, owners, warp, uniforms, frames })
  fillEmptyTexels(texels, owners, size)
  const bytes = encode({ width: size, height: size, channels: 3, data: texels })
  return withNormalTexture(surface.warped, bytes, overlap)
}

const adviceToUnwrap =
  'unwrap the model so that each triangle has its own place in the image, such as by Lightmap Pack in Blender'

const percentOf = (fraction: number) => `${Number((100 * fraction).toPrecision(2))}%`

/** Returns the surface with the vertices that the file will have, and with the normals that `exportGLB` writes. */
function unwrappedSurface({ rest, warped }: WarpedMesh): Surface {
  const { uvs, indices, positions } = warped
  if (!(indices ?? positions).length)
    throw place.error('the mesh has no triangles, but a normal map needs at least one.')
  if (!uvs)
    throw place.error(
      `the mesh has no uvs, which place a normal map on its triangles; ${adviceToUnwrap}.`,
    )
  const normals = withJob(place, (job) => {
    putMesh(job, warped)
    job.act('normalizeNormals')
    return job.floats('normals')
  })
  return splitByTangents(rest, { ...warped, normals, uvs })
}

function withNormalTexture(mesh: Mesh, bytes: Uint8Array, overlap: number): Mesh {
  const { material = { baseColor: [1, 1, 1, 1] } } = mesh
  const normalTexture = { bytes, mimeType: 'image/png' }
  const baked: Mesh = { ...mesh, material: { ...material, normalTexture } }
  if (overlap > 0)
    baked.warnings = [
      `The uvs overlap at ${percentOf(overlap)} of the texels, which have the normal of one of their triangles.`,
    ]
  return baked
}
