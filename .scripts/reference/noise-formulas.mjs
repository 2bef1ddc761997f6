// The formulas of noise and its derivatives, for web/docs/plots-vectors.md, in the notation of vector-formulas.mjs.
// tests/core/noise-formulas.test.js compares them with noise that plain JavaScript computes in double precision.

const octaves =
  'Over the octaves k, from 0 on: gₖ is gain to the power of k, nₖ the noise at lacunarity to the power of k times p, shifted a little, and dnₖ its derivative'

/**
 * Maps each noise → { value, derivative, symbols, remark, call, from, to }. `symbols` explains the letters of the formulas; the other fields
 * are as in vector-formulas.mjs, but `from` and `to` are 0 and 6 by default.
 */
export const noiseFormulas = {
  noise: {
    value: 's Σ wₖ (gₖ · oₖ)',
    derivative: 's Σ (dwₖ (gₖ · oₖ) + wₖ (gₖ · dp))',
    symbols:
      'Over the corners k of the cell: oₖ leads from the corner to p, gₖ is a direction that looks random; wₖ is the product of `t³ (6 t² − 15 t + 10)` along each axis, where t is 1 minus the distance from the corner; s is 2 / √n in n dimensions',
    call: 'glsl.noise(glsl.vec2(x, 0.4))',
  },
  simplex: {
    value: 's Σ rₖ⁴ (gₖ · oₖ)',
    derivative: 's Σ rₖ³ (rₖ (gₖ · dp) − 8 (oₖ · dp) (gₖ · oₖ))',
    symbols:
      'Over the corners k of the simplex, a triangle on a plane: oₖ and gₖ as above, rₖ is `max(0.5 − oₖ · oₖ, 0)`; s lets it reach 1',
    call: 'glsl.simplex(glsl.vec2(x, 0.4))',
  },
  valueNoise: {
    value: 'Σ wₖ hₖ',
    derivative: 'Σ dwₖ hₖ',
    symbols: 'wₖ as for `noise`; hₖ is a number from -1 to 1 that looks random',
    call: 'glsl.valueNoise(glsl.vec2(x, 0.4))',
  },
  worley: {
    value: '|p − c|',
    derivative: '(p − c) · dp / |p − c|',
    symbols:
      'c is the nearest of the feature points, of which each cell has one at a place that looks random; for the second component, c is the second nearest',
    remark:
      'Where p = c, the derivative is 0; where two points are equally near, that of one of them.',
    call: 'glsl.worley(glsl.vec2(x, 0.4)).x()',
  },
  curl: {
    value: '(∂N₃/∂y − ∂N₂/∂z, ∂N₁/∂z − ∂N₃/∂x, ∂N₂/∂x − ∂N₁/∂y)',
    derivative: '(∂dN₃/∂y − ∂dN₂/∂z, ∂dN₁/∂z − ∂dN₃/∂x, ∂dN₂/∂x − ∂dN₁/∂y)',
    symbols: 'N₁, N₂ and N₃ are noises of different seeds, dN₁ … their derivatives',
    call: 'glsl.curl(glsl.vec3(x, 0.4, 0.2)).y()',
  },
  fbm: {
    value: 'Σ gₖ nₖ / Σ gₖ',
    derivative: 'Σ gₖ dnₖ / Σ gₖ',
    symbols: octaves,
    call: 'glsl.fbm(glsl.vec2(x, 0.4))',
    to: 2,
  },
  ridged: {
    value: 'Σ gₖ (1 − |nₖ|)² / Σ gₖ',
    derivative: '−2 Σ gₖ (1 − |nₖ|) sign(nₖ) dnₖ / Σ gₖ',
    symbols: 'gₖ, nₖ and dnₖ as for `fbm`',
    remark: 'On a ridge, where nₖ = 0, the derivative of that octave is 0.',
    call: 'glsl.ridged(glsl.vec2(x, 0.4), { octaves: 2 })',
    to: 4,
  },
  turbulence: {
    value: 'Σ gₖ |nₖ| / Σ gₖ',
    derivative: 'Σ gₖ sign(nₖ) dnₖ / Σ gₖ',
    symbols: 'gₖ, nₖ and dnₖ as for `fbm`',
    remark: 'Where nₖ = 0, the derivative of that octave is 0.',
    call: 'glsl.turbulence(glsl.vec2(x, 0.4), { octaves: 2 })',
    to: 4,
  },
}
