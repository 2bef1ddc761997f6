// What a text reads from outside, as expressions.
import { isExpression } from '../errors/describe.js'
import { WarpError, describe, describeShape } from '../errors/errors.js'
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import type { Session } from '../core/expression/session.js'
import type { TypeName } from '../core/expression/shapes.js'
import { drawInputs, inputSizes, markWhole, variationInputs } from '../core/inputs/inputs.js'
import type { Vec4, WarpInputs } from '../core/types/types.js'
import { imageSizeText, instanceID, textsAsFloats } from './function-text.js'
import { Columns, type Given as Value, Halves, halvesOf } from './halves.js'
import type { Named, External } from './listing.js'
import { article } from './options.js'
import type { Given } from './replay.js'

const hidden = new Set(['tangent', ...Object.keys(variationInputs)])

/** The inputs of an offset function, each with its type in GLSL. */
export const inputTypes: Readonly<Record<string, string>> = Object.assign(
  Object.create(null) as object,
  Object.fromEntries(
    Object.entries({ ...inputSizes, mouseX: 1, mouseY: 1, width: 1, height: 1 })
      .filter(([name]) => !hidden.has(name))
      .map(([name, size]) => [name, size === 1 ? 'float' : `vec${size}`]),
  ),
)

/** Options of `texture()` in GLSL: for an image with `HostSampling`, and for one whose sampler only the shader knows. */
const asHostSamples = { transform: false }
const bySampler = { wrap: 'sampler' }

/** The inputs of an offset function, or none of them. */
export type Inputs = Partial<WarpInputs>

export const inputNamed = (inputs: Inputs, name: string) =>
  inputs[name as keyof WarpInputs] as unknown as Expression | undefined

/**
 * Uniforms and attributes by name: what the sketch declared under it, an input such as `millis` of the right type, or a
 * variable of the host's shader.
 */
export function bindExternals(
  method: string,
  glsl: Builder,
  externals: readonly External[],
  inputs: Inputs,
): Pick<Given, 'external' | 'texture' | 'imageSize'> {
  const declared = (inputs.uniforms ?? {}) as unknown as Record<string, unknown>
  const isDeclared = (name: string) => Object.hasOwn(declared, name)
  const made = new Map<number, Value>()
  const find = (external: External): Value => {
    const { name, type, isAttribute } = external
    if (!isAttribute && isDeclared(name)) {
      if (isWhole(type)) (declared as Marking)[markWhole]?.(name)
      return checked(method, glsl, external, declared[name])
    }
    if (isAttribute && name === instanceID)
      return inputNamed(inputs, 'instance') ?? parameterOf(method, glsl, external)
    const input = inputTypes[name] === type && inputNamed(inputs, name)
    // The parts of `size` and `mouse` have names, such as height, that a text may well mean otherwise.
    if (input && (isAttribute || Object.hasOwn(drawInputs, name))) return input
    if (!isAttribute) {
      checkRoot(method, glsl, external)
      return parameterOf(method, glsl, external)
    }
    throw new WarpError(
      `${method}: nothing gives the attribute ${name} its value; a warp knows position, normal, uv, color and ${instanceID}.`,
    )
  }
  const imageOf = (place: number) => {
    const { name } = externals[place]!
    return isDeclared(name) ? declared[name] : name
  }
  const imageSize = (place: number) => {
    const { target } = glsl.val!(0).session as Session
    return glsl.vec2Param!(imageSizeText(target, String(imageOf(place))))
  }
  const external = (place: number) => {
    let value = made.get(place)
    if (!value) made.set(place, (value = find(externals[place]!)))
    return value
  }
  // A uniform whose value cancels out is read too, so that `evaluate` accepts a value for it.
  for (const [place, { name, type, isAttribute }] of externals.entries())
    if (!isAttribute && isParameter(type) && !isDeclared(name) && !Object.hasOwn(inputSizes, name))
      external(place)
  return {
    external,
    texture(place, at, isFetched) {
      const image = imageOf(place)
      const { samplings } = glsl.val!(0).session as Session
      if (!isFetched)
        return glsl.texture!(image, at, samplings.has(String(image)) ? asHostSamples : bySampler)
      const uv = glsl.div!(glsl.add!(at, 0.5), imageSize(place))
      return glsl.texture!(image, uv, { filter: 'nearest', wrap: 'clamp', transform: false })
    },
    imageSize,
  }
}

