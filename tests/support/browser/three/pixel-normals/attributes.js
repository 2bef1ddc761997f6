/**
 * Maps a gradient of the normal or uv over the surface, as the inputs of offsets are named → the attribute of a geometry with its values.
 */
export const variationAttributes = Object.fromEntries(
  ['normalX', 'normalY', 'normalZ', 'u', 'v'].map((name) => [
    `${name}Gradient`,
    `aWarpjet_${name}Gradient`,
  ]),
)
