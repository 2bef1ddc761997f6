// Expressions as plain objects, { op, shape, size, args, … }: generates their code for our builder, and computes their values in
// plain numbers. Leaves are { op: 'input', name } and { op: 'number', value, raw }; raw numbers are written as JavaScript
// numbers.
import { apply } from './plain.js'
import { componentShape, dimension, isMatrix, sizeOf } from './shapes.js'

export const node = (op, shape, args, more = {}) => ({
  op,
  shape,
  size: sizeOf(shape),
  args,
  ...more,
})
export const number = (value, raw = true) => node('number', 'float', [], { value, raw })

/** The inputs that every expression may read. */
export const inputs = Object.entries({
  x: 'float',
  y: 'float',
  z: 'float',
  p: 'vec2',
  q: 'vec3',
  r: 'vec4',
  a: 'mat2',
  b: 'mat3',
  c: 'mat4',
}).map(([name, shape]) => ({ name, shape }))

export const inputNode = ({ name, shape }) => node('input', shape, [], { name })

function componentText({ name, shape }, index) {
  if (shape === 'float') return name
  const size = dimension(shape)
  const vector = isMatrix(shape) ? `${name}.column(${Math.floor(index / size)})` : name
  return `${vector}.${'xyzw'[index % size]}()`
}

/** The variables by which expressions are differentiated: numbers, and components of vectors and matrices. */
export const components = inputs.flatMap((input) =>
  Array.from({ length: sizeOf(input.shape) }, (_, index) => ({
    name: input.name,
    index,
    text: componentText(input, index),
  })),
)

/** Returns all nodes, starting with the root. */
export function* nodesOf(root) {
  yield root
  for (const argument of root.args) yield* nodesOf(argument)
}

export const depthOf = (root) => 1 + Math.max(0, ...root.args.map(depthOf))

/** Returns the names of the inputs that an expression reads. */
export const inputsOf = (root) =>
  new Set([...nodesOf(root)].filter(({ op }) => op === 'input').map(({ name }) => name))

/**
 * Returns the value of an expression as a flat list. `around(node, values, compute)`, if present, computes the value of each node
 * from those of its arguments; `compute(values)` is the correct value.
 */
export function evaluate(root, point, { operations, around } = {}) {
  const visit = (node) => {
    const compute = (values) => {
      if (node.op === 'input') return point[node.name]
      return node.op === 'number' ? [node.value] : apply(node, values, operations)
    }
    const values = node.args.map(visit)
    return around ? around(node, values, compute) : compute(values)
  }
  return visit(root)
}

/** Returns the JavaScript of an expression. `form` of a node is 'method' (its first argument is the receiver) or 'builder'. */
export function textOf(node) {
  const { op, args } = node
  if (op === 'input') return node.name
  if (op === 'number') return node.raw ? String(node.value) : `glsl.val(${node.value})`
  if (op === 'swizzle') return `${textOf(args[0])}.${node.letters}()`
  if (op === 'column' || op === 'row') return `${textOf(args[0])}.${op}(${node.index})`
  const texts = args.map(textOf)
  if (node.form === 'method' && !args[0].raw)
    return `${texts[0]}.${op}(${texts.slice(1).join(', ')})`
  return `glsl.${op}(${texts.join(', ')})`
}

const paramName = (shape) => (shape === 'float' ? 'param' : `${shape}Param`)

/** Returns the callback for `compile` as code: declares the inputs, and returns results, [{ name, text }], made from `value`. */
export function callbackText(root, results) {
  const names = new Set(inputsOf(root))
  for (const { name } of components)
    if (results.some(({ text }) => new RegExp(`(?<![.\\w])${name}\\b`).test(text))) names.add(name)
  return [
    '(glsl) => {',
    ...inputs
      .filter(({ name }) => names.has(name))
      .map(({ name, shape }) => `  const ${name} = glsl.${paramName(shape)}('${name}')`),
    `  const value = ${textOf(root)}`,
    `  return { ${results.map(({ name, text }) => `${name}: ${text}`).join(', ')} }`,
    '}',
  ].join('\n')
}

/** Returns the result that is the value itself. */
export const valueResult = ({ shape }) => ({ name: 'value', text: 'value', shape })

/**
 * Returns the derivatives of an expression as [{ name, text, shape, entries }]: its first derivatives with respect to all components of
 * numbers and vectors, and to one entry of each matrix. `entries` has { place, by } for each number of the result: the index of a component
 * of the value, and the list of components of inputs by which it is differentiated.
 */
export function derivativeResults(root, random) {
  if (root.shape === 'bool') return []
  const usedInputs = inputsOf(root)
  return inputs
    .filter(({ name }) => usedInputs.has(name))
    .flatMap(({ name, shape }) => {
      const by = components.filter((component) => component.name === name)
      if (isMatrix(shape)) return singleResult(root, by[Math.floor(by.length * random())])
      if (shape !== 'float' && !isMatrix(root.shape) && random() < 0.5)
        return gradientResult(root, name, by)
      return by.map((component) => singleResult(root, component))
    })
}

const componentIndices = (root) => Array.from({ length: root.size }, (_, i) => i)

/** Returns the derivative with respect to one component. */
export function singleResult(root, by) {
  return {
    name: `d_${by.name}${by.index}`,
    text: `glsl.derivative(value, ${by.text})`,
    shape: root.shape,
    entries: componentIndices(root).map((place) => ({ place, by: [by] })),
  }
}

/** Returns the gradient of a number, or the Jacobian of a vector: a row for each component of the value. */
function gradientResult(root, name, by) {
  const scalar = root.shape === componentShape(root.shape)
  const [rows, columns] = [dimension(root.shape), by.length]
  const square = rows === columns ? rows : `${columns}x${rows}`
  return {
    name: `${scalar ? 'gradient' : 'jacobian'}_${name}`,
    text: `glsl.${scalar ? 'gradient' : 'jacobian'}(value, ${name})`,
    shape: scalar ? `vec${columns}` : `mat${square}`,
    entries: by.flatMap((component) =>
      componentIndices(root).map((place) => ({ place, by: [component] })),
    ),
  }
}

/** Returns the second derivative with respect to two components. */
export const secondResult = (root, first, second) => ({
  name: `d_${first.name}${first.index}_${second.name}${second.index}`,
  text: `glsl.derivative(glsl.derivative(value, ${first.text}), ${second.text})`,
  shape: root.shape,
  entries: componentIndices(root).map((place) => ({ place, by: [first, second] })),
})
