// Writes js-bindings/core/types/methods.ts: every operation as a method of its first operand and as a function of the builder.

// Each signature is written as a method with its own comment. (An editor shows no comment for a property whose type has several signatures.)

/**
 * The signatures of `mult` as a method of a number and as a function of the builder. A vector times square matrices is a vector.
 */
const productSignatures = [
  '(...numbers: Operand[]): Scalar',
  '<Value extends Scalar | Vector | Mat2 | Mat3 | Mat4>(...factors: (Value | Operand)[]): Value',
  '(...factors: (Vec2 | Mat2 | Operand)[]): Vec2',
  '(...factors: (Vec3 | Mat3 | Operand)[]): Vec3',
  '(...factors: (Vec4 | Mat4 | Operand)[]): Vec4',
  '<Value extends AnyMatrix>(matrix: Value, ...numbers: Operand[]): Value',
  '<Value extends AnyMatrix>(number: Operand, matrix: Value): Value',
  '<Left extends AnyMatrix>(matrix: Left, vector: VectorOf<ColumnsOf<Left>>): VectorOf<RowsOf<Left>>',
  '<Right extends AnyMatrix>(vector: VectorOf<RowsOf<Right>>, matrix: Right): VectorOf<ColumnsOf<Right>>',
  '<Left extends AnyMatrix, Columns extends Size>(left: Left, right: Shape<Columns, ColumnsOf<Left>>): MatrixOf<Columns, RowsOf<Left>>',
]

const quotientSignatures = [
  '(...numbers: Operand[]): Scalar',
  '<Value extends Scalar | Vector>(...operands: (Value | Operand)[]): Value',
]

/** Maps each operation that the general rules do not cover → its signatures in the interfaces with that name as `special`. */
const specialSignatures = {
  mult: {
    scalar: productSignatures,
    vector: ['(...factors: (Self | SquareBeside<Self> | Operand)[]): Self'],
    matrix: [
      '(...factors: (IfSquare<Self> | Operand)[]): Self',
      '(...factors: (IfSquare<Self> | VectorOf<ColumnsOf<Self>> | Operand)[]): VectorOf<RowsOf<Self>>',
      '<Columns extends Size>(matrix: Shape<Columns, ColumnsOf<Self>>): MatrixOf<Columns, RowsOf<Self>>',
    ],
    function: productSignatures,
  },
  div: {
    // Nothing can be divided by a matrix.
    scalar: quotientSignatures,
    matrix: ['(...divisors: Operand[]): Self'],
    function: [
      ...quotientSignatures,
      '<Value extends AnyMatrix>(matrix: Value, ...divisors: Operand[]): Value',
    ],
  },
}

/**
 * The methods of vectors that also accept separate numbers in place of a vector, like those of p5.Vector. Maps each name → the number of
 * operands after the vector.
 */
const operandsAfterVector = { mod: 0, dot: 0, cross: 0, dist: 0, distance: 0, mix: 1 }

/**
 * Writes one signature for a vector or separate numbers. Two overloads would not do: TypeScript allows a call on a union of vectors only if
 * the method has no overloads.
 */
const vectorOrNumbersSignature = (self) => (operation) => {
  const [signature] = methodSignatures(self)(operation)
  const after = operandsAfterVector[operation.name]
  if (after === undefined) return [signature]
  const numbers = `x: Operand, y: Operand, ...${after ? 'others' : 'zw'}: Operand[]`
  return [signature.replace(/^\((.*)\): /, `(...given: [$1] | [${numbers}]): `)]
}

const isComponentwise = ({ kinds }) => kinds.every((kind) => kind === 'number or vector')
const hasSeveralOperands = (operation) =>
  isComponentwise(operation) && (operation.kinds.length > 1 || operation.isOptional)

/**
 * The interfaces. `contains` selects the operations of an interface, `signaturesOf` writes the signatures of an operation, and `special` is
 * the name of the interface in `specialSignatures`.
 */
