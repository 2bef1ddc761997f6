/** Returns points of a cube from -1 to 1, the same in every run, in float32. */
export const pointsOfCube = (count) =>
  Array.from({ length: count }, (_, i) =>
    [0.7548776662, 0.569840291, 0.3819660113].map((step) =>
      Math.fround(2 * ((0.5 + (i + 1) * step) % 1) - 1),
    ),
  )
