/**
 * Guards functions of p5 and of JavaScript's Math that work only on numbers: while an offset function runs, such a function
 * throws if it gets an expression, with advice on what to write instead. Afterwards the originals are restored.
 */
import type { OffsetFunction } from '../../compile/hosts.js'
import { isExpression } from '../../errors/describe.js'
import { WarpError } from '../../errors/errors.js'
import { guardedKey } from '../../errors/operators.js'
import { sketchOf, type Canvas } from '../host.js'

/** Functions that expressions have as methods of the same name. */
const methods =
  'sin cos tan asin acos atan sinh cosh tanh abs floor ceil round sign trunc sqrt exp log log2 fract degrees radians'

/** Maps a function's name to what to write instead. */
const instead: Record<string, string> = {
  ...Object.fromEntries(methods.split(' ').map((name) => [name, `x.${name}()`])),
  atan2: 'glsl.atan(y, x)',
  pow: 'glsl.pow(x, 2)',
  sq: 'x.mult(x)',
  min: 'glsl.min(x, y)',
  max: 'glsl.max(x, y)',
  hypot: 'glsl.vec2(x, y).length()',
  mag: 'glsl.vec2(x, y).length()',
  dist: 'a.dist(b) of two vectors, such as glsl.vec2(x, y)',
  lerp: 'glsl.mix(from, to, amount)',
  constrain: 'glsl.clamp(x, low, high)',
  norm: 'x.sub(low).div(high - low)',
  map: 'x.sub(low).div(high - low).mult(newHigh - newLow).add(newLow)',
  noise: 'position.mult(3).noise(), or glsl.vec3(x, y, z).noise()',
  createVector: 'glsl.vec3(x, y, z)',
  color: 'glsl.vec4(red, green, blue, alpha)',
  millis: 'millis',
  // Functions of p5.strands.
  vec2: 'glsl.vec2(x, y)',
  vec3: 'glsl.vec3(x, y, z)',
  vec4: 'glsl.vec4(x, y, z, w)',
}

let hasWarned = false

/** Warns once: a time that stays constant is valid, but seldom intended. */
function warnAboutMillis() {
  if (hasWarned) return
  hasWarned = true
  console.warn(
    "createWarp: p5's millis() is constant in a warp; use the millis that the offset function gets, as in ({ glsl, millis }) => ….",
  )
}

/** Returns an offset function that guards these functions while it calls `offset`. */
export const withGuards =
  (canvas: Canvas, offset: OffsetFunction): OffsetFunction =>
  (inputs) => {
    const sketch = sketchOf(canvas)
    const undo = [
      ...guard(Math, 'Math.'),
      ...guard(sketch, "p5's "),
      ...(sketch._isGlobal ? guard(globalThis, "p5's ") : []),
    ]
    try {
      return offset(inputs)
    } finally {
      for (const restore of undo.reverse()) restore()
    }
  }

/** Replaces the functions of `object`; returns functions that restore them. */
function guard(object: object, owner: string): (() => void)[] {
  return Object.entries(instead).flatMap(([name, what]) => {
    const own = Object.getOwnPropertyDescriptor(object, name)
    const original: unknown = Reflect.get(object, name)
    if (typeof original !== 'function' || (own ? !own.configurable : !Object.isExtensible(object)))
      return []
    const value = function (this: unknown, ...given: unknown[]): unknown {
      if (given.some(isExpression))
        throw new WarpError(
          `${owner}${name} works on numbers, not on expressions of a warp; write ${what}.`,
        )
      if (name === 'millis') warnAboutMillis()
      return Reflect.apply(original, this, given)
    }
    Object.defineProperty(value, guardedKey, { value: original })
    Object.defineProperty(object, name, { value, configurable: true, writable: true })
    return () => {
      if (own) Object.defineProperty(object, name, own)
      else Reflect.deleteProperty(object, name)
    }
  })
}
