// Offset functions with operators, beside the same with methods: the text that comes of both is the same, byte for byte.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { operators } from '../../dist/operators.js'
import { translateModule } from '../../dist/operators-plugin.js'
import { withOperators } from '../../dist/operators-runtime.js'
import { compileWarp, WarpError } from '../../dist/warpjet.js'

/** By name, with operators and with methods. */
const pairs = {
  arithmetic: [
    ({ position, millis }) => [position.y * 4 + millis / 500, -position.x, 2 - position.z ** 2],
    ({ glsl, position, millis }) =>
      glsl.vec3(
        position.y().mult(4).add(millis.div(500)),
        position.x().neg(),
        glsl.sub(2, position.z().pow(2)),
      ),
  ],
  vectors: [
    ({ position }) => position * 2 + [1, 2, 3] - position.yzx / 3,
    ({ glsl, position }) =>
      position
        .mult(2)
        .add(glsl.vec3(1, 2, 3))
        .sub(position.yzx().div(3)),
  ],
  'functions of Math': [
    ({ position }) => [
      Math.sin(position.y * 4),
      Math.max(position.x, 0, position.z),
      Math.atan2(position.y, position.x) * Math.PI,
    ],
    ({ glsl, position }) =>
      glsl.vec3(
        position.y().mult(4).sin(),
        glsl.max(glsl.max(position.x(), 0), position.z()),
        position.y().atan(position.x()).mult(Math.PI),
      ),
  ],
  'comparisons and logic': [
    ({ position }) =>
      (position.x > 0 && !(position.y <= 1)) || position.z === 2 ? position : -position,
    ({ position }) =>
      position
        .x()
        .gt(0)
        .and(position.y().le(1).not())
        .or(position.z().eq(2))
        .ifElse(position, position.neg()),
  ],
  'if and else': [
    ({ position }) => {
      let height = 1
      let side = position.x
      if (position.y > 0) {
        height = position.y
        side *= 2
      } else if (position.y > -1) height += position.z
      return [side, height, 0]
    },
    ({ glsl, position }) => {
      const [x, y, z] = [position.x(), position.y(), position.z()]
      const isUp = y.gt(0)
      const inner = y.gt(-1).ifElse(glsl.add(1, z), 1)
      return glsl.vec3(isUp.ifElse(x.mult(2), x), isUp.ifElse(y, inner), 0)
    },
  ],
  'an early return': [
    ({ position }) => {
      if (position.y > 0) return position * 2
      const [x, y] = [position.x, position.y]
      return [x, y * 3, 0]
    },
    ({ glsl, position }) =>
      position
        .y()
        .gt(0)
        .ifElse(position.mult(2), glsl.vec3(position.x(), position.y().mult(3), 0)),
  ],
  'a loop of known count': [
    ({ position }) => {
      let sum = 0
      for (let i = 1; i <= 4; i++) {
        if (i === 3) continue
        sum += Math.sin(position.x * i) / i
      }
      return [0, sum, 0]
    },
    ({ glsl, position }) => {
      let sum
      for (const i of [1, 2, 4]) {
        const wave = position.x().mult(i).sin().div(i)
        sum = sum ? sum.add(wave) : glsl.add(0, wave)
      }
      return glsl.vec3(0, sum, 0)
    },
  ],
  'a function inside': [
    function ({ position, millis }) {
      const wave = (x, speed = 2) => Math.sin(x + (speed * millis) / 1000)
      return [wave(position.y), wave(position.z, 3), 0]
    },
    ({ glsl, position, millis }) => {
      const wave = (x, speed) => x.add(glsl.mult(speed, millis).div(1000)).sin()
      return glsl.vec3(wave(position.y(), 2), wave(position.z(), 3), 0)
    },
  ],
  'a twist': [
    ({ glsl, position, millis }) => {
      const angle = position.y * 0.02 * Math.sin(millis / 900)
      return glsl.rotateY(angle) * position - position
    },
    ({ glsl, position, millis }) => {
      const angle = position.y().mult(0.02).mult(millis.div(900).sin())
      return glsl.rotateY(angle).mult(position).sub(position)
    },
  ],
}

describe('with operators as with methods:', () => {
  for (const [name, [written, called]] of Object.entries(pairs))
    test(name, () => {
      const expected = compileWarp(called).code
      assert.equal(compileWarp(operators(written)).code, expected)
      // As a build has it.
      const module = translateModule(`createWarp(${written})`)
      const [, text] = /; createWarp\(warpjetWithOperators\((.*)\)\)$/s.exec(module)
      assert.equal(module.split('\n').length, `${written}`.split('\n').length, 'lines')
      const make = new Function(`return ${text}`)()
      assert.equal(compileWarp(withOperators(make)).code, expected)
    })
})

test('numbers among numbers stay numbers, and texts texts', () => {
  const seen = []
  globalThis.warpjetSeen = seen
  compileWarp(
    operators(({ position }) => {
      const n = 3
      warpjetSeen.push(n * 2, n > 2 ? 'many' : 'few', `${n}` + 'x', !n, -n, n % 2, n && 5, typeof n)
      let i = 0
      while (i < 2) i++
      warpjetSeen.push(i)
      return position * i
    }),
  )
  delete globalThis.warpjetSeen
  assert.deepEqual(seen, [6, 'many', '3x', false, -3, 1, 5, 'number', 2])
})

test('what is around a function comes by scope, or a sentence says so', () => {
  const amount = 3
  const offset = ({ position }) => position * amount
  const expected = compileWarp(({ position }) => position.mult(3)).code
  assert.equal(compileWarp(operators(offset, { amount })).code, expected)
  const other = ({ position }) => position * (amount + 0)
  assert.throws(
    () => compileWarp(operators(other)),
    (error) => {
      assert.ok(error.name === 'WarpError')
      assert.equal(
        error.message,
        `createWarp: operators are read from the function's text, which cannot see "amount" of the sketch around it; make it global, or add the option { scope: { amount } }.`,
      )
      return true
    },
  )
  // Without an operator on expressions nothing is amiss.
  assert.equal(compileWarp(operators(({ position }) => position.mult(amount))).code, expected)
})

test('what only JavaScript can decide says so', () => {
  for (const offset of [
    ({ position }) => {
      let i = 0
      while (position.x > i) i++
      return position * i
    },
    ({ position }) => {
      for (let i = 0; i < 3; i++) if (position.x > i) break
      return position
    },
  ])
    assert.throws(
      () => compileWarp(operators(offset)),
      /^WarpError: .* cannot wait for a condition/,
    )
  assert.throws(() => operators(3), /^WarpError: operators: a function was expected/)
  assert.ok(WarpError)
})

test('a module without warps is left alone, and closures stay in one with them', () => {
  assert.equal(translateModule('const a = b * c'), undefined)
  const code = translateModule(
    `const amount = 2\ncreateWarp(sketch, ({ position }) => position * amount, {})`,
  )
  assert.match(
    code,
    /^import \{ withOperators as \w+ \} from 'warpjet\/operators\/runtime'; const amount = 2\n/,
  )
  assert.match(code, /warpjetOperators\.mult\(position, amount\)/)
})
