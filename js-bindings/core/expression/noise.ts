// `glsl.noise` and its kin. The functions themselves are in src/noise; here their options are read.
import type { Session } from './session.js'
import { WarpError, describe } from '../../errors/errors.js'
import { Expression, toExpression } from './expression.js'
import { checkOptions } from '../../options/options.js'
import { mostOctaves, mostSeed, noises } from '../../wasm/tables.js'

type NoiseKind = keyof typeof noises

/** In the order of their numbers in the wasm. */
export const noiseKinds = Object.keys(noises) as readonly NoiseKind[]

/** What others may be made of. */
const bases = noiseKinds.filter((kind) => noises[kind] === 'base')

const fractalOptions = ['octaves', 'lacunarity', 'gain', 'noise', 'seed']

const optionsFor = {
  base: ['seed'],
  plain: ['seed'],
  made: ['noise', 'seed'],
  fractal: fractalOptions,
}

export function callNoise(
  session: Session,
  kind: NoiseKind,
  [point, options, ...others]: readonly unknown[],
  isMethod = false,
): Expression {
  const operand = toExpression(session, kind, point, 1)
  const isNumber = (value: unknown) => value instanceof Expression || typeof value === 'number'
  if (isNumber(options) && others.every(isNumber) && others.length < 3)
    throw new WarpError(
      `${kind}: it takes one point; write ${others.length ? 'glsl.vec3(x, y, z)' : 'glsl.vec2(x, y)'}.${kind}().`,
    )
  if (others.length > 0)
    throw new WarpError(
      `${kind}: it takes ${isMethod ? 'options' : 'a point and options'}; ${describe(others[0])} is too many.`,
    )
  const known = optionsFor[noises[kind]]
  checkOptions(kind, options, known)
  const {
    octaves = 5,
    lacunarity = 2,
    gain = 0.5,
    noise = 'noise',
    seed = 0,
  } = (options ?? {}) as Record<string, unknown>
  const base = noiseKinds.indexOf(noise as never)
  if (!bases.includes(noise as never))
    throw new WarpError(
      `${kind}: the option "noise" must be one of ${bases.join(', ')}, but is ${describe(noise)}.`,
    )
  checkWhole(kind, 'octaves', octaves, 1, mostOctaves)
  checkWhole(kind, 'seed', seed, -mostSeed, mostSeed)
  const operands = [operand, toExpression(session, kind, seed, 'the option "seed"')]
  if (known === fractalOptions)
    operands.push(
      factor(session, kind, 'lacunarity', lacunarity),
      factor(session, kind, 'gain', gain),
    )
  return session.callNoise(
    noiseKinds.indexOf(kind),
    base,
    octaves as number,
    kind,
    operands,
    isMethod,
  )
}

function checkWhole(kind: string, option: string, value: unknown, least: number, most: number) {
  if (!(Number.isInteger(value) && (value as number) >= least && (value as number) <= most))
    throw new WarpError(
      `${kind}: the option "${option}" must be a whole number from ${least} to ${most}, but is ${describe(value)}.`,
    )
}

/** What an octave differs from the one before by. */
function factor(session: Session, kind: string, option: string, value: unknown) {
  if (typeof value === 'number' && !(value > 0))
    throw new WarpError(
      `${kind}: the option "${option}" must be above 0, but is ${describe(value)}.`,
    )
  const expression = toExpression(session, kind, value, `the option "${option}"`)
  if (session.shapeOf(expression).some((size) => size > 1))
    throw new WarpError(
      `${kind}: the option "${option}" must be a number, but is a vector or a matrix.`,
    )
  return expression
}
