// An interpreter of GLSL in double, for tests only: it shares no code with the front end, and executes each statement as often as
// the source says. It supports a small part of the language: floats, ints, bools and vectors, functions and statements, but no
// structures.

const vectors = { vec2: 2, vec3: 3, vec4: 4 }
const types = /^(?:float|int|bool|vec[234]|void)$/

const each = (f) => ({
  type: (operands) => operands.find((type) => type in vectors) ?? 'float',
  run: (...x) => {
    const size = x.find(Array.isArray)?.length
    if (size === undefined) return f(...x)
    const part = (i) => x.map((value) => (Array.isArray(value) ? value[i] : value))
    return Array.from({ length: size }, (_, i) => f(...part(i)))
  },
})
const dot = (x, y) =>
  Array.isArray(x) ? x.reduce((sum, value, i) => sum + value * y[i], 0) : x * y
const number = (run) => ({ type: () => 'float', run })

const builtIns = {
  ...Object.fromEntries(
    ['sin', 'cos', 'atan', 'tanh', 'exp', 'sqrt', 'floor', 'sign'].map((name) => [
      name,
      each(Math[name]),
    ]),
  ),
  abs: { type: ([type]) => type, run: each(Math.abs).run },
  min: { type: ([type]) => type, run: each(Math.min).run },
  max: { type: ([type]) => type, run: each(Math.max).run },
  clamp: { type: ([type]) => type, run: each((x, a, b) => Math.min(Math.max(x, a), b)).run },
  fract: each((x) => x - Math.floor(x)),
  mod: each((x, y) => x - y * Math.floor(x / y)),
  mix: each((x, y, t) => x + (y - x) * t),
  dot: number(dot),
  length: number((x) => Math.sqrt(dot(x, x))),
}

const levels = [['||'], ['&&'], ['==', '!='], ['<', '>', '<=', '>='], ['+', '-'], ['*', '/', '%']]
const arithmetic = {
  '+': (x, y) => x + y,
  '-': (x, y) => x - y,
  '*': (x, y) => x * y,
  '/': (x, y) => x / y,
}
const comparisons = {
  '==': (x, y) => x === y,
  '!=': (x, y) => x !== y,
  '<': (x, y) => x < y,
  '>': (x, y) => x > y,
  '<=': (x, y) => x <= y,
  '>=': (x, y) => x >= y,
}

const fail = (sentence) => {
  throw new SyntaxError(`the interpreter: ${sentence}`)
}

/** Returned by statements after which control does not continue with the next statement. */
const ends = { break: { by: 'break' }, continue: { by: 'continue' } }

