// What stands for the builder `glsl` where a call of the docs is to be computed in double: each operation is the formula that the
// docs print, and noise the plain one. Nothing of warpjet is in it.
import { formulas } from '../../.scripts/reference/formulas.mjs'
import { vectorFormulas } from '../../.scripts/reference/vector-formulas.mjs'
import { isMatrix, transpose } from './linear.js'
import * as noise from './noise.js'
import { evaluated } from './notation.js'
import * as numbers from './number-formulas.js'

/** The letters of a form, such as `rotate(a, φ) v`, but for the v that is turned. */
export const lettersOf = (form) => /\((.*)\)/.exec(form)[1].split(', ')

/** The matrix that turns v so. */
export const turns = Object.fromEntries(
  Object.entries(vectorFormulas)
    .filter(([, { form }]) => form.endsWith(') v'))
    .map(([name, { form, value, where }]) => [
      name,
      (...given) => {
        const known = Object.fromEntries(lettersOf(form).map((letter, i) => [letter, given[i]]))
        const turned = ([x, y, z]) => evaluated(value, { ...known, v: [x, y, z] }, where)
        return transpose([turned([1, 0, 0]), turned([0, 1, 0]), turned([0, 0, 1])])
      },
    ]),
)

function titleOf(name, values) {
  if (name === 'atan' && values.length > 1) return 'atan(y, x)'
  if (name !== 'mult' || !values.some(isMatrix)) return name
  const [first, second] = values.map(isMatrix)
  return first && second ? 'mult(A, B)' : first ? 'mult(A, v)' : 'mult(v, A)'
}

function computed(name, values) {
  if (turns[name]) return turns[name](...values)
  if (/^vec\d$/.test(name)) return values
  if (/^mat\d$/.test(name)) {
    const size = Number(name[3])
    const column = (i) => values.slice(i * size, (i + 1) * size)
    return transpose(Array.from({ length: size }, (_, i) => column(i)))
  }
  if (noise[name]) return noise[name]([values[0]].flat(), values[1])
  if (name === 'column') return transpose(values[0])[values[1]]
  const title = titleOf(name, values)
  const vector = vectorFormulas[title]
  if (vector) {
    const known = Object.fromEntries(lettersOf(vector.form).map((letter, i) => [letter, values[i]]))
    const result = evaluated(vector.value, { ...known, count: values[0].length }, vector.where)
    // `0` is written for a vector, too.
    return result === 0 && title === 'refract' ? values[0].map(() => 0) : result
  }
  const { value, by, where } = formulas[title]
  const named = numbers.operandsOf(title, by.length).map((operand, i) => [operand, values[i]])
  return numbers.evaluated(value, Object.fromEntries(named), where)
}

const plain = (given) => given?.plain ?? given

/** A value with the operations as methods; what it is stands in `plain`. */
export const wrapped = (value) =>
  new Proxy(
    { plain: value },
    {
      get(target, name) {
        if (name === 'plain') return target.plain
        if (/^[xyzw]$/.test(name)) return () => wrapped(target.plain['xyzw'.indexOf(name)])
        return (...rest) => builder[name](target.plain, ...rest)
      },
    },
  )

export const builder = new Proxy(
  {},
  {
    get:
      (_, name) =>
      (...given) =>
        wrapped(computed(name, given.map(plain))),
  },
)
