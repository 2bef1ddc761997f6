// What a warp is called in the shaders of a host: all of it begins with warpjet, so that it meets nobody else's names.

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
