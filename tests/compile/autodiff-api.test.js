// Checks `gen` against the API in glsl-autodiff's README: inputs, outputs and settings. glsl/run.js evaluates the generated statements.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { describe, test } from 'node:test'
import { gen } from '../../dist/autodiff.js'
import { runGlsl } from '../glsl/run.js'

test('the interpreter in glsl/run.js rejects invalid GLSL', () => {
  const code = 'float y; bool b = x > 1.0; { y = b ? -x : p.yx.x * 2.0; } // done'
  assert.deepEqual(runGlsl(code, { x: 3, p: [5, 7] }), { x: 3, p: [5, 7], b: true, y: -3 })
  for (const [text, message] of [
    ['float y = 1;', /y: expected float, got int/],
    ['y = 1.0;', /y is not declared/],
    ['float y = t;', /t is not declared/],
    ['float t; float y = t;', /t is not set/],
    ['float x = 1.0;', /x is declared twice/],
    ['float y = p;', /y: expected float, got vec2/],
    ['vec3 y = p + vec3(1.0);', /different sizes/],
    ['float y = x ? 1.0 : 2.0;', /expected bool before \?, got float/],
    ['float y = p.z;', /a vec2 has no \.z/],
    ['float y = sine(x);', /there is no function sine/],
    ['float y = 1.0', /Expected .*";"/],
  ])
    assert.throws(() => runGlsl(text, { x: 3, p: [5, 7] }), message)
})

describe('inputs and outputs:', () => {
  test('gen returns code, and needs no settings', () => {
    assert.equal(typeof gen((ad) => ad.param('x').output('y')), 'string')
    assert.equal(
      gen((ad) => ad.param('x').output('y'), {}),
      gen((ad) => ad.param('x').output('y')),
    )
  })

  test('each param method reads a shader variable of its size', () => {
    const code = gen((ad) => {
      ad.param('speed').mult(2).output('a')
      ad.vec2Param('uv').mult(ad.vec2(2, 3)).output('b')
      ad.vec3Param('position')
        .mult(ad.vec3(2, 3, 4))
        .output('c')
      ad.vec4Param('color')
        .mult(ad.vec4(2, 3, 4, 5))
        .output('d')
    })
    const inputs = { speed: 1, uv: [1, 1], position: [1, 1, 1], color: [1, 1, 1, 1] }
    const { a, b, c, d } = runGlsl(code, inputs)
    assert.deepEqual({ a, b, c, d }, { a: 2, b: [2, 3], c: [2, 3, 4], d: [2, 3, 4, 5] })
  })

  test('a parameter can be any expression of the shader', () => {
    const code = gen((ad) => {
      const place = ad.vec2Param('position.zx')
      place.x().mult(ad.param('position.y')).output('product')
      place.x().mult(place.y()).outputDeriv('slope', place.y())
    })
    const { product, slope } = runGlsl(code, { position: [2, 3, 5] })
    assert.deepEqual([product, slope], [15, 5])
  })

  test('a vector can be differentiated with respect to a number, and a number with respect to a component', () => {
    const code = gen((ad) => {
      const [p, time] = [ad.vec3Param('p'), ad.param('time')]
      p.scale(time).outputDeriv('velocity', time)
      ad.vec3(p.x(), p.x().mult(p.z()), 1).outputDeriv('column', p.x())
      p.dot(p).outputDeriv('byY', p.y())
    })
    const { velocity, column, byY } = runGlsl(code, { p: [2, 3, 5], time: 7 })
    assert.deepEqual([velocity, column, byY], [[2, 3, 5], [1, 5, 0], 6])
  })

  test('JavaScript’s loops and functions are unrolled and inlined', () => {
    const code = gen((ad) => {
      const double = (node) => node.mult(2)
      let x = ad.param('x')
      for (let i = 0; i < 5; i++) x = double(x)
      x.output('y')
      x.outputDeriv('slope', ad.param('x'))
    })
    const { y, slope } = runGlsl(code, { x: 3 })
    assert.deepEqual([y, slope], [96, 32])
  })
})

