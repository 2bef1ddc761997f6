// Generates random GLSL functions, each with its equivalent in JavaScript: control flow, structures, assigned swizzles, integers.
// Values stay below about a hundred, so that float32 is precise enough.
export function randomOf(seed) {
  let state = (seed * 0x9e3779b1) >>> 0
  return () => {
    state = (state + 0x6d2b79f5) >>> 0
    let t = Math.imul(state ^ (state >>> 15), state | 1)
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61)
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296
  }
}

/** Runtime functions of the JavaScript: they work per component, and a number with a vector applies to each component. */
export const library = {
  each(f, ...x) {
    const size = x.find(Array.isArray)?.length
    if (size === undefined) return f(...x)
    return Array.from({ length: size }, (_, i) =>
      f(...x.map((each) => (Array.isArray(each) ? each[i] : each))),
    )
  },
  bits: (x) => new Uint32Array(Float32Array.of(x).buffer)[0],
  dot: (x, y) => x.reduce((sum, each, i) => sum + each * y[i], 0),
  pick: (v, letters) => {
    const all = [...letters].map((letter) => v['xyzw'.indexOf(letter)])
    return all.length === 1 ? all[0] : all
  },
  /** Implements v.letters = value, and returns a new vector. */
  put: (v, letters, value) => {
    const next = [...v]
    ;[...letters].forEach((letter, i) => {
      next['xyzw'.indexOf(letter)] = Array.isArray(value) ? value[i] : value
    })
    return next
  },
}

const sizes = { float: 1, vec2: 2, vec3: 3 }
const number = (value) => (Number.isInteger(value) ? `${value}.0` : `${value}`)

class Generator {
  constructor(seed) {
    this.random = randomOf(seed)
    this.count = 0
    this.scopes = [[]]
    this.depth = 0
  }

  int(n) {
    return Math.floor(this.random() * n)
  }
  of(list) {
    return list[this.int(list.length)]
  }
  name() {
    return `v${this.count++}`
  }
  variables(type, isWritten = false) {
    return this.scopes.flat().filter((each) => each.type === type && !(isWritten && each.isFixed))
  }
  literal() {
    return Math.round((this.random() * 3 - 1.5) * 100) / 100
  }

