// `glsl.texture`: an image of the host as a function of texture coordinates. The interpolation is in src/texture.
import type { Compilation } from './compilation.js'
import { WarpError, describe } from './errors.js'
import { type Expression, toExpression } from './expression.js'
import { checkOptions } from './options.js'

/** In the order of their numbers in the wasm, `Filter` and `Wrap`. */
const filters = ['bilinear', 'bicubic', 'bspline']
const wraps = ['clamp', 'repeat', 'mirror']

export function callTexture(
  compilation: Compilation,
  [sampler, uv, options, ...others]: readonly unknown[],
): Expression {
  if (typeof sampler !== 'string')
    throw new WarpError(
      `texture: argument 1 must be the name of a sampler2D of the shader, such as "heightMap", but is ${describe(sampler)}.`,
    )
  const operand = toExpression(compilation, 'texture', uv, 2)
  if (others.length > 0)
    throw new WarpError(
      `texture: it takes a name, a vec2 and options; ${describe(others[0])} is too many.`,
    )
  checkOptions('texture', options, ['filter', 'wrap'])
  const { filter = 'bilinear', wrap = 'clamp' } = (options ?? {}) as Record<string, unknown>
  return compilation.texture(
    sampler,
    operand,
    numberOf('filter', filters, filter),
    numberOf('wrap', wraps, wrap),
  )
}

function numberOf(option: string, names: string[], value: unknown): number {
  const number = names.indexOf(value as string)
  if (number >= 0) return number
  throw new WarpError(
    `texture: the option "${option}" must be one of ${names.join(', ')}, but is ${describe(value)}.`,
  )
}