describe('settings:', () => {
  const offset = (ad) => {
    const [x, y, time] = ['x', 'y', 'time'].map((name) => ad.param(name))
    let height = ad.val(0)
    for (let i = 0; i < 3; i++) {
      const angle = ad.sum(height.mult(0.5), x.mult(1.5), y.mult(2.8), time.mult(0.002))
      height = height.add(ad.sin(angle))
    }
    return { x, y, height: height.mult(0.1) }
  }
  const withSlopes = (ad) => {
    const { x, y, height } = offset(ad)
    height.output('z')
    height.outputDeriv('byX', x)
    height.outputDeriv('byY', y)
  }
  const chain = (ad) => {
    let x = ad.param('x')
    for (let i = 0; i < 30; i++) x = x.sin()
    x.output('y')
  }

  /** Returns the assignments. Those to temporaries start with a type; results are declared before the code. */
  const linesOf = (text) =>
    [...text.matchAll(/^ *(float)? ?(\w+) = (.*);$/gm)].map(([, type, name, value]) => {
      return { isTemporary: type !== undefined, name, value }
    })
  const count = (text, pattern) => text.match(pattern)?.length ?? 0

  test('no setting changes a result', () => {
    const inputs = { x: 0.7, y: -0.4, time: 1234 }
    const { z, byX, byY } = runGlsl(gen(withSlopes), inputs)
    for (const maxDepthPerVariable of [1, 2, 4, 50, Infinity])
      for (const debug of [true, false]) {
        const results = runGlsl(gen(withSlopes, { maxDepthPerVariable, debug }), inputs)
        assert.deepEqual([results.z, results.byX, results.byY], [z, byX, byY])
      }
  })

  test('maxDepthPerVariable 1 writes one operation per line', () => {
    const operation = / [-+*/] |\b\w+\(/g
    for (const { name, value } of linesOf(gen(withSlopes, { maxDepthPerVariable: 1 })))
      assert.equal(count(value, operation), 1, `${name} = ${value}`)
  })

  test('maxDepthPerVariable is the maximum number of nested operations, by default 8', () => {
    for (const depth of [1, 2, 5, 8, 13]) {
      const lines = linesOf(gen(chain, { maxDepthPerVariable: depth }))
      assert.equal(lines.length, Math.ceil(30 / depth))
      for (const { value } of lines) assert.ok(count(value, /sin\(/g) <= depth, value)
    }
    assert.equal(gen(chain), gen(chain, { maxDepthPerVariable: 8 }))
  })

  test('maxDepthPerVariable Infinity condenses to as few lines as sharing allows', () => {
    assert.equal(linesOf(gen(chain, { maxDepthPerVariable: Infinity })).length, 1)
    const text = gen(withSlopes, { maxDepthPerVariable: Infinity })
    for (const { name } of linesOf(text).filter(({ isTemporary }) => isTemporary))
      assert.ok(count(text, new RegExp(`\\b${name}\\b`, 'g')) > 2, `${name} is read only once`)
  })

  test('debug writes the line of the user’s code above each statement', () => {
    const outputHeight = (ad) => offset(ad).height.output('z')
    const text = gen(outputHeight, { debug: true, maxDepthPerVariable: 4 })
    const source = readFileSync(new URL(import.meta.url), 'utf8').split('\n')
    const location = /\/\/ From .*autodiff-api\.test\.js:(\d+):(\d+)/
    const commented = [...text.matchAll(/((?: *\/\/ .*\n)+)(.*)/g)]
    assert.equal(commented.length, linesOf(text).length)
    for (const [, comments, statement] of commented) {
      assert.match(statement, / = /)
      for (const comment of comments.trimEnd().split('\n')) {
        const [, line, column] = location.exec(comment)
        assert.match(source[line - 1].slice(column - 1), /^(mult|add|sum|sin)\(/)
      }
    }
    assert.equal(text.replace(/ *\/\/.*\n/g, ''), gen(outputHeight, { maxDepthPerVariable: 4 }))
  })
})
