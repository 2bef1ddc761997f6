/** The `WarpError` of the page's main script, for its other scripts: all of them throw the same class, so that `instanceof` works. */
const { warpjet } = globalThis as { warpjet?: Pick<typeof import('./warp-error.js'), 'WarpError'> }
if (!warpjet?.WarpError)
  throw new Error('warpjet: the script p5.warpjet.min.js must be loaded by a tag before this one.')

export const { WarpError } = warpjet
