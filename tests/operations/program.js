// Makes a program from a case of the reference: its value and the derivatives with respect to every component of every input.
import { compile } from '../../dist/warpjet.js'
import { sizeOf } from '../support/browser/pipelines/text.js'

const makers = {
  1: 'param',
  2: 'vec2Param',
  3: 'vec3Param',
  4: 'vec4Param',
  mat2: 'mat2Param',
  mat3: 'mat3Param',
  mat4: 'mat4Param',
}

/** The builder's functions that make inputs. The cases call all of them, since they have inputs of every shape. */
export const inputMakers = Object.values(makers)

/** Returns the numbers of an input, as expressions; a matrix in column-major order. */
export function components(input, shape) {
  if (shape === 1) return [input]
  const letters = [...'xyzw'].slice(0, Number(`${shape}`.at(-1)))
  const letterOf = (vector) => letters.map((letter) => vector[letter]())
  return typeof shape === 'number'
    ? letterOf(input)
    : letters.flatMap((_, i) => letterOf(input.column(i)))
}

/** Returns the shape of a derivative. Derivatives of conditions are zeros: 1 for a bool, as many as components for a vector of bools. */
const slopeShape = (shape) => (/^b/.test(shape) ? Number(`${shape}`.at(-1)) || 1 : shape)

/** The ways to call the operation: as a method of its first operand, and as a function of the builder. */
export const forms = ({ only }) => (only ? [only] : ['method', 'builder'])

/**
 * Returns the program for `target`, { code, declarations, inputs, outputs, evaluate }, for the pipelines. The outputs are the
 * value and its derivative with respect to each number of the inputs.
 */
export function programOf(operation, target, form = forms(operation).at(-1)) {
  const { name, inputs, result, build } = operation
  const slopes = inputs.flatMap(({ shape }) => Array(sizeOf(shape)).fill(slopeShape(result)))
  const { code, declarations, evaluate } = compile(
    (glsl) => {
      const call = (first, ...others) =>
        form === 'method' ? first[name](...others) : glsl[name](first, ...others)
      const operands = inputs.map((input) => glsl[makers[input.shape]](input.name))
      const value = build({ glsl, call }, ...operands)
      const numbers = operands.flatMap((operand, i) => components(operand, inputs[i].shape))
      return {
        value,
        ...Object.fromEntries(numbers.map((by, i) => [`by${i}`, glsl.derivative(value, by)])),
      }
    },
    { target },
  )
  const outputs = [
    { name: 'value', shape: result },
    ...slopes.map((shape, i) => ({ name: `by${i}`, shape })),
  ]
  return { code, declarations, inputs, outputs, evaluate }
}

/** Runs a program on the CPU, in double precision, and returns all floats of its outputs for each point. */
export const runOnCpu = ({ inputs, outputs, evaluate }, points) =>
  points.map((point) => {
    let next = 0
    const values = inputs.map(({ name, shape }) => {
      const numbers = point.slice(next, (next += sizeOf(shape)))
      return [name, shape === 1 ? numbers[0] : numbers]
    })
    const results = evaluate(Object.fromEntries(values))
    return outputs.flatMap(({ name }) => results[name])
  })
