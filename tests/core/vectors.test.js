// Methods of p5.Vector on expressions have the same values as p5's own class, or throw an error that says what to write instead.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { WarpError, compile, compileWarp } from '../../dist/warpjet.js'

// p5's own class, without the rest of p5, which needs a browser.
const { Vector } = await import('../../node_modules/p5/dist/math/p5.Vector.js')
// p5 wraps these methods in a sketch, so that they take numbers, a vector, or an array of numbers.
for (const name of ['add', 'sub', 'mult', 'div', 'rem']) {
  const original = Vector.prototype[name]
  Vector.prototype[name] = function (...args) {
    const [first] = args
    if (first instanceof Vector) return original.call(this, first.values)
    return original.call(this, args.length > 1 || /add|sub/.test(name) ? args : first)
  }
}

const samples = [
  [0.75, -2, 3.5],
  [-1.25, 0.5, 4],
  [3, 1, -0.25],
  [5.5, -7.25, 2],
]

/** Compares the results of `write(v, w)` for expressions with those for p5's vectors. */
function compare(size, write, name = write.toString()) {
  const run = compile((glsl) => {
    const v = glsl[`vec${size}Param`]('v')
    return { result: write(v, glsl[`vec${size}Param`]('w')) }
  })
  for (const [i, sample] of samples.entries()) {
    const [v, w] = [sample, samples[(i + 1) % 4]].map((numbers) => numbers.slice(0, size))
    const { result } = run.evaluate({ v, w })
    const expected = write(new Vector(...v), new Vector(...w))
    const numbers = expected instanceof Vector ? expected.values : [expected]
    assert.equal([result].flat().length, numbers.length, name)
    for (const [k, value] of [...[result].flat()].entries())
      assert.ok(
        Math.abs(value - numbers[k]) <= 1e-5 * Math.max(1, Math.abs(numbers[k])),
        `${name} of ${v}: ${result}, not ${numbers}`,
      )
  }
}

test('a vector can be passed as separate numbers, as in p5', () => {
  for (const name of ['add', 'sub', 'mult', 'div']) {
    compare(3, (v) => v[name](0.5, 2, -4), `${name} of three`)
    compare(2, (v) => v[name](0.5, 2), `${name} of two`)
  }
  compare(3, (v) => v.rem(0.5, 2, 3))
  compare(2, (v) => v.rem(0.5, 2))
  compare(3, (v) => v.rem(2))
  compare(3, (v, w) => v.copy().rem(w.copy().mult(w)))
  compare(3, (v) => v.dot(0.5, 2, -4))
  compare(2, (v) => v.dot(0.5, 2))
  compare(3, (v) => v.copy().lerp(0.5, 2, -4, 0.25))
  compare(3, (v, w) => v.copy().lerp(w, 0.25))
})

test('separate numbers can be expressions, also for functions of the builder and for aliases', () => {
  const text = (write) =>
    compile((glsl) => ({
      result: write(glsl, glsl.vec3Param('v'), glsl.param('a'), glsl.vec2Param('uv')),
    })).code
  const pairs = [
    [(glsl, v, a) => v.mult(a, 2, a.sin()), (glsl, v, a) => v.mult(glsl.vec3(a, 2, a.sin()))],
    [(glsl, v, a) => glsl.mult(v, a, 2, 3), (glsl, v, a) => glsl.mult(v, glsl.vec3(a, 2, 3))],
    [(glsl, v, a) => v.plus(a, 2, 3), (glsl, v, a) => v.add(glsl.vec3(a, 2, 3))],
    [(glsl, v, a, uv) => uv.div(a, 4), (glsl, v, a, uv) => uv.div(glsl.vec2(a, 4))],
    [(glsl, v, a) => v.mod(a, 2, 3), (glsl, v, a) => v.mod(glsl.vec3(a, 2, 3))],
    [(glsl, v, a) => v.dist(a, 2, 3), (glsl, v, a) => v.dist(glsl.vec3(a, 2, 3))],
    [(glsl, v, a) => v.cross(a, 2, 3), (glsl, v, a) => v.cross(glsl.vec3(a, 2, 3))],
    [(glsl, v, a) => v.lerp(a, 2, 3, 0.5), (glsl, v, a) => v.mix(glsl.vec3(a, 2, 3), 0.5)],
    [(glsl, v) => glsl.vec3(...v.array()), (glsl, v) => glsl.vec3(v.x, v.y, v.z)],
    // Operands are not combined into a vector if one of them is a vector, or if the method is called on a number.
    [(glsl, v, a) => v.add(v, a, 2), (glsl, v, a) => v.add(v).add(a).add(2)],
    [(glsl, v, a) => a.mult(2, 3, 4), (glsl, v, a) => a.mult(2).mult(3).mult(4)],
    [(glsl, v, a) => v.mult(2).add(a), (glsl, v, a) => v.mult(2).add(glsl.vec3(a, a, a))],
  ]
  for (const [short, long] of pairs) assert.equal(text(short), text(long), short.toString())
})

