// What a warp is called in the shaders of a host: all of it begins with warpjet, so that it meets nobody else's names.

export const outputs = {
  offset: 'warpjetOffset',
  position: 'warpjetMoved',
  normal: 'warpjetTurned',
  tangent: 'warpjetSwung',
}

/** 1, or -1 where the warp mirrors all of space. */
export const orientationName = 'warpjetOrientation'

export const millisUniform = 'warpjetMillis'
