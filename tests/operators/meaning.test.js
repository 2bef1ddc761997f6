// Tests that operators have JavaScript's meaning: compares each function, translated in a page and by the plugin, with its version with
// methods.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { operators } from '../../dist/operators.js'
import { compileWarp } from '../../dist/warpjet.js'
import { callOffset, compileBoth, runTranslated } from '../support/operator-tests.js'

const pairs = {
  'a shorthand parameter with a default': [
    '({ position }) => { const f = ({ x, amount = 2 }) => x * amount; const { y, size = 3 } = { y: 1 }; return f({ x: position }) * f({ x: 1, amount: size }) }',
    ({ position }) => position.mult(2).mult(3),
  ],
  'shorthand parameters with computed defaults': [
    '({ position }) => { const f = ({ a = 1 + 1, b: { c = a * 2 } = {} } = {}) => a + c; return position * f() }',
    ({ position }) => position.mult(6),
  ],
  'map() with clamping': [
    '({ position }) => [map(position.x, -1, 1, 0, 3, true), map(position.y, 0, 2, 5, 1, true), map(position.z, 0, 1, 2, 4)]',
    ({ glsl, position: { x, y, z } }) =>
      glsl.vec3(
        x.sub(-1).div(2).mult(3).add(0).clamp(0, 3),
        y.sub(0).div(2).mult(-4).add(5).clamp(1, 5),
        z.sub(0).div(1).mult(2).add(2),
      ),
  ],
  'max and min of an array, and of a spread array': [
    '({ position: { x, y, z } }) => [max([x, y, 0.5]), Math.min(...[x, z]), min([x, y, z])]',
    ({ glsl, position: { x, y, z } }) => glsl.vec3(x.max(y).max(0.5), x.min(z), x.min(y).min(z)),
  ],
  '|| and && of numbers return numbers': [
    '({ position: { x, y } }) => [x || 0.2, x && y, (x > 0) && y] * 1',
    ({ glsl, position: { x, y } }) =>
      glsl.vec3(x.ifElse(x, 0.2), x.ifElse(y, 0), x.gt(0).ifElse(y, 0)).mult(1),
  ],
  'logical assignments': [
    '({ position: { x, y } }) => { let a = x * 1; a ||= 3; let b = y * 1; b &&= a; let c = 0; c ||= 0.25; return [a, b, c] }',
    ({ glsl, position: { x, y } }) => {
      const [a, b] = [x.ifElse(x, 3), y]
      return glsl.vec3(a, b.ifElse(a, 0), 0.25)
    },
  ],
  'a uniform or its replacement': [
    '({ position, uniforms }) => position * (uniforms.amount || 0.2)',
    ({ position, uniforms: { amount } }) => position.mult(amount.ifElse(amount, 0.2)),
  ],
  'nested conditions, and true and false': [
    '({ position: { x, y } }) => { let on = false; if (x > 0 || y > 0) on = true; let off = on ? y < 3 : false; return on && !off ? [x, 0, 0] : [0, y, 0] }',
    ({ glsl, position: { x, y } }) => {
      const on = x.gt(0).or(y.gt(0))
      return on.and(on.and(y.lt(3)).not()).ifElse(glsl.vec3(x, 0, 0), glsl.vec3(0, y, 0))
    },
  ],
  'a vector is truthy': [
    '({ position, normal }) => (position && normal || 3) * (position ? 2 : 1)',
    ({ normal }) => normal.mult(2),
  ],
  'halves are rounded up': [
    '({ position: { x, y } }) => [round(x), Math.round(y * 2), round(2.5)]',
    ({ glsl, position: { x, y } }) => {
      const round = (a) => a.floor().add(glsl.step(0.5, a.sub(a.floor())))
      return glsl.vec3(round(x), round(y.mult(2)), 3)
    },
  ],
  'rounding to decimals': [
    '({ position: { x } }) => [round(x, 2), 0, 0]',
    ({ glsl, position: { x } }) => {
      const a = x.mult(100)
      return glsl.vec3(
        a
          .floor()
          .add(glsl.step(0.5, a.sub(a.floor())))
          .div(100),
        0,
        0,
      )
    },
  ],
  'a destructured vector': [
    '({ position }) => { let [x, y, z] = position; x *= 2; return [x, y, z] }',
    ({ glsl, position: { x, y, z } }) => glsl.vec3(x.mult(2), y, z),
  ],
  'a vector destructured in a parameter, and a spread vector': [
    '({ position: [x, ...others], uv }) => [x * 1, ...others.slice(1), [...uv].length]',
    ({ glsl, position: { x, z } }) => glsl.vec3(x.mult(1), z, 2),
  ],
  'dist of numbers and of vectors, and createVector': [
    '({ position: { x, y, z }, position, normal }) => [dist(x, y, 0, 1), dist(x, y, z, 1, 2, 3), dist(position, normal)] + createVector(x, 1) + createVector(1, 2, 3)',
    ({ glsl, position: { x, y, z }, position, normal }) =>
      glsl
        .vec3(
          glsl.dist(glsl.vec2(x, y), glsl.vec2(0, 1)),
          glsl.dist(glsl.vec3(x, y, z), glsl.vec3(1, 2, 3)),
          position.dist(normal),
        )
        .add(glsl.vec3(x, 1, 0))
        .add(glsl.vec3(1, 2, 3)),
  ],
  'a vector of numbers with a component that is assigned': [
    '({ position }) => { const v = createVector(1, 2, 3); v.y = sin(position.x); return v }',
    ({ glsl, position }) => glsl.vec3(1, position.x.sin(), 3),
  ],
  'the names of p5.strands': [
    '({ position, normal }) => { const p = position * 1; return normalize(p) * smoothstep(0, 1, p.x) + mix(p, cross(p, normal), step(0.5, p.y)) * clamp(length(p), 0, 1) * dot(p, normal) + vec3(mix(0, 10, 0.5), step(1, 2), clamp(7, 0, 3)) }',
    ({ glsl, position, normal }) => {
      const p = position.mult(1)
      return p
        .normalize()
        .mult(glsl.smoothstep(0, 1, p.x))
        .add(
          glsl
            .mix(p, glsl.cross(p, normal), glsl.step(0.5, p.y))
            .mult(p.length().clamp(0, 1))
            .mult(glsl.dot(p, normal)),
        )
        .add(glsl.vec3(5, 1, 3))
    },
  ],
  '++ and --': [
    "({ position }) => { let x = position.x * 1; const o = { n: x }; x++; const before = o.n++; --o.n; let i = '5'; i++; let j = 2; const k = j-- + j; return [x, before + o.n, i + k] }",
    ({ glsl, position }) => {
      const x = position.x.mult(1)
      return glsl.vec3(x.add(1), x.add(x.add(1).add(-1)), 9)
    },
  ],
  'truncation to an integer': [
    '({ position: { x, y, z } }) => [x | 0, ~~y, z >> 0]',
    ({ glsl, position: { x, y, z } }) => glsl.vec3(x.trunc(), y.trunc(), z.trunc()),
  ],
  'further functions of Math': [
    '({ position: { x, y } }) => [Math.log10(x), Math.expm1(y), Math.hypot(x, y, 1, 2, 3)]',
    ({ glsl, position: { x, y } }) =>
      glsl.vec3(
        x.log().div(Math.LN10),
        y.exp().sub(1),
        glsl.sqrt(x.mult(x).add(y.mult(y)).add(1).add(4).add(9)),
      ),
  ],
  'a parameter of an inner function that shadows a function': [
    '({ position }) => { const f = (sin) => sin(position.y * 1); return [f((a) => a + 1), 0, 0] }',
    ({ glsl, position }) => glsl.vec3(position.y.mult(1).add(1), 0, 0),
  ],
  'functions destructured from Math': [
    '({ position: { x } }) => { const { sin, floor: down } = Math; const s = Math.cos; return [sin(x), s(x * 2), sin(0)] }',
    ({ glsl, position: { x } }) => glsl.vec3(x.sin(), x.mult(2).cos(), 0),
  ],
  'the arguments of a function': [
    '(function () { const { position } = arguments[0]; return position * 2 })',
    ({ position }) => position.mult(2),
  ],
  'a variable declared in only one block': [
    '({ position }) => { { const sin = 2; position.x.mult(sin) } return [sin(position.y * 1), 0, 0] }',
    ({ glsl, position }) => glsl.vec3(position.y.mult(1).sin(), 0, 0),
  ],
  'variables with the names of our generated variables': [
    '({ position }) => { const warpjetOperators = 2, warpjetRest1 = 3, warpjetValue = 4, warpjetWithOperators = 5; let s = 1; if (position.x > 0) { s += 1; return position * s } s *= warpjetValue; const o = { s }; o.s += 1; return position * (warpjetOperators + warpjetRest1 + o.s + warpjetWithOperators) }',
    ({ position }) => position.x.gt(0).ifElse(position.mult(2), position.mult(15)),
  ],
  'labels, optional chains and generators': [
    `({ position }) => {
      let n = 0
      outer: for (let i = 0; i < 3; i++) {
        for (let j = 0; j < 3; j++) if (j === 2) continue outer; else if (i === 2) { for (;;) break outer } else n++
      }
      const list = function* (k) { if (k > 1) yield k * 2; yield k ? k : 5 }
      const nothing = undefined
      return position * (n + [...list(2)].length + (nothing?.f.g() ?? 1) + (({ f: (a) => a * 2 }).f?.(3)))
    }`,
    ({ position }) => position.mult(4 + 2 + 1 + 6),
  ],
}