const interfaces = [
  {
    head: 'AnyMethods<Self>',
    description: 'Of numbers, vectors and matrices.',
    contains: ({ kinds }) => kinds[0] === 'any',
    signaturesOf: methodSignatures('Self'),
  },
  {
    head: 'ComponentMethods<Self> extends AnyMethods<Self>',
    description: 'Of numbers and vectors, by component.',
    contains: (operation) => isComponentwise(operation) && !hasSeveralOperands(operation),
    signaturesOf: methodSignatures('Self'),
  },
  {
    head: 'ScalarMethods extends ComponentMethods<Scalar>',
    description: 'Of numbers. A vector and a number give a vector.',
    contains: (operation) => operation.kinds[0] === 'number' || hasSeveralOperands(operation),
    special: 'scalar',
    signaturesOf: (operation) =>
      isComponentwise(operation)
        ? componentwiseSignatures(operation, 1)
        : methodSignatures('Scalar')(operation),
  },
  {
    head: 'VectorMethods<Self extends Shape<1, Size>> extends ComponentMethods<Self>',
    description: 'Of vectors. A number is used for each component.',
    contains: (operation) => operation.kinds[0] === 'vector' || hasSeveralOperands(operation),
    special: 'vector',
    signaturesOf: vectorOrNumbersSignature('Self'),
  },
  {
    head: 'Vec3Methods',
    contains: ({ kinds }) => kinds[0] === 'vec3',
    signaturesOf: vectorOrNumbersSignature('Vec3'),
  },
  {
    head: 'MatrixMethods<Self extends Shape<Size, Size>> extends AnyMethods<Self>',
    contains: ({ kinds, takesMatrices }) => takesMatrices || kinds[0] === 'matrix',
    special: 'matrix',
    signaturesOf: methodSignatures('Self'),
  },
  {
    head: 'SquareMethods<Self>',
    description: 'Of matrices of as many rows as columns.',
    contains: ({ kinds }) => kinds[0] === 'square matrix',
    signaturesOf: methodSignatures('Self'),
  },
  {
    head: 'Functions',
    description: 'Of the builder `glsl`.',
    contains: () => true,
    special: 'function',
    signaturesOf: functionSignatures,
    commentOf: functionComment,
  },
]

/** Returns the source of the file, not yet formatted. */
export function typesText({ operations, aliases }) {
  const merged = mergeByName(operations)
  const all = [...merged, ...aliases.map((alias) => resolveAlias(alias, merged))]
  return `// Written by \`npm run reference\` from the tables of operations: src/ops/declarations.hpp, src/ops/documentation.hpp and
// src/builder/compositions.hpp. Everything else is in types.ts.
import type {
  ColumnsOf, IfSquare, Jacobian, MatrixOf, RowsOf, Shape, Size, SquareBeside, Transposed, VectorOf,
} from './signatures.js'
import type {
  AnyMatrix, Expression, Mat2, Mat3, Mat4, Operand, Scalar, Vec2, Vec3, Vec4, Vector,
} from './types.js'

${interfaces.map((each) => writeInterface(each, all.filter(each.contains))).join('\n')}`
}

/** Merges operations of the same name into one with optional operands. */
function mergeByName(operations) {
  const names = [...new Set(operations.map(({ name }) => name))]
  return names.map((name) => {
    const forms = operations.filter((operation) => operation.name === name)
    return { ...forms.at(-1), base: name, forms, isOptional: forms.length > 1 }
  })
}

function resolveAlias({ name, original }, operations) {
  const operation = operations.find((operation) => operation.name === original)
  const meaning = `Another name of \`${original}\`.`
  return { ...operation, name, forms: [{ ...operation, meaning }] }
}

function writeInterface(definition, operations) {
  const { head, description, special, signaturesOf, commentOf = methodComment } = definition
  const members = operations.flatMap((operation) => {
    const signatures = specialSignatures[operation.base]?.[special] ?? signaturesOf(operation)
    return signatures.map((signature) => `${commentOf(operation)}${operation.name}${signature}\n`)
  })
  return `${description ? comment(description) : ''}export interface ${head} {\n${members.join('')}}\n`
}

/** Returns the comment of a method. If the meaning names the receiver, the comment begins with a call that shows it. */
function methodComment({ forms }) {
  const texts = forms.map(({ name, operands: [receiver, ...others], meaning, isChained }) => {
    if (!RegExp(`(?<![\\w'])${receiver}\\b`).test(meaning)) return meaning
    const parameters = isChained ? [...others, '…'] : others
    return `\`${receiver}.${name}(${parameters.join(', ')})\`: ${meaning}`
  })
  return comment(texts.join(' '))
}

