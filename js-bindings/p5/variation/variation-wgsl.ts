/** WGSL that reads the gradients of normal and uv from attributes. We add these to the shader's source, since p5's hooks cannot. */
import { variationAttribute, variationNames, type VariationInput } from '../../compile/hosts.js'
import { WarpError } from '../../errors/errors.js'
import type { Shader } from '../host.js'
import type { WarpSpace } from '../settings.js'
import { variationIn, variationVariables, type TextOfVertex } from './variation-text.js'

/** A WebGPU vertex shader may have 8 buffers, of which p5 uses 4. */
const maxBuffers = 4

const isOfNormal = (name: string) => name.startsWith('normal')

/** Declares globals for attributes: `main` takes attributes in a struct, which hooks cannot access. */
export const privatesFor = (names: readonly VariationInput[]) =>
  names.map((name) => `var<private> ${variationAttribute(name)}_: vec3<f32>;`)

/**
 * Adds the attributes to the struct and copies them into the globals. Throws a `WarpError` with the message `tooMany` if there are too
 * many.
 */
export function addAttributes(
  shader: Pick<Shader, '_vertSrc'>,
  names: readonly VariationInput[],
  tooMany: string,
) {
  if (names.length === 0) return
  if (names.length > maxBuffers) throw new WarpError(tooMany)
  const fields = names.map(
    (name, i) => `  @location(${4 + i}) ${variationAttribute(name)}: vec3<f32>,\n`,
  )
  const globals = names.map(
    (name) => `  ${variationAttribute(name)}_ = input.${variationAttribute(name)};\n`,
  )
  shader._vertSrc = shader
    ._vertSrc!.replace(/(struct VertexInput \{[^}]*)\}/, `$1${fields.join('')}}`)
    .replace('HOOK_beforeVertex();', `${globals.join('')}  HOOK_beforeVertex();`)
}

/** A warp's code and the space of its offset. */
interface InSpace {
  text: TextOfVertex
  space: WarpSpace
}

/** Returns the attributes that the code reads. Outside the shape's own space, each gradient of the normal depends on all three. */
export function attributesOf({ text, space }: InSpace) {
  const read = variationIn(text)
  const needsWholeNormal = space !== 'local' && read.some(isOfNormal)
  return variationNames.filter(
    (name) => read.includes(name) || (needsWholeNormal && isOfNormal(name)),
  )
}

/** Returns the WGSL for what `variationInGlsl` computes. The matrix `cameraMatrix` transforms normals to view space. */
export function variationInWgsl(warpCode: InSpace, cameraMatrix = 'model.uNormalMatrix'): string {
  const { space } = warpCode
  const names = attributesOf(warpCode)
  if (names.length === 0) return ''
  const attributeOf = (name: string) => `${variationAttribute(name)}_`
  const matrix = { local: '', world: 'model.uModelNormalMatrix', camera: cameraMatrix }[space]
  const lines = names.map((name) => {
    if (!matrix) return attributeOf(name)
    if (!isOfNormal(name)) return `warpjetNormalMatrix * ${attributeOf(name)}`
    const row = 'XYZ'.indexOf(name[6]!)
    const gradients = ['X', 'Y', 'Z'].map((axis) => `normal${axis}Gradient`)
    const terms = gradients
      .map(
        (each, i) =>
          names.includes(each as never) &&
          `${attributeOf(each)} * warpjetNormalMatrix[${i}][${row}]`,
      )
      .filter(Boolean)
    return `warpjetNormalMatrix * (${terms.join(' + ')})`
  })
  return (
    (matrix && `  let warpjetNormalMatrix = ${matrix};\n`) +
    names.map((name, i) => `  let ${variationVariables[name]} = ${lines[i]};\n`).join('')
  )
}
