// Writes js-bindings/core/types/methods.ts: every operation as a method of its first operand and as a function of the builder.

import { readFileSync } from 'node:fs'
import { path } from '../lib/files.mjs'

// Every signature has its own comment: an editor shows no comment for a property whose type has several signatures.

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

/** The signatures of operations that the general rules do not cover, by receiver. */
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
 * Methods of vectors that also accept a vector as separate numbers, like p5.Vector's. Maps each → the number of operands after the vector.
 */
const operandsAfterVector = { mod: 0, dot: 0, cross: 0, dist: 0, distance: 0, mix: 1 }

/**
 * Returns the signature for a vector or separate numbers. It is one, because TypeScript allows a call on a union of vectors only without
 * overloads.
 */
function vectorOrNumbersSignature(operation, self) {
  const [signature] = methodSignatures(self)(operation)
  const after = operandsAfterVector[operation.name]
  if (after === undefined) return [signature]
  const numbers = `x: Operand, y: Operand, ...${after ? 'others' : 'zw'}: Operand[]`
  return [signature.replace(/^\((.*)\): /, `(...given: [$1] | [${numbers}]): `)]
}

/** The interfaces of methods, each with the operations that it contains. */
const receivers = [
  {
    head: 'AnyMethods<Self>',
    description: 'Of numbers, vectors and matrices.',
    contains: ({ kinds }) => kinds[0] === 'any',
    signaturesOf: methodSignatures('Self'),
  },
  {
    head: 'ComponentMethods<Self> extends AnyMethods<Self>',
    description: 'Of numbers and vectors, by component.',
    contains: ({ kinds, isOptional }) =>
      isComponentwise(kinds) && kinds.length === 1 && !isOptional,
    signaturesOf: methodSignatures('Self'),
  },
  {
    head: 'ScalarMethods extends ComponentMethods<Scalar>',
    description: 'Of numbers. A vector and a number give a vector.',
    contains: ({ kinds, isOptional }) =>
      kinds[0] === 'number' || (isComponentwise(kinds) && (kinds.length > 1 || isOptional)),
    signaturesOf: (operation) =>
      specialSignatures[operation.base]?.scalar ??
      (isComponentwise(operation.kinds)
        ? componentwiseSignatures(operation, 1)
        : methodSignatures('Scalar')(operation)),
  },
  {
    head: 'VectorMethods<Self extends Shape<1, Size>> extends ComponentMethods<Self>',
    description: 'Of vectors. A number is used for each component.',
    contains: ({ kinds, isOptional }) =>
      kinds[0] === 'vector' || (isComponentwise(kinds) && (kinds.length > 1 || isOptional)),
    signaturesOf: (operation) =>
      specialSignatures[operation.base]?.vector ?? vectorOrNumbersSignature(operation, 'Self'),
  },
  {
    head: 'Vec3Methods',
    contains: ({ kinds }) => kinds[0] === 'vec3',
    signaturesOf: (operation) => vectorOrNumbersSignature(operation, 'Vec3'),
  },
  {
    head: 'MatrixMethods<Self extends Shape<Size, Size>> extends AnyMethods<Self>',
    contains: ({ kinds, takesMatrices }) => takesMatrices || kinds[0] === 'matrix',
    signaturesOf: (operation) =>
      specialSignatures[operation.base]?.matrix ?? methodSignatures('Self')(operation),
  },
  {
    head: 'SquareMethods<Self>',
    description: 'Of matrices of as many rows as columns.',
    contains: ({ kinds }) => kinds[0] === 'square matrix',
    signaturesOf: methodSignatures('Self'),
  },
]

const isComponentwise = (kinds) => kinds.every((kind) => kind === 'number or vector')

/** Returns the source of the file, not yet formatted. */
export function typesText({ operations, aliases }) {
  const merged = mergeByName(operations)
  const all = [...merged, ...aliases.map((alias) => resolveAlias(alias, merged))]
  const interfaces = [
    ...receivers.map(({ head, description, contains, signaturesOf }) =>
      interfaceText(head, description, all.filter(contains), signaturesOf, methodComment),
    ),
    interfaceText('Functions', 'Of the builder `glsl`.', all, functionSignatures, functionComment),
  ]
  return `// Written by \`npm run reference\` from the tables of operations: src/ops/declarations.hpp, src/ops/documentation.hpp and
// src/builder/compositions.hpp. Everything else is in types.ts.
import type { ${listUsed(interfaces, 'signatures')} } from './signatures.js'
import type { ${listUsed(interfaces, 'expressions')} } from './types.js'

${interfaces.join('\n')}`
}

/** Lists the names that a file of js-bindings/core/types exports and that `texts` use. */
function listUsed(texts, file) {
  const source = readFileSync(path(`js-bindings/core/types/${file}.ts`), 'utf8')
  return [...source.matchAll(/^export (?:type|interface) (\w+)/gm)]
    .map(([, name]) => name)
    .filter((name) => texts.some((text) => RegExp(`\\b${name}\\b`).test(text)))
    .sort()
    .join(', ')
}