/** Returns the comment of a function of the builder. If it has several forms, each begins with its call. */
function functionComment({ forms }) {
  if (forms.length === 1) return comment(forms[0].meaning)
  const texts = forms.map(
    ({ name, operands, meaning }) => `\`${name}(${operands.join(', ')})\`: ${meaning}`,
  )
  return comment(texts.join(' '))
}

/** Writes a comment in lines of at most 96 characters. */
const comment = (text) =>
  text.length <= 89
    ? `/** ${text} */\n`
    : `/**\n${text.replace(/(.{1,92})(?: |$)/g, ' * $1\n')} */\n`

/** Writes the parameters of a signature, for the operands from index `first` on. `typeOf` maps the kind of an operand → its type. */
function listParameters(operation, first, typeOf, restName = 'others') {
  const { operands, kinds, isChained, isOptional } = operation
  if (isChained) return `...${restName}: (${typeOf(kinds[0])})[]`
  const markOf = (i) => (isOptional && i > 0 ? '?' : '')
  return operands
    .map((name, i) => `${name}${markOf(i)}: ${typeOf(kinds[i])}`)
    .slice(first)
    .join(', ')
}

/**
 * Writes the signatures of a componentwise operation, for the operands from index `first` on. The result of numbers is a number. If an
 * operand is a vector, or a matrix where the operation takes matrices, the result has the type of this operand.
 */
function componentwiseSignatures(operation, first) {
  const listOf = (type) => listParameters(operation, first, () => type, 'operands')
  const widestType = operation.takesMatrices ? 'Expression' : 'Scalar | Vector'
  return [
    `(${listOf('Operand')}): Scalar`,
    `<Value extends ${widestType}>(${listOf('Value | Operand')}): Value`,
  ]
}

/** Maps each kind whose values have only one type → that type. */
const fixedTypes = {
  number: 'Operand',
  vec3: 'Vec3',
  mat3: 'Mat3',
  input: 'Scalar',
  'vec3 of inputs': 'Vec3',
}
/** Maps each other kind → the bound of its type parameter. */
const bounds = {
  vector: 'Vector',
  'square matrix': 'Mat2 | Mat3 | Mat4',
  matrix: 'AnyMatrix',
  any: 'Expression',
  'vector of inputs': 'Vector',
}

/** Returns a function that writes the signature of a method of the type `self`. */
function methodSignatures(self) {
  return (operation) => {
    const types = {
      ...fixedTypes,
      'number or vector': `${self} | Operand`,
      'vector of inputs': 'Inputs',
    }
    const generic = operation.kinds.includes('vector of inputs') ? '<Inputs extends Vector>' : ''
    const list = listParameters(operation, 1, (kind) => types[kind] ?? self)
    return [`${generic}(${list}): ${resultType(operation, self)}`]
  }
}

function functionSignatures(operation) {
  if (isComponentwise(operation)) return componentwiseSignatures(operation, 0)
  const { kinds, result } = operation
  // A type parameter relates operands to each other or to the result.
  const needsParameter = (kind) =>
    !(result in fixedTypes) || kinds.filter((other) => other === kind).length > 1
  const parameterOf = (kind) => (kind === 'vector of inputs' ? 'Inputs' : 'Value')
  const typeOf = (kind) =>
    fixedTypes[kind] ?? (needsParameter(kind) ? parameterOf(kind) : bounds[kind])
  const parameters = Object.keys(bounds)
    .filter((kind) => kinds.includes(kind) && needsParameter(kind))
    .map((kind) => `${parameterOf(kind)} extends ${bounds[kind]}`)
  const generic = parameters.length ? `<${parameters.join(', ')}>` : ''
  return [`${generic}(${listParameters(operation, 0, typeOf)}): ${resultType(operation, 'Value')}`]
}

/** Returns the type of the result if the widest operand has the type `self`. */
function resultType({ kinds, result }, self) {
  if (result === 'number') return 'Scalar'
  if (result in fixedTypes) return fixedTypes[result]
  const ofInputs = kinds.includes('vector of inputs')
  if (result === 'matrix') return ofInputs ? `Jacobian<${self}, Inputs>` : `Transposed<${self}>`
  return ofInputs ? 'Inputs' : self
}
