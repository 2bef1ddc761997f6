// Operators have JavaScript's meaning: compares each function with its version by methods, translated in a page and by the
// plugin.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { mask } from '../../dist/deformers.js'
import { operators } from '../../dist/operators.js'
import { translateModule } from '../../dist/operators-plugin.js'
import * as runtime from '../../dist/operators-runtime.js'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { warp } from '../../dist/three.js'
import { BoxGeometry, MathUtils, Mesh } from 'three'

/** p5's functions in global mode, which work only on numbers. */
const p5Functions = {
  sin: Math.sin,
  cos: Math.cos,
  max: Math.max,
  min: Math.min,
  abs: Math.abs,
  map: () => NaN,
  round: Math.round,
  noise: () => NaN,
  dist: () => NaN,
  createVector: (x = 0, y = 0, z = 0) => ({ x, y, z }),
  lerp: (a, b, t) => a + (b - a) * t,
}
// Bound functions have no source code, like p5's own.
for (const [name, known] of Object.entries(p5Functions)) globalThis[name] = known.bind(null)

/** Runs a module translated by the plugin. */
function built(code, names = {}) {
  const translated = translateModule(code) ?? code
  const [last, all, one] =
    /\nimport \{ (?:operators as (\w+), )?withOperators as (\w+) \} from .*\n$/.exec(translated)
  const imports = `const ${one} = runtime.withOperators${all ? `, ${all} = runtime.operators` : ''}; `
  const body = imports + translated.replace(last, '')
  assert.equal(translated.split('\n').length - 2, code.split('\n').length, 'lines')
  const out = []
  new Function('runtime', 'createWarp', 'out', ...Object.keys(names), body)(
    runtime,
    (offset) => compileWarp(offset).code,
    out,
    ...Object.values(names),
  )
  return out.length > 1 ? out : out[0]
}

const uniforms = { amount: 0.5 }

/** Compiles a function as translated in a page and by the plugin. */
function bothOf(written) {
  const offset = (0, eval)(`(${written})`)
  const options = written.includes('uniforms') ? { uniforms } : {}
  const inPage = compileWarp(operators(offset), options).code
  const [, text] = /^createWarp\(\w+\((.*)\)\)\nimport .*\n$/s.exec(
    translateModule(`createWarp(${written})`),
  ) ?? [, undefined]
  const byBuild = text
    ? compileWarp(runtime.withOperators(new Function(`return ${text}`)()), options).code
    : inPage
  return [inPage, byBuild]
}

const callOffset = (offset, options = {}) =>
  compileWarp(operators(offset), /uniforms/.test(offset) ? { uniforms, ...options } : options).code

