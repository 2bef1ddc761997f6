// Tests functions, methods, classes and helpers of a sketch with operators, translated in a page and by the plugin.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { MathUtils } from 'three'
import { operators } from '../../dist/operators.js'
import { compileWarp } from '../../dist/warpjet.js'
import { callOffset, runTranslated } from '../support/operator-tests.js'

describe('functions, methods and classes:', () => {
  const expected = compileWarp(({ position }) => position.mult(2)).code

  test('methods of objects and classes, static methods, and fields are translated', () => {
    class Waves {
      static wave({ position }) {
        return position * 2
      }
      plain({ position }) {
        return position * 2
      }
      static field = ({ position }) => position * 2;
      ['computed' + 1]({ position }) {
        return position * 2
      }
    }
    const object = {
      wave({ position }) {
        return position * 2
      },
      static({ position }) {
        return position * 2
      },
      get({ position }) {
        return position * 2
      },
    }
    const waves = new Waves()
    for (const offset of [
      Waves.wave,
      waves.plain,
      Waves.field,
      waves.computed1,
      object.wave,
      object.static,
      object.get,
    ])
      assert.equal(compileWarp(operators(offset)).code, expected)
  })

  test('this in a method is the object on which it is called', () => {
    const object = {
      factor: 2,
      wave({ position }) {
        return position * this.factor
      },
    }
    const translated = operators(object.wave)
    assert.equal(compileWarp((inputs) => translated.call(object, inputs)).code, expected)
    // The method is also translated when it is called as a helper, with expressions.
    const offset = ({ position }) => [waves.wave({ position: position * 1 })][0]
    assert.equal(
      compileWarp(operators(offset, { waves: object })).code,
      compileWarp(({ position }) => position.mult(1).mult(2)).code,
    )
  })

  test('messages name the members that the source code cannot access', () => {
    class Base {
      offset({ position }) {
        return position * 2
      }
    }
    class Wave extends Base {
      #factor = 2
      factor = 2
      amount = 3
      bySuper(inputs) {
        return super.offset(inputs) * 1
      }
      byPrivate({ position }) {
        return position * this.#factor
      }
      byThis() {
        return ({ position }) => position * this.factor + this.amount
      }
    }
    const wave = new Wave()
    for (const [offset, message] of [
      [wave.bySuper, /cannot access "super" .*; write a plain function/],
      [wave.byPrivate, /cannot access "#factor" .*; write a plain function/],
      [
        wave.byThis(),
        /cannot access "this" of the enclosing object; write factor, amount in place of this.factor, this.amount, and add the option \{ scope: \{ factor: this.factor, amount: this.amount \} \}/,
      ],
      [
        new (function () {
          this.f = ({ position }) => position * (new.target ? 2 : 1)
        })().f,
        /cannot access "new.target"/,
      ],
    ])
      assert.throws(
        () =>
          compileWarp(
            operators((inputs) => offset.call(wave, inputs), { offset: operators(offset), wave }),
          ),
        message,
      )
  })

  test('a function can read its own new.target', () => {
    const offset = function ({ position }) {
      return position * (new.target ? 1 : 2)
    }
    assert.equal(compileWarp(operators(offset)).code, expected)
  })

  test('without operators the original function is called', () => {
    let count = 0
    const factor = 2
    const offset = ({ position }) => {
      count++
      let sum
      for (let i = 0; i < 2; i++) sum = sum ? sum.add(position.mult(i * factor)) : position.mult(i)
      return sum
    }
    assert.equal(compileWarp(offset).code, expected)
    assert.equal(count, 1)
    const plain = ({ position }) => position.mult(2 * (factor - 1))
    assert.equal(operators(plain), plain)
  })

  test('invalid scopes and invalid variable names are rejected', () => {
    const offset = ({ position }) => position * 2
    assert.throws(
      () => operators(offset, null),
      /^WarpError: operators: expected an object .*, got null/,
    )
    assert.throws(
      () => operators(offset, []),
      /^WarpError: operators: expected an object .*, got an array/,
    )
    for (const name of ['my-name', '2', 'class', 'a b', ''])
      assert.throws(
        () => operators(offset, { [name]: 1 }),
        new RegExp(
          `^WarpError: operators: expected names of variables in the scope, .* got "${name}"`,
        ),
      )
    assert.equal(compileWarp(operators(offset, { größe: 1, $: 2 })).code, expected)
  })
})

