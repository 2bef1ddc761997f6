// The operations for the generator: for each shape of a result, the shapes of arguments that lead to it, and the domains where
// they are defined.
import { chained } from './plain.js'
import { dimension, matrixShapes, vectorShapes } from './shapes.js'

/** Operations by component, with the domain of each argument. */
const componentwise = {
  neg: 'any',
  add: 'any any',
  sub: 'any any',
  mult: 'any any',
  div: 'any nonzero',
  pow: 'positive small',
  sqrt: 'positive',
  inversesqrt: 'positive',
  sin: 'any',
  cos: 'any',
  tan: 'unit',
  asin: 'unit',
  acos: 'unit',
  atan: 'any',
  sinh: 'small',
  cosh: 'small',
  tanh: 'any',
  asinh: 'any',
  acosh: 'above1',
  atanh: 'unit',
  exp: 'small',
  exp2: 'small',
  log: 'positive',
  log2: 'positive',
  abs: 'any',
  sign: 'any',
  floor: 'any',
  ceil: 'any',
  round: 'any',
  trunc: 'any',
  fract: 'any',
  mod: 'any nonzero',
  min: 'any any',
  max: 'any any',
  clamp: 'any any any',
  mix: 'any any any',
  step: 'any any',
  smoothstep: 'negative positive any',
  radians: 'any',
  degrees: 'unit',
  sum: 'any any',
  prod: 'any any',
}
const onVectors = {
  vecSum: 'any any',
  vecProd: 'any any',
  vecMix: 'any any any',
  vecClamp: 'any any any',
  vecMin: 'any any',
  vecMax: 'any any',
}
const comparisons = ['lt', 'le', 'gt', 'ge', 'eq', 'ne']

/** Makes a signature: the shapes of the arguments of an operation, and their domains. Signatures are chosen in proportion to `weight`. */
const signature = (op, shapes, domains = '', weight = 1) => {
  const domainList = domains.split(' ')
  return {
    op,
    weight,
    arguments: shapes.map((shape, i) => ({ shape, domain: domainList[i] || 'any' })),
  }
}

/** Returns a signature whose arguments have one shape; if that is a vector, some of them may become numbers. */
function componentSignature(op, shape, domains, weight) {
  const { length } = domains.split(' ')
  const row = signature(op, Array(length).fill(shape), domains, weight)
  return { ...row, broadcasts: shape !== 'float', chained: chained.has(op) }
}

const rows = (table, shape) =>
  Object.entries(table).map(([op, domains]) => componentSignature(op, shape, domains))

const floatSignatures = [
  ...rows(componentwise, 'float'),
  componentSignature('atan', 'float', 'nonzero any', 2),
  { ...signature('pow', ['float'], 'nonzero', 2), exponent: true },
  signature('ifElse', ['bool', 'float', 'float'], '', 3),
  ...vectorShapes.flatMap((v) => [
    signature('swizzle', [v], '', 2),
    signature('dot', [v, v]),
    signature('length', [v], 'direction'),
    signature('dist', [v, v], 'direction'),
    signature('distance', [v, v], 'direction'),
  ]),
  ...matrixShapes.map((m) => signature('determinant', [m], '', 2)),
]

const vectorSignatures = (v) => {
  const n = dimension(v)
  const m = `mat${n}`
  return [
    ...rows({ ...componentwise, ...onVectors }, v),
    componentSignature('atan', v, 'nonzero any', 2),
    { ...signature('pow', [v], 'nonzero', 2), exponent: true },
    ...['ifElse', 'vecIfElse'].flatMap((op) =>
      ['bool', `b${v}`].map((condition) => signature(op, [condition, v, v])),
    ),
    ...vectorShapes.map((from) => signature('swizzle', [from], '', 2)),
    ...constructorShapes(n).map((shapes) => signature(v, shapes)),
    signature('scale', [v, 'float'], '', 2),
    signature('normalize', [v], 'direction', 2),
    signature('reflect', [v, v], '', 2),
    signature('refract', [v, v, 'float'], 'direction direction unit', 2),
    signature('faceforward', [v, v, v], '', 2),
    ...(n === 3 ? [signature('cross', [v, v], '', 4)] : []),
    signature('mult', [m, v], '', 3),
    signature('mult', [v, m], '', 3),
    { ...signature('column', [m], '', 2), indexed: true },
    { ...signature('row', [m], '', 2), indexed: true },
  ]
}

/** Returns the shapes of arguments that construct a vector: floats and shorter vectors, or one number. */
function constructorShapes(n) {
  const shapes = ['float', 'vec2', 'vec3']
  const ways = (rest) =>
    rest === 0
      ? [[]]
      : shapes
          .slice(0, Math.min(rest, n - 1))
          .flatMap((shape) => ways(rest - dimension(shape)).map((way) => [shape, ...way]))
  return [['float'], ...ways(n)]
}

const matrixSignatures = (m) => {
  const n = dimension(m)
  return [
    signature('add', [m, m]),
    signature('sub', [m, m]),
    signature('neg', [m]),
    signature('mult', [m, m], '', 2),
    signature('mult', [m, 'float']),
    signature('div', [m, 'float'], 'any nonzero'),
    signature('transpose', [m]),
    signature('inverse', [m], 'invertible'),
    signature(m, Array(n).fill(`vec${n}`)),
    signature(`${m}Rows`, Array(n).fill(`vec${n}`)),
    signature(m, Array(n * n).fill('float'), '', 0.5),
    signature(m, ['float']),
    ...(n === 3 ? rotations : []),
  ]
}
const rotations = [
  signature('rotate', ['vec3', 'float'], 'direction'),
  ...['rotateX', 'rotateY', 'rotateZ'].map((op) => signature(op, ['float'])),
]

/** Returns signatures whose result is a bool, from numbers, or a bvec, from vectors. */
const conditionSignatures = (shape) => {
  const operand = shape === 'bool' ? 'float' : shape.slice(1)
  return [
    ...comparisons.map((op) => componentSignature(op, operand, 'any any')),
    componentSignature('and', shape, 'any any', 2),
    componentSignature('or', shape, 'any any', 2),
    componentSignature('not', shape, 'any'),
  ]
}

const table = { float: floatSignatures, bool: conditionSignatures('bool') }
for (const shape of vectorShapes) {
  table[shape] = vectorSignatures(shape)
  table[`b${shape}`] = conditionSignatures(`b${shape}`)
}
for (const shape of matrixShapes) table[shape] = matrixSignatures(shape)

/** Returns the signatures with the result `shape`. */
export const signaturesFor = (shape) => table[shape]

/** All names that the generator can use. */
export const operationNames = [
  ...new Set(
    Object.values(table)
      .flat()
      .map(({ op }) => op),
  ),
]
