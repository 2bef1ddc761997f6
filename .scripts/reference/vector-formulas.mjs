// Formulas of operations on vectors and matrices, and of the derivatives of these operations, in the notation of textbooks, for
// web/docs/plots-vectors.md.
// tests/core/vector-formulas.test.js parses these formulas, compares each derivative with finite differences of its value, and
// compares values and derivatives with those of warpjet. `da` is the differential of `a`.

const normalizeDerivative = 'da / |a| − a (a · da) / |a|³'
const distance = {
  value: '|a − b|',
  derivative: '(a − b) · (da − db) / |a − b|',
  remark: 'Where a = b, the derivative is 0.',
}

/** Returns the row of a rotation of v by φ about `axis`. */
const createRotation = (name, axis, value) => ({
  form: `${name}(φ) v`,
  value,
  derivative: `${name}(φ) dv + dφ (e × w)`,
  where: { e: axis },
})

/**
 * Maps each title → its formulas:
 * - `form`: the operation, with a letter for each operand.
 * - `value` and `derivative`. In `derivative`, `w` is the value. `where` defines terms of both formulas.
 * - `remark`: what warpjet returns as derivative where the function is not differentiable, and other remarks.
 * - `call`, `from` and `to`: the expression that is plotted, and the range of x.
 */
export const vectorFormulas = {
  dot: {
    form: 'dot(a, b)',
    value: 'Σ aᵢ bᵢ',
    derivative: 'da · b + a · db',
    call: 'glsl.vec2(x, 1).dot(glsl.vec2(x, 2))',
  },
  cross: {
    form: 'cross(a, b)',
    value: '(a₂ b₃ − a₃ b₂, a₃ b₁ − a₁ b₃, a₁ b₂ − a₂ b₁)',
    derivative: 'da × b + a × db',
    call: 'glsl.vec3(x, 1, 0).cross(glsl.vec3(1, x, 0)).z()',
  },
  length: {
    form: 'length(v)',
    value: '√(v · v)',
    derivative: 'v · dv / |v|',
    call: 'glsl.vec2(x, 0.5).length()',
  },
  dist: { form: 'dist(a, b)', ...distance, call: 'glsl.vec2(x, 1).dist(glsl.vec2(1, 1))' },
  distance: {
    form: 'distance(a, b)',
    ...distance,
    call: 'glsl.vec2(x, 1).distance(glsl.vec2(1, 0))',
  },
  normalize: {
    form: 'normalize(a)',
    value: 'a / |a|',
    derivative: normalizeDerivative,
    remark: 'Where a = 0, value and derivative are 0.',
    call: 'glsl.vec2(x, 1).normalize().x()',
  },
  scale: {
    form: 'scale(v, s)',
    value: 's v',
    derivative: 'ds v + s dv',
    call: 'glsl.vec2(1, 2).scale(x).y()',
  },
  reflect: {
    form: 'reflect(i, n)',
    value: 'i − 2 (n · i) n',
    derivative: 'di − 2 (dn · i + n · di) n − 2 (n · i) dn',
    call: 'glsl.vec2(1, -1).reflect(glsl.vec2(x.sin(), x.cos())).x()',
  },
  refract: {
    form: 'refract(i, n, η)',
    value: 'k < 0 ? 0 : η i − (η c + √k) n',
    derivative: 'k < 0 ? 0 : dη i + η di − (dη c + η dc + dk / (2 √k)) n − (η c + √k) dn',
    where: {
      c: 'n · i',
      k: '1 − η² (1 − c²)',
      dc: 'dn · i + n · di',
      dk: '2 η² c dc − 2 η (1 − c²) dη',
    },
    remark: 'Where k = 0, the derivative of √k counts as 0.',
    call: 'glsl.vec2(x.sin(), x.cos().neg()).refract(glsl.vec2(0, 1), 1.4).x()',
    from: -1.5,
    to: 1.5,
  },
  faceforward: {
    form: 'faceforward(n, i, r)',
    value: 'r · i < 0 ? n : −n',
    derivative: 'r · i < 0 ? dn : −dn',
    remark: 'Where r · i = 0, it is −n, and its derivative −dn.',
    call: 'glsl.vec2(0, 1).faceforward(glsl.vec2(x, -1), glsl.vec2(1, 0)).y()',
  },
  transpose: {
    form: 'transpose(A)',
    value: 'Aᵀ',
    derivative: 'dAᵀ',
    call: 'glsl.mat2(1, x.sin(), 2, 3).transpose().column(1).x()',
  },
  determinant: {
    form: 'determinant(A)',
    value: 'det(A)',
    derivative: 'det(A) tr(A⁻¹ dA)',
    remark:
      'For a mat2 it is `A₁₁ A₂₂ − A₁₂ A₂₁`, for larger matrices a sum of such products. It has no kinks: where det(A) = 0, the derivative is the limit of the formula.',
    call: 'glsl.mat2(x, 1, 2, x).determinant()',
  },
  inverse: {
    form: 'inverse(A)',
    value: 'A⁻¹',
    derivative: '−A⁻¹ dA A⁻¹',
    remark: 'Where det(A) = 0, the derivative is infinite or NaN, too.',
    call: 'glsl.mat2(x, 1, -1, x).inverse().column(0).x()',
  },
  rotateX: {
    ...createRotation('rotateX', '(1, 0, 0)', '(v₁, v₂ cos(φ) − v₃ sin(φ), v₂ sin(φ) + v₃ cos(φ))'),
    call: 'glsl.rotateX(x).mult(glsl.vec3(0, 1, 0)).z()',
  },
  rotateY: {
    ...createRotation('rotateY', '(0, 1, 0)', '(v₁ cos(φ) + v₃ sin(φ), v₂, v₃ cos(φ) − v₁ sin(φ))'),
    call: 'glsl.rotateY(x).mult(glsl.vec3(0, 0, 1)).x()',
  },
  rotateZ: {
    ...createRotation('rotateZ', '(0, 0, 1)', '(v₁ cos(φ) − v₂ sin(φ), v₁ sin(φ) + v₂ cos(φ), v₃)'),
    call: 'glsl.rotateZ(x).mult(glsl.vec3(1, 0, 0)).y()',
  },
  rotate: {
    form: 'rotate(a, φ) v',
    value: 'c v + s (u × v) + (1 − c) (u · v) u',
    derivative: 'rotate(a, φ) dv + dφ (u × w) + s (du × v) + (1 − c) ((du · v) u + (u · v) du)',
    where: { u: 'a / |a|', c: 'cos(φ)', s: 'sin(φ)', du: normalizeDerivative },
    remark: 'Where a = 0, u and du count as 0: the result is c v.',
    call: 'glsl.rotate(glsl.vec3(1, 1, 1), x).mult(glsl.vec3(1, 0, 0)).y()',
  },
  'mult(A, B)': {
    form: 'mult(A, B)',
    value: 'A B',
    derivative: 'dA B + A dB',
    call: 'glsl.mat2(x, 1, 2, x).mult(glsl.mat2(x, 0, 1, 1)).column(0).x()',
  },
  'mult(A, v)': {
    form: 'mult(A, v)',
    value: 'A v',
    derivative: 'dA v + A dv',
    call: 'glsl.mat2(x, 1, 2, 3).mult(glsl.vec2(x, 1)).x()',
  },
  'mult(v, A)': {
    form: 'mult(v, A)',
    value: 'Aᵀ v',
    derivative: 'dAᵀ v + Aᵀ dv',
    call: 'glsl.vec2(x, 1).mult(glsl.mat2(x, 1, 2, 3)).x()',
  },
  adjustNormal: {
    form: 'adjustNormal(f, n, p)',
    value: 'w / |w|',
    derivative: 'dw / |w| − w (w · dw) / |w|³',
    where: {
      w: 'det(F) F⁻ᵀ n',
      dw: 'tr(F⁻¹ dF) w − F⁻ᵀ dFᵀ w + det(F) F⁻ᵀ dn',
    },
    remark: 'F is `1 + ∂f/∂p`. Where w = 0, value and derivative are 0.',
  },
  adjustTangent: {
    form: 'adjustTangent(f, t, n, p)',
    value: 'u / |u|',
    derivative: 'du / |u| − u (u · du) / |u|³',
    where: {
      u: 'F t − n (n · (F t))',
      m: 'dF t + F dt',
      du: 'm − dn (n · (F t)) − n (dn · (F t) + n · m)',
    },
    remark: 'F is `1 + ∂f/∂p`. Where u = 0, value and derivative are 0.',
  },
}
