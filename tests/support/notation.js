// Evaluates formulas in textbook notation, in double precision: `v · dv / |v|`, `−A⁻¹ dA A⁻¹`, `Σ aᵢ bᵢ`. A vector is an array of numbers,
// a matrix an array of rows. All kinds of products, including juxtaposition, have the same precedence and associate to the left. Σ applies
// to the juxtaposed factors after it, and sums over the index ᵢ or ₖ. Written for tests of the docs, independently of warpjet.

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

function tokenize(text) {
  const tokens = []
  token.lastIndex = 0
  while (token.lastIndex < text.length) {
    const [, next] = token.exec(text) ?? []
    if (!next) throw new Error(`cannot read ${text}`)
    tokens.push(next)
  }
  return tokens
}

/** Parses a formula. Returns a function that maps the values of its names to the value of the formula. */
function parse(text) {
  const tokens = tokenize(text)
  let at = 0
  const isNext = (...choices) => choices.includes(tokens[at])
  const take = (expected) => {
    if (expected && tokens[at] !== expected)
      throw new Error(`expected ${expected}, got ${tokens[at]} in ${text}`)
    return tokens[at++]
  }

  // Each of the following functions parses the part of a formula that it is named after, and returns a function that maps values to a
  // result.
  function choice() {
    const left = sum()
    if (!isNext('<')) return left
    take()
    const right = sum()
    take('?')
    const yes = choice()
    take(':')
    const no = choice()
    return (values) => (left(values) < right(values) ? yes(values) : no(values))
  }

  function sum() {
    let left = product()
    while (isNext('+', '−')) {
      const [f, a, b] = [take() === '+' ? add : subtract, left, product()]
      left = (values) => f(a(values), b(values))
    }
    return left
  }

  const startsFactor = () =>
    /^(?:[\dA-Za-zα-ω(√|Σ])/.test(tokens[at] ?? '') && !(isNext('|') && isBarOpen)
  const products = { '·': dot, '×': cross, '/': (a, b) => scale(a, 1 / b) }

  function product() {
    if (isNext('−')) {
      take()
      const positive = product()
      return (values) => scale(positive(values), -1)
    }
    let left = factor()
    while (isNext(...Object.keys(products)) || startsFactor()) {
      const [f, a, b] = [
        isNext(...Object.keys(products)) ? products[take()] : times,
        left,
        factor(),
      ]
      left = (values) => f(a(values), b(values))
    }
    return left
  }

  /** If true, the next bar closes an absolute value. */
  let isBarOpen = false
  /** Parses a list up to the token `close`. */
  function parseList(close, isBar) {
    const wasBarOpen = isBarOpen
    isBarOpen = isBar
    const elements = [choice()]
    while (isNext(',')) elements.push((take(), choice()))
    take(close)
    isBarOpen = wasBarOpen
    return elements
  }

  function factor() {
    let value = primary()
    while (suffixes[tokens[at]] || /^[₁₂₃₄ᵢₖ]$/.test(tokens[at] ?? '')) {
      const [sign, inner] = [take(), value]
      const component = '₁₂₃₄'.indexOf(sign)
      if (suffixes[sign]) value = (values) => suffixes[sign](inner(values))
      else value = (values) => inner(values)[component < 0 ? values.index : component]
    }
    return value
  }

  function primary() {
    const name = take()
    if (/^\d/.test(name)) return () => Number(name)
    if (name === '√')
      return (
        (inner) => (values) =>
          Math.sqrt(inner(values))
      )(factor())
    if (name === 'Σ') return total()
    if (name === '|') {
      const [inner] = parseList('|', true)
      return (values) => ((x) => Math.sqrt(dot(x, x)))([inner(values)].flat())
    }
    if (name === '(') {
      const elements = parseList(')', false)
      return elements.length > 1 ? (values) => elements.map((inner) => inner(values)) : elements[0]
    }
    if (!/^[A-Za-zα-ω]/.test(name)) throw new Error(`unexpected ${name} in ${text}`)
    const getFunction = (values) => values[name] ?? functions[name]
    if (isNext('(') && (functions[name] || /^rotate/.test(name))) {
      take()
      const operands = parseList(')', false)
      return (values) => getFunction(values)(...operands.map((inner) => inner(values)))
    }
    return (values) => {
      if (values[name] === undefined) throw new Error(`${name} has no value in ${text}`)
      return values[name]
    }
  }

  function total() {
    let term = factor()
    while (startsFactor() && !isNext('Σ'))
      term = (
        (a, b) => (values) =>
          times(a(values), b(values))
      )(term, factor())
    return (values) =>
      Array.from({ length: values.count }, (_, index) =>
        term(Object.create(values, { index: { value: index } })),
      ).reduce(add)
  }

  const result = choice()
  if (at < tokens.length) throw new Error(`unexpected ${tokens[at]} in ${text}`)
  return result
}

/** Evaluates a formula. `where` defines names in it, which may refer to each other. */
export function evaluateFormula(text, values, where = {}) {
  const all = { ...values }
  for (const [name, definition] of Object.entries(where))
    Object.defineProperty(all, name, { get: () => parse(definition)(all) })
  return parse(text)(all)
}
