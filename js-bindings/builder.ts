// `glsl`, as a sketch gets it: makes inputs and constants, and has every operation as a function.
import type { Compilation } from './compilation.js'
import { Expression, toExpression } from './expression.js'
import { call, operationNames } from './operations.js'
import { compose, compositions, construct, swizzle, swizzles } from './vectors.js'
import { WarpError } from './errors.js'

export class Builder {
  readonly #compilation: Compilation

  constructor(compilation: Compilation) {
    this.#compilation = compilation
    installMethods()
  }

  param(name: string) {
    return this.#compilation.input(name, 1, 'param')
  }
  vec2Param(name: string) {
    return this.#compilation.input(name, 2, 'vec2Param')
  }
  vec3Param(name: string) {
    return this.#compilation.input(name, 3, 'vec3Param')
  }
  vec4Param(name: string) {
    return this.#compilation.input(name, 4, 'vec4Param')
  }

  val(value: number) {
    return toExpression(this.#compilation, 'val', value, 'argument 1')
  }
  vec2(...parts: unknown[]) {
    return construct(this.#compilation, 2, parts)
  }
  vec3(...parts: unknown[]) {
    return construct(this.#compilation, 3, parts)
  }
  vec4(...parts: unknown[]) {
    return construct(this.#compilation, 4, parts)
  }

  derivative(value: unknown, input: unknown) {
    return this.#compilation.derivative(
      toExpression(this.#compilation, 'derivative', value, 'argument 1'),
      toExpression(this.#compilation, 'derivative', input, 'argument 2'),
      'derivative',
    )
  }

  /** Calls any operation as a function. */
  static apply(builder: Builder, run: typeof call, name: string, operands: unknown[]) {
    return run(builder.#compilation, name, operands, false)
  }
}

/** Methods that ask for results, as glsl-autodiff has them. */
const results = {
  output(this: Expression, name: unknown) {
    this.compilation.output(name, this, 'output')
  },
  outputDeriv(this: Expression, name: unknown, input: unknown) {
    const { compilation } = this
    const by = toExpression(compilation, 'outputDeriv', input, 'argument 2')
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

/** Puts every operation on expressions and on `glsl`. The table is in the wasm, so this waits for it. */
function installMethods() {
  if (installed) return
  installed = true
  for (const name of operationNames()) install(name, call)
  for (const name of Object.keys(compositions)) install(name, compose)
  for (const [name, indices] of swizzles())
    define(Expression.prototype, name, function (this: Expression) {
      return swizzle(this, name, indices)
    })
  for (const [name, method] of Object.entries(results)) define(Expression.prototype, name, method)
}

function install(name: string, run: typeof call) {
  define(Expression.prototype, name, function (this: Expression, ...operands: unknown[]) {
    return run(this.compilation, name, [this, ...operands], true)
  })
  define(Builder.prototype, name, function (this: Builder, ...operands: unknown[]) {
    return Builder.apply(this, run, name, operands)
  })
}

function define(prototype: object, name: string, value: unknown) {
  Object.defineProperty(prototype, name, { value, configurable: true, writable: true })
}
