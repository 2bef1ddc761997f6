// Tests that offset functions with operators generate the same code as with methods, byte for byte.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { translateModule } from '../../dist/operators-plugin.js'
import { withOperators } from '../../dist/operators-runtime.js'
import { operators } from '../../dist/operators.js'
import { WarpError, compileWarp } from '../../dist/warpjet.js'

/** Maps a name → the offset function with operators, and the same function with methods. */
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
  'an early return inside an if': [
    ({ position }) => {
      let s = 1
      if (position.x > 0) {
        s = 2
        if (position.y > 0) return position * s
      } else if (position.z > 0) s += 3
      s += 1
      return position / s
    },
    ({ glsl, position }) => {
      const [x, y] = [position.x(), position.y()]
      const [isRight, isUp] = [x.gt(0), y.gt(0)]
      const right = isUp.ifElse(position.mult(2), position.div(3))
      const s = position.z().gt(0).ifElse(4, 1)
      return isRight.ifElse(right, position.div(glsl.add(s, 1)))
    },
  ],
  'an assignment before an early return affects only that branch': [
    ({ position }) => {
      let s = 1
      if (position.x > 0) {
        s = 2
        return position * s
      }
      return position / s
    },
    ({ position }) => position.x().gt(0).ifElse(position.mult(2), position.div(1)),
  ],
  'early returns of a block that returns': [
    ({ position, millis }) => {
      const counter = { n: 1 }
      if (counter.n > 0) {
        counter.n = 2
        if (position.x > 0) return position * counter.n
        return position
      }
      return millis
    },
    ({ position }) => position.x().gt(0).ifElse(position.mult(2), position),
  ],
  'an early return from a loop': [
    ({ position }) => {
      let s = 0
      for (let i = 0; i < 4; i++) {
        if (i === 2) return position * s
        else s += 1
      }
      return position
    },
    ({ position }) => position.mult(2),
  ],
  'a variable that an inner block redeclares': [
    ({ position }) => {
      let s = 1
      if (position.x > 0) {
        let s = 5
        s += 1
      } else s = 2
      return position * s
    },
    ({ position }) => position.mult(position.x().gt(0).ifElse(1, 2)),
  ],
  'undefined and null values': [
    ({ position }) => {
      let nothing
      if (nothing == null && position != null && position !== undefined) return position * 2
      return position
    },
    ({ position }) => position.mult(2),
  ],
  'comma operators, logical assignments and indices with side effects': [
    ({ position }) => {
      const all = [1, 2, 3]
      let i = 0
      all[i++] += 5
      all[i++] *= 5
      let both = position.x > 0
      both &&= position.y > 0
      both ||= position.z > 0
      let a = 0,
        b = 0
      ;((a += 1), (b += (i, 2)))
      return both ? position * (0, all[0]) : position * all[i - 1] + Math.sin((b, a))
    },
    ({ glsl, position }) =>
      glsl
        .or(position.x().gt(0).and(position.y().gt(0)), position.z().gt(0))
        .ifElse(position.mult(6), position.mult(10).add(Math.sin(1))),
  ],
  'a number modulo an expression': [
    ({ position }) => position * (-5 % position.x) + (position.y % 2),
    ({ glsl, position }) => position.mult(glsl.mod(-5, position.x())).add(position.y().mod(2)),
  ],
  'a loop with a constant count': [
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
  'an inner function': [
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
  for (const [name, [offsetWithOperators, offsetWithMethods]] of Object.entries(pairs))
    test(name, () => {
      const expected = compileWarp(offsetWithMethods).code
      assert.equal(compileWarp(operators(offsetWithOperators)).code, expected)
      // Translated by the plugin.
      const module = translateModule(`createWarp(${offsetWithOperators})`)
      const [, text, last] = /^createWarp\(warpjetWithOperators\((.*)\)\)(\nimport .*\n)$/s.exec(
        module,
      )
      assert.equal(
        text.split('\n').length,
        `${offsetWithOperators}`.split('\n').length,
        'the number of lines differs',
      )
      assert.equal(last.split('\n').length, 3)
      const make = new Function(`return ${text}`)()
      assert.equal(compileWarp(withOperators(make)).code, expected)
    })
})

