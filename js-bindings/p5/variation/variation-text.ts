/** How normals and uvs vary over a shape, as text of a shader that is handed it by attributes. */
import { variationAttribute, variationNames } from '../../core/inputs/inputs.js'
import type { WarpText } from '../../compile/warp-text.js'

/** Whether the text reads how the surface varies. */
export const readsVariation = (text: WarpText) => variationIn(text).length > 0

/** What the text reads for each input: `variationIn` makes it of the attribute. */
export const variationVariables = Object.fromEntries(
  variationNames.map((name) => [name, `warpjet_${name}`]),
)

/** Those that the text reads. */
export const variationIn = ({ attributes }: WarpText) =>
  attributes.flatMap(({ name }) => variationNames.filter((each) => each === name))

/** GLSL for above a shader that reads any. */
export const variationDeclarations = variationNames
  .map((name) => `IN vec3 ${variationAttribute(name)};`)
  .join('\n')

/**
 * GLSL that makes them of the attributes, in a space that `matrix` turns normals to from the shape's own. By such a matrix N, the
 * inverse transpose of that for positions, gradients turn as normals do, and the derivative W of the normal becomes N W Nᵀ. GLSL
 * 1.00 has no `transpose`, but `v * N`.
 */
export function turnedVariation(matrix: string): string {
  const attributes = variationNames.map(variationAttribute)
  const turned = (attribute: string, i: number) => {
    if (!matrix) return attribute
    return `warpjetN * ${i < 3 ? `(mat3(${attributes.slice(0, 3)}) * (mat3(1.0)[${i}] * warpjetN))` : attribute}`
  }
  return (
    (matrix && `  mat3 warpjetN = ${matrix};\n`) +
    attributes
      .map((attribute, i) => `  vec3 warpjet_${variationNames[i]} = ${turned(attribute, i)};\n`)
      .join('')
  )
}
