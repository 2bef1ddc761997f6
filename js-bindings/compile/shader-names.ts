// The names of a warp's variables in the shaders of a host, which begin with warpjet so that they collide with no others; and expressions
// that are the same in all hosts.

export const shaderNames = {
  offset: 'warpjetOffset',
  position: 'warpjetPosition',
  normal: 'warpjetNormal',
  tangent: 'warpjetTangent',
  jacobian: 'warpjetJacobian',
  /** 1, or -1 where the warp mirrors all of space. */
  orientation: 'warpjetOrientation',
  millis: 'warpjetMillis',
} as const

/** Returns the vector that passes a normal and its length to pixels, since interpolation shortens the normal. `vec4` is the type's name. */
export const withLength = (normal: string, vec4: string) => `${vec4}(${normal}, length(${normal}))`

/** Returns an expression, in GLSL and in WGSL, for the normal with its length at vertices, from the interpolated vector of `withLength`. */
export const restoreLength = (passed: string) =>
  `${passed}.xyz * (${passed}.w / max(length(${passed}.xyz), 1e-30))`