const pairs = {
  'a shorthand parameter with a default': [
    '({ position }) => { const f = ({ x, amount = 2 }) => x * amount; const { y, size = 3 } = { y: 1 }; return f({ x: position }) * f({ x: 1, amount: size }) }',
    ({ position }) => position.mult(2).mult(3),
  ],
  'shorthand parameters with defaults that are computed': [
    '({ position }) => { const f = ({ a = 1 + 1, b: { c = a * 2 } = {} } = {}) => a + c; return position * f() }',
    ({ position }) => position.mult(6),
  ],
  'map that clamps': [
    '({ position }) => [map(position.x, -1, 1, 0, 3, true), map(position.y, 0, 2, 5, 1, true), map(position.z, 0, 1, 2, 4)]',
    ({ glsl, position: { x, y, z } }) =>
      glsl.vec3(
        x.sub(-1).div(2).mult(3).add(0).clamp(0, 3),
        y.sub(0).div(2).mult(-4).add(5).clamp(1, 5),
        z.sub(0).div(1).mult(2).add(2),
      ),
  ],
  'max and min of an array, and of one that is spread': [
    '({ position: { x, y, z } }) => [max([x, y, 0.5]), Math.min(...[x, z]), min([x, y, z])]',
    ({ glsl, position: { x, y, z } }) => glsl.vec3(x.max(y).max(0.5), x.min(z), x.min(y).min(z)),
  ],
  'or, and of numbers keep numbers': [
    '({ position: { x, y } }) => [x || 0.2, x && y, (x > 0) && y] * 1',
    ({ glsl, position: { x, y } }) =>
      glsl.vec3(x.ifElse(x, 0.2), x.ifElse(y, 0), x.gt(0).ifElse(y, 0)).mult(1),
  ],
  'assignments of logic': [
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
  'conditions among conditions, and true and false': [
    '({ position: { x, y } }) => { let on = false; if (x > 0 || y > 0) on = true; let off = on ? y < 3 : false; return on && !off ? [x, 0, 0] : [0, y, 0] }',
    ({ glsl, position: { x, y } }) => {
      const on = x.gt(0).or(y.gt(0))
      return on.and(on.and(y.lt(3)).not()).ifElse(glsl.vec3(x, 0, 0), glsl.vec3(0, y, 0))
    },
  ],
  'a vector is there, and so true': [
    '({ position, normal }) => (position && normal || 3) * (position ? 2 : 1)',
    ({ normal }) => normal.mult(2),
  ],
  'rounding goes up at halves': [
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
  'a vector that is taken apart': [
    '({ position }) => { let [x, y, z] = position; x *= 2; return [x, y, z] }',
    ({ glsl, position: { x, y, z } }) => glsl.vec3(x.mult(2), y, z),
  ],
  'a vector that is taken apart as a parameter, and spread': [
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
  'a vector of numbers, of which a part is set': [
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
  'counting up and down': [
    "({ position }) => { let x = position.x * 1; const o = { n: x }; x++; const before = o.n++; --o.n; let i = '5'; i++; let j = 2; const k = j-- + j; return [x, before + o.n, i + k] }",
    ({ glsl, position }) => {
      const x = position.x.mult(1)
      return glsl.vec3(x.add(1), x.add(x.add(1).add(-1)), 9)
    },
  ],
  'cutting off the fraction': [
    '({ position: { x, y, z } }) => [x | 0, ~~y, z >> 0]',
    ({ glsl, position: { x, y, z } }) => glsl.vec3(x.trunc(), y.trunc(), z.trunc()),
  ],
  'more of Math': [
    '({ position: { x, y } }) => [Math.log10(x), Math.expm1(y), Math.hypot(x, y, 1, 2, 3)]',
    ({ glsl, position: { x, y } }) =>
      glsl.vec3(
        x.log().div(Math.LN10),
        y.exp().sub(1),
        glsl.sqrt(x.mult(x).add(y.mult(y)).add(1).add(4).add(9)),
      ),
  ],
  'a parameter of a function within has the name of a function': [
    '({ position }) => { const f = (sin) => sin(position.y * 1); return [f((a) => a + 1), 0, 0] }',
    ({ glsl, position }) => glsl.vec3(position.y.mult(1).add(1), 0, 0),
  ],
  'functions that are taken from Math': [
    '({ position: { x } }) => { const { sin, floor: down } = Math; const s = Math.cos; return [sin(x), s(x * 2), sin(0)] }',
    ({ glsl, position: { x } }) => glsl.vec3(x.sin(), x.mult(2).cos(), 0),
  ],
  'the arguments of a function': [
    '(function () { const { position } = arguments[0]; return position * 2 })',
    ({ position }) => position.mult(2),
  ],
  'a name that only one block has': [
    '({ position }) => { { const sin = 2; position.x.mult(sin) } return [sin(position.y * 1), 0, 0] }',
    ({ glsl, position }) => glsl.vec3(position.y.mult(1).sin(), 0, 0),
  ],
  'variables that are called as our own are': [
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

describe('means the same for expressions as for numbers:', () => {
  for (const [name, [written, twin]] of Object.entries(pairs))
    test(name, () => {
      const expected = callOffset(twin)
      const [inPage, byBuild] = bothOf(written)
      assert.equal(inPage, expected)
      assert.equal(byBuild, expected)
    })
})

test('p5 uses degrees after angleMode(DEGREES)', () => {
  const inDegrees = (f) => ((x) => f((x * Math.PI) / 180)).bind(null)
  const degrees = (f) => ((...x) => (f(...x) * 180) / Math.PI).bind(null)
  const scope = {
    ...Object.fromEntries(['sin', 'cos', 'tan'].map((name) => [name, inDegrees(Math[name])])),
    ...Object.fromEntries(['asin', 'atan2'].map((name) => [name, degrees(Math[name])])),
  }
  const written = ({ position: { x, y, z } }) => [
    sin(x * 90),
    atan2(y, x) + tan(z),
    Math.sin(x) + asin(y),
  ]
  const expected = compileWarp(({ glsl, position: { x, y, z } }) =>
    glsl.vec3(
      x.mult(90).radians().sin(),
      y.atan(x).degrees().add(z.radians().tan()),
      x.sin().add(y.asin().degrees()),
    ),
  ).code
  assert.equal(compileWarp(operators(written, scope)).code, expected)
})

test("a sketch in instance mode calls p5's functions by its p", () => {
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
  assert.equal(built(code, { p }), expected)
})

test('static functions of p5.Vector', () => {
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

describe('functions, methods and classes:', () => {
  const expected = compileWarp(({ position }) => position.mult(2)).code

  test('methods of objects and classes, static methods, and fields', () => {
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

  test('this of a method is the object of the call', () => {
    const object = {
      factor: 2,
      wave({ position }) {
        return position * this.factor
      },
    }
    const read = operators(object.wave)
    assert.equal(compileWarp((inputs) => read.call(object, inputs)).code, expected)
    // Also a method that is called with expressions.
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

  test('a function with new.target', () => {
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

  test('invalid scopes, and invalid names of variables', () => {
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
    'a class that is made of expressions': [
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
  for (const [name, [written, twin]] of Object.entries(cases))
    test(name, () => {
      const expected = callOffset(twin)
      assert.equal(compileWarp(operators((0, eval)(`(${written})`))).code, expected)
      const module = `${script.replaceAll(/globalThis\.(\w+) = function/g, 'const $1 = function').replaceAll('globalThis.', 'const ')}\nout.push(createWarp(${written}))`
      assert.equal(built(module), expected)
    })

  test('a helper that reads a variable set by the offset function', () => {
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

  test('a helper of another library', () => {
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
        built('out.push(createWarp(({ position }) => [imported(position.x), 0, 0]))', {
          imported: (d) => d * 2,
        }),
      /^WarpError: createWarp: an operator .* that warpjet\/operators\/plugin has not translated.* move the function into that module/,
    )
  })

  test('a build translates offset functions that have names, and keeps closures', () => {
    const code = `const amount = 2
function height(x) {
  const scaled = (y) => y * amount
  return scaled(x) + 1
}
const offset = ({ position }) => [height(position.x), height(0), 0]
function makeWave(height) {
  return createWarp(({ position }) => position.mult(height) * 1)
}
out.push(createWarp(offset), makeWave(5), height(3))`
    const [byName, shadowed, number] = built(code)
    assert.equal(
      byName,
      compileWarp(({ glsl, position }) => glsl.vec3(position.x.mult(2).add(1), 1, 0)).code,
    )
    assert.equal(shadowed, compileWarp(({ position }) => position.mult(5).mult(1)).code)
    assert.equal(number, 7)
  })
})

test('compileWarp, compile and compositions translate operators by themselves', () => {
  assert.equal(
    compileWarp(({ position }) => position * 2).code,
    compileWarp(({ position }) => position.mult(2)).code,
  )
  assert.equal(
    compile((glsl) => ({ x: glsl.param('a') * 2, y: glsl.param('a') + 1 })).code,
    compile((glsl) => ({ x: glsl.param('a').mult(2), y: glsl.param('a').add(1) })).code,
  )
  assert.equal(
    compileWarp(
      mask(
        ({ position }) => position * 2,
        ({ position }) => (position.y > 0 ? 1 : 0),
      ),
    ).code,
    compileWarp(
      mask(
        ({ position }) => position.mult(2),
        ({ position }) => position.y.gt(0).ifElse(1, 0),
      ),
    ).code,
  )
  const boundsOf = (offset) => warp(new Mesh(new BoxGeometry()), offset).bounds()
  assert.deepEqual(
    boundsOf(({ position }) => [position.y * 2, 0, 0]),
    boundsOf(({ glsl, position }) => glsl.vec3(position.y.mult(2), 0, 0)),
  )
  const hidden = 3
  assert.throws(
    () => warp(new Mesh(new BoxGeometry()), ({ position }) => position * hidden),
    /^WarpError: warp: .* cannot access "hidden"/,
  )
  assert.throws(
    () => compileWarp(({ position }) => position * hidden),
    /^WarpError: compileWarp: .* cannot access "hidden" .* write operators\(offset, \{ hidden \}\) with operators of warpjet\/operators/,
  )
})

test('a variable that is read only once warns, with its name and the uniform to write', () => {
  const notes = []
  const { warn } = console
  console.warn = (note) => notes.push(note)
  try {
    globalThis.mouseX = 20
    globalThis.warpjetLevel = 0.5
    compileWarp(operators((0, eval)('({ position }) => position * (mouseX + warpjetLevel)')))
    built(
      `let level = 2\nfunction draw() { level = 3 }\nout.push(createWarp(({ position }) => position * (level + p.frameCount + keyCode)))`,
      { p: { frameCount: 1 }, keyCode: 1 },
    )
  } finally {
    console.warn = warn
  }
  for (const name of ['mouseX', 'warpjetLevel', 'level', 'p.frameCount', 'keyCode']) {
    const label = name.replace('p.', '')
    assert.equal(
      notes.filter(
        (note) =>
          note.includes(`reads ${name} once`) &&
          note.includes(
            `write uniforms.${label} in its place, with the option { uniforms: { ${label}: () => ${name} } }`,
          ),
      ).length,
      1,
      `${name} in ${notes.join('\n')}`,
    )
  }
})

test('silent or wrong code warns', () => {
  const notes = []
  const { warn } = console
  console.warn = (note) => notes.push(note)
  try {
    compileWarp(
      operators((0, eval)('({ position }) => { let v = position * 1; v.mult(2); return v }')),
    )
    compileWarp(operators((0, eval)('({ position: { x, y, z } }) => [noise(x * 2, y, z), 0, 0]')))
  } finally {
    console.warn = warn
  }
  assert.match(notes[0], /^v\.mult\(2\) has no effect: .* as in v = v\.mult\(2\)/)
  assert.match(
    notes[1],
    /^noise: p5's noise\(\) works on numbers; for expressions it becomes warpjet's glsl\.fbm/,
  )
  assert.throws(
    () => compileWarp(operators((0, eval)('({ position }) => position * (position.x & 3)'))),
    /^WarpError: & works on the bits of whole numbers/,
  )
})

test("noise is warpjet's, from 0 to 1", () => {
  const { warn } = console
  console.warn = () => {}
  try {
    assert.equal(
      compileWarp(
        operators(
          (0, eval)('({ position: { x, y, z } }) => [noise(x, y, z), noise(x), noise(x, y)]'),
        ),
      ).code,
      compileWarp(({ glsl, position: { x, y, z } }) => {
        const of = (p) => glsl.fbm(p, { octaves: 4 }).mult(0.5).add(0.5)
        return glsl.vec3(of(glsl.vec3(x, y, z)), of(x), of(glsl.vec2(x, y)))
      }).code,
    )
  } finally {
    console.warn = warn
  }
})

test('a method that is passed without its object has a message', () => {
  class Wave {
    amount = 2
    offset({ position }) {
      return [position.x * this.amount, 0, 0]
    }
  }
  assert.throws(() => compileWarp(new Wave().offset), {
    name: 'WarpError',
    message:
      /^compileWarp: the function reads this\.amount, but a method that is passed by itself has no "this"; write \(inputs\) => object\.method\(inputs\)/,
  })
})
