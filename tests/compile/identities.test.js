// The identities by which the compiler rewrites formulas, one at a time: evaluates the code of random formulas in double precision,
// against the formula and its derivative without rewriting, and checks that the code has the shorter form.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import { runGlsl } from '../glsl/run.js'
import { seededRandom } from '../warps/random.js'

/** The rounding error in double precision, of numbers of about 1. */
const tolerance = 1e-11
const formulas = 60

/** A formula in two forms: for the compiler, and as a function inputs → [value, derivative with respect to x]. */
class Twin {
  constructor(expression, at) {
    Object.assign(this, { expression, at })
  }

  #one(name, f, slope) {
    const at = (inputs) => {
      const [value, derivative] = this.at(inputs)
      return [f(value), slope(value) * derivative]
    }
    return new Twin(this.expression[name](), at)
  }
  /** `other` may be a number. */
  #two(name, other, f, slopeOfFirst, slopeOfSecond) {
    const isNumber = typeof other === 'number'
    const at = (inputs) => {
      const [[a, da], [b, db]] = [this.at(inputs), isNumber ? [other, 0] : other.at(inputs)]
      return [f(a, b), slopeOfFirst(a, b) * da + slopeOfSecond(a, b) * db]
    }
    return new Twin(this.expression[name](isNumber ? other : other.expression), at)
  }

  neg = () =>
    this.#one(
      'neg',
      (a) => -a,
      () => -1,
    )
  sin = () => this.#one('sin', Math.sin, Math.cos)
  cos = () => this.#one('cos', Math.cos, (a) => -Math.sin(a))
  sqrt = () => this.#one('sqrt', Math.sqrt, (a) => 0.5 / Math.sqrt(a))
  add = (other) => this.#two('add', other, (a, b) => a + b, one, one)
  sub = (other) =>
    this.#two(
      'sub',
      other,
      (a, b) => a - b,
      one,
      () => -1,
    )
  mult = (other) =>
    this.#two(
      'mult',
      other,
      (a, b) => a * b,
      (_, b) => b,
      (a) => a,
    )
  div = (other) =>
    this.#two(
      'div',
      other,
      (a, b) => a / b,
      (_, b) => 1 / b,
      (a, b) => -a / b ** 2,
    )
}

const one = () => 1

class Chance {
  constructor(glsl, seed) {
    this.glsl = glsl
    this.random = seededRandom(seed * 7919 + 1)
    this.inputs = 'xyzw'
      .split('')
      .map((name) => new Twin(glsl.param(name), (at) => [at[name], Number(name === 'x')]))
  }

  below = (end) => Math.floor(this.random() * end)
  isHeads = () => this.below(2) === 0
  /** Returns a number with few digits, so that the literal in the code is exact in float32. */
  number = () => ((1 + this.below(6)) / 4) * (this.isHeads() ? 1 : -1)
  either = (a, b) => (this.isHeads() ? [a, b] : [b, a])
  /** Picks an input, x more often than others. */
  formula(depth = 2) {
    const input = this.inputs[Math.max(this.below(6) - 2, 0)]
    if (depth === 0) return input
    const some = this.formula(depth - 1)
    const kinds = [
      () => some.mult(this.number()).add(input),
      () => some.mult(input),
      () => input.add(some).sin(),
      () => input.sub(some.cos()),
    ]
    return kinds[this.below(kinds.length)]()
  }
  product(a, b) {
    const [first, second] = this.either(a, b)
    return first.mult(second)
  }
  square = (a) => a.mult(a)
  reciprocal(x) {
    const at = (inputs) => {
      const [value, derivative] = x.at(inputs)
      return [1 / value, -derivative / value ** 2]
    }
    return new Twin(this.glsl.div(1, x.expression), at)
  }
  positive = () => this.square(this.formula()).add(0.5)
}