test('operators on numbers give numbers, and on strings they give strings', () => {
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

test('variables around a function are read from the argument `scope`; without it there is a message', () => {
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
        `createWarp: operators are translated in the function's source code, which cannot access "amount" of the enclosing scope; make it global, or add the option { scope: { amount } }.`,
      )
      return true
    },
  )
  // A function without operators on expressions throws no error.
  assert.equal(compileWarp(operators(({ position }) => position.mult(amount))).code, expected)
})

test('numbers decide conditions as in JavaScript', () => {
  const results = []
  globalThis.warpjetKept = results
  compileWarp(
    operators(({ position }) => {
      const early = (a, b) => {
        if (a) {
          if (b) return 'x'
        }
        return 'y'
      }
      const inLoop = (last) => {
        for (let i = 0; i < 5; i++) {
          if (i === last) return i
          else if (i > 3) break
        }
        return 'none'
      }
      const inTry = (a) => {
        try {
          if (a) return 1
        } finally {
          warpjetKept.push('finally')
        }
        return 2
      }
      const byVar = (a) => {
        if (a) {
          var n = 1
        } else var n = 2
        return n
      }
      const properties = (a) => {
        const v = { y: 0 }
        if (a) v.y = 1
        else v.y += 2
        a ? (v.z = 1) : (v.z = 2)
        return [v.y, v.z]
      }
      warpjetKept.push(early(1, 1), early(1, 0), early(0, 1), inLoop(2), inLoop(9))
      warpjetKept.push(inTry(true), inTry(false), byVar(true), byVar(false))
      warpjetKept.push(properties(true), properties(false), -1 % 3, '1' == 1, '1' === 1, 1 != '1')
      return position
    }),
  )
  delete globalThis.warpjetKept
  assert.deepEqual(results, [
    ...['x', 'y', 'y', 2, 'none', 'finally', 'finally', 1, 2, 1, 2],
    ...[[1, 1], [2, 2], -1, true, false, false],
  ])
})

test('each call has its own scope, and a name may become global later', () => {
  const amount = 3
  const offset = ({ position }) => position * amount
  const codeOfFactor = (n) => compileWarp(({ position }) => position.mult(n)).code
  assert.equal(compileWarp(operators(offset, { amount: 2 })).code, codeOfFactor(2))
  assert.equal(compileWarp(operators(offset, { amount: 4 })).code, codeOfFactor(4))
  assert.throws(() => compileWarp(operators(offset)), /cannot access "amount"/)
  globalThis.amount = 5
  const translated = operators(offset)
  assert.equal(compileWarp(translated).code, codeOfFactor(5))
  delete globalThis.amount
  assert.equal(operators(translated), translated)
})

test('conditions that only JavaScript can decide have a message', () => {
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
    ({ position }) => {
      for (let i = 0; i < 3; i++) if (position.x > i) return position * i
      return position
    },
    ({ position }) => {
      const v = { y: 0 }
      if (position.x > 0) v.y = 1
      else v.y = 2
      return position * v.y
    },
    ({ position }) => {
      const v = { y: 0 }
      if (position.x > 0) {
        v.y = 1
        return position * v.y
      }
      return position - v.y
    },
    ({ position }) => {
      var n = 0
      if (position.x > 0) {
        var n = 1
      }
      return position * n
    },
    ({ position }) => {
      let n = 0
      position.x > 0 ? (n = 1) : (n = 2)
      return position * n
    },
    ({ position }) => {
      let n = 0
      position.x > 0 && (n = 1)
      return position * n
    },
    ({ position }) => {
      switch (position.x) {
        case 0:
          return position
      }
      return position * 2
    },
  ])
    assert.throws(
      () => compileWarp(operators(offset)),
      /^WarpError: .* cannot depend on a condition/,
    )
  assert.throws(
    () => operators(3),
    /^WarpError: operators: expected a function, as in .*, got the number 3/,
  )
  assert.ok(WarpError)
})