describe('JavaScript has the same meaning for expressions as for numbers:', () => {
  for (const [name, [withOperators, withMethods]] of Object.entries(pairs))
    test(name, () => {
      const expected = callOffset(withMethods)
      const [inPage, byBuild] = compileBoth(withOperators)
      assert.equal(inPage, expected)
      assert.equal(byBuild, expected)
    })
})

test('functions of p5 use degrees after angleMode(DEGREES)', () => {
  const inDegrees = (f) => ((x) => f((x * Math.PI) / 180)).bind(null)
  const degrees = (f) => ((...x) => (f(...x) * 180) / Math.PI).bind(null)
  const scope = {
    ...Object.fromEntries(['sin', 'cos', 'tan'].map((name) => [name, inDegrees(Math[name])])),
    ...Object.fromEntries(
      ['asin', 'acos', 'atan', 'atan2'].map((name) => [name, degrees(Math[name])]),
    ),
  }
  const offset = ({ position: { x, y, z } }) => [
    sin(x * 90) + cos(y),
    atan2(y, x) + tan(z) + acos(x),
    Math.sin(x) + asin(y) + atan(z),
  ]
  const expected = compileWarp(({ glsl, position: { x, y, z } }) =>
    glsl.vec3(
      x.mult(90).radians().sin().add(y.radians().cos()),
      y.atan(x).degrees().add(z.radians().tan()).add(x.acos().degrees()),
      x.sin().add(y.asin().degrees()).add(z.atan().degrees()),
    ),
  ).code
  assert.equal(compileWarp(operators(offset, scope)).code, expected)
})

