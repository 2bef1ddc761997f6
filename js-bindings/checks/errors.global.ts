/**
 * `errors.ts` for scripts that stand beside the one that holds the compiler: all throw one class, so
 * that `instanceof` holds.
 */
export { describe, describeShape, shorten } from './describe.js'

const { warpjet } = globalThis as { warpjet?: typeof import('../global.js') }
if (!warpjet?.WarpError)
  throw new Error(
    'This script of warpjet needs another one, p5.warpjet.min.js, in a tag before it.',
  )

export const { WarpError } = warpjet
