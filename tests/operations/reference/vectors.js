// Operations on whole vectors, and constructors of vectors. scalars.js describes rows.
import { span, swizzle } from './row.js'

const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0)
const length = (v) => Math.sqrt(dot(v, v))
const minus = (a, b) => a.map((x, i) => x - b[i])
const times = (v, factor) => v.map((x) => x * factor)
const unit = (v) => (length(v) === 0 ? v : times(v, 1 / length(v)))

const coordinate = span(-2, 2, { at: [0] })
const sizes = [2, 3, 4]
const pairs = sizes.map((size) => [size, size])
const firstShape = ([shape]) => shape
const scalarShape = () => 1

/** For `adjust`: sometimes makes all operands equal or the first one zero, and often makes the first one short. */
const shortenFirst = (operands, random) => {
  const chance = random()
  if (chance < 0.04) return operands.map(() => operands[0])
  const factor = chance < 0.08 ? 0 : chance < 0.3 ? 10 ** (-3 * random()) : 1
  return operands.map((operand, k) => (k === 0 ? times(operand, factor) : operand))
}

/** Makes the length of a vector almost, but not exactly 1, like that of normals in a shader. */
const nearlyUnit = (random) => (v) =>
  times(length(v) < 0.1 ? v.map(() => 1) : unit(v), 0.8 + 0.4 * random())

/** For `adjust`: makes the incident vector and the normal of reflect and refract nearly unit vectors. */
const adjustLight = ([incident, normal, ...others], random) => [
  ...[incident, normal].map(nearlyUnit(random)),
  ...others,
]

const radicand = (incident, normal, eta) => 1 - eta * eta * (1 - dot(normal, incident) ** 2)

function refract(incident, normal, [eta]) {
  const k = radicand(incident, normal, eta)
  if (k < 0) return incident.map(() => 0)
  const along = eta * dot(normal, incident) + Math.sqrt(k)
  return minus(times(incident, eta), times(normal, along))
}

const constructorRow = (name, shapes, note, reference, more) => ({
  name,
  note,
  only: 'builder',
  shapes: [shapes],
  result: () => Number(name.at(-1)),
  domains: [coordinate],
  reference,
  ...more,
})

const join = (...operands) => operands.flat()

/** Methods named by their letters; tests/core/operations.test.js tests all of them. */
const swizzles = {
  2: ['x', 'g', 'u', 'yx', 'ss', 'vu', 'rgrg'],
  3: ['z', 'b', 'xx', 'zyx', 'gbr', 'ptsp'],
  4: ['w', 'q', 'a', 'wy', 'qqs', 'wzyx', 'aaaa', 'xyzw'],
}

const swizzleRow = (name, size) => ({
  name,
  group: 'swizzles',
  only: 'method',
  shapes: [[size]],
  result: () => name.length,
  domains: [coordinate],
  reference: (v) => swizzle(name, v),
})

export const vectors = [
  {
    name: 'scale',
    shapes: sizes.map((size) => [size, 1]),
    domains: [coordinate],
    reference: (v, [factor]) => times(v, factor),
  },
  {
    name: 'dot',
    shapes: pairs,
    result: scalarShape,
    domains: [coordinate],
    reference: (a, b) => [dot(a, b)],
  },
  {
    name: 'length',
    shapes: sizes.map((size) => [size]),
    result: scalarShape,
    domains: [coordinate],
    adjust: shortenFirst,
    kinks: 'at 0',
    reference: (v) => [length(v)],
  },
  ...['dist', 'distance'].map((name) => ({
    name,
    shapes: pairs,
    result: scalarShape,
    domains: [coordinate],
    adjust: shortenFirst,
    kinks: 'where the points are equal',
    reference: (a, b) => [length(minus(a, b))],
  })),
  {
    name: 'cross',
    shapes: [[3, 3]],
    domains: [coordinate],
    reference: ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x],
  },
  {
    name: 'normalize',
    shapes: sizes.map((size) => [size]),
    domains: [coordinate],
    adjust: shortenFirst,
    kinks: 'at 0',
    // The partial derivatives are large at a short vector, and the derivative along the vector is a small difference of them.
    sensitivity: {
      derivative: (v) => [1 + 1 / Math.max(1e-7, length(v))],
      because: '1 + 1 / length',
    },
    reference: unit,
  },
  {
    name: 'reflect',
    shapes: pairs,
    domains: [coordinate],
    adjust: adjustLight,
    reference: (incident, normal) => minus(incident, times(normal, 2 * dot(normal, incident))),
  },
  {
    name: 'refract',
    shapes: sizes.map((size) => [size, size, 1]),
    result: firstShape,
    domains: [coordinate, coordinate, span(0.4, 1.7)],
    adjust: adjustLight,
    kinks: 'where total reflection begins',
    // The root of a number close to zero amplifies errors.
    sensitivity: {
      derivative: (incident, normal, [eta]) => [
        1 / Math.max(1e-7, Math.min(1, Math.abs(radicand(incident, normal, eta)))),
      ],
      because: '1 / radicand',
    },
    reference: refract,
  },
  {
    name: 'faceforward',
    shapes: sizes.map((size) => [size, size, size]),
    domains: [coordinate],
    kinks: 'where the incident vector is at right angles to the reference',
    reference: (normal, incident, reference) =>
      dot(reference, incident) < 0 ? normal : times(normal, -1),
  },

  constructorRow('vec2', [1, 1], 'of numbers', join),
  constructorRow('vec3', [1, 1, 1], 'of numbers', join),
  constructorRow('vec3', [2, 1], 'of a vector and a number', join),
  constructorRow('vec3', [1, 2], 'of a number and a vector', join),
  constructorRow('vec4', [1, 1, 1, 1], 'of numbers', join),
  constructorRow('vec4', [2, 2], 'of two vectors', join),
  constructorRow('vec4', [1, 2, 1], 'of a vector amid numbers', join),
  constructorRow('vec4', [1, 3], 'of a number and a vector', join),
  constructorRow('vec3', [2], 'of a vector and a constant', ([x, y]) => [x, 0.5, y], {
    build: ({ call }, v) => call(v.x(), 0.5, v.y()),
  }),
  ...[2, 3, 4].map((size) =>
    constructorRow(`vec${size}`, [1], 'of one number for all', ([x]) => Array(size).fill(x)),
  ),

  ...Object.entries(swizzles).flatMap(([size, names]) =>
    names.map((name) => swizzleRow(name, Number(size))),
  ),
]
