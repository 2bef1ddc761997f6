// Interprets GLSL statements of the compiler in double precision, independently of the compiler, so that their results can be compared
// with plain JavaScript. It supports only the necessary subset of GLSL: declarations and assignments of float, bool and vec2 to vec4, and
// a mat2 that multiplies a vec2; operators, constructors, swizzles, and the functions below. It rejects what GLSL rejects: undeclared and
// unassigned names, wrong types, float literals without a point. It evaluates both branches of ?: and both sides of && and ||, since
// nothing has side effects.

const { acosh, asinh, atanh, ceil, cosh, floor, log2, sign, sinh, tanh, trunc } = Math
const { abs, acos, asin, atan, atan2, cos, exp, log, max, min, sin, sqrt, tan } = Math
const clamp = (x, low, high) => min(max(x, low), high)

const functions = {
  ...{ acosh, asinh, atanh, ceil, cosh, floor, log2, sign, sinh, tanh, trunc },
  ...{ abs, acos, asin, cos, exp, log, sin, sqrt, tan, clamp },
  atan: (y, x) => (x === undefined ? atan(y) : atan2(y, x)),
  degrees: (x) => (x * 180) / Math.PI,
  exp2: (x) => 2 ** x,
  fract: (x) => x - floor(x),
  inversesqrt: (x) => 1 / sqrt(x),
  max: (x, y) => max(x, y),
  min: (x, y) => min(x, y),
  mix: (x, y, t) => x * (1 - t) + y * t,
  mod: (x, y) => x - y * floor(x / y),
  // Results that GLSL does not define are NaN.
  pow: (x, y) => (x < 0 || (x === 0 && y <= 0) ? NaN : x ** y),
  radians: (x) => (x * Math.PI) / 180,
  smoothstep(low, high, x) {
    const t = clamp((x - low) / (high - low), 0, 1)
    return low < high ? t * t * (3 - 2 * t) : NaN
  },
  step: (edge, x) => (x < edge ? 0 : 1),
}

const operators = {
  '||': onlyOf('bool', (a, b) => a || b),
  '&&': onlyOf('bool', (a, b) => a && b),
  '==': (a, b) => a === b,
  '!=': (a, b) => a !== b,
  '<': onlyOf('float', (a, b) => a < b),
  '<=': onlyOf('float', (a, b) => a <= b),
  '>': onlyOf('float', (a, b) => a > b),
  '>=': onlyOf('float', (a, b) => a >= b),
  '+': byComponent((a, b) => a + b),
  '-': byComponent((a, b) => a - b),
  '*': (a, b) => (a.columns ? multiplyMat2(a, b) : product(a, b)),
  '/': byComponent((a, b) => a / b),
}

const product = byComponent((a, b) => a * b)
const negative = byComponent((a) => -a)
const not = onlyOf('bool', (a) => !a)

/** The binary operators, from the lowest precedence. */
const precedence = [['||'], ['&&'], ['==', '!='], ['<', '<=', '>', '>='], ['+', '-'], ['*', '/']]

/**
 * Runs statements with the values of variables by name; returns all variables that they assign, by name. Numbers are floats, arrays of two
 * to four numbers are vectors, true and false are bools.
 */
