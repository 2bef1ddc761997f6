// `bakeWarp`: a mesh as a warp leaves it.
import type { CpuWarp } from '../cpu-warp.js'
import { WarpError, describe } from '../errors.js'
import { type Mesh, type MeshInput, putMesh, takeMesh } from './mesh.js'
import { withJob } from './module.js'
import { takeVariation } from './variation.js'
import type { Uniforms, Vertices } from '../vertices.js'
import { type WarpProgram, warpProgram } from '../warp-program.js'

/** What of `compileWarp`'s result is used here. */
export interface Evaluates extends Pick<CpuWarp, 'evaluate'> {
  /** @internal */
  readonly [warpProgram]?: WarpProgram
}

/** Whether the warp wants to know how normals and uvs vary over the mesh. */
export const asksForVariation = (warp: Evaluates) => warp[warpProgram]?.varies ?? false

/**
 * The mesh with every vertex moved and every normal and tangent turned; all else is copied. Missing normals are computed
 * before, and how normals and uvs vary over the surface, if the warp depends on them. `warp` is what `compileWarp` returns. An empty mesh stays empty; 10 million triangles take some seconds. Throws
 * a `WarpError` if arrays do not fit together, a uniform is missing, the warp has no finite value at a vertex, or the
 * mesh is too large for the memory of the module (such as 40 million triangles).
 */
export function bakeWarp(mesh: MeshInput, warp: Evaluates, uniforms?: Uniforms): Mesh {
  checkWarp('bakeWarp', warp)
  const { copy, variation } = withJob('bakeWarp', (job) => {
    putMesh(job, mesh)
    job.act('addNormals')
    return { copy: takeMesh(job), variation: asksForVariation(warp) ? takeVariation(job) : {} }
  })
  const vertices = { ...copy, ...variation }
  const { positions, normals, tangents } = evaluateFor('bakeWarp', warp, vertices, uniforms)
  if (!normals)
    throw new WarpError(
      'bakeWarp: the warp was compiled with "normals: false", so that it turns none; compile it without.',
    )
  checkFinite('position', positions, 3, copy)
  checkFinite('normal', normals, 3, copy)
  if (!tangents) return { ...copy, positions, normals }
  checkFinite('tangent', tangents, 4, copy)
  return { ...copy, positions, normals, tangents }
}

export function checkWarp(method: string, warp: unknown) {
  if (typeof (warp as Evaluates | undefined)?.evaluate === 'function') return
  throw new WarpError(
    `${method}: the warp must be what compileWarp returns, but is ${describe(warp)}.`,
  )
}

/** `warp.evaluate`, whose sentences then name what the user called. */
export function evaluateFor(
  method: string,
  warp: Evaluates,
  vertices: Vertices,
  uniforms?: Uniforms,
) {
  try {
    return warp.evaluate({ ...vertices, uniforms })
  } catch (error) {
    if (!(error instanceof WarpError)) throw error
    throw new WarpError(error.message.replace(/^evaluate: /, `${method}: `))
  }
}

function checkFinite(name: string, numbers: Float32Array, size: number, { positions }: Mesh) {
  const i = numbers.findIndex((number) => !Number.isFinite(number))
  if (i < 0) return
  const vertex = Math.floor(i / size)
  const place = [...positions.subarray(3 * vertex, 3 * vertex + 3)].join(', ')
  throw new WarpError(
    `bakeWarp: the warp gives vertex ${vertex} at (${place}) no finite ${name}, but ${numbers[i]}; check what it does there, such as a division by 0.`,
  )
}
