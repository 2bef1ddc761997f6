// The built-in functions of GLSL in double precision, as the specification defines them, for tests only. Each has `run`, which maps the
// components of the operands to those of the result. It also has `type`, a function of the operands' types, unless the result has the type
// of the widest operand.
const perComponent =
  (f) =>
  (...lists) => {
    const size = Math.max(...lists.map((list) => list.length))
    if (size === 1) return [f(...lists.map(([number]) => number))]
    return Array.from({ length: size }, (_, i) =>
      f(...lists.map((list) => list[list.length === 1 ? 0 : i])),
    )
  }
const dot = (x, y) => x.reduce((sum, value, i) => sum + value * y[i], 0)
const length = (x) => Math.sqrt(dot(x, x))
const scale = (x, by) => x.map((value) => value * by)
const plus = (x, y) => x.map((value, i) => value + y[i])
const roundHalfToEven = (x) => {
  const low = Math.floor(x)
  return x - low === 0.5 ? low + (low % 2 ? 1 : 0) : Math.round(x)
}
const clamp = (x, low, high) => Math.min(Math.max(x, low), high)
const mix = (a, b, t) => (typeof t === 'boolean' ? (t ? b : a) : a * (1 - t) + b * t)

const bits = new DataView(new ArrayBuffer(4))
const toBits = (kind) => (x) => (bits.setFloat32(0, x), bits[`get${kind}32`](0))
const fromBits = (x) => (bits.setUint32(0, x >>> 0), bits.getFloat32(0))
/** Packs two 16-bit integers into one uint, or unpacks them; `f` converts each. */
const pack16 = (f) => (v) => [((f(v[0]) & 0xffff) | (f(v[1]) << 16)) >>> 0]
const unpack16 =
  (f) =>
  ([u]) => [f(u & 0xffff), f(u >>> 16)]
/** Returns the bits of the half float nearest to x; half floats have 11 significant bits. */
function toHalfFloat(x) {
  const size = Math.min(Math.abs(x), 65536)
  if (size < 2 ** -14) return (x < 0 ? 0x8000 : 0) | roundHalfToEven(size * 2 ** 24)
  const power = Math.floor(Math.log2(size))
  const value = roundHalfToEven(size / 2 ** (power - 10)) * 2 ** (power - 10)
  const powerOfValue = Math.floor(Math.log2(value))
  return (
    (x < 0 ? 0x8000 : 0) | ((powerOfValue + 15) << 10) | (value / 2 ** (powerOfValue - 10) - 1024)
  )
}
/** Returns the value of a half float. */
function fromHalfFloat(h) {
  const [sign, power, rest] = [h & 0x8000 ? -1 : 1, (h >> 10) & 31, h & 1023]
  return sign * (power === 0 ? rest * 2 ** -24 : (1024 + rest) * 2 ** (power - 25))
}

const sizeOfSquare = (m) => Math.sqrt(m.length)
function minor(m, column, row) {
  const n = sizeOfSquare(m)
  return m.filter((_, i) => Math.floor(i / n) !== column && i % n !== row)
}
function determinant(m) {
  if (m.length === 1) return m[0]
  const n = sizeOfSquare(m)
  return Array.from({ length: n }, (_, c) => c).reduce(
    (sum, c) => sum + (c % 2 ? -1 : 1) * m[c * n] * determinant(minor(m, c, 0)),
    0,
  )
}
function inverse(m) {
  const [n, d] = [sizeOfSquare(m), determinant(m)]
  return m.map((_, i) => {
    const [column, row] = [Math.floor(i / n), i % n]
    return ((column + row) % 2 ? -1 : 1) * (determinant(minor(m, row, column)) / d)
  })
}

const fromMath = (names) =>
  Object.fromEntries(names.map((name) => [name, { run: perComponent(Math[name]) }]))
const scalarResult = (f) => ({ type: () => 'float', run: (...lists) => [f(...lists)] })
const withType = (type, run) => ({ type, run })
/** Returns the type with the same number of components of another kind: 'float' and 'vec2', 'int' and 'ivec2' … */
export const ofKind = (kind, type) => {
  const size = /vec(\d)$/.exec(type)?.[1]
  return size ? `${kind === 'float' ? '' : kind[0]}vec${size}` : kind
}
const ofKindPerComponent = (kind, f) => withType((type) => ofKind(kind, type), perComponent(f))