test("a sketch in instance mode can call p5's functions as methods of its p", () => {
  class P5 {
    createCanvas() {}
    angleMode() {}
    noise() {}
    sin(x) {
      return Math.sin(x)
    }
    map() {
      return NaN
    }
    lerpColor() {}
  }
  const p = new P5()
  const code = `const f = ({ position }) => [p.sin(position.y * 4), p.map(position.x, 0, 1, 0, 2), p.sin(0)]\nout.push(createWarp(f))`
  const expected = compileWarp(({ glsl, position: { x, y } }) =>
    glsl.vec3(y.mult(4).sin(), x.sub(0).div(1).mult(2).add(0), 0),
  ).code
  const offset = ({ position }) => [p.sin(position.y * 4), p.map(position.x, 0, 1, 0, 2), p.sin(0)]
  assert.equal(compileWarp(operators(offset, { p })).code, expected)
  assert.equal(runTranslated(code, { p }), expected)
})

test('static functions of p5.Vector work with expressions', () => {
  class Vector {
    static random3D() {}
    static fromAngle() {}
    static add() {
      return NaN
    }
    static angleBetween() {}
  }
  const p5 = { Vector }
  const offset = ({ position, normal }) => p5.Vector.add(position, normal) * 2
  assert.equal(
    compileWarp(operators(offset, { p5 })).code,
    compileWarp(({ position, normal }) => position.add(normal).mult(2)).code,
  )
  const other = ({ position, normal }) => p5.Vector.angleBetween(position, normal) * position
  assert.throws(
    () => compileWarp(operators(other, { p5 })),
    /^WarpError: p5.Vector.angleBetween works on numbers, not on expressions/,
  )
})

test('a missing input has a message, also in a destructuring default', () => {
  assert.throws(
    () => compileWarp(operators(({ position, amount = 2 }) => position * amount)),
    /^WarpError: An offset function gets no "amount"/,
  )
})
