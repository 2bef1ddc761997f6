/** GLSL that reads the gradients of normal and uv from attributes. */
import { variationAttribute, variationNames, type HostText } from '../../compile/hosts.js'

/** The attributes that a warp's code reads. */
export type TextOfVertex = Pick<HostText, 'attributes'>

/** Returns whether the code reads gradients of normal or uv. */
export const readsVariation = (text: TextOfVertex) => variationIn(text).length > 0

/** Maps each gradient to the variable that holds it, which `variationInGlsl` computes from the attribute. */
export const variationVariables = Object.fromEntries(
  variationNames.map((name) => [name, `warpjet_${name}`]),
)

/** Returns the gradients that the code reads. */
export const variationIn = ({ attributes }: TextOfVertex) =>
  attributes.flatMap(({ name }) => variationNames.filter((each) => each === name))

/** Declarations for a shader that reads any gradient. */
export const variationDeclarations = variationNames
  .map((name) => `IN vec3 ${variationAttribute(name)};`)
  .join('\n')

/**
 * Returns GLSL that computes the gradients from the attributes, in a space to which `matrix` transforms normals from the shape's own.
 * Such a matrix N is the inverse transpose of the one for positions. It transforms gradients like normals, and the derivative W of the
 * normal to N W Nᵀ. GLSL 1.00 has no `transpose`, hence `v * N`.
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