  /** Returns { glsl, js } of a type. */
  expression(type, depth = 3) {
    if (type === 'int') return this.whole(depth)
    if (type === 'bool') return this.condition(depth)
    const known = this.variables(type)
    if (depth <= 0 || this.random() < 0.15) {
      if (known.length && this.random() < 0.8) {
        const { name } = this.of(known)
        return { glsl: name, js: name }
      }
      const literal = this.literal()
      const list = `[${Array(sizes[type]).fill(literal)}]`
      return type === 'float'
        ? { glsl: `(${number(literal)})`, js: `(${literal})` }
        : { glsl: `${type}(${number(literal)})`, js: list }
    }
    const x = () => this.expression(type, depth - 1)
    const number1 = () => this.expression('float', depth - 1)
    const each = (glsl, f, ...operands) => ({
      glsl,
      js: `each(${f}, ${operands.map(({ js }) => js).join(', ')})`,
    })
    const kinds = {
      sum: () => {
        const [a, b] = [x(), x()]
        const op = this.of(['+', '-'])
        return each(`(${a.glsl} ${op} ${b.glsl})`, `(a, b) => a ${op} b`, a, b)
      },
      product: () => {
        const [a, b] = [x(), number1()]
        return each(`(${a.glsl} * sin(${b.glsl}))`, '(a, b) => a * Math.sin(b)', a, b)
      },
      quotient: () => {
        const [a, b] = [x(), number1()]
        return each(
          `(${a.glsl} / (1.5 + abs(${b.glsl})))`,
          '(a, b) => a / (1.5 + Math.abs(b))',
          a,
          b,
        )
      },
      wave: () => {
        const a = x()
        const f = this.of(['sin', 'cos', 'atan', 'tanh'])
        return each(`${f}(${a.glsl})`, `Math.${f}`, a)
      },
      root: () => {
        const a = x()
        return each(`sqrt(abs(${a.glsl}) + 0.2)`, '(a) => Math.sqrt(Math.abs(a) + 0.2)', a)
      },
      negative: () => {
        const a = x()
        return each(`(-${a.glsl})`, '(a) => -a', a)
      },
      mix: () => {
        const [a, b, t] = [x(), x(), number1()]
        return each(
          `mix(${a.glsl}, ${b.glsl}, fract(${t.glsl}))`,
          '(a, b, t) => a + (b - a) * (t - Math.floor(t))',
          a,
          b,
          t,
        )
      },
      extreme: () => {
        const [a, b] = [x(), number1()]
        const f = this.of(['min', 'max'])
        return each(`${f}(${a.glsl}, ${b.glsl})`, `Math.${f}`, a, b)
      },
      choice: () => {
        const [c, a, b] = [this.condition(depth - 1), x(), x()]
        return { glsl: `(${c.glsl} ? ${a.glsl} : ${b.glsl})`, js: `(${c.js} ? ${a.js} : ${b.js})` }
      },
    }
    if (type === 'float') {
      kinds.dot = () => {
        const [a, b] = [this.expression('vec3', depth - 1), this.expression('vec3', depth - 1)]
        return { glsl: `sin(dot(${a.glsl}, ${b.glsl}))`, js: `Math.sin(dot(${a.js}, ${b.js}))` }
      }
      kinds.length = () => {
        const a = this.expression('vec2', depth - 1)
        return {
          glsl: `length(${a.glsl} + 0.05)`,
          js: `Math.sqrt(${a.js}.reduce((sum, x) => sum + (x + 0.05) ** 2, 0))`,
        }
      }
      kinds.part = () => {
        const a = this.expression('vec3', depth - 1)
        const letter = this.of('xyz')
        return { glsl: `${a.glsl}.${letter}`, js: `pick(${a.js}, '${letter}')` }
      }
      kinds.whole = () => {
        const a = this.whole(depth - 1)
        return { glsl: `(float(${a.glsl}) * 0.11)`, js: `(${a.js} * 0.11)` }
      }
      kinds.table = () => {
        const a = this.whole(depth - 1)
        return { glsl: `table[abs(${a.glsl}) % 4]`, js: `table[Math.abs(${a.js}) % 4]` }
      }
      kinds.field = () => ({ glsl: 'wave.height', js: 'wave.height' })
      kinds.call = () => {
        const [a, b] = [number1(), this.expression('vec2', depth - 1)]
        return { glsl: `helper(${a.glsl}, ${b.glsl})`, js: `helper(${a.js}, ${b.js})` }
      }
    } else {
      kinds.vector = () => {
        const parts = Array.from({ length: sizes[type] }, number1)
        return {
          glsl: `${type}(${parts.map(({ glsl }) => glsl).join(', ')})`,
          js: `[${parts.map(({ js }) => js).join(', ')}]`,
        }
      }
      kinds.swizzle = () => {
        const a = this.expression('vec3', depth - 1)
        const letters = Array.from({ length: sizes[type] }, () => this.of('xyz')).join('')
        return { glsl: `${a.glsl}.${letters}`, js: `pick(${a.js}, '${letters}')` }
      }
    }
    return this.of(Object.values(kinds))()
  }

  whole(depth) {
    const known = this.variables('int')
    if (depth <= 0 || this.random() < 0.4) {
      if (known.length && this.random() < 0.8) {
        const { name } = this.of(known)
        return { glsl: name, js: name }
      }
      const value = this.int(7) - 2
      return { glsl: `(${value})`, js: `(${value})` }
    }
    const kind = this.int(11)
    const [a, b] = [this.whole(depth - 2), this.whole(depth - 2)]
    // Bit operations, with few bits in the result.
    if (kind === 4) return { glsl: `(${a.glsl} / 3)`, js: `Math.trunc(${a.js} / 3)` }
    if (kind === 5)
      return { glsl: `((${a.glsl} ^ ${b.glsl}) & 15)`, js: `((${a.js} ^ ${b.js}) & 15)` }
    if (kind === 6) return { glsl: `(~${a.glsl} >> 1)`, js: `(~${a.js} >> 1)` }
    if (kind === 7)
      return {
        glsl: `int((uint(${a.glsl}) * 2654435761u) >> 28)`,
        js: `(Math.imul(${a.js}, 2654435761) >>> 28)`,
      }
    if (kind === 8)
      return {
        glsl: `int((uint(${a.glsl}) | 5u) % 7u)`,
        js: `(((${a.js} | 5) >>> 0) % 7)`,
      }
    if (kind === 9)
      return { glsl: `max(${a.glsl} << 1, ${b.glsl})`, js: `Math.max(${a.js} << 1, ${b.js})` }
    if (kind === 10) {
      const x = this.expression('float', depth - 1)
      return { glsl: `int(floatBitsToUint(${x.glsl}) >> 30)`, js: `(bits(${x.js}) >>> 30)` }
    }
    if (kind === 0) return { glsl: `(${a.glsl} + ${b.glsl})`, js: `(${a.js} + ${b.js})` }
    if (kind === 1) return { glsl: `(${a.glsl} * 3)`, js: `(${a.js} * 3)` }
    if (kind === 2) return { glsl: `(abs(${a.glsl}) / 3)`, js: `Math.floor(Math.abs(${a.js}) / 3)` }
    const x = this.expression('float', depth - 1)
    return {
      glsl: `int(floor(clamp(${x.glsl}, -4.0, 4.0)))`,
      js: `Math.floor(Math.min(Math.max(${x.js}, -4), 4))`,
    }
  }

