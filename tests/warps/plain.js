// What the oracles have in common: functions of numbers, none of them ours.

export const clamp = (x, low, high) => Math.min(Math.max(x, low), high)
export const mix = (a, b, t) => a + t * (b - a)
export const seconds = ({ millis }) => millis / 1000

/** Warps by name, on a mesh of size 1, as a list. */
export const onSmallMesh = (warps) =>
  Object.entries(warps).map(([name, warp]) => ({ name, size: 1, ...warp }))
