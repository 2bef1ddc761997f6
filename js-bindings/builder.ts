// `glsl`, as a sketch gets it: makes inputs and constants, and has every operation as a function.
import type { Compilation } from './compilation.js'
import { Expression, toExpression } from './expression.js'
import { call, operationNames } from './operations.js'
import { compose, compositions, construct, swizzle, swizzles } from './vectors.js'
import { WarpError } from './errors.js'

export type Builder = Record<string, (...operands: unknown[]) => Expression>

/** Functions that need no `this`, so that `const { vec3, sin } = glsl` works. */
export function createBuilder(compilation: Compilation): Builder {
  installMethods()
  const builder: Builder = {
    val: (value) => toExpression(compilation, 'val', value, 1),
    derivative: (value, input) =>
      compilation.derivative(
        toExpression(compilation, 'derivative', value, 1),
        toExpression(compilation, 'derivative', input, 2),
        'derivative',
      ),
  }
  const params = { param: 1, vec2Param: 2, vec3Param: 3, vec4Param: 4 }
  for (const [name, size] of Object.entries(params))
    builder[name] = (label, ...others) => {
      if (others.length > 0)
        throw new WarpError(
          `${name}: it takes only a name; there are param, vec2Param, vec3Param and vec4Param.`,
        )
      return compilation.input(label, size, name)
    }
  for (const size of [2, 3, 4])
    builder[`vec${size}`] = (...parts) => construct(compilation, size, parts)
  for (const name of operationNames())
    builder[name] = (...operands) => call(compilation, name, operands)
  for (const name of Object.keys(compositions))
    builder[name] = (...operands) => compose(compilation, name, operands)
  return builder
}

/** Methods that ask for results, as glsl-autodiff has them. */
const results = {
  output(this: Expression, name: unknown) {
    this.compilation.output(name, this, 'output')
  },
  outputDeriv(this: Expression, name: unknown, input: unknown) {
    const { compilation } = this
    const by = toExpression(compilation, 'outputDeriv', input, 2)
    compilation.output(name, compilation.derivative(this, by, 'outputDeriv'), 'outputDeriv')
  },
  adjustNormal(this: Expression, normal: unknown, position: unknown) {
    const { compilation } = this
    const vectors = [this, normal, position].map((operand, i) => {
      const place = i === 0 ? 'the offset' : `argument ${i}`
      const vector = toExpression(compilation, 'adjustNormal', operand, place)
      if (vector.ids.length === 3) return vector
      throw new WarpError(`adjustNormal: ${place} must be a vec3.`)
    }) as [Expression, Expression, Expression]
    return compilation.warpedNormal(vectors[2], vectors[1], vectors[0], 'adjustNormal')
  },
}

let installed = false

/** Puts every operation on expressions. The table is in the wasm, so this waits for the first warp. */
function installMethods() {
  if (installed) return
  installed = true
  for (const name of operationNames())
    define(name, function (...operands) {
      return call(this.compilation, name, operands, this)
    })
  for (const name of Object.keys(compositions))
    define(name, function (...operands) {
      return compose(this.compilation, name, operands, this)
    })
  for (const [name, indices] of swizzles())
    define(name, function () {
      return swizzle(this, name, indices)
    })
  for (const [name, method] of Object.entries(results)) define(name, method)
}

function define(name: string, method: (this: Expression, ...operands: unknown[]) => unknown) {
  const value = function (this: unknown, ...operands: unknown[]) {
    if (this instanceof Expression) return method.apply(this, operands)
    throw new WarpError(`${name}: call it on an expression, as in x.${name}(…).`)
  }
  Object.defineProperty(Expression.prototype, name, { value, configurable: true, writable: true })
}