  condition(depth) {
    const kind = this.int(5)
    if (kind === 0 && depth > 1) {
      const [a, b] = [this.condition(depth - 1), this.condition(depth - 1)]
      const op = this.of(['&&', '||'])
      return { glsl: `(${a.glsl} ${op} ${b.glsl})`, js: `(${a.js} ${op} ${b.js})` }
    }
    if (kind === 1) {
      const [a, b] = [this.whole(depth - 1), this.whole(depth - 1)]
      const op = this.of(['<', '==', '>='])
      return { glsl: `(${a.glsl} ${op} ${b.glsl})`, js: `(${a.js} ${op} ${b.js})` }
    }
    const [a, b] = [this.expression('float', depth - 1), this.expression('float', depth - 1)]
    // Makes equal values that are rounded differently take the same branch.
    const op = this.of(['<', '>', '<='])
    return {
      glsl: `(${a.glsl} ${op} ${b.glsl} + 0.01037)`,
      js: `(${a.js} ${op} ${b.js} + 0.01037)`,
    }
  }

  /** Generates statements in their own scope. */
  block(count, inLoop) {
    this.scopes.push([])
    this.depth++
    const lines = Array.from({ length: count }, () => this.statement(inLoop))
    this.depth--
    this.scopes.pop()
    const join = (language) => `{\n${lines.map((line) => line[language]).join('\n')}\n}`
    return { glsl: join('glsl'), js: join('js') }
  }

  statement(inLoop) {
    const kinds = ['declare', 'declare', 'assign', 'assign', 'swizzle', 'field', 'whole']
    if (this.depth < 3) kinds.push('if', 'if', 'loop', 'switch', 'while')
    if (this.depth > 0) kinds.push('return')
    if (inLoop) kinds.push('leave')
    return this[`make_${this.of(kinds)}`](inLoop)
  }

  make_declare() {
    const type = this.of(['float', 'float', 'vec2', 'vec3'])
    const value = this.expression(type)
    const name = this.name()
    this.scopes.at(-1).push({ name, type })
    return { glsl: `${type} ${name} = ${value.glsl};`, js: `let ${name} = ${value.js};` }
  }

  make_whole() {
    const value = this.whole(3)
    const name = this.name()
    this.scopes.at(-1).push({ name, type: 'int', isFixed: true })
    return { glsl: `int ${name} = ${value.glsl};`, js: `let ${name} = ${value.js};` }
  }

  make_assign() {
    const type = this.of(['float', 'vec2', 'vec3'])
    const known = this.variables(type, true)
    if (!known.length) return this.make_declare()
    const { name } = this.of(known)
    const value = this.expression(type)
    const op = this.of(['', '+', '-'])
    return {
      glsl: `${name} ${op}= ${value.glsl};`,
      js: op
        ? `${name} = each((a, b) => a ${op} b, ${name}, ${value.js});`
        : `${name} = ${value.js};`,
    }
  }

  make_swizzle() {
    const known = this.variables('vec3', true)
    if (!known.length) return this.make_declare()
    const { name } = this.of(known)
    const letters = this.of(['x', 'z', 'xy', 'zx', 'yz', 'zyx', 'yxz'])
    const type = ['float', 'vec2', 'vec3'][letters.length - 1]
    const value = this.expression(type)
    const isSum = this.random() < 0.5
    return {
      glsl: `${name}.${letters} ${isSum ? '+=' : '='} ${value.glsl};`,
      js: `${name} = put(${name}, '${letters}', ${isSum ? `each((a, b) => a + b, pick(${name}, '${letters}'), ${value.js})` : value.js});`,
    }
  }

