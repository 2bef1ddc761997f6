/** The `WarpError` of the page's main script, for the scripts beside it: all throw one class, so that `instanceof` holds. */
const { warpjet } = globalThis as { warpjet?: Pick<typeof import('./warp-error.js'), 'WarpError'> }
if (!warpjet?.WarpError)
  throw new Error('warpjet: the script p5.warpjet.min.js must stand in a tag before this one.')

export const { WarpError } = warpjet
