// Binds the uniforms and attributes of GLSL source to expressions.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import type { Session } from '../core/expression/session.js'
import type { TypeName } from '../core/expression/shapes.js'
import { drawInputs, inputSizes, markWhole, variationInputs } from '../core/inputs/inputs.js'
import type { Vec4, WarpInputs } from '../core/types/types.js'
import { isExpression } from '../errors/describe.js'
import { describe, describeShape } from '../errors/errors.js'
import type { Place } from '../options/place.js'
import { floatConversions, instanceID } from './function-text.js'
import { Columns, Halves, halvesOf, type GlslValue } from './halves.js'
import type { External, Named } from './listing.js'
import { article } from './options.js'
import type { ReplayInputs } from './replay.js'

/** Inputs that source cannot name. */
const hiddenInputs = new Set(['tangent', ...Object.keys(variationInputs)])

/** Maps the inputs that source can name → their types in GLSL. */
export const inputTypes: Readonly<Record<string, string>> = Object.assign(
  Object.create(null) as object,
  Object.fromEntries(
    Object.entries({ ...inputSizes, mouseX: 1, mouseY: 1, width: 1, height: 1 })
      .filter(([name]) => !hiddenInputs.has(name))
      .map(([name, size]) => [name, size === 1 ? 'float' : `vec${size}`]),
  ),
)

/** Options for `texture()` of GLSL, from an image that has a `HostSampling`. */
const hostSamplingOptions = { transform: false }
/** Options for `texture()` of GLSL, from an image whose sampler is known only in the shader. */
const shaderSamplerOptions = { wrap: 'sampler' }

/** The inputs of an offset function, all optional. */
export type Inputs = Partial<WarpInputs>

export const inputNamed = (inputs: Inputs, name: string) =>
  inputs[name as keyof WarpInputs] as unknown as Expression | undefined

/**
 * Binds uniforms and attributes by name: to a uniform that the sketch declared, to an input of the same type such as `millis`, or to a
 * variable of the host's shader.
 */
export function bindExternals(
  place: Place,
  glsl: Builder,
  externals: readonly External[],
  inputs: Inputs,
): Pick<ReplayInputs, 'external' | 'texture' | 'imageSize'> {
  const declared = (inputs.uniforms ?? {}) as unknown as Record<string, unknown>
  const isDeclared = (name: string) => Object.hasOwn(declared, name)
  const values = new Map<number, GlslValue>()
  const findValue = (external: External): GlslValue => {
    const { name, type, isAttribute } = external
    if (!isAttribute && isDeclared(name)) {
      if (isInteger(type)) (declared as WithMark)[markWhole]?.(name)
      return toDeclaredValue(place, glsl, external, declared[name])
    }
    if (isAttribute && name === instanceID)
      return inputNamed(inputs, 'instance') ?? parameterOf(place, glsl, external)
    const input = inputTypes[name] === type && inputNamed(inputs, name)
    // A uniform can only be a whole input of a draw call: a uniform with the name of a component, such as height of `size`, means
    // something else.
    if (input && (isAttribute || Object.hasOwn(drawInputs, name))) return input
    if (!isAttribute) {
      rejectInputName(place, glsl, external)
      return parameterOf(place, glsl, external)
    }
    throw place.error(
      `the attribute ${name} has no value; a warp knows position, normal, uv, color and ${instanceID}.`,
    )
  }
  const imageOf = (index: number) => {
    const { name } = externals[index]!
    return isDeclared(name) ? declared[name] : name
  }
  const imageSize = (index: number) =>
    (glsl.val!(0).session as Session).imageSize(String(imageOf(index)))
  const external = (index: number) => {
    let value = values.get(index)
    if (!value) values.set(index, (value = findValue(externals[index]!)))
    return value
  }
  // Uniforms that cancel out in the result are read too, so that `evaluate` accepts values for them.
  for (const [index, { name, type, isAttribute }] of externals.entries())
    if (!isAttribute && isParameter(type) && !isDeclared(name) && !Object.hasOwn(inputSizes, name))
      external(index)
  return {
    external,
    texture(index, coordinates, isFetched) {
      const image = imageOf(index)
      const { samplings } = glsl.val!(0).session as Session
      if (!isFetched)
        return glsl.texture!(
          image,
          coordinates,
          samplings.has(String(image)) ? hostSamplingOptions : shaderSamplerOptions,
        )
      const uv = glsl.div!(glsl.add!(coordinates, 0.5), imageSize(index))
      return glsl.texture!(image, uv, { filter: 'nearest', wrap: 'clamp', transform: false })
    },
    imageSize,
  }
}