/** Returns the functions of the source by name, each on numbers and arrays of numbers. */
export function interpret(text) {
  const tokens = text
    .replace(/\/\/.*|\/\*[^]*?\*\//g, '')
    .match(/\d*\.?\d+(?:e[+-]?\d+)?\.?|\w+|[-+*/]=|\+\+|--|&&|\|\||[<>=!]=|\S/g)
  let at = 0
  const functions = {}
  let scope = { names: {} }
  const accept = (token) => tokens[at] === token && !!++at
  const expect = (token) => accept(token) || fail(`${token} expected, not ${tokens[at]}`)
  const within = (work) => {
    scope = { names: {}, outer: scope }
    const result = work()
    scope = scope.outer
    return result
  }
  let slots = 0
  const declare = (name, type) => (scope.names[name] = { type, slot: slots++ })
  const find = (name) => {
    for (let in_ = scope; in_; in_ = in_.outer)
      if (Object.hasOwn(in_.names, name)) return in_.names[name]
    return fail(`${name} is not declared`)
  }

  function primary() {
    const token = tokens[at++]
    if (token === '(') {
      const value = expression()
      expect(')')
      return value
    }
    if (/^\.?\d/.test(token)) {
      const value = Number(token)
      return { type: /[.e]/.test(token) ? 'float' : 'int', run: () => value }
    }
    if (token === 'true' || token === 'false') return { type: 'bool', run: () => token === 'true' }
    if (accept('(')) return call(token)
    const { type, slot } = find(token)
    return { type, run: (frame) => frame[slot], set: (frame, value) => (frame[slot] = value) }
  }

  function call(name) {
    const operands = []
    while (!accept(')')) {
      operands.push(expression())
      accept(',')
    }
    const run = (frame) => operands.map((operand) => operand.run(frame))
    if (name in vectors)
      return {
        type: name,
        run: (frame) => {
          const parts = run(frame).flat()
          return parts.length === 1 ? Array(vectors[name]).fill(parts[0]) : parts
        },
      }
    if (name === 'float') return { type: 'float', run: (frame) => Number(run(frame)[0]) }
    if (name === 'int') return { type: 'int', run: (frame) => Math.trunc(Number(run(frame)[0])) }
    if (Object.hasOwn(functions, name)) {
      const { type, call } = functions[name]
      return { type, run: (frame) => call(...run(frame)) }
    }
    const builtIn = builtIns[name] ?? fail(`${name} is no function`)
    return {
      type: builtIn.type(operands.map(({ type }) => type)),
      run: (frame) => builtIn.run(...run(frame)),
    }
  }

  function postfix() {
    let value = primary()
    for (;;) {
      if (accept('.')) value = swizzle(value, [...tokens[at++]])
      else if (tokens[at] === '++' || tokens[at] === '--')
        value = increment(value, tokens[at++] === '++' ? 1 : -1, false)
      else return value
    }
  }

  function swizzle(of, letters) {
    const places = letters.map((letter) => 'xyzw'.indexOf(letter))
    return {
      type: places.length === 1 ? 'float' : `vec${places.length}`,
      run: (frame) => {
        const vector = of.run(frame)
        return places.length === 1 ? vector[places[0]] : places.map((place) => vector[place])
      },
      set: (frame, value) => {
        const vector = [...of.run(frame)]
        places.forEach((place, i) => (vector[place] = places.length === 1 ? value : value[i]))
        of.set(frame, vector)
      },
    }
  }

  const increment = (of, by, isBefore) => ({
    type: of.type,
    run: (frame) => {
      const before = of.run(frame)
      of.set(frame, before + by)
      return isBefore ? before + by : before
    },
  })

  function unary() {
    if (accept('-')) {
      const of = unary()
      return { type: of.type, run: (frame) => each((x) => -x).run(of.run(frame)) }
    }
    if (accept('!')) {
      const of = unary()
      return { type: 'bool', run: (frame) => !of.run(frame) }
    }
    if (tokens[at] === '++' || tokens[at] === '--') {
      const by = tokens[at++] === '++' ? 1 : -1
      return increment(unary(), by, true)
    }
    return postfix()
  }

  function binary(level) {
    if (level === levels.length) return unary()
    let left = binary(level + 1)
    while (levels[level].includes(tokens[at])) {
      const op = tokens[at++]
      left = operation(op, left, binary(level + 1))
    }
    return left
  }

  function operation(op, x, y) {
    if (op === '&&') return { type: 'bool', run: (frame) => x.run(frame) && y.run(frame) }
    if (op === '||') return { type: 'bool', run: (frame) => x.run(frame) || y.run(frame) }
    if (comparisons[op])
      return { type: 'bool', run: (frame) => comparisons[op](x.run(frame), y.run(frame)) }
    const isInt = x.type === 'int' && y.type === 'int'
    if (!isInt && [x.type, y.type].includes('int')) fail(`${x.type} ${op} ${y.type}`)
    const f =
      isInt && op === '/' ? (a, b) => Math.trunc(a / b) : (arithmetic[op] ?? ((a, b) => a % b))
    const { run } = each(f)
    return {
      type: isInt ? 'int' : x.type in vectors ? x.type : y.type,
      run: (frame) => run(x.run(frame), y.run(frame)),
    }
  }

  function expression() {
    const test = binary(0)
    if (accept('?')) {
      const yes = expression()
      expect(':')
      const no = expression()
      return { type: yes.type, run: (frame) => (test.run(frame) ? yes : no).run(frame) }
    }
    const [, op] = /^([-+*/]?)=$/.exec(tokens[at]) ?? []
    if (op === undefined) return test
    at++
    const right = expression()
    const value = op ? operation(op, test, right) : right
    return { type: test.type, run: (frame) => test.set(frame, value.run(frame)) }
  }

  /** Parses a statement to a function of a frame, which returns `undefined` if control continues with the next statement. */
  function statement() {
    const token = tokens[at]
    if (accept('{')) return within(() => sequence('}'))
    if (accept(';')) return () => undefined
    if (accept('if')) {
      const test = condition()
      const yes = within(statement)
      const no = accept('else') ? within(statement) : () => undefined
      return (frame) => (test.run(frame) ? yes : no)(frame)
    }
    if (accept('for')) return within(forLoop)
    if (accept('while')) {
      const test = condition()
      return loop(test, within(statement))
    }
    if (accept('do')) {
      const body = within(statement)
      expect('while')
      const test = condition()
      expect(';')
      let isFirst
      const again = { run: (frame) => isFirst || test.run(frame) }
      const run = loop(again, (frame) => ((isFirst = false), body(frame)))
      return (frame) => ((isFirst = true), run(frame))
    }
    if (token in ends && accept(token)) {
      expect(';')
      return () => ends[token]
    }
    if (accept('return')) {
      const value = expression()
      expect(';')
      return (frame) => ({ by: 'return', value: value.run(frame) })
    }
    return declarationOrExpression()
  }

  function declarationOrExpression() {
    const all = []
    if (types.test(tokens[at]) && tokens[at + 1] !== '(') {
      const type = tokens[at++]
      do {
        const name = tokens[at++]
        const value = accept('=') ? expression() : { run: () => 0 }
        const { slot } = declare(name, type)
        all.push((frame) => void (frame[slot] = value.run(frame)))
      } while (accept(','))
    } else {
      do {
        const { run } = expression()
        all.push((frame) => void run(frame))
      } while (accept(','))
    }
    expect(';')
    return (frame) => all.forEach((run) => run(frame))
  }

  function condition() {
    expect('(')
    const test = expression()
    expect(')')
    return test
  }

  function forLoop() {
    expect('(')
    const start = declarationOrExpression()
    const test = expression()
    expect(';')
    const step = expression()
    expect(')')
    const run = loop(test, within(statement), step)
    return (frame) => (start(frame), run(frame))
  }

  const loop = (test, body, step) => (frame) => {
    for (; test.run(frame); step?.run(frame)) {
      const end = body(frame)
      if (end === ends.break) return undefined
      if (end?.by === 'return') return end
    }
    return undefined
  }

  function sequence(last) {
    const all = []
    while (!accept(last)) all.push(statement())
    return (frame) => {
      for (const run of all) {
        const end = run(frame)
        if (end) return end
      }
      return undefined
    }
  }

  while (at < tokens.length) {
    const type = tokens[at++]
    if (!types.test(type)) fail(`${type} opens no function`)
    const name = tokens[at++]
    expect('(')
    within(() => {
      const parameters = []
      while (!accept(')')) {
        const type = tokens[at++]
        parameters.push(declare(tokens[at++], type))
        accept(',')
      }
      expect('{')
      const body = sequence('}')
      const call = (...values) => {
        const frame = []
        parameters.forEach(({ slot }, i) => (frame[slot] = values[i]))
        return body(frame).value
      }
      functions[name] = { type, call }
    })
  }
  return Object.fromEntries(Object.entries(functions).map(([name, { call }]) => [name, call]))
}