describe('helper functions:', () => {
  globalThis.warpjetFrequency = 4
  const script = `
    globalThis.ripple = function (d) { return sin(d * warpjetFrequency) * 0.2 }
    globalThis.twice = function (d) { return ripple(d) * 2 }
    globalThis.Wave = class {
      constructor(amount) { this.amount = amount * 2 }
      at(d) { return this.shaped(d) * this.amount }
      shaped(d) { return d > 0 ? d : -d }
    }
    globalThis.wave = new Wave(3)
    globalThis.sum = function (list) { return list.reduce((a, b) => a + b, 0) }
    globalThis.factorial = function factorial(x, n) { return n > 1 ? factorial(x, n - 1) * x : x }`
  ;(0, eval)(script)
  const cases = {
    'a function, and one that it calls': [
      '({ position }) => [ripple(position.x), twice(position.y), ripple(0)]',
      ({ glsl, position: { x, y } }) =>
        glsl.vec3(x.mult(4).sin().mult(0.2), y.mult(4).sin().mult(0.2).mult(2), 0),
    ],
    'a method, and one that it calls': [
      '({ position }) => [wave.at(position.x), wave.amount, 0]',
      ({ glsl, position: { x } }) => glsl.vec3(x.gt(0).ifElse(x, x.neg()).mult(6), 6, 0),
    ],
    'a class constructed from expressions': [
      '({ position }) => { const w = new Wave(position.y); return [w.at(1), w.at(position.x), w instanceof Wave ? 1 : 0] }',
      ({ glsl, position: { x, y } }) => {
        const amount = y.mult(2)
        return glsl.vec3(glsl.mult(1, amount), x.gt(0).ifElse(x, x.neg()).mult(amount), 1)
      },
    ],
    'lists and recursion': [
      '({ position: { x, y } }) => [sum([x, y, 1]), factorial(x, 3), sum([1, 2])]',
      ({ glsl, position: { x, y } }) =>
        glsl.vec3(glsl.add(0, x).add(y).add(1), x.mult(x).mult(x), 3),
    ],
  }
  for (const [name, [withOperators, withMethods]] of Object.entries(cases))
    test(name, () => {
      const expected = callOffset(withMethods)
      assert.equal(compileWarp(operators((0, eval)(`(${withOperators})`))).code, expected)
      const module = `${script.replaceAll(/globalThis\.(\w+) = function/g, 'const $1 = function').replaceAll('globalThis.', 'const ')}\nout.push(createWarp(${withOperators}))`
      assert.equal(runTranslated(module), expected)
    })

  test('a helper can read a variable that the offset function sets', () => {
    ;(0, eval)(`globalThis.warpjetPoint = undefined
    globalThis.lift = function () { return warpjetPoint.x * 2 }`)
    assert.equal(
      compileWarp(
        operators(
          (0, eval)('({ position }) => { warpjetPoint = position; return [lift(), 0, 0] }'),
        ),
      ).code,
      compileWarp(({ glsl, position }) => glsl.vec3(position.x.mult(2), 0, 0)).code,
    )
  })

  test('a class that is constructed without expressions is not replaced, also if its argument is an object with a method', () => {
    ;(0, eval)('globalThis.Sized = class { constructor({ size }) { this.half = size / 2 } }')
    const offset = (0, eval)(`({ position }) => {
      const sized = new Sized({ size: 4, grow() {} })
      return position * (sized.constructor === Sized ? sized.half : 0)
    }`)
    assert.equal(
      compileWarp(operators(offset)).code,
      compileWarp(({ position }) => position.mult(2)).code,
    )
  })

  test('a helper of another library works with expressions, if it is in the scope', () => {
    assert.equal(
      compileWarp(operators(({ position }) => MathUtils.lerp(position, 2, 0.25) * 1, { MathUtils }))
        .code,
      compileWarp(({ glsl, position }) =>
        glsl
          .mult(1 - 0.25, position)
          .add(0.25 * 2)
          .mult(1),
      ).code,
    )
  })

  test('a helper whose variables are inaccessible has one message that names them', () => {
    const hidden = 3
    globalThis.hiddenRipple = (d) => d * hidden
    const offset = ({ position }) => [hiddenRipple(position.x), 0, 0]
    assert.throws(
      () => compileWarp(operators(offset)),
      /^WarpError: createWarp: operators are translated in the source code of the function hiddenRipple, which it calls, which cannot access "hidden" .* scope: \{ hidden \}/,
    )
    assert.equal(
      compileWarp(operators(offset, { hidden })).code,
      compileWarp(({ glsl, position }) => glsl.vec3(position.x.mult(3), 0, 0)).code,
    )
  })

  test('a build reports that it does not translate functions of other modules', () => {
    assert.throws(
      () =>
        runTranslated('out.push(createWarp(({ position }) => [imported(position.x), 0, 0]))', {
          imported: (d) => d * 2,
        }),
      /^WarpError: createWarp: an operator .* that warpjet\/operators\/plugin has not translated.* move the function into that module/,
    )
  })

  test('a build translates offset functions that have names, and keeps closures', () => {
    const code = `const amount = 2
function height(x) {
  const scale = (y) => y * amount
  return scale(x) + 1
}
const offset = ({ position }) => [height(position.x), height(0), 0]
function makeWave(height) {
  return createWarp(({ position }) => position.mult(height) * 1)
}
out.push(createWarp(offset), makeWave(5), height(3))`
    const [byName, shadowed, number] = runTranslated(code)
    assert.equal(
      byName,
      compileWarp(({ glsl, position }) => glsl.vec3(position.x.mult(2).add(1), 1, 0)).code,
    )
    assert.equal(shadowed, compileWarp(({ position }) => position.mult(5).mult(1)).code)
    assert.equal(number, 7)
  })
})