/**
 * Throws for a uniform with a name that the shader of a warp uses for an input, or, in WGSL, with a name of GLSL such as gl_VertexID, which
 * WGSL lacks.
 */
function rejectInputName(place: Place, glsl: Builder, { name }: Named) {
  const [root = ''] = /^\w+/.exec(name) ?? []
  const { target, inputNames } = glsl.val!(0).session as Session
  const input = inputNames.get(root)
  if (input !== undefined)
    throw place.error(
      `the uniform ${root} has the name of an input, ${input}; rename it in the source, such as my${root[0]!.toUpperCase()}${root.slice(1)}.`,
    )
  if (root.startsWith('gl_') && target === 'wgsl')
    throw place.error(`WGSL has no ${root}; pass its value in a uniform.`)
}

function toDeclaredValue(
  place: Place,
  glsl: Builder,
  { name, type, shape }: External,
  declared: unknown,
): GlslValue {
  if (typeof declared === 'string')
    throw place.error(
      `the uniform ${name}: expected ${article(type)}, as declared in the source, got an image.`,
    )
  if (typeof declared !== 'number' && !isExpression(declared))
    throw place
      .part(`the uniform ${name}`)
      .expected('a number or an expression', describe(declared))
  if (typeof declared === 'number' && /^u?int$/.test(type)) return halvesOf(glsl, declared)
  const value = typeof declared === 'number' ? glsl.val!(declared) : (declared as Expression)
  const declaredShape = value.session.shapeOf(value)
  if (`${declaredShape}` === `${shape}`) return value
  // Four numbers in the option `uniforms` have become a vec4, although the source declares a matrix.
  if (type === 'mat2' && `${declaredShape}` === '1,4') {
    const { x, y, z, w } = value as unknown as Vec4
    return glsl.mat2!(x(), y(), z(), w())
  }
  throw place.error(
    `the uniform ${name}: expected ${article(type)}, as declared in the source, got ${describeShape(declaredShape)}.`,
  )
}

const isInteger = (type: string) => /^(?:u?int|[iu]vec\d)$/.test(type)

/** The method that core/inputs/uniform-expressions.ts defines: it marks a uniform as one that holds integers. */
interface WithMark {
  [markWhole]?: (name: string) => void
}

const parameterTypes = /^(float|vec|mat|u?int|bool|[iub]vec)(\d?)$/
const matrixTypes = /^mat(\d)x(\d)$/
const isParameter = (type: string) => parameterTypes.test(type) || matrixTypes.test(type)

/** Returns a value that reads a variable of the host's shader: a parameter of a function, or a uniform. */
export function parameterOf(place: Place, glsl: Builder, { name, type }: Named): GlslValue {
  const [, columns, rows] = matrixTypes.exec(type) ?? []
  if (rows && columns !== rows)
    return new Columns(
      Array.from({ length: Number(columns) }, (_, i) => glsl[`vec${rows}Param`]!(`${name}[${i}]`)),
    )
  const [, base, size] = parameterTypes.exec(type) ?? []
  if (base === undefined)
    throw place.error(
      `${name} is ${article(type)}; only numbers, vectors and matrices can be passed.`,
    )
  if (base === 'float') return glsl.param!(name)
  if (base === 'vec' || base === 'mat') return glsl[`${type}Param`]!(name)
  const { session } = glsl.val!(0) as unknown as { session: Session }
  const read = (half?: 'low' | 'high') => {
    const texts = floatConversions(name, type, half)
    return session.inputOf(
      { name, type: type as TypeName, half, texts },
      [1, Number(size || 1)],
      place.method,
    )
  }
  return isInteger(type) && session.target !== 'glsl100'
    ? new Halves(read('low'), read('high'))
    : read()
}