/** Merges operations of the same name into one with optional operands. */
function mergeByName(operations) {
  const merged = new Map()
  for (const operation of operations) {
    const forms = [...(merged.get(operation.name)?.forms ?? []), operation]
    const isOptional = forms.length > 1
    merged.set(operation.name, { ...operation, base: operation.name, forms, isOptional })
  }
  return [...merged.values()]
}

function resolveAlias({ name, original }, operations) {
  const operation = operations.find((operation) => operation.name === original)
  return {
    ...operation,
    name,
    forms: [{ ...operation, meaning: `Another name of \`${original}\`.` }],
  }
}

function interfaceText(head, description, operations, signaturesOf, commentOf) {
  const members = operations.flatMap((operation) =>
    signaturesOf(operation).map(
      (signature) => `${commentOf(operation)}${operation.name}${signature}\n`,
    ),
  )
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

function comment(text, width = 96) {
  if (text.length + 7 <= width) return `/** ${text} */\n`
  const lines = ['']
  for (const word of text.split(' ')) {
    if (`${lines.at(-1)} ${word}`.length + 3 > width) lines.push('')
    lines[lines.length - 1] += ` ${word}`
  }
  return `/**\n${lines.map((line) => ` *${line}\n`).join('')} */\n`
}

const optionalMark = ({ isOptional }, i) => (isOptional && i > 0 ? '?' : '')

/**
 * Returns the signatures of a componentwise operation, for the operands from index `first`: numbers give a number; otherwise the result is a
 * vector, or a matrix if the operation takes them, of the size of the operands.
 */
function componentwiseSignatures(operation, first) {
  const { operands, isChained, takesMatrices } = operation
  const listOf = (type) =>
    isChained
      ? `...operands: (${type})[]`
      : operands
          .slice(first)
          .map((name, i) => `${name}${optionalMark(operation, first + i)}: ${type}`)
          .join(', ')
  const wide = takesMatrices ? 'Expression' : 'Scalar | Vector'
  return [
    `(${listOf('Operand')}): Scalar`,
    `<Value extends ${wide}>(${listOf('Value | Operand')}): Value`,
  ]
}

/** Returns a function that writes the signature of a method of the type `self`. */
function methodSignatures(self) {
  const types = {
    number: 'Operand',
    vector: self,
    vec3: 'Vec3',
    'number or vector': `${self} | Operand`,
    'square matrix': self,
    matrix: self,
    mat3: 'Mat3',
    any: self,
    input: 'Scalar',
    'vector of inputs': 'Inputs',
    'vec3 of inputs': 'Vec3',
  }
  return (operation) => {
    const { operands, kinds, isChained } = operation
    const generic = kinds.includes('vector of inputs') ? '<Inputs extends Vector>' : ''
    const others = operands
      .slice(1)
      .map((name, i) => `${name}${optionalMark(operation, i + 1)}: ${types[kinds[i + 1]]}`)
    const list = isChained ? `...others: (${types[kinds[0]]})[]` : others.join(', ')
    return [`${generic}(${list}): ${resultType(operation, self)}`]
  }
}

function functionSignatures(operation) {
  const { operands, kinds, base } = operation
  if (specialSignatures[base]?.function) return specialSignatures[base].function
  if (isComponentwise(kinds)) return componentwiseSignatures(operation, 0)
  const generics = {
    vector: ['Value', 'Vector'],
    'square matrix': ['Value', 'Mat2 | Mat3 | Mat4'],
    matrix: ['Value', 'AnyMatrix'],
    any: ['Value', 'Expression'],
    'vector of inputs': ['Inputs', 'Vector'],
  }
  const types = {
    number: 'Operand',
    vec3: 'Vec3',
    mat3: 'Mat3',
    input: 'Scalar',
    'vec3 of inputs': 'Vec3',
  }
  const isFixed = ['number', 'vec3', 'mat3'].includes(operation.result)
  const needsTypeParameter = (kind) =>
    !isFixed || kinds.filter((other) => other === kind).length > 1
  const typeOf = (kind) => generics[kind]?.[needsTypeParameter(kind) ? 0 : 1] ?? types[kind]
  const bounds = Object.entries(generics)
    .filter(([kind]) => kinds.includes(kind) && needsTypeParameter(kind))
    .map(([, generic]) => generic.join(' extends '))
  const list = operands.map((name, i) => `${name}: ${typeOf(kinds[i])}`).join(', ')
  const start = bounds.length ? `<${bounds.join(', ')}>` : ''
  return [`${start}(${list}): ${resultType(operation, 'Value')}`]
}

/** Returns the type of the result if the widest operand has the type `self`. */
function resultType({ kinds, result }, self) {
  if (result === 'number') return 'Scalar'
  if (result === 'vec3') return 'Vec3'
  if (result === 'mat3') return 'Mat3'
  const ofInputs = kinds.includes('vector of inputs')
  if (result === 'matrix') return ofInputs ? `Jacobian<${self}, Inputs>` : `Transposed<${self}>`
  return ofInputs ? 'Inputs' : self
}