test('compositions have the values of the methods of p5.Vector', () => {
  for (const size of [2, 3]) {
    compare(size, (v) => v.copy())
    compare(size, (v) => v.mag())
    compare(size, (v) => v.magSq())
    compare(size, (v) => v.copy().normalize())
    compare(size, (v) => v.copy().limit(2))
    compare(size, (v) => v.copy().limit(100))
    compare(size, (v) => v.copy().setMag(0.5))
    compare(size, (v) => v.heading())
    compare(size, (v, w) => v.dist(w))
    compare(size, (v, w) => v.dot(w))
  }
  compare(3, (v, w) => v.cross(w))
  compare(3, (v, w) => v.angleBetween(w))
  compare(2, (v) => v.copy().rotate(0.75))
  compare(2, (v, w) => v.angleBetween(w))
})

test('compositions have the right derivatives', () => {
  const checkSlopes = (size, write) => {
    const run = compile((glsl) => {
      const v = glsl[`vec${size}Param`]('v')
      const value = glsl.dot(write(v, glsl), glsl[`vec${size}`](...[1, 2, 3].slice(0, size)))
      return { value, slope: glsl.gradient(value, v) }
    })
    const h = 1e-4
    for (const sample of samples) {
      const v = sample.slice(0, size)
      const at = (i, by) => run.evaluate({ v: v.map((x, k) => x + (k === i ? by : 0)) }).value
      const { slope } = run.evaluate({ v })
      v.forEach((_, i) => {
        const difference = (at(i, h) - at(i, -h)) / (2 * h)
        assert.ok(Math.abs(slope[i] - difference) < 0.02 * Math.max(1, Math.abs(difference)), write)
      })
    }
  }
  checkSlopes(3, (v) => v.limit(2))
  checkSlopes(3, (v) => v.setMag(2))
  checkSlopes(2, (v) => v.rotate(v.x.mult(0.5)))
  checkSlopes(3, (v) => v.mult(v.y, 2, v.x.sin()))
})

const compileWith = (write) => () =>
  compileWarp(({ glsl, position, uv }) => write(position, glsl, uv))

test('unsupported uses throw, and say what to write', () => {
  for (const [write, message] of [
    [
      (v) => v.mult(2, 3),
      /^WarpError: mult: a vec3 takes one number for all components or 3, one for each, but got 2; write v\.mult\(glsl\.vec3\(…\)\)/,
    ],
    [(v) => v.add(1, 2, 3, 4), /^WarpError: add: a vec3 takes .* but got 4/],
    [(v, glsl, uv) => glsl.vec3(uv.mult(1, 2, 3), 0), /mult: a vec2 takes/],
    [
      (v) => v.set(1, 2, 3),
      /set: .*did you mean v = glsl\.vec3\(x, y, z\), since an expression never changes/,
    ],
    [(v) => v.slerp(v, 0.5), /slerp: .*a\.mix\(b, amount\)/],
    [(v) => v.limit(), /limit: expected 1 argument, got 0/],
    [(v) => v.rem(1, 2), /rem: expected 1 argument, got 2/],
    [
      (v) => v.mult(v.x.heading()),
      /heading: expected a vec2 or a vec3 or a vec4, got a single number/,
    ],
    [
      (v) => v.setMag('a'),
      /setMag: expected a number or an expression for argument 1, got the text "a"/,
    ],
  ])
    assert.throws(
      compileWith(write),
      (error) => error instanceof WarpError && message.test(`${error}`),
      `${write}`,
    )
})

test('warns once per line about copy(), since the user may want to modify the copy', (t) => {
  const warn = t.mock.method(console, 'warn', () => {})
  const warnings = () => warn.mock.calls.map(({ arguments: [text] }) => text)
  compileWith((v) => {
    const p = v.copy()
    p.add(1, 2, 3)
    return p
  })()
  assert.equal(warnings().length, 1)
  assert.match(
    warnings()[0],
    /^add: an expression of a warp never changes, and the new one is not used \(vectors\.test\.js, line \d+\); write v = v\.add\(…\)\.$/,
  )
  warn.mock.resetCalls()
  compileWith((v) => {
    const p = v.copy()
    p.normalize().mult(2)
    return p
  })()
  assert.match(warnings().join(), /^mult: /)
  warn.mock.resetCalls()
  compileWith((v) => v.copy().add(1, 2, 3).setMag(2).limit(1))()
  compileWith((v, glsl) => glsl.vec3(v.copy().mult(2).x, 0, 0))()
  compileWith((v) => {
    v.add(1)
    return v
  })()
  assert.deepEqual(warnings(), [])
})

test('limit(0) is 0, for a zero vector too', () => {
  const { evaluateAt } = compileWarp(
    ({ position, uniforms }) => position.limit(uniforms.maxLength),
    {
      uniforms: { maxLength: 1 },
    },
  )
  for (const [place, maxLength, moved] of [
    [[0, 0, 0], 0, [0, 0, 0]],
    [[3, 0, 4], 0, [3, 0, 4]],
    [[3, 0, 4], 1, [3.6, 0, 4.8]],
  ]) {
    const { position } = evaluateAt(place, { uniforms: { maxLength } })
    position.forEach((x, i) => assert.ok(Math.abs(x - moved[i]) < 1e-6, `${position}`))
  }
})
