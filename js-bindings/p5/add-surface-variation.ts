/**
 * How normals and uvs vary over a shape: p5 2.x keeps that with a p5.Geometry as properties of its vertices, and hands them
 * to the shader as attributes. 1.11 has no such properties.
 */
import { WarpError } from '../checks/errors.js'
import { variationAttribute, variationInputs, variationNames } from '../inputs/inputs.js'
import { noteApproximation } from '../checks/notes.js'
import type { WarpText } from '../compile/warp-text.js'
import type { Shader } from './host.js'
import { importMesh } from './mesh-module.js'
import type { WarpSpace } from './settings.js'

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
  attributes.some(({ name }) => name in variationInputs)

/** For a warp that does, when it is drawn with. */
export function noteUnlessUsed() {
  if (!isUsed) noteApproximation('createWarp', 'addSurfaceVariation(shape)')
}

/** What the text reads for each input: `variationIn` makes it of the attribute. */
export const variationVariables = Object.fromEntries(
  variationNames.map((name) => [name, `warpjet_${name}`]),
)

export const variationDeclarations = variationNames
  .map((name) => `IN vec3 ${variationAttribute(name)};`)
  .join('\n')

/** In p5 2.x, what turns normals from the shape's own space to another. */
const normalMatrices = { local: '', world: 'uModelNormalMatrix', camera: 'uNormalMatrix' }

/**
 * By such a matrix N, the inverse transpose of that for positions, gradients turn as normals do, and the derivative W of the
 * normal becomes N W Nᵀ. GLSL 1.00 has no `transpose`, but `v * N`.
 */
export function variationIn(space: WarpSpace): string {
  const n = normalMatrices[space]
  const attributes = variationNames.map(variationAttribute)
  const turned = (attribute: string, i: number) => {
    if (!n) return attribute
    const axis = ['1, 0, 0', '0, 1, 0', '0, 0, 1'][i]
    return `${n} * ${axis ? `(mat3(${attributes.slice(0, 3)}) * (vec3(${axis}) * ${n}))` : attribute}`
  }
  return attributes
    .map((attribute, i) => `  vec3 warpjet_${variationNames[i]} = ${turned(attribute, i)};\n`)
    .join('')
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
