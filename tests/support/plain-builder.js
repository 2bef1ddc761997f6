// A replacement for the builder `glsl` that evaluates calls in double precision: operations by the formulas in the docs, noise by noise.js.
// Independent of warpjet.
import { formulas } from '../../.scripts/reference/formulas.mjs'
import { vectorFormulas } from '../../.scripts/reference/vector-formulas.mjs'
import { isMatrix, transpose } from './linear.js'
import * as noise from './noise.js'
import { evaluateFormula } from './notation.js'
import * as numbers from './number-formulas.js'

/** Returns the operands of a form: for `rotate(a, φ) v`, these are a and φ. */
export const lettersOf = (form) => /\((.*)\)/.exec(form)[1].split(', ')

/** Maps the name of a rotation → a function that returns its matrix. */
export const turns = Object.fromEntries(
  Object.entries(vectorFormulas)
    .filter(([, { form }]) => form.endsWith(') v'))
    .map(([name, { form, value, where }]) => [
      name,
      (...operands) => {
        const known = Object.fromEntries(lettersOf(form).map((letter, i) => [letter, operands[i]]))
        const rotate = ([x, y, z]) => evaluateFormula(value, { ...known, v: [x, y, z] }, where)
        return transpose([rotate([1, 0, 0]), rotate([0, 1, 0]), rotate([0, 0, 1])])
      },
    ]),
)

/** Returns the title of an operation in the docs. */
function titleOf(name, values) {
  if (name === 'atan' && values.length > 1) return 'atan(y, x)'
  if (name !== 'mult' || !values.some(isMatrix)) return name
  const [first, second] = values.map(isMatrix)
  return first && second ? 'mult(A, B)' : first ? 'mult(A, v)' : 'mult(v, A)'
}

function compute(name, values) {
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
    const result = evaluateFormula(
      vector.value,
      { ...known, count: values[0].length },
      vector.where,
    )
    // The docs also write `0` for a zero vector.
    return result === 0 && title === 'refract' ? values[0].map(() => 0) : result
  }
  const { value, by, where } = formulas[title]
  const named = numbers.operandsOf(title, by.length).map((operand, i) => [operand, values[i]])
  return numbers.evaluateFormula(value, Object.fromEntries(named), where)
}

const unwrap = (operand) => operand?.plain ?? operand

/** Wraps a value so that it has operations as methods; `plain` is the value. */
export const wrap = (value) =>
  new Proxy(
    { plain: value },
    {
      get(target, name) {
        if (name === 'plain') return target.plain
        if (/^[xyzw]$/.test(name)) return () => wrap(target.plain['xyzw'.indexOf(name)])
        return (...rest) => builder[name](target.plain, ...rest)
      },
    },
  )

export const builder = new Proxy(
  {},
  {
    get:
      (_, name) =>
      (...operands) =>
        wrap(compute(name, operands.map(unwrap))),
  },
)
