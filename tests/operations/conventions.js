// Our conventions where GLSL or mathematics leaves a choice: values and derivatives exactly at kinks, jumps and the ends of domains,
// computed by hand. `slopes` lists the derivatives with respect to each number of the operands; each derivative has as many numbers as the
// value.
import { cases } from './reference.js'

const { PI } = Math
const zeros = (count) => Array(count).fill(0)

const conventionsByTitle = {
  'abs(float)': [{ at: [0], value: [0], slopes: [0] }],
  'abs(vec3)': [{ at: [0, -2, 3], value: [0, 2, 3], slopes: [0, 0, 0, 0, -1, 0, 0, 0, 1] }],
  'sign(float)': [{ at: [0], value: [0], slopes: [0] }],
  'floor(float)': [-2, 0, 3].map((x) => ({ at: [x], value: [x], slopes: [0] })),
  'ceil(float)': [-2, 0, 3].map((x) => ({ at: [x], value: [x], slopes: [0] })),
  'trunc(float)': [-2, 0, 3].map((x) => ({ at: [x], value: [x], slopes: [0] })),
  // A half is rounded to the even neighbour.
  'round(float)': [
    [-2.5, -2],
    [-1.5, -2],
    [-0.5, 0],
    [0.5, 0],
    [1.5, 2],
    [2.5, 2],
    [3, 3],
  ].map(([x, y]) => ({ at: [x], value: [y], slopes: [0] })),
  'fract(float)': [-2, 0, 3].map((x) => ({ at: [x], value: [0], slopes: [1] })),

  'sqrt(float)': [{ at: [0], value: [0], slopes: [0] }],
  'asin(float)': [-1, 1].map((x) => ({ at: [x], value: [(x * PI) / 2], slopes: [0] })),
  'acos(float)': [
    { at: [1], value: [0], slopes: [0] },
    { at: [-1], value: [PI], slopes: [0] },
  ],
  'acosh(float)': [{ at: [1], value: [0], slopes: [0] }],
  'tanh(float)': [-100, 100].map((x) => ({ at: [x], value: [x / 100], slopes: [0] })),
  'atan(float, float)': [
    { at: [0, 0], value: [0], slopes: [0, 0] },
    { at: [0, -2], value: [PI], slopes: [-0.5, 0] },
    { at: [2, 0], value: [PI / 2], slopes: [0, -0.5] },
    { at: [-2, 0], value: [-PI / 2], slopes: [0, 0.5] },
  ],

  'pow(float): constant exponents 0, 1, 2, 3': [
    { at: [0], value: [1, 0, 0, 0], slopes: [0, 1, 0, 0] },
    { at: [-2], value: [1, -2, 4, -8], slopes: [0, 1, -4, 12] },
  ],
  'pow(float): constant exponents -4, -3, -2, -1': [
    { at: [-2], value: [1 / 16, -1 / 8, 1 / 4, -1 / 2], slopes: [1 / 8, -3 / 16, 1 / 4, -1 / 4] },
  ],
  'pow(float): constant exponents 0.5, 1.5, 2.5, 17': [
    { at: [0], value: zeros(4), slopes: zeros(4) },
  ],
  'pow(float, float)': [
    { at: [0, 2], value: [0], slopes: [0, 0] },
    { at: [0, 0.5], value: [0], slopes: [0, 0] },
  ],

  'mod(float, float)': [
    { at: [4, 2], value: [0], slopes: [1, -2] },
    { at: [-4, 2], value: [0], slopes: [1, 2] },
    { at: [0, 3], value: [0], slopes: [1, 0] },
    { at: [-1, 3], value: [2], slopes: [1, 1] },
    { at: [5, -3], value: [-1], slopes: [1, 2] },
  ],

  // For equal operands the derivative is that of the first.
  'min(float, float)': [{ at: [1, 1], value: [1], slopes: [1, 0] }],
  'max(float, float)': [{ at: [1, 1], value: [1], slopes: [1, 0] }],
  'min(float, float, float)': [
    { at: [2, 2, 2], value: [2], slopes: [1, 0, 0] },
    { at: [3, 2, 2], value: [2], slopes: [0, 1, 0] },
  ],
  'max(float, float, float)': [
    { at: [2, 2, 2], value: [2], slopes: [1, 0, 0] },
    { at: [1, 2, 2], value: [2], slopes: [0, 1, 0] },
  ],
  // min(max(x, low), high), also if the bounds are in the wrong order.
  'clamp(float, float, float)': [
    { at: [1, 1, 2], value: [1], slopes: [1, 0, 0] },
    { at: [2, 1, 2], value: [2], slopes: [1, 0, 0] },
    { at: [3, 3, 3], value: [3], slopes: [1, 0, 0] },
    { at: [5, 2, 1], value: [1], slopes: [0, 0, 1] },
    { at: [0, 2, 1], value: [1], slopes: [0, 0, 1] },
  ],
  'step(float, float)': [{ at: [1, 1], value: [1], slopes: [0, 0] }],
  'smoothstep(float, float, float)': [
    { at: [1, 3, 1], value: [0], slopes: [0, 0, 0] },
    { at: [1, 3, 3], value: [1], slopes: [0, 0, 0] },
  ],

  'lt(float, float)': [{ at: [1, 1], value: [0], slopes: [0, 0] }],
  'le(float, float)': [{ at: [1, 1], value: [1], slopes: [0, 0] }],
  'gt(float, float)': [{ at: [1, 1], value: [0], slopes: [0, 0] }],
  'ge(float, float)': [{ at: [1, 1], value: [1], slopes: [0, 0] }],
  'eq(float, float)': [{ at: [1, 1], value: [1], slopes: [0, 0] }],
  'ne(float, float)': [{ at: [1, 1], value: [0], slopes: [0, 0] }],
  // The condition is that the first operand is above 0.
  'ifElse(float, float, float): first operand above 0': [
    { at: [0, 5, 7], value: [7], slopes: [0, 0, 1] },
  ],

  'length(vec2)': [{ at: zeros(2), value: [0], slopes: zeros(2) }],
  'length(vec3)': [{ at: zeros(3), value: [0], slopes: zeros(3) }],
  'dist(vec3, vec3)': [{ at: [1, 2, 3, 1, 2, 3], value: [0], slopes: zeros(6) }],
  'distance(vec2, vec2)': [{ at: [1, 2, 1, 2], value: [0], slopes: zeros(4) }],
  'normalize(vec2)': [{ at: zeros(2), value: zeros(2), slopes: zeros(4) }],
  'normalize(vec3)': [{ at: zeros(3), value: zeros(3), slopes: zeros(9) }],
  'refract(vec2, vec2, float)': [
    // Total reflection, and its boundary, where the root of 0 has the derivative 0.
    { at: [1, 0, 0, 1, 1.5], value: [0, 0], slopes: zeros(10) },
    { at: [1, 0, 0, 1, 1], value: [1, 0], slopes: [1, 0, 0, 0, 0, -1, 0, 0, 1, 0] },
  ],
  // A perpendicular vector does not count as in front.
  'faceforward(vec2, vec2, vec2)': [
    { at: [1, 2, 1, 0, 0, 1], value: [-1, -2], slopes: [-1, 0, 0, -1, ...zeros(8)] },
  ],
}

/** The conventions as [{ operation, points: [{ at, value, slopes }] }], where `operation` is a case of the reference. */
export const conventions = Object.entries(conventionsByTitle).map(([title, points]) => {
  const operation = cases.find((candidate) => candidate.title === title)
  if (!operation) throw new Error(`The reference has no case ${title}.`)
  return { operation, points }
})
