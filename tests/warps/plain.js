// Helpers of the oracles: plain functions of numbers.

export const clamp = (x, low, high) => Math.min(Math.max(x, low), high)
export const mix = (a, b, t) => a + t * (b - a)
export const seconds = ({ millis }) => millis / 1000

/** Converts warps by name, on a mesh of size 1, to a list. */
export const onSmallMesh = (warps) =>
  Object.entries(warps).map(([name, warp]) => ({ name, size: 1, ...warp }))
