// `glsl.noise` and the other noises: reads their options. src/noise implements them.
import { describe, describeShape } from '../../errors/describe.js'
import { kind, oneOf, wholeNumber } from '../../options/kinds.js'
import { Place } from '../../options/place.js'
import { object, type KindsOf, type ValuesOf } from '../../options/schema.js'
import { maxOctaves, maxSeed, noises } from '../../wasm/tables.js'
import type { BaseNoise, CurlOptions, FractalOptions, NoiseOptions } from '../types/noise.js'
import type { Operand } from '../types/types.js'
import { Expression, toExpression } from './expression.js'
import type { Session } from './session.js'

type NoiseKind = keyof typeof noises

/** The noises, in the order of their numbers in the wasm. */
export const noiseKinds = Object.keys(noises) as readonly NoiseKind[]

/** Noises from which others can be composed. */
const bases = noiseKinds.filter((name): name is BaseNoise => noises[name] === 'base')

const isNumber = (value: unknown) => value instanceof Expression || typeof value === 'number'

const factorName = 'a number above 0, or an expression of one number,'
/** Returns the kind of an option that is a ratio between an octave and the octave before. */
const factor = (defaultValue: number) =>
  kind<Expression | number, Operand>(
    factorName,
    (given) => given instanceof Expression || (typeof given === 'number' && given > 0),
    { default: defaultValue },
  )

/** The kinds of the options. `base` and `plain` noises have only a seed; `made` and `fractal` noises are composed of a base noise. */
const seedKinds = {
  seed: wholeNumber({ min: -maxSeed, max: maxSeed, default: 0 }),
} satisfies KindsOf<NoiseOptions>
const madeKinds = { noise: oneOf(bases, 'noise'), ...seedKinds } satisfies KindsOf<CurlOptions>
const fractalKinds = {
  octaves: wholeNumber({ min: 1, max: maxOctaves, default: 5 }),
  lacunarity: factor(2),
  gain: factor(0.5),
  ...madeKinds,
} satisfies KindsOf<FractalOptions>

const schemas = {
  base: object(seedKinds),
  plain: object(seedKinds),
  made: object(madeKinds),
  fractal: object(fractalKinds),
}

export function callNoise(
  session: Session,
  name: NoiseKind,
  [point, given, ...others]: readonly unknown[],
  isMethod = false,
): Expression {
  const place = new Place(name)
  const operand = toExpression(session, point, place, 1)
  if (isNumber(given) && others.every(isNumber) && others.length < 3)
    throw place.error(
      `it takes one point; write ${others.length ? 'glsl.vec3(x, y, z)' : 'glsl.vec2(x, y)'}.${name}().`,
    )
  if (others.length > 0)
    throw place.error(
      `it takes ${isMethod ? 'options' : 'a point and options'}; ${describe(others[0])} is too many.`,
    )
  const options: Partial<ValuesOf<typeof fractalKinds>> = schemas[noises[name]].read(given, place)
  const { octaves = 1, lacunarity, gain, noise = 'noise', seed } = options
  const operands = [operand, toExpression(session, seed, place)]
  for (const [option, value] of Object.entries({ lacunarity, gain }))
    if (value !== undefined) operands.push(toFactor(session, value, place.option(option)))
  const [number, base] = [noiseKinds.indexOf(name), noiseKinds.indexOf(noise)]
  return session.callNoise(number, base, octaves, name, operands, isMethod)
}

function toFactor(session: Session, value: unknown, place: Place) {
  const expression = toExpression(session, value, place)
  const shape = session.shapeOf(expression)
  if (`${shape}` !== '1,1') throw place.expected(factorName, describeShape(shape))
  return expression
}