/** Maps a name → function that makes a formula, and a pattern that its code must match, if the rewrite shows in the code. */
const identities = {
  'sin² + cos² is 1': {
    write(chance) {
      const angle = chance.formula()
      const [a, b] = chance.either(chance.square(angle.sin()), chance.square(angle.cos()))
      return a.add(b).mult(chance.inputs[3])
    },
    has: ({ value }) => value === 'w',
  },
  'x + x is 2 x, and two minus signs are none': {
    write(chance) {
      const [x, y] = [chance.formula(), chance.formula()]
      return x.add(x).sub(y.neg()).add(x.neg().mult(y.neg()))
    },
    has: ({ value }) => !/- ?-|\(-/.test(value),
  },
  'x / √x is √x': {
    write(chance) {
      const x = chance.positive()
      return x.div(x.sqrt())
    },
    has: ({ value }) => /^sqrt\(/.test(value),
  },
  'x (1 / y) is x / y': {
    write(chance) {
      const [x, y] = [chance.formula(), chance.positive()]
      return chance.product(x, chance.reciprocal(y))
    },
    has: ({ value }) => value.includes('/') && !value.includes('1.0 /'),
  },
  'constants of a sum, and of a product, are one': {
    write(chance) {
      const x = chance.inputs[1].add(chance.number()).sub(chance.number())
      return x.mult(chance.number()).mult(chance.number())
    },
    has: ({ value }) => (value.match(/\d\.\d/g) ?? []).length <= 2,
  },
}

/** Rotates two formulas by a random angle: about a pivot or not, in either direction, with factors and terms in any order. */
function rotate(chance, [p, q], angle) {
  const [c, s] = [angle.cos(), angle.sin()]
  const times = (a, b) => chance.product(a, b)
  const [ahead, back] = chance.either(1, -1)
  const plus = (a, b) => chance.either(a, b).reduce((x, y) => x.add(y))
  const sum = (a, b, sign) => (sign > 0 ? plus(a, b) : a.sub(b))
  return [sum(times(p, c), times(q, s), ahead), sum(times(q, c), times(p, s), back)]
}

function check(seed, outputs, has = () => true) {
  let twins
  const { code, stats } = compile((glsl) => {
    twins = outputs(new Chance(glsl, seed))
    const results = twins.flatMap((twin, i) => [
      [`value${i}`, twin.expression],
      [`slope${i}`, glsl.derivative(twin.expression, glsl.param('x'))],
    ])
    return Object.fromEntries(results)
  })
  const random = seededRandom(seed + 4711)
  for (let point = 0; point < 8; point++) {
    const inputs = Object.fromEntries('xyzw'.split('').map((name) => [name, random() * 4 - 2]))
    const found = runGlsl(code, inputs)
    twins.forEach((twin, i) => {
      const [value, slope] = twin.at(inputs)
      for (const [name, expected] of [
        [`value${i}`, value],
        [`slope${i}`, slope],
      ]) {
        const error = Math.abs(found[name] - expected)
        assert.ok(
          error <= tolerance * Math.max(1, Math.abs(expected)),
          `${name} of ${seed}: ${found[name]}, ${expected}\n${code}`,
        )
      }
    })
  }
  const value = /value0 = (.*);/.exec(code)[1]
  assert.ok(has({ code, stats, value }), `formula ${seed}:\n${code}`)
}

describe('the value and the derivative:', () => {
  for (const [name, { write, has }] of Object.entries(identities))
    test(name, () => {
      for (let seed = 0; seed < formulas; seed++) check(seed, (chance) => [write(chance)], has)
    })

  test('a point that is rotated twice has the shortest code', () => {
    for (let seed = 0; seed < 5 * formulas; seed++)
      check(seed, (chance) => {
        const point = [chance.formula(1), chance.formula()]
        const once = rotate(chance, point, chance.formula())
        return [...once, ...rotate(chance, once, chance.formula())]
      })
  })

  test('the derivative of a rotated constant point is the other component times the slope of the angle', () => {
    for (let seed = 0; seed < formulas; seed++)
      check(
        seed,
        (chance) => {
          const [x, y, z, w] = chance.inputs
          return rotate(chance, [y.add(w), z], x.mult(w).add(chance.number()))
        },
        // y + w, the angle, its sine and cosine, four products and two sums; then two products and a minus sign.
        ({ stats }) => stats.operations <= 1 + 2 + 2 + 6 + 3,
      )
  })
})

describe('vectors:', () => {
  const random = seededRandom(99)
  const below = (end) => Math.floor(random() * end)
  const shuffle = (items) =>
    items
      .map((item) => [random(), item])
      .sort(([a], [b]) => a - b)
      .map(([, item]) => item)
  const numbers = (size) => Array.from({ length: size }, () => random() * 4 - 2)
  const parts = ['x', 'y', 'z', 'w']

  /** Adds terms in the given order; each is a pair of factors in any order. */
  const sumOf = (terms) =>
    terms.map(([a, b]) => (below(2) ? a.mult(b) : b.mult(a))).reduce((sum, term) => sum.add(term))

  test('a sum of products of components is a dot product', () => {
    for (let i = 0; i < formulas; i++) {
      const size = 2 + below(3)
      const order = shuffle(parts.slice(0, size))
      const { code } = compile((glsl) => {
        const [a, b] = ['a', 'b'].map((name) => glsl[`vec${size}Param`](name))
        return { y: sumOf(order.map((part) => [a[part](), b[part]()])) }
      })
      assert.match(code, /y = dot\(/)
      const [a, b] = [numbers(size), numbers(size)]
      const expected = a.reduce((sum, _, k) => sum + a[k] * b[k], 0)
      assert.ok(Math.abs(runGlsl(code, { a, b }).y - expected) < tolerance, code)
    }
  })

  test('similar formulas are not rewritten', () => {
    for (let i = 0; i < formulas; i++) {
      const [first, second] = [shuffle(['x', 'y', 'z']), shuffle(['x', 'y', 'z'])]
      const { code } = compile((glsl) => {
        const [a, b] = [glsl.vec3Param('a'), glsl.vec3Param('b')]
        return { y: sumOf(first.map((part, k) => [a[part](), b[second[k]]()])) }
      })
      const [a, b] = [numbers(3), numbers(3)]
      const at = (v, part) => v[parts.indexOf(part)]
      const expected = first.reduce((sum, part, k) => sum + at(a, part) * at(b, second[k]), 0)
      assert.ok(Math.abs(runGlsl(code, { a, b }).y - expected) < tolerance, code)
      assert.equal(code.includes('dot('), String(first) === String(second), code)
    }
  })

  test('differences of products of components are a cross product, in either order', () => {
    for (let i = 0; i < formulas; i++) {
      const [u, v] = shuffle(['a', 'b'])
      const wrong = below(3) ? -1 : below(3)
      const isReverse = below(2) === 1
      const product = (a, b) => (isReverse ? b.mult(a) : a.mult(b))
      const { code } = compile((glsl) => {
        const of = { a: glsl.vec3Param('a'), b: glsl.vec3Param('b') }
        const component = (_, k) => {
          const [j, l] = [parts[(k + 1) % 3], parts[(k + 2) % 3]]
          const [plus, minus] = [
            [of[u][j](), of[v][l]()],
            [of[u][l](), of[v][j]()],
          ]
          const [first, second] = k === wrong ? [minus, plus] : [plus, minus]
          return product(...first).sub(product(...second))
        }
        return { y: glsl.vec3(...[0, 1, 2].map(component)) }
      })
      const inputs = { a: numbers(3), b: numbers(3) }
      const [p, q] = [inputs[u], inputs[v]]
      const found = runGlsl(code, inputs).y
      found.forEach((value, k) => {
        const [j, l] = [(k + 1) % 3, (k + 2) % 3]
        const expected = (p[j] * q[l] - p[l] * q[j]) * (k === wrong ? -1 : 1)
        assert.ok(Math.abs(value - expected) < tolerance, code)
      })
      assert.equal(code.includes('cross('), wrong === -1, code)
    }
  })

  test('the same operations on all components become vector operations, and different ones do not', () => {
    for (let i = 0; i < formulas; i++) {
      const [scale, shift] = numbers(2).map((number) => Math.round(number * 4) / 4 + 5)
      const other = below(4)
      const order = shuffle(['x', 'y', 'z'])
      const { code } = compile((glsl) => {
        const p = glsl.vec3Param('p')
        const component = (part, k) => {
          const inner = p[part]()
            .mult(k === other ? shift : scale)
            .add(shift)
            .sin()
          return inner.mult(inner).add(p[part]())
        }
        return { y: glsl.vec3(...order.map(component)) }
      })
      const p = numbers(3)
      const found = runGlsl(code, { p }).y
      order.forEach((part, k) => {
        const x = p[parts.indexOf(part)]
        const inner = Math.sin(x * (k === other ? shift : scale) + shift)
        assert.ok(Math.abs(found[k] - inner * inner - x) < tolerance, code)
      })
      if (other === 3) assert.equal(code.match(/sin\(/g).length, 1, code)
    }
  })
})