  make_field() {
    const value = this.expression('vec2')
    return this.random() < 0.5
      ? {
          glsl: `wave.way = ${value.glsl}; wave.height += wave.way.x * 0.1;`,
          js: `wave.way = ${value.js}; wave.height += wave.way[0] * 0.1;`,
        }
      : {
          glsl: `bump(wave, ${value.glsl}.y);`,
          js: `bump(wave, ${value.js}[1]);`,
        }
  }

  make_if(inLoop) {
    const test = this.condition(2)
    const yes = this.block(1 + this.int(2), inLoop)
    const no = this.random() < 0.5 ? this.block(1, inLoop) : undefined
    const text = (language) =>
      `if (${test[language]}) ${yes[language]}${no ? ` else ${no[language]}` : ''}`
    return { glsl: text('glsl'), js: text('js') }
  }

  make_loop() {
    const name = this.name()
    const count = 1 + this.int(4)
    this.scopes.push([{ name, type: 'int', isFixed: true }])
    const body = this.block(1 + this.int(2), true)
    this.scopes.pop()
    return {
      glsl: `for (int ${name} = 0; ${name} < ${count}; ${name}++) ${body.glsl}`,
      js: `for (let ${name} = 0; ${name} < ${count}; ${name}++) ${body.js}`,
    }
  }

  make_while() {
    const name = this.name()
    this.scopes.push([{ name, type: 'int', isFixed: true }])
    const body = this.block(1, true)
    this.scopes.pop()
    const count = 1 + this.int(3)
    return {
      glsl: `int ${name} = ${count}; while (${name}-- > 0) ${body.glsl}`,
      js: `let ${name} = ${count}; while (${name}-- > 0) ${body.js}`,
    }
  }

  make_switch(inLoop) {
    const value = this.whole(3)
    const cases = [0, 1, 2].map((label) => ({
      label,
      body: this.block(1, inLoop && 'switch'),
      ends: this.random() < 0.7,
    }))
    const text = (language) =>
      `switch (${value[language]}) {\n${cases
        .map(
          ({ label, body, ends }) =>
            `${label === 2 ? 'default' : `case ${label}`}: ${body[language]}${ends || label === 2 ? ' break;' : ''}`,
        )
        .join('\n')}\n}`
    return { glsl: text('glsl'), js: text('js') }
  }

  make_return() {
    const test = this.condition(2)
    const value = this.expression('vec3', 2)
    return {
      glsl: `if (${test.glsl}) return ${value.glsl};`,
      js: `if (${test.js}) return ${value.js};`,
    }
  }

  make_leave(inLoop) {
    const test = this.condition(2)
    const word = inLoop === 'switch' ? 'continue' : this.of(['break', 'continue'])
    return { glsl: `if (${test.glsl}) ${word};`, js: `if (${test.js}) ${word};` }
  }
}

/** Returns { glsl, js }: `vec3 random<seed>(vec3 p)`, and a function of an array of three numbers. */
export function randomFunction(seed) {
  const generator = new Generator(seed)
  generator.scopes[0].push({ name: 'p', type: 'vec3' })
  const lines = Array.from({ length: 3 + generator.int(4) }, () => generator.statement(false))
  const result = generator.expression('vec3')
  const table = [0.3, -0.7, 1.1, 0.5]
  const glsl = `vec3 random${seed}(vec3 p) {
Wave wave = Wave(p.x, p.yz);
${lines.map((line) => line.glsl).join('\n')}
return ${result.glsl};
}
`
  const js = new Function(
    ...Object.keys(library),
    `const table = ${JSON.stringify(table)}
const helper = (x, y) => { if (x > 0.4) return Math.sin(x) + y[0]; return x * y[1] }
const bump = (wave, by) => { wave.height += Math.sin(by); wave.way = each((a) => a * 0.5, wave.way) }
return (p) => {
const wave = { height: p[0], way: [p[1], p[2]] }
${lines.map((line) => line.js).join('\n')}
return ${result.js}
}`,
  )(...Object.values(library))
  return { seed, glsl, js }
}

/** Source above all of them. */
export const above = `struct Wave { float height; vec2 way; };
const float table[4] = float[4](0.3, -0.7, 1.1, 0.5);
float helper(float x, vec2 y) { if (x > 0.4) return sin(x) + y.x; return x * y.y; }
void bump(inout Wave wave, float by) { wave.height += sin(by); wave.way *= 0.5; }
`
