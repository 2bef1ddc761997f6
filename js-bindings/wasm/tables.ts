// Written by `npm run reference` from the C++: its enumerations, ordered by value, and its limits.

/** Maps a shading language → the name of its sources in `glsl.fn`. The first one is the default. */
export const languages = { glsl300: 'glsl', glsl100: 'glsl', wgsl: 'wgsl' } as const

/** Maps a noise → the kind of its options: 'made' and 'fractal' noises are composed from a 'base'; fractals have octaves. */
export const noises = {
  noise: 'base',
  simplex: 'base',
  valueNoise: 'base',
  worley: 'plain',
  curl: 'made',
  fbm: 'fractal',
  ridged: 'fractal',
  turbulence: 'fractal',
} as const

/** Options of `glsl.texture`. */
export const filters = ['bilinear', 'bicubic', 'bspline', 'nearest', 'host'] as const
export const wraps = ['clamp', 'repeat', 'mirror', 'host', 'sampler'] as const

export const maxSeed = 8388608
export const maxOctaves = 16

/** Returned in place of a handle: the session's `problem()` says why. */
export const failed = -1
/** Returned in place of a handle: partial derivatives of calls are needed first. */
export const needsPartials = -2

/** The operands of a warp, after its offset. */
export const warpOperands = [
  'position',
  'normal',
  'uv',
  'tangent',
  'normalXGradient',
  'normalYGradient',
  'normalZGradient',
  'uGradient',
  'vGradient',
  'color',
] as const

/** The results of a warp. The last 4 are followed by variants that take into account how normal and uv vary over the surface. */
export const warpResults = {
  offset: 0,
  position: 1,
  orientation: 2,
  normal: 3,
  tangent: 4,
  direction: 5,
  determinant: 6,
}
export const variantCount = 4
