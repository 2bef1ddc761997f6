// The names of a warp's variables in the shaders of a host. All begin with warpjet, so that they collide with no others.

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
