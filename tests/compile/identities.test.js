// Tests each identity by which the compiler rewrites formulas: evaluates the code of random formulas in double precision, compares it with
// the value and the derivative that are computed here without rewriting, and checks that the code has the shorter form.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import { runGlsl } from '../glsl/run.js'
import { seededRandom } from '../warps/random.js'

/** The maximum rounding error in double precision, of numbers of about 1. */
const tolerance = 1e-11
const formulaCount = 60

/** A formula in two forms: for the compiler, and as a function inputs → [value, derivative with respect to x]. */
class Twin {
  constructor(expression, at) {
    Object.assign(this, { expression, at })
  }

  #unary(name, f, slope) {
    const at = (inputs) => {
      const [value, derivative] = this.at(inputs)
      return [f(value), slope(value) * derivative]
    }
    return new Twin(this.expression[name](), at)
  }
  /** `other` may be a number. */
  #binary(name, other, f, slopeOfFirst, slopeOfSecond) {
    const isNumber = typeof other === 'number'
    const at = (inputs) => {
      const [[a, da], [b, db]] = [this.at(inputs), isNumber ? [other, 0] : other.at(inputs)]
      return [f(a, b), slopeOfFirst(a, b) * da + slopeOfSecond(a, b) * db]
    }
    return new Twin(this.expression[name](isNumber ? other : other.expression), at)
  }

  neg = () =>
    this.#unary(
      'neg',
      (a) => -a,
      () => -1,
    )
  sin = () => this.#unary('sin', Math.sin, Math.cos)
  cos = () => this.#unary('cos', Math.cos, (a) => -Math.sin(a))
  sqrt = () => this.#unary('sqrt', Math.sqrt, (a) => 0.5 / Math.sqrt(a))
  add = (other) => this.#binary('add', other, (a, b) => a + b, one, one)
  sub = (other) =>
    this.#binary(
      'sub',
      other,
      (a, b) => a - b,
      one,
      () => -1,
    )
  mult = (other) =>
    this.#binary(
      'mult',
      other,
      (a, b) => a * b,
      (_, b) => b,
      (a) => a,
    )
  div = (other) =>
    this.#binary(
      'div',
      other,
      (a, b) => a / b,
      (_, b) => 1 / b,
      (a, b) => -a / b ** 2,
    )
}

const one = () => 1

