// Every swizzle that there is, all in one program.
import { compile } from '../../dist/warpjet.js'
import { letterSets, swizzled } from './reference/row.js'

/** All words of up to four of the letters. */
function words(letters, most = 4) {
  if (most === 0) return ['']
  const shorter = words(letters, most - 1)
  return ['', ...[...letters].flatMap((letter) => shorter.map((word) => letter + word))]
}

/** Their names, from `x` to `vvvv`. */
export const swizzles = letterSets.flatMap((letters) => words(letters).filter(Boolean))

export const points = [[0.5, -1.25, 2, 3.5]]

/** The numbers of each swizzle of the point, one after the other. */
export const expected = swizzles.flatMap((name) => swizzled(name, points[0]))

/** As `programOf` of program.js has it. */
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
