// Offsets that are finite although an intermediate value of their derivative is not, with points, normals, and the expected normals
// from the exact derivative.
const heightOverX = (name, height, slope, xs) => ({
  name,
  offset: ({ glsl, position }) => glsl.vec3(0, height(position.x(), glsl), 0),
  points: xs.map((x) => ({
    position: [x, 0.5, 0.25],
    normal: [0, 1, 0],
    expected: unit([-slope(x), 1, 0]),
  })),
})

const unit = (v) => v.map((x) => x / Math.hypot(...v))
const sech = (x) => 1 / Math.cosh(x)
const keepsNormal = (position, normal) => ({ position, normal, expected: normal })

export const extremes = [
  heightOverX(
    '1 / (exp(-x) + 1)',
    (x, glsl) => glsl.val(1).div(x.neg().exp().add(1)),
    (x) => Math.exp(-Math.abs(x)) / (1 + Math.exp(-Math.abs(x))) ** 2,
    [-100, -89, -60, -3, 0, 2, 100],
  ),
  heightOverX(
    '1 / cosh(x)',
    (x, glsl) => glsl.val(1).div(x.cosh()),
    (x) => -Math.tanh(x) * sech(x),
    [-100, -3, 0, 0.5, 88, 100],
  ),
  heightOverX(
    'atan(exp(x))',
    (x) => x.exp().atan(),
    (x) => sech(x) / 2,
    [-100, -3, 0.5, 50, 100],
  ),
  heightOverX(
    'exp(-1 / x²)',
    (x, glsl) => glsl.val(-1).div(x.mult(x)).exp(),
    (x) => (x === 0 ? 0 : (Math.exp(-1 / (x * x)) * 2) / x ** 3),
    [0, 1e-20, 1e-10, 1e-3, 0.5, -0.7, 3],
  ),
  heightOverX(
    'tanh(1 / x)',
    (x, glsl) => glsl.val(1).div(x).tanh(),
    (x) => (x === 0 ? 0 : -(sech(1 / x) ** 2) / (x * x)),
    [0, 1e-20, 0.3, 2],
  ),
  {
    name: 'atan(y / x)',
    offset: ({ glsl, position }) => glsl.vec3(0, 0, position.y().div(position.x()).atan()),
    points: [
      [0, 2],
      [0, -0.5],
      [1, 2],
      [-3, 0.1],
    ].map(([x, y]) => ({
      position: [x, y, 0],
      normal: [0, 0, 1],
      expected: unit([y / (x * x + y * y), -x / (x * x + y * y), 1]),
    })),
  },
  ...[1e8, 1e10, 1e20, 1e30].map((factor) => ({
    name: `position times ${factor}`,
    offset: ({ position }) => position.mult(factor),
    points: [keepsNormal([1, 2, 3], [0, 0.6, 0.8]), keepsNormal([1, 2, 3], [1, 0, 0])],
  })),
  ...[1e10, 1e20, 1e30].map((factor) => ({
    name: `a shear by ${factor}`,
    offset: ({ glsl, position }) => glsl.vec3(position.y().mult(factor), 0, 0),
    points: [
      keepsNormal([1, 2, 3], [0, 1, 0]),
      { position: [1, 2, 3], normal: [1, 0, 0], expected: [0, -1, 0] },
    ],
  })),
  {
    name: 'the unit vector from the axis',
    offset: ({ glsl, position }) => {
      const away = position.xz().normalize()
      return glsl.vec3(0, away.x(), 0)
    },
    // The slope of x / |xz| along z is infinite at the axis; along x it is 0.
    points: [
      ...[1e-4, 1e-10, 1e-13, 1e-16].map((x) => keepsNormal([x, 0, 0], [0, 0, 1])),
      // Between the axes it is finite and huge: sqrt(1/8) / x along x, and minus that along z.
      ...[1e-4, 1e-10, 1e-13, 1e-16].map((x) => {
        const slope = Math.sqrt(1 / 8) / x
        const length = Math.hypot(slope, 1, slope)
        return {
          position: [x, 0, x],
          normal: [0, 1, 0],
          expected: [-slope / length, 1 / length, slope / length],
        }
      }),
    ],
  },
]