export const builtIns = {
  ...fromMath([
    'sin',
    'cos',
    'tan',
    'asin',
    'acos',
    'sinh',
    'cosh',
    'tanh',
    'asinh',
    'acosh',
    'atanh',
  ]),
  ...fromMath([
    'exp',
    'log',
    'log2',
    'sqrt',
    'abs',
    'sign',
    'floor',
    'trunc',
    'ceil',
    'min',
    'max',
  ]),
  radians: { run: perComponent((x) => (x * Math.PI) / 180) },
  degrees: { run: perComponent((x) => (x * 180) / Math.PI) },
  atan: { run: (y, x) => (x ? perComponent(Math.atan2)(y, x) : perComponent(Math.atan)(y)) },
  pow: { run: perComponent(Math.pow) },
  exp2: { run: perComponent((x) => 2 ** x) },
  inversesqrt: { run: perComponent((x) => 1 / Math.sqrt(x)) },
  round: { run: perComponent(roundHalfToEven) },
  roundEven: { run: perComponent(roundHalfToEven) },
  fract: { run: perComponent((x) => x - Math.floor(x)) },
  mod: { run: perComponent((x, y) => x - y * Math.floor(x / y)) },
  clamp: { run: perComponent(clamp) },
  mix: { run: perComponent(mix) },
  step: { run: perComponent((edge, x) => (x < edge ? 0 : 1)) },
  smoothstep: {
    run: perComponent((low, high, x) => {
      const t = clamp((x - low) / (high - low), 0, 1)
      return t * t * (3 - 2 * t)
    }),
  },
  isnan: ofKindPerComponent('bool', Number.isNaN),
  isinf: ofKindPerComponent('bool', (x) => Math.abs(x) === Infinity),

  floatBitsToInt: ofKindPerComponent('int', toBits('Int')),
  floatBitsToUint: ofKindPerComponent('uint', toBits('Uint')),
  intBitsToFloat: ofKindPerComponent('float', fromBits),
  uintBitsToFloat: ofKindPerComponent('float', fromBits),
  packSnorm2x16: withType(
    () => 'uint',
    pack16((x) => roundHalfToEven(clamp(x, -1, 1) * 32767)),
  ),
  packUnorm2x16: withType(
    () => 'uint',
    pack16((x) => roundHalfToEven(clamp(x, 0, 1) * 65535)),
  ),
  packHalf2x16: withType(() => 'uint', pack16(toHalfFloat)),
  unpackSnorm2x16: withType(
    () => 'vec2',
    unpack16((u) => clamp(((u << 16) >> 16) / 32767, -1, 1)),
  ),
  unpackUnorm2x16: withType(
    () => 'vec2',
    unpack16((u) => u / 65535),
  ),
  unpackHalf2x16: withType(() => 'vec2', unpack16(fromHalfFloat)),

  length: scalarResult(length),
  distance: scalarResult((x, y) => length(plus(x, scale(y, -1)))),
  dot: scalarResult(dot),
  cross: {
    run: ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x],
  },
  normalize: { run: (x) => scale(x, 1 / length(x)) },
  faceforward: { run: (n, i, reference) => scale(n, dot(reference, i) < 0 ? 1 : -1) },
  reflect: { run: (i, n) => plus(i, scale(n, -2 * dot(n, i))) },
  refract: {
    run: (i, n, [eta]) => {
      const cosine = dot(n, i)
      const k = 1 - eta * eta * (1 - cosine * cosine)
      return k < 0 ? scale(i, 0) : plus(scale(i, eta), scale(n, -(eta * cosine + Math.sqrt(k))))
    },
  },

  matrixCompMult: { run: perComponent((x, y) => x * y) },
  outerProduct: withType(
    (a, b) => (a === b ? `mat${a.at(-1)}` : `mat${b.at(-1)}x${a.at(-1)}`),
    (a, b) => b.flatMap((x) => scale(a, x)),
  ),
  determinant: scalarResult(determinant),
  inverse: { run: inverse },

  lessThan: ofKindPerComponent('bool', (x, y) => x < y),
  lessThanEqual: ofKindPerComponent('bool', (x, y) => x <= y),
  greaterThan: ofKindPerComponent('bool', (x, y) => x > y),
  greaterThanEqual: ofKindPerComponent('bool', (x, y) => x >= y),
  equal: ofKindPerComponent('bool', (x, y) => x === y),
  notEqual: ofKindPerComponent('bool', (x, y) => x !== y),
  any: withType(
    () => 'bool',
    (x) => [x.some(Boolean)],
  ),
  all: withType(
    () => 'bool',
    (x) => [x.every(Boolean)],
  ),
  not: { run: perComponent((x) => !x) },
}
