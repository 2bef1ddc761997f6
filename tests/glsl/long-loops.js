// Generates random GLSL functions that contain long loops: with states of each type, counters of each kind, early exits and nested loops.
// Values stay small, since each state decays towards 0; all constants are sixteenths, which are exact in float32.
import { randomOf } from './generate.js'

class LoopGenerator {
  constructor(seed) {
    this.random = randomOf(seed)
    this.names = 0
  }
  int(n) {
    return Math.floor(this.random() * n)
  }
  pick(list) {
    return list[this.int(list.length)]
  }
  name(word) {
    return `${word}${this.names++}`
  }
  /** Returns a number from -1 to 1. */
  literal() {
    const value = (this.int(31) - 15) / 16
    return Number.isInteger(value) ? `${value}.0` : `${value}`
  }

  /** Generates a float between about -2 and 2 from the variables of a scope. */
  float(scope, depth = 2) {
    const { floats, vectors, counters } = scope
    const kind = this.int(depth > 0 ? 11 : 3)
    const next = () => this.float(scope, depth - 1)
    switch (kind) {
      case 0:
        return this.pick(floats)
      case 1:
        return `${this.pick(vectors)}.${this.pick('xyz')}`
      case 2:
        return counters.length ? `float(${this.pick(counters)}) * 0.0625` : this.pick(floats)
      case 3:
        return `sin(${next()} * 1.5 + ${this.literal()})`
      case 4:
        return `(${next()} + ${next()}) * 0.5`
      case 5:
        return `${next()} / (1.5 + abs(${next()}))`
      case 6:
        return `mix(${next()}, ${next()}, 0.25)`
      case 7:
        return `dot(${this.pick(vectors)}, ${this.pick(vectors)}.yzx) * 0.25`
      case 8:
        return `(${this.condition(scope)} ? ${next()} : ${next()})`
      case 9:
        return `wave(${next()}, ${this.pick(vectors)})`
      default:
        return `cos(${next()})`
    }
  }

  condition(scope) {
    const { counters } = scope
    if (counters.length && this.random() < 0.4)
      return `${this.pick(counters)} % ${2 + this.int(3)} == ${this.int(2)}`
    // Without the constant, values that are equal except for rounding could take different branches.
    return `${this.float(scope, 1)} > ${this.float(scope, 0)} + 0.0103759765625`
  }

  statement(scope, depth) {
    const { floats, vectors, ints } = scope
    const kind = this.int(depth > 0 ? 10 : 7)
    if (kind === 0) {
      const x = this.pick(floats.slice(1))
      return `${x} = ${x} * 0.5 + ${this.float(scope)} * 0.5;`
    }
    if (kind === 1) {
      const v = this.pick(vectors.slice(1))
      return `${v} = ${v}.${this.pick(['yzx', 'zxy', 'xyz'])} * 0.75 + 0.25 * sin(${this.pick(vectors)} + ${this.float(scope, 1)});`
    }
    if (kind === 2) {
      const v = this.pick(vectors.slice(1))
      return `${v}.${this.pick(['xy', 'zx'])} *= ${this.pick(['0.5', '0.75'])}; ${v}.${this.pick('xyz')} += ${this.float(scope)} * 0.25;`
    }
    if (kind === 3) return `sum += weight * ${this.float(scope)}; weight *= 0.5;`
    if (kind === 4) return `if (${this.condition(scope)}) ${this.pick(ints)}++;`
    if (kind === 5)
      return `if (${this.condition(scope)}) { ${this.statement(scope, 0)} } else { ${this.statement(scope, 0)} }`
    if (kind === 6) return `flag = flag != (${this.condition(scope)}); if (flag) sum += 0.0625;`
    if (kind === 7)
      return `if (${this.condition(scope)}) ${this.pick(['break', 'continue', 'continue'])};`
    if (kind === 8) return this.loop(scope, depth - 1, 3 + this.int(2))
    return `if (${this.float(scope, 1)} > 1.75) return sum + ${this.pick(floats)};`
  }

  loop(scope, depth, steps = 6 + this.int(18)) {
    const i = this.name('i')
    const hasFloatCounter = this.random() < 0.2
    const inner = {
      ...scope,
      floats: hasFloatCounter ? [...scope.floats, `(${i} * 0.0625)`] : scope.floats,
      counters: hasFloatCounter ? scope.counters : [...scope.counters, i],
    }

    const body = Array.from({ length: 2 + this.int(3) }, () =>
      this.statement(this.withoutCounters(inner), depth),
    ).join('\n')
    if (hasFloatCounter)
      return `for (float ${i} = 0.0; ${i} < ${steps}.5; ${i} += 1.0) {\n${body}\n}`
    const [start, step] = [this.int(9) - 4, 1 + this.int(3)]
    return this.pick([
      `for (int ${i} = 0; ${i} < ${steps}; ${i}++) {\n${body}\n}`,
      `for (int ${i} = ${start}; ${i} > ${start - step * steps}; ${i} -= ${step}) {\n${body}\n}`,
      `for (int ${i} = ${start}; ${i} <= ${start + step * steps}; ${i} += ${step}) {\n${body}\n}`,
      `{ int ${i} = ${steps}; while (${i}-- > 0) {\n${body}\n} }`,
      `{ int ${i} = 0; do {\n${body.replaceAll('continue', 'break')}\n} while (++${i} < ${steps}); }`,
    ])
  }

  /** Returns a scope without the expressions of float counters, which cannot be assigned. */
  withoutCounters = (scope) => ({
    ...scope,
    floats: scope.floats.filter((name) => !name.startsWith('(')),
  })

  text() {
    const scope = {
      floats: ['p.y', 'x', 'y'],
      vectors: ['p', 'v', 'w'],
      ints: ['n', 'm'],
      counters: [],
    }
    const loops = Array.from({ length: 1 + this.int(2) }, () => this.loop(scope, 1)).join('\n')
    return `float wave(float t, vec3 q) { float s = sin(t + q.x); return s * cos(q.y * 0.5) + 0.25 * t; }
float f(vec3 p) {
float x = p.x, y = sin(p.z), sum = 0.0, weight = 1.0;
vec3 v = p.zxy * 0.5, w = vec3(p.x * p.y, 0.5, p.z);
int n = 0, m = 3;
bool flag = p.x > 0.0;
${loops}
return sum + x * 0.5 + y * 0.25 + dot(v, w) + float(n) * 0.125 - float(m) * 0.0625 + (flag ? 0.5 : 0.0);
}
`
  }
}

/** Generates the source of a function `float f(vec3 p)`. */
export const randomLongLoops = (seed) => new LoopGenerator(seed).text()
