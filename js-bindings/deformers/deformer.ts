// Makes the offset function of a deformer from its options.
import type { OffsetFunction, Vec3, WarpInputs } from '../core/types/types.js'
import { markLibraryFunction } from '../errors/operators.js'
import { Place } from '../options/place.js'
import { object, type Kinds, type KindsOf, type ValuesOf } from '../options/schema.js'
import type { Computed } from './kinds.js'

/** The arguments of a formula: in `Values`, options that are functions of the inputs are replaced by their results. */
export type Evaluated<Values> = {
  [Name in keyof Values]: Values[Name] extends Computed<infer Value>
    ? Value
    : Values[Name] extends Computed<infer Value> | undefined
      ? Value | undefined
      : Values[Name]
}

export type Formula<Values> = (inputs: WarpInputs, values: Evaluated<Values>) => Vec3

/** Returns the offset function of the deformer `name`. `kinds` has a kind for each option. */
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
      `got the inputs of an offset function; call it with its options, as in createWarp(${name}({})).`,
    )
  return object(kinds).read(options, place)
}

export const withFormula = <Values extends object>(
  values: Values,
  formula: Formula<Values>,
): OffsetFunction =>
  markLibraryFunction((inputs) => {
    const evaluated = Object.entries(values).map(([name, value]: [string, unknown]) => [
      name,
      typeof value === 'function' ? (value as Computed<unknown>)(inputs) : value,
    ])
    return formula(inputs, Object.fromEntries(evaluated) as Evaluated<Values>)
  })
