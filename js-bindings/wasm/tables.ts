// Written by `npm run reference` from the C++: what has a number there, in the order of its numbers, and what is limited.

/** Shading languages, the one first that counts unless another is asked for, each with what `glsl.fn` calls its sources. */
export const languages = { glsl300: 'glsl', glsl100: 'glsl', wgsl: 'wgsl' } as const

/** Kinds of noise, each with what it takes: others are made of bases, and a fractal has octaves. */
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

/** Of `glsl.texture`. */
export const filters = ['bilinear', 'bicubic', 'bspline', 'nearest', 'host'] as const
export const wraps = ['clamp', 'repeat', 'mirror', 'host', 'sampler'] as const

export const mostSeed = 8388608
export const mostOctaves = 16

/** In the place of a handle: why, the session says; or derivatives of calls are to be given first. */
export const failed = -1
export const needsPartials = -2

/** What a warp is made of besides its offset. */
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

/** The results of a warp. The last 4, which turn, come again, as they are where normal and uv vary over the surface. */
export const warpResults = {
  offset: 0,
  position: 1,
  orientation: 2,
  normal: 3,
  tangent: 4,
  direction: 5,
  determinant: 6,
}
export const turnedResults = 4
