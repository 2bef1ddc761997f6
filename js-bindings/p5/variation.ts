/**
 * How normals and uvs vary over a shape: p5 2.x keeps that with a p5.Geometry as properties of its vertices, and hands them
 * to the shader as attributes. 1.11 has no such properties.
 */
import { WarpError } from '../errors.js'
import { variationAttributes } from '../inputs.js'
import { noteApproximation } from '../notes.js'
import type { WarpText } from '../warp-text.js'
import type { Shader } from './host.js'
import { importMesh } from './mesh-module.js'
import type { WarpSpace } from './options.js'

let isUsed = false

/** Finds out how a geometry varies, and keeps it there, in place of what was there before. */
export async function addSurfaceVariation<Geometry>(geometry: Geometry): Promise<Geometry> {
  isUsed = true
  const { varyGeometry } = await importMesh('addSurfaceVariation')
  await withOwnErrors(() => varyGeometry(geometry))
  return geometry
}

/** Whether the text reads how the surface varies. */
export const readsVariation = ({ attributes }: WarpText) =>
  variationAttributes.some(([name]) => attributes.includes(name))

/** For a warp that does, when it is drawn with. */
export function noteUnlessUsed() {
  if (!isUsed) noteApproximation('createWarp', 'addSurfaceVariation(shape)')
}

/** What the text is to read: the attributes, or in a space other than their own what `variationIn` makes of them. */
export const variationNames = (space: WarpSpace) =>
  Object.fromEntries(
    variationAttributes.map(([name, text]) => [name, space === 'local' ? text : text.slice(1)]),
  )

export const variationDeclarations = variationAttributes
  .map(([, attribute]) => `IN vec3 ${attribute};`)
  .join('\n')

/**
 * In a space where normals come from local ones by the matrix `n`, the inverse transpose of that for positions: gradients
 * turn as normals do, and the derivative W of the normal becomes n W nᵀ. GLSL 1.00 has no `transpose`, but `v * n`.
 */
export function variationIn(space: WarpSpace): string {
  if (space === 'local') return ''
  const n = space === 'world' ? 'uModelNormalMatrix' : 'uNormalMatrix'
  const column = (axis: string) => `${n} * (warpjetShape * (vec3(${axis}) * ${n}))`
  const names = variationNames(space)
  const [d, o, u, v] = variationAttributes.map(([, attribute]) => attribute)
  return `  mat3 warpjetShape = mat3(${d}.x, ${o}.zy, ${o}.z, ${d}.y, ${o}.x, ${o}.yx, ${d}.z);
  warpjetShape = mat3(${column('1, 0, 0')}, ${column('0, 1, 0')}, ${column('0, 0, 1')});
  vec3 ${names.shapeDiagonal} = vec3(warpjetShape[0].x, warpjetShape[1].y, warpjetShape[2].z);
  vec3 ${names.shapeOffDiagonal} = vec3(warpjetShape[1].z, warpjetShape[0].zy);
  vec3 ${names.uGradient} = ${n} * ${u}, ${names.vGradient} = ${n} * ${v};
`
}

/** p5 leaves the attributes of the last shape on for one that lacks them, which is then to read zeros. */
export function forgetLastShape(shader: Shader) {
  const bind = shader.bindShader!
  shader.bindShader = (...args) => {
    bind.apply(shader, args)
    const { registerEnabled, GL } = shader._renderer!
    for (const location of registerEnabled) GL.disableVertexAttribArray(location)
    registerEnabled.clear()
  }
}

/** The other module has a `WarpError` of its own. */
export async function withOwnErrors<Result>(work: () => Result): Promise<Awaited<Result>> {
  try {
    return await work()
  } catch (error) {
    const { name, message } = error as Error
    if (name !== 'WarpError') throw error
    throw new WarpError(message.replaceAll('loadMesh', 'loadWarpModel'))
  }
}
