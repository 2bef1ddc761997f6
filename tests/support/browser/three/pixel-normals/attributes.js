/** Maps an input that says how normal or uv vary over the surface → the attribute of a geometry that has it. */
export const variationAttributes = Object.fromEntries(
  ['normalX', 'normalY', 'normalZ', 'u', 'v'].map((name) => [
    `${name}Gradient`,
    `aWarpjet_${name}Gradient`,
  ]),
)
