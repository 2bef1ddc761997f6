/**
 * Maps the name of an input of offsets, which is a gradient of the normal or uv over the surface → the name of the attribute with its
 * values.
 */
export const variationAttributes = Object.fromEntries(
  ['normalX', 'normalY', 'normalZ', 'u', 'v'].map((name) => [
    `${name}Gradient`,
    `aWarpjet_${name}Gradient`,
  ]),
)