export function runGlsl(code, inputs = {}) {
  const values = { ...inputs }
  const types = Object.fromEntries(
    Object.entries(inputs).map(([key, value]) => [key, typeOf(value)]),
  )
  const tokens = code
    .replace(/\/\/.*/g, '')
    .match(/\d+\.?\d*(?:e[+-]?\d+)?|\w+|[<>=!]=|&&|\|\||\S/g)
  let at = 0
  const next = () => tokens[at++]
  const accept = (token) => tokens[at] === token && at++ >= 0
  const expect = (token) => accept(token) || fail(`${token} is missing before ${tokens[at]}`)

  function list() {
    const values = []
    do values.push(expression())
    while (accept(','))
    expect(')')
    return values
  }

  function primary() {
    const token = next()
    if (token === '(') {
      const [value, ...others] = list()
      return others.length === 0 ? value : fail('a comma in parentheses')
    }
    if (/^\d/.test(token)) return /[.e]/.test(token) ? Number(token) : fail(`${token} is an int`)
    if (accept('(')) return call(token, list())
    return values[token] ?? fail(`${token} is ${types[token] ? 'not set' : 'not declared'}`)
  }

  function unary() {
    if (accept('-')) return negative(unary())
    if (accept('!')) return not(unary())
    let value = primary()
    while (accept('.')) value = swizzle(value, next())
    return value
  }

  function binary(level) {
    if (level === precedence.length) return unary()
    let value = binary(level + 1)
    while (precedence[level].includes(tokens[at]))
      value = operators[next()](value, binary(level + 1))
    return value
  }

  function expression() {
    const value = binary(0)
    if (!accept('?')) return value
    const yes = expression()
    expect(':')
    const no = expression()
    if (typeOf(yes) !== typeOf(no)) fail(`a choice of ${typeOf(yes)} or ${typeOf(no)}`)
    return onlyOf('bool', (condition) => (condition ? yes : no))(value)
  }

  while (at < tokens.length) {
    if (accept('{') || accept('}')) continue
    const type = /^(float|bool|vec[234])$/.test(tokens[at]) && next()
    do {
      const name = next()
      if (type && types[name]) fail(`${name} is declared twice`)
      if (type) types[name] = type
      if (type && tokens[at] !== '=') continue
      expect('=')
      values[name] = expression()
      if (typeOf(values[name]) !== types[name])
        fail(`${name} is ${types[name] ?? 'not declared'}, its value ${typeOf(values[name])}`)
    } while (type && accept(','))
    expect(';')
  }
  return values
}

function fail(sentence) {
  throw new SyntaxError(`GLSL: ${sentence}.`)
}

function typeOf(value) {
  if (Array.isArray(value)) return `vec${value.length}`
  return typeof value === 'number' ? 'float' : 'bool'
}

function onlyOf(type, f) {
  return (...operands) => {
    const other = operands.find((operand) => typeOf(operand) !== type)
    return other === undefined ? f(...operands) : fail(`${typeOf(other)} where ${type} belongs`)
  }
}

/** Applies a function by component; a float is used for each component of a vector. */
function byComponent(f) {
  const scalar = onlyOf('float', f)
  return (...operands) => {
    const size = operands.find(Array.isArray)?.length
    if (!size) return scalar(...operands)
    if (operands.some((operand) => Array.isArray(operand) && operand.length !== size))
      fail('vectors of different sizes')
    const component = (i) =>
      operands.map((operand) => (Array.isArray(operand) ? operand[i] : operand))
    return Array.from({ length: size }, (_, i) => scalar(...component(i)))
  }
}

function call(name, operands) {
  const parts = operands.flat()
  if (name === 'float' && parts.length === 1) return Number(parts[0])
  if (name === 'bool' && parts.length === 1) return Boolean(parts[0])
  if (name === 'dot') return dot(...operands)
  if (name === 'cross') return cross(...operands)
  if (name === 'mat2' && parts.length === 4) return { columns: [parts.slice(0, 2), parts.slice(2)] }
  if (functions[name]) return byComponent(functions[name])(...operands)
  const size = Number(/^vec([234])$/.exec(name)?.[1] ?? fail(`${name} is no function`))
  if (parts.length === 1) return new Array(size).fill(Number(parts[0]))
  return parts.length === size ? parts.map(Number) : fail(`${name} of ${parts.length} components`)
}

function multiplyMat2({ columns: [first, second] }, [x, y, ...others]) {
  if (y === undefined || others.length) fail('a mat2 times what is no vec2')
  return [0, 1].map((row) => first[row] * x + second[row] * y)
}

function dot(a, b) {
  if (typeOf(a) !== typeOf(b) || !Array.isArray(a)) fail(`dot of ${typeOf(a)} and ${typeOf(b)}`)
  return a.reduce((sum, _, i) => sum + a[i] * b[i], 0)
}

function cross(a, b) {
  if (a.length !== 3 || b.length !== 3) fail(`cross of ${typeOf(a)} and ${typeOf(b)}`)
  return [0, 1, 2].map((i) => {
    const [j, k] = [(i + 1) % 3, (i + 2) % 3]
    return a[j] * b[k] - a[k] * b[j]
  })
}

function swizzle(value, letters) {
  const set = ['xyzw', 'rgba', 'stpq'].find((set) => [...letters].every((x) => set.includes(x)))
  const parts = [...letters].map((letter) => value[set?.indexOf(letter)])
  if (!Array.isArray(value) || parts.includes(undefined)) fail(`.${letters} of ${typeOf(value)}`)
  return parts.length === 1 ? parts[0] : parts
}
