// Makes one program that reads every swizzle.
import { compile } from '../../dist/warpjet.js'
import { letterSets, swizzle } from './reference/row.js'

/** Returns all words of up to `max` of the letters. */
function words(letters, max = 4) {
  if (max === 0) return ['']
  const shorter = words(letters, max - 1)
  return ['', ...[...letters].flatMap((letter) => shorter.map((word) => letter + word))]
}

/** The names of the swizzles, from `x` to `vvvv`. */
export const swizzles = letterSets.flatMap((letters) => words(letters).filter(Boolean))

export const points = [[0.5, -1.25, 2, 3.5]]

/** Returns the numbers of each swizzle of the point, one after the other. */
export const expected = swizzles.flatMap((name) => swizzle(name, points[0]))

/** Returns a program with the members that `programOf` of program.js returns. */
export function swizzleProgram(target) {
  const inputs = [{ name: 'v', shape: 4 }]
  const outputs = swizzles.map((name) => ({ name: `by_${name}`, shape: name.length }))
  const compiled = compile(
    (glsl) => {
      const v = glsl.vec4Param('v')
      return Object.fromEntries(swizzles.map((name) => [`by_${name}`, v[name]()]))
    },
    { target },
  )
  return { ...compiled, inputs, outputs }
}
