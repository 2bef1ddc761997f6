// From the options of a deformer to its offset function.
import type { OffsetFunction, Vec3, WarpInputs } from '../core/types/types.js'
import { asOwn } from '../errors/operators.js'
import { Place } from '../options/place.js'
import { type Kinds, type KindsOf, type ValuesOf, object } from '../options/schema.js'
import type { Computed } from './kinds.js'

/** The values that a formula works with: computed ones are made. */
export type Made<Values> = {
  [Name in keyof Values]: Values[Name] extends Computed<infer Value>
    ? Value
    : Values[Name] extends Computed<infer Value> | undefined
      ? Value | undefined
      : Values[Name]
}

export type Formula<Values> = (inputs: WarpInputs, values: Made<Values>) => Vec3

/** The offset function of the deformer of that name. `kinds` has a kind for each of the options. */
export function deformer<Options, All extends Kinds & KindsOf<Options>>(
  name: string,
  options: Options | undefined,
  kinds: All & { [Name in Exclude<keyof All, keyof Options>]: never },
  formula: Formula<ValuesOf<All>>,
): OffsetFunction {
  return withFormula(readOptions<All>(name, options, kinds), formula)
}

export function readOptions<All extends Kinds>(name: string, options: unknown, kinds: All) {
  const place = new Place(name)
  if (Object.keys(options ?? {}).includes('glsl'))
    throw place.error(
      `it makes an offset function; call it with its options, as in createWarp(${name}({})).`,
    )
  return object(kinds).read(options, place)
}

export const withFormula = <Values extends object>(
  values: Values,
  formula: Formula<Values>,
): OffsetFunction =>
  asOwn((inputs) => {
    const made = Object.entries(values).map(([name, value]: [string, unknown]) => [
      name,
      typeof value === 'function' ? (value as Computed<unknown>)(inputs) : value,
    ])
    return formula(inputs, Object.fromEntries(made) as Made<Values>)
  })
