/** GLSL that reads the gradients of normal and uv from attributes. */
import { variationAttribute, variationNames, type HostText } from '../../compile/hosts.js'

/** The code of a warp, of which only the list of attributes that it reads is needed here. */
export type TextOfVertex = Pick<HostText, 'attributes'>

/** Returns whether the code reads gradients of normal or uv. */
export const readsVariation = (text: TextOfVertex) => variationIn(text).length > 0

/** Maps each gradient to the variable that holds it, which `variationInGlsl` computes from the attribute. */
export const variationVariables = Object.fromEntries(
  variationNames.map((name) => [name, `warpjet_${name}`]),
)

/** Returns the names of the gradients that the code reads. */
export const variationIn = ({ attributes }: TextOfVertex) =>
  attributes.flatMap(({ name }) => variationNames.filter((each) => each === name))

/** Declarations for a shader that reads any gradient. */
export const variationDeclarations = variationNames
  .map((name) => `IN vec3 ${variationAttribute(name)};`)
  .join('\n')

/**
 * Returns GLSL that computes the gradients from the attributes and transforms them by `matrix`, which transforms normals from the space of
 * the shape to that of the hook. If `matrix` is empty, the gradients stay in the space of the shape. Such a matrix N is the inverse
 * transpose of the one for positions. It maps a gradient g to N g, and the derivative W of the normal, whose columns are the first three
 * attributes, to N W Nᵀ. GLSL 1.00 has no `transpose`, hence `v * N`.
 */
export function variationInGlsl(matrix: string): string {
  const attributes = variationNames.map(variationAttribute)
  const transformAttribute = (attribute: string, i: number) => {
    if (!matrix) return attribute
    return `warpjetNormalMatrix * ${i < 3 ? `(mat3(${attributes.slice(0, 3)}) * (mat3(1.0)[${i}] * warpjetNormalMatrix))` : attribute}`
  }
  return (
    (matrix && `  mat3 warpjetNormalMatrix = ${matrix};\n`) +
    attributes
      .map(
        (attribute, i) =>
          `  vec3 warpjet_${variationNames[i]} = ${transformAttribute(attribute, i)};\n`,
      )
      .join('')
  )
}
