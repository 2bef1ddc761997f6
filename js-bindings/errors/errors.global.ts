/**
 * `errors.ts` for scripts that stand beside the one that holds the compiler: all throw one class, so
 * that `instanceof` holds.
 */
export { describe, describeShape, shorten } from './describe.js'

const { warpjet } = globalThis as { warpjet?: Pick<typeof import('./errors.js'), 'WarpError'> }
if (!warpjet?.WarpError)
  throw new Error('warpjet: the script p5.warpjet.min.js must stand in a tag before this one.')

export const { WarpError } = warpjet
