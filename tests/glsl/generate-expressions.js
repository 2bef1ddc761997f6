// Generates random expressions of GLSL, each with its equivalent in JavaScript. Values stay below about 100, so that float32 is precise
// enough.
export function randomOf(seed) {
  let state = (seed * 0x9e3779b1) >>> 0
  return () => {
    state = (state + 0x6d2b79f5) >>> 0
    let t = Math.imul(state ^ (state >>> 15), state | 1)
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61)
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296
  }
}

/** Functions that the generated JavaScript calls. They work per component; a number next to a vector applies to each component. */
export const library = {
  perComponent(f, ...x) {
    const size = x.find(Array.isArray)?.length
    if (size === undefined) return f(...x)
    return Array.from({ length: size }, (_, i) =>
      f(...x.map((operand) => (Array.isArray(operand) ? operand[i] : operand))),
    )
  },
  bits: (x) => new Uint32Array(Float32Array.of(x).buffer)[0],
  dot: (x, y) => x.reduce((sum, value, i) => sum + value * y[i], 0),
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
const floatLiteral = (value) => (Number.isInteger(value) ? `${value}.0` : `${value}`)

export class ExpressionGenerator {
  constructor(seed) {
    this.random = randomOf(seed)
    this.count = 0
    this.scopes = [[]]
    this.depth = 0
  }

  int(n) {
    return Math.floor(this.random() * n)
  }
  pick(list) {
    return list[this.int(list.length)]
  }
  name() {
    return `v${this.count++}`
  }
  variables(type, isWritten = false) {
    return this.scopes
      .flat()
      .filter((variable) => variable.type === type && !(isWritten && variable.isFixed))
  }
  literal() {
    return Math.round((this.random() * 3 - 1.5) * 100) / 100
  }

  /** Returns { glsl, js } of a type. */
  expression(type, depth = 3) {
    if (type === 'int') return this.integer(depth)
    if (type === 'bool') return this.condition(depth)
    const candidates = this.variables(type)
    if (depth <= 0 || this.random() < 0.15) {
      if (candidates.length && this.random() < 0.8) {
        const { name } = this.pick(candidates)
        return { glsl: name, js: name }
      }
      const literal = this.literal()
      const list = `[${Array(sizes[type]).fill(literal)}]`
      return type === 'float'
        ? { glsl: `(${floatLiteral(literal)})`, js: `(${literal})` }
        : { glsl: `${type}(${floatLiteral(literal)})`, js: list }
    }
    const x = () => this.expression(type, depth - 1)
    const scalar = () => this.expression('float', depth - 1)
    const perComponent = (glsl, f, ...operands) => ({
      glsl,
      js: `perComponent(${f}, ${operands.map(({ js }) => js).join(', ')})`,
    })
    const kinds = {
      sum: () => {
        const [a, b] = [x(), x()]
        const op = this.pick(['+', '-'])
        return perComponent(`(${a.glsl} ${op} ${b.glsl})`, `(a, b) => a ${op} b`, a, b)
      },
      product: () => {
        const [a, b] = [x(), scalar()]
        return perComponent(`(${a.glsl} * sin(${b.glsl}))`, '(a, b) => a * Math.sin(b)', a, b)
      },
      quotient: () => {
        const [a, b] = [x(), scalar()]
        return perComponent(
          `(${a.glsl} / (1.5 + abs(${b.glsl})))`,
          '(a, b) => a / (1.5 + Math.abs(b))',
          a,
          b,
        )
      },
      wave: () => {
        const a = x()
        const f = this.pick(['sin', 'cos', 'atan', 'tanh'])
        return perComponent(`${f}(${a.glsl})`, `Math.${f}`, a)
      },
      root: () => {
        const a = x()
        return perComponent(`sqrt(abs(${a.glsl}) + 0.2)`, '(a) => Math.sqrt(Math.abs(a) + 0.2)', a)
      },
      negative: () => {
        const a = x()
        return perComponent(`(-${a.glsl})`, '(a) => -a', a)
      },
      mix: () => {
        const [a, b, t] = [x(), x(), scalar()]
        return perComponent(
          `mix(${a.glsl}, ${b.glsl}, fract(${t.glsl}))`,
          '(a, b, t) => a + (b - a) * (t - Math.floor(t))',
          a,
          b,
          t,
        )
      },
      extreme: () => {
        const [a, b] = [x(), scalar()]
        const f = this.pick(['min', 'max'])
        return perComponent(`${f}(${a.glsl}, ${b.glsl})`, `Math.${f}`, a, b)
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
      kinds.component = () => {
        const a = this.expression('vec3', depth - 1)
        const letter = this.pick('xyz')
        return { glsl: `${a.glsl}.${letter}`, js: `pick(${a.js}, '${letter}')` }
      }
      kinds.integer = () => {
        const a = this.integer(depth - 1)
        return { glsl: `(float(${a.glsl}) * 0.11)`, js: `(${a.js} * 0.11)` }
      }
      kinds.table = () => {
        const a = this.integer(depth - 1)
        return { glsl: `table[abs(${a.glsl}) % 4]`, js: `table[Math.abs(${a.js}) % 4]` }
      }
      kinds.field = () => ({ glsl: 'wave.height', js: 'wave.height' })
      kinds.call = () => {
        const [a, b] = [scalar(), this.expression('vec2', depth - 1)]
        return { glsl: `helper(${a.glsl}, ${b.glsl})`, js: `helper(${a.js}, ${b.js})` }
      }
    } else {
      kinds.vector = () => {
        const parts = Array.from({ length: sizes[type] }, scalar)
        return {
          glsl: `${type}(${parts.map(({ glsl }) => glsl).join(', ')})`,
          js: `[${parts.map(({ js }) => js).join(', ')}]`,
        }
      }
      kinds.swizzle = () => {
        const a = this.expression('vec3', depth - 1)
        const letters = Array.from({ length: sizes[type] }, () => this.pick('xyz')).join('')
        return { glsl: `${a.glsl}.${letters}`, js: `pick(${a.js}, '${letters}')` }
      }
    }
    return this.pick(Object.values(kinds))()
  }

  integer(depth) {
    const candidates = this.variables('int')
    if (depth <= 0 || this.random() < 0.4) {
      if (candidates.length && this.random() < 0.8) {
        const { name } = this.pick(candidates)
        return { glsl: name, js: name }
      }
      const value = this.int(7) - 2
      return { glsl: `(${value})`, js: `(${value})` }
    }
    const kind = this.int(11)
    const [a, b] = [this.integer(depth - 2), this.integer(depth - 2)]
    // Bit operations whose results are small.
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
      const op = this.pick(['&&', '||'])
      return { glsl: `(${a.glsl} ${op} ${b.glsl})`, js: `(${a.js} ${op} ${b.js})` }
    }
    if (kind === 1) {
      const [a, b] = [this.integer(depth - 1), this.integer(depth - 1)]
      const op = this.pick(['<', '==', '>='])
      return { glsl: `(${a.glsl} ${op} ${b.glsl})`, js: `(${a.js} ${op} ${b.js})` }
    }
    const [a, b] = [this.expression('float', depth - 1), this.expression('float', depth - 1)]
    // Without the constant, values that are equal except for rounding could take different branches.
    const op = this.pick(['<', '>', '<='])
    return {
      glsl: `(${a.glsl} ${op} ${b.glsl} + 0.01037)`,
      js: `(${a.js} ${op} ${b.js} + 0.01037)`,
    }
  }
}