/** In the shader of a warp, `position` is the position, whatever the text declares under that name. */
function checkRoot(method: string, glsl: Builder, { name }: Named) {
  const [root = ''] = /^\w+/.exec(name) ?? []
  const { target, inputNames } = glsl.val!(0).session as Session
  const input = inputNames.get(root)
  if (input !== undefined)
    throw new WarpError(
      `${method}: the uniform ${root} has the name of an input, ${input}; rename it in the text, such as my${root[0]!.toUpperCase()}${root.slice(1)}.`,
    )
  if (root.startsWith('gl_') && target === 'wgsl')
    throw new WarpError(`${method}: WGSL has no ${root}; give its value by a uniform.`)
}

function checked(
  method: string,
  glsl: Builder,
  { name, type, shape }: External,
  declared: unknown,
): Value {
  if (typeof declared === 'string')
    throw new WarpError(
      `${method}: the uniform ${name} is ${article(type)} in the text, but an image was given.`,
    )
  if (typeof declared !== 'number' && !isExpression(declared))
    throw new WarpError(
      `${method}: the uniform ${name} must be a number or an expression, but is ${describe(declared)}.`,
    )
  if (typeof declared === 'number' && /^u?int$/.test(type)) return halvesOf(glsl, declared)
  const value = typeof declared === 'number' ? glsl.val!(declared) : (declared as Expression)
  const given = value.session.shapeOf(value)
  if (`${given}` === `${shape}`) return value
  // Four numbers of the option are a vec4 until a text wants a matrix of them.
  if (type === 'mat2' && `${given}` === '1,4') {
    const { x, y, z, w } = value as unknown as Vec4
    return glsl.mat2!(x(), y(), z(), w())
  }
  throw new WarpError(
    `${method}: the uniform ${name} is ${article(type)} in the text, but ${describeShape(given)} was given.`,
  )
}

const isWhole = (type: string) => /^(?:u?int|[iu]vec\d)$/.test(type)

/** Of inputs/declared-uniforms.ts. */
interface Marking {
  [markWhole]?: (name: string) => void
}

const parameterTypes = /^(float|vec|mat|u?int|bool|[iub]vec)(\d?)$/
const matrixTypes = /^mat(\d)x(\d)$/
const isParameter = (type: string) => parameterTypes.test(type) || matrixTypes.test(type)

/** A variable of the host's shader: a parameter of a function, or a uniform. */
export function parameterOf(method: string, glsl: Builder, { name, type }: Named): Value {
  const [, columns, rows] = matrixTypes.exec(type) ?? []
  if (rows && columns !== rows)
    return new Columns(
      Array.from({ length: Number(columns) }, (_, i) => glsl[`vec${rows}Param`]!(`${name}[${i}]`)),
    )
  const [, word, size] = parameterTypes.exec(type) ?? []
  if (word === undefined)
    throw new WarpError(
      `${method}: ${name} is ${article(type)}; only numbers, vectors and matrices can be given.`,
    )
  if (word === 'float') return glsl.param!(name)
  if (word === 'vec' || word === 'mat') return glsl[`${type}Param`]!(name)
  const { session } = glsl.val!(0) as unknown as { session: Session }
  const read = (half?: 'low' | 'high') => {
    const texts = textsAsFloats(name, type, half)
    return session.inputOf(
      { name, type: type as TypeName, half, texts },
      [1, Number(size || 1)],
      method,
    )
  }
  return isWhole(type) && session.target !== 'glsl100'
    ? new Halves(read('low'), read('high'))
    : read()
}
