// `subdivide`: more triangles, where a warp needs them.
import type { CpuWarp } from '../cpu/cpu-warp.js'
import { WarpError, describe } from '../errors/errors.js'
import { checkOptions } from '../options/options.js'
import { settled } from '../core/inputs/declared-uniforms.js'
import type { Uniforms } from '../core/inputs/vertices.js'
import { warpProgram } from '../cpu/warp-program.js'
import { type Evaluates, asksForVariation, checkWarp, evaluateFor } from './bake.js'
import { type Geometry, isGeometry } from '../core/inputs/geometry.js'
import { type Plain, finerGeometry } from './geometry.js'
import { type Mesh, type MeshInput, type MeshOrGeometry, putMesh, takeMesh } from './mesh-arrays.js'
import { type Job, withJob } from '../wasm/mesh.js'
import { mostTriangles, usualTriangles } from '../wasm/mesh-tables.js'
import { variationOf } from './surface-variation.js'

interface Limit {
  /** Never more than so many; 1,048,576 unless given. */
  maxTriangles?: number
}

export interface AdaptiveOptions extends Limit {
  /** What `compileWarp` returns. */
  warp: Evaluates
  /** Of the warp. */
  uniforms?: Uniforms
  /** How far the warped surface may leave its triangles, in units of the model. It is looked at in samples, so that what is
   * narrower than a 200th of the mesh can be missed. */
  tolerance: number
  /** How far, in radians, warped normals may turn away from those between corners: 0.17 (10 degrees) unless given.
   * Infinity leaves normals out. */
  angle?: number
}

export interface LevelsOptions extends Limit {
  /** How often each triangle becomes four. */
  levels: number
}

/**
 * The same surface with more vertices, not warped yet. Edges are split until the warped triangles are as near to the
 * warped surface as `tolerance` says, only where that is needed; or, with `levels`, everywhere. No cracks come up, and
 * new vertices lie between the old ones in every attribute. If `maxTriangles` ends it before, `warnings` says so. A mesh
 * without triangles comes back as it is. A `BufferGeometry` of three.js comes back as one, with all its attributes, morph
 * targets and groups, and the warnings in its `userData`. Throws a `WarpError` for wrong options, arrays that do not fit together, and a
 * result that does not fit into the 4 GB of the module.
 */
export function subdivide<Given extends Geometry>(
  geometry: Given,
  options: AdaptiveOptions | LevelsOptions,
): Plain<Given>
export function subdivide(mesh: MeshInput, options: AdaptiveOptions | LevelsOptions): Mesh
export function subdivide(
  given: MeshOrGeometry,
  options: AdaptiveOptions | LevelsOptions,
): unknown {
  if (typeof options !== 'object' || options === null)
    throw new WarpError(
      `subdivide: options such as { warp, tolerance: 0.01 } or { levels: 2 } were expected, but ${describe(options)} came.`,
    )
  const known = 'levels' in options ? ['levels'] : ['warp', 'uniforms', 'tolerance', 'angle']
  checkOptions('subdivide', options, [...known, 'maxTriangles'])
  const { maxTriangles = usualTriangles } = options
  checkNumber(
    'maxTriangles',
    maxTriangles,
    `a whole number from 1 to 2^${Math.log2(mostTriangles)}`,
    isCount,
  )
  const refine =
    'levels' in options ? uniformly(options, maxTriangles) : adaptively(options, maxTriangles)
  return withJob('subdivide', (job) => {
    putMesh(job, given)
    job.act('addNormals')
    refine(job)
    const warnings = job.texts()
    const mesh = warnings.length ? { ...takeMesh(job), warnings } : takeMesh(job)
    if (!isGeometry(given)) return mesh
    const [ends, triangles] = [job.indices('ends'), job.indices('triangles')]
    return finerGeometry(given, mesh, { ends, triangles })
  })
}

const isCount = (value: number) => Number.isInteger(value) && value >= 1 && value <= mostTriangles

function uniformly({ levels }: LevelsOptions, maxTriangles: number) {
  checkNumber(
    'levels',
    levels,
    'a whole number from 0 to 15',
    (value) => Number.isInteger(value) && value >= 0 && value <= 15,
  )
  return (job: Job) => job.refineUniformly(levels, maxTriangles)
}

function adaptively(options: AdaptiveOptions, maxTriangles: number) {
  const { warp, tolerance, angle = 0.17 } = options
  checkWarp('subdivide', warp)
  const { declared } = (warp as Partial<CpuWarp>)[warpProgram] ?? {}
  const uniforms = settled('subdivide', declared, options.uniforms)
  checkNumber('tolerance', tolerance, 'a number above 0', (value) => value > 0 && value < Infinity)
  checkNumber('angle', angle, 'a number above 0', (value) => value > 0)
  return (job: Job) => {
    const varies = asksForVariation(warp)
    if (varies) job.act('addVariation')
    let givesNormals: boolean | undefined
    job.refine(tolerance, angle, maxTriangles, (vertices) => {
      // Tangents are not looked at, so none need be turned.
      const mesh = {
        ...takeMesh(vertices),
        ...(varies && variationOf(vertices)),
        tangents: undefined,
      }
      const warped = evaluateFor('subdivide', warp, mesh, uniforms)
      givesNormals ??= warped.normals !== undefined
      if (givesNormals !== (warped.normals !== undefined))
        throw new WarpError(
          "subdivide: the warp's evaluate must give normals each time that it is called or never, but gave them only sometimes.",
        )
      vertices.setFloats('positions', warped.positions)
      vertices.setFloats('normals', warped.normals ?? [])
    })
  }
}

function checkNumber(
  name: string,
  value: unknown,
  expected: string,
  isRight: (value: number) => boolean,
) {
  if (typeof value === 'number' && isRight(value)) return
  throw new WarpError(
    `subdivide: the option "${name}" must be ${expected}, but is ${describe(value)}.`,
  )
}
