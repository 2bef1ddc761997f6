// Checks for callers that have no schema.
import { callback as callbackKind } from './kinds.js'
import { Place } from './place.js'
import { rejectUnknownOptions } from './schema.js'

export { isCallable, isList, own } from './guards.js'

/** An object of options, or nothing; `known` names what it may hold. */
export const checkOptions = (method: string, options: unknown, known: readonly string[]) =>
  rejectUnknownOptions(options, known, method)

export const checkCallback = (method: string, callback: unknown) =>
  void callbackKind.read(callback, new Place(method))
