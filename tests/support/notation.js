// Evaluates formulas in textbook notation, in double precision: `v · dv / |v|`, `−A⁻¹ dA A⁻¹`, `Σ aᵢ bᵢ`. A vector is an array of numbers,
// a matrix an array of its rows. All kinds of products, also by juxtaposition, have the same precedence and associate to the left; Σ
// applies to the juxtaposed factors after it, over the index ᵢ or ₖ. Written for the tests of the docs, independently of warpjet.

import { add, cross, dot, invert, scale, subtract, times, transpose } from './linear.js'

const functions = {
  det: (m) => invert(m).det,
  tr: (m) => m.reduce((total, row, i) => total + row[i], 0),
  ...Object.fromEntries(['sin', 'cos', 'sign', 'max'].map((name) => [name, Math[name]])),
}

const powers = { '²': 2, '³': 3, '⁴': 4 }
const suffixes = {
  '⁻¹': (m) => invert(m).inverse,
  '⁻ᵀ': (m) => transpose(invert(m).inverse),
  ᵀ: transpose,
  ...Object.fromEntries(Object.entries(powers).map(([sign, n]) => [sign, (x) => x ** n])),
}
const token = /\s*(\d+(?:\.\d+)?|[A-Za-zα-ω]+|⁻¹|⁻ᵀ|[ᵀ²³⁴₁₂₃₄ᵢₖ]|[-+−·×/?:<√|(),Σ])/y

function tokensOf(text) {
  const tokens = []
  token.lastIndex = 0
  while (token.lastIndex < text.length) {
    const [, found] = token.exec(text) ?? []
    if (!found) throw new Error(`Not understood: ${text}`)
    tokens.push(found)
  }
  return tokens
}

/** Parses a formula to a function of the values of its letters. */
export function read(text) {
  const tokens = tokensOf(text)
  let at = 0
  const isNext = (...choices) => choices.includes(tokens[at])
  const take = (expected) => {
    if (expected && tokens[at] !== expected) throw new Error(`${expected} is missing in ${text}`)
    return tokens[at++]
  }

  function choice() {
    const left = sum()
    if (!isNext('<')) return left
    take()
    const right = sum()
    take('?')
    const yes = choice()
    take(':')
    const no = choice()
    return (known) => (left(known) < right(known) ? yes(known) : no(known))
  }

  function sum() {
    let left = product()
    while (isNext('+', '−')) {
      const [f, a, b] = [take() === '+' ? add : subtract, left, product()]
      left = (known) => f(a(known), b(known))
    }
    return left
  }

  const startsFactor = () =>
    /^(?:[\dA-Za-zα-ω(√|Σ])/.test(tokens[at] ?? '') && !(isNext('|') && open)
  const kinds = { '·': dot, '×': cross, '/': (a, b) => scale(a, 1 / b) }

  function product() {
    if (isNext('−')) {
      take()
      const positive = product()
      return (known) => scale(positive(known), -1)
    }
    let left = factor()
    while (isNext(...Object.keys(kinds)) || startsFactor()) {
      const [f, a, b] = [isNext(...Object.keys(kinds)) ? kinds[take()] : times, left, factor()]
      left = (known) => f(a(known), b(known))
    }
    return left
  }

  /** Tests whether the next bar is a closing one. */
  let open = false
  function inside(close, isBar) {
    const outer = open
    open = isBar
    const list = [choice()]
    while (isNext(',')) list.push((take(), choice()))
    take(close)
    open = outer
    return list
  }

  function factor() {
    let value = primary()
    while (suffixes[tokens[at]] || /^[₁₂₃₄ᵢₖ]$/.test(tokens[at] ?? '')) {
      const [sign, inner] = [take(), value]
      const part = '₁₂₃₄'.indexOf(sign)
      if (suffixes[sign]) value = (known) => suffixes[sign](inner(known))
      else value = (known) => inner(known)[part < 0 ? known.index : part]
    }
    return value
  }

  function primary() {
    const name = take()
    if (/^\d/.test(name)) return () => Number(name)
    if (name === '√')
      return (
        (inner) => (known) =>
          Math.sqrt(inner(known))
      )(factor())
    if (name === 'Σ') return total()
    if (name === '|') {
      const [inner] = inside('|', true)
      return (known) => ((x) => Math.sqrt(dot(x, x)))([inner(known)].flat())
    }
    if (name === '(') {
      const list = inside(')', false)
      return list.length > 1 ? (known) => list.map((inner) => inner(known)) : list[0]
    }
    if (!/^[A-Za-zα-ω]/.test(name)) throw new Error(`${name} is not understood in ${text}`)
    const isCall = (known) => known[name] ?? functions[name]
    if (isNext('(') && (functions[name] || /^rotate/.test(name))) {
      take()
      const list = inside(')', false)
      return (known) => isCall(known)(...list.map((inner) => inner(known)))
    }
    return (known) => {
      if (known[name] === undefined) throw new Error(`${name} is not known in ${text}`)
      return known[name]
    }
  }

  function total() {
    let term = factor()
    while (startsFactor() && !isNext('Σ'))
      term = (
        (a, b) => (known) =>
          times(a(known), b(known))
      )(term, factor())
    return (known) =>
      Array.from({ length: known.count }, (_, index) =>
        term(Object.create(known, { index: { value: index } })),
      ).reduce(add)
  }

  const result = choice()
  if (at < tokens.length) throw new Error(`Not understood from ${tokens[at]} on: ${text}`)
  return result
}

/** Evaluates a formula. The parts that `where` defines can refer to each other. */
export function evaluateFormula(text, known, where = {}) {
  const all = { ...known }
  for (const [name, part] of Object.entries(where))
    Object.defineProperty(all, name, { get: () => read(part)(all) })
  return read(text)(all)
}