/** Generates random formulas and choices. */
class Generator {
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
  /** Returns a and b in random order. */
  either = (a, b) => (this.isHeads() ? [a, b] : [b, a])
  /** Returns a random formula of operations nested up to `depth` deep. It reads x more often than the other inputs. */
  formula(depth = 2) {
    const input = this.inputs[Math.max(this.below(6) - 2, 0)]
    if (depth === 0) return input
    const operand = this.formula(depth - 1)
    const kinds = [
      () => operand.mult(this.number()).add(input),
      () => operand.mult(input),
      () => input.add(operand).sin(),
      () => input.sub(operand.cos()),
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

/**
 * Maps the name of an identity → `write`, which makes a formula to rewrite, and `isRewritten`, which returns whether its code has the short
 * form.
 */
const identities = {
  'sin² + cos² is 1': {
    write(generator) {
      const angle = generator.formula()
      const [a, b] = generator.either(generator.square(angle.sin()), generator.square(angle.cos()))
      return a.add(b).mult(generator.inputs[3])
    },
    isRewritten: ({ value }) => value === 'w',
  },
  'x + x is 2 x, and two minus signs cancel': {
    write(generator) {
      const [x, y] = [generator.formula(), generator.formula()]
      return x.add(x).sub(y.neg()).add(x.neg().mult(y.neg()))
    },
    isRewritten: ({ value }) => !/- ?-|\(-/.test(value),
  },
  'x / √x is √x': {
    write(generator) {
      const x = generator.positive()
      return x.div(x.sqrt())
    },
    isRewritten: ({ value }) => /^sqrt\(/.test(value),
  },
  'x (1 / y) is x / y': {
    write(generator) {
      const [x, y] = [generator.formula(), generator.positive()]
      return generator.product(x, generator.reciprocal(y))
    },
    isRewritten: ({ value }) => value.includes('/') && !value.includes('1.0 /'),
  },
  'the constants of a sum or a product are combined into one': {
    write(generator) {
      const x = generator.inputs[1].add(generator.number()).sub(generator.number())
      return x.mult(generator.number()).mult(generator.number())
    },
    isRewritten: ({ value }) => (value.match(/\d\.\d/g) ?? []).length <= 2,
  },
}

/** Rotates two formulas by an angle, in a random direction, with factors and terms in random order. */
function rotate(generator, [p, q], angle) {
  const [c, s] = [angle.cos(), angle.sin()]
  const times = (a, b) => generator.product(a, b)
  const [firstSign, secondSign] = generator.either(1, -1)
  const plus = (a, b) => generator.either(a, b).reduce((x, y) => x.add(y))
  const sum = (a, b, sign) => (sign > 0 ? plus(a, b) : a.sub(b))
  return [sum(times(p, c), times(q, s), firstSign), sum(times(q, c), times(p, s), secondSign)]
}

function check(seed, outputs, isRewritten = () => true) {
  let twins
  const { code, stats } = compile((glsl) => {
    twins = outputs(new Generator(glsl, seed))
    const results = twins.flatMap((twin, i) => [
      [`value${i}`, twin.expression],
      [`slope${i}`, glsl.derivative(twin.expression, glsl.param('x'))],
    ])
    return Object.fromEntries(results)
  })
  const random = seededRandom(seed + 4711)
  for (let point = 0; point < 8; point++) {
    const inputs = Object.fromEntries('xyzw'.split('').map((name) => [name, random() * 4 - 2]))
    const actual = runGlsl(code, inputs)
    twins.forEach((twin, i) => {
      const [value, slope] = twin.at(inputs)
      for (const [name, expected] of [
        [`value${i}`, value],
        [`slope${i}`, slope],
      ]) {
        const error = Math.abs(actual[name] - expected)
        assert.ok(
          error <= tolerance * Math.max(1, Math.abs(expected)),
          `${name} of formula ${seed}: ${actual[name]}, not ${expected}\n${code}`,
        )
      }
    })
  }
  const value = /value0 = (.*);/.exec(code)[1]
  assert.ok(isRewritten({ code, stats, value }), `formula ${seed}:\n${code}`)
}

describe('the value and the derivative:', () => {
  for (const [name, { write, isRewritten }] of Object.entries(identities))
    test(name, () => {
      for (let seed = 0; seed < formulaCount; seed++)
        check(seed, (generator) => [write(generator)], isRewritten)
    })

  test('a point that is rotated twice', () => {
    for (let seed = 0; seed < 5 * formulaCount; seed++)
      check(seed, (generator) => {
        const point = [generator.formula(1), generator.formula()]
        const once = rotate(generator, point, generator.formula())
        return [...once, ...rotate(generator, once, generator.formula())]
      })
  })

  test('if only the angle depends on x, the derivative of a rotated point is the other component times the slope of the angle', () => {
    for (let seed = 0; seed < formulaCount; seed++)
      check(
        seed,
        (generator) => {
          const [x, y, z, w] = generator.inputs
          return rotate(generator, [y.add(w), z], x.mult(w).add(generator.number()))
        },
        // Value: y + w, the angle, its sine and cosine, four products and two sums. Derivatives: two products and a minus sign.
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
  const letters = ['x', 'y', 'z', 'w']

  /** Adds terms in the given order; each is a pair of factors in any order. */
  const sumOf = (terms) =>
    terms.map(([a, b]) => (below(2) ? a.mult(b) : b.mult(a))).reduce((sum, term) => sum.add(term))

  test('a sum of products of components is a dot product', () => {
    for (let i = 0; i < formulaCount; i++) {
      const size = 2 + below(3)
      const order = shuffle(letters.slice(0, size))
      const { code } = compile((glsl) => {
        const [a, b] = ['a', 'b'].map((name) => glsl[`vec${size}Param`](name))
        return { y: sumOf(order.map((letter) => [a[letter](), b[letter]()])) }
      })
      assert.match(code, /y = dot\(/)
      const [a, b] = [numbers(size), numbers(size)]
      const expected = a.reduce((sum, _, k) => sum + a[k] * b[k], 0)
      assert.ok(Math.abs(runGlsl(code, { a, b }).y - expected) < tolerance, code)
    }
  })

  test('a sum of products of different components is not a dot product', () => {
    for (let i = 0; i < formulaCount; i++) {
      const [first, second] = [shuffle(['x', 'y', 'z']), shuffle(['x', 'y', 'z'])]
      const { code } = compile((glsl) => {
        const [a, b] = [glsl.vec3Param('a'), glsl.vec3Param('b')]
        return { y: sumOf(first.map((letter, k) => [a[letter](), b[second[k]]()])) }
      })
      const [a, b] = [numbers(3), numbers(3)]
      const at = (v, letter) => v[letters.indexOf(letter)]
      const expected = first.reduce((sum, letter, k) => sum + at(a, letter) * at(b, second[k]), 0)
      assert.ok(Math.abs(runGlsl(code, { a, b }).y - expected) < tolerance, code)
      assert.equal(code.includes('dot('), String(first) === String(second), code)
    }
  })

  test('differences of products of components are a cross product, in either order', () => {
    for (let i = 0; i < formulaCount; i++) {
      const [u, v] = shuffle(['a', 'b'])
      // The index of the component whose terms are swapped; mostly -1, for none.
      const swapped = below(3) ? -1 : below(3)
      const isReverse = below(2) === 1
      const product = (a, b) => (isReverse ? b.mult(a) : a.mult(b))
      const { code } = compile((glsl) => {
        const vectors = { a: glsl.vec3Param('a'), b: glsl.vec3Param('b') }
        const component = (_, k) => {
          const [j, l] = [letters[(k + 1) % 3], letters[(k + 2) % 3]]
          const [plus, minus] = [
            [vectors[u][j](), vectors[v][l]()],
            [vectors[u][l](), vectors[v][j]()],
          ]
          const [first, second] = k === swapped ? [minus, plus] : [plus, minus]
          return product(...first).sub(product(...second))
        }
        return { y: glsl.vec3(...[0, 1, 2].map(component)) }
      })
      const inputs = { a: numbers(3), b: numbers(3) }
      const [p, q] = [inputs[u], inputs[v]]
      const actual = runGlsl(code, inputs).y
      actual.forEach((value, k) => {
        const [j, l] = [(k + 1) % 3, (k + 2) % 3]
        const expected = (p[j] * q[l] - p[l] * q[j]) * (k === swapped ? -1 : 1)
        assert.ok(Math.abs(value - expected) < tolerance, code)
      })
      assert.equal(code.includes('cross('), swapped === -1, code)
    }
  })

  test('the same operations on all components become vector operations, and different ones do not', () => {
    for (let i = 0; i < formulaCount; i++) {
      const [scale, shift] = numbers(2).map((number) => Math.round(number * 4) / 4 + 5)
      // The index of the component whose operations differ; 3 if none do.
      const differing = below(4)
      const order = shuffle(['x', 'y', 'z'])
      const { code } = compile((glsl) => {
        const p = glsl.vec3Param('p')
        const component = (letter, k) => {
          const inner = p[letter]()
            .mult(k === differing ? shift : scale)
            .add(shift)
            .sin()
          return inner.mult(inner).add(p[letter]())
        }
        return { y: glsl.vec3(...order.map(component)) }
      })
      const p = numbers(3)
      const actual = runGlsl(code, { p }).y
      order.forEach((letter, k) => {
        const x = p[letters.indexOf(letter)]
        const inner = Math.sin(x * (k === differing ? shift : scale) + shift)
        assert.ok(Math.abs(actual[k] - inner * inner - x) < tolerance, code)
      })
      if (differing === 3) assert.equal(code.match(/sin\(/g).length, 1, code)
    }
  })
})
