// Compares random long loops in GLSL, which are not unrolled, with an interpreter in double precision: values directly, and derivatives
// with finite differences.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { glslOffset } from '../../dist/glsl.js'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { randomLongLoops } from '../glsl/long-loops.js'
import { walk } from '../glsl/walk.js'

const count = isRun('every random expression') ? 500 : 60

const points = Array.from({ length: 6 }, (_, i) =>
  [0.7548776662, 0.569840291, 0.3819660113].map((step) => 2 * ((0.5 + (i + 1) * step) % 1) - 1),
)

/** Returns the slope along an axis from central differences; `undefined` at a kink or a jump, where differences of two widths disagree. */
function slopeOf(f, p, k) {
  const at = (h) => f(p.map((x, i) => (i === k ? x + h : x)))
  const central = (h) => (at(h) - at(-h)) / (2 * h)
  const [wide, narrow] = [central(2e-5), central(1e-5)]
  const isSmooth = Math.abs(narrow - wide) <= 1e-5 * Math.max(1, Math.abs(narrow))
  return isSmooth ? narrow : undefined
}

test('the interpreter returns the values computed by hand', () => {
  const run = (body, x = 2) => walk(`float f(float x) { ${body} }`, 'f')([x])[0]
  assert.equal(run('int i = 7; return float(i / 2 * 2 + i % 2 - -i);'), 14)
  assert.equal(run('vec3 v = vec3(1.0, 2.0, 3.0); v.zx = v.xy * 2.0; return dot(v, vec3(1.0));'), 8)
  assert.equal(
    run(
      'float s = 0.0; for (int i = 0; i < 9; i++) { if (i == 2) continue; if (i > 4) break; s += float(i); } return s;',
    ),
    8,
  )
  assert.equal(run('int n = 3; float s = 0.0; while (n-- > 0) s += float(n); return s;'), 3)
  assert.equal(
    run('int n = 0; do { n++; } while (n < 0); return float(n) + (x > 1.0 ? 0.5 : 0.0);'),
    1.5,
  )
  assert.equal(
    run(
      'for (int i = 0; i < 9; i++) for (int j = 0; j < 9; j++) if (i * j == 6) return float(i); return 0.0;',
    ),
    1,
  )
  assert.equal(run('float x = 3.0; { float x = 4.0; } return mix(x, 5.0, 0.5);'), 4)
})

test(`${count} random long loops have correct values and gradients`, () => {
  const problems = []
  const compared = { slopes: 0, loops: 0 }
  for (let seed = 1; seed <= count && problems.length < 3; seed++) {
    const text = randomLongLoops(seed)
    try {
      const numbers = walk(text, 'f')
      const f = (p) => numbers(p)[0]
      const compiled = compile((glsl) => {
        const p = glsl.vec3Param('p')
        const value = glsl.source(text, { function: 'f' })(p)
        return { value, gradient: glsl.gradient(value, p) }
      })
      if (/\bfor \(/.test(compiled.code)) compared.loops++
      for (const p of points) {
        const { value, gradient } = compiled.evaluate({ p })
        const steepest = Math.max(1, ...gradient.map(Math.abs))
        if (Math.abs(value - f(p)) > 1e-6 * steepest)
          problems.push(`${seed} at ${p}: ${value}, not ${f(p)}\n${text}`)
        gradient.forEach((actual, k) => {
          const slope = slopeOf(f, p, k)
          if (slope === undefined) return
          compared.slopes++
          if (Math.abs(actual - slope) > 1e-4 * steepest)
            problems.push(`${seed}, by ${k} at ${p}: ${actual}, not ${slope}\n${text}`)
        })
      }
    } catch (error) {
      problems.push(`${seed}: ${error.message}\n${text}`)
    }
  }
  assert.equal(problems.length, 0, problems.join('\n\n').slice(0, 6000))
  assert.ok(compared.slopes > count * 9, `${compared.slopes} slopes were compared`)
  assert.ok(compared.loops > count * 0.6, `${compared.loops} sources kept a loop`)
})

test('a loop ends in the shader once its condition fails, whatever maxIterations is', () => {
  const codeOf = (loop, language) => {
    const text = `uniform float n;
      float f(vec3 p) { float s = 0.0; ${loop} return s; }`
    return compile(
      (glsl) => ({
        gradient: glsl.gradient(
          glsl.source(text, { function: 'f', maxIterations: 64 })(glsl.vec3Param('p')),
          glsl.vec3Param('p'),
        ),
      }),
      { target: language },
    ).code
  }
  const countBreaks = (code) => code.match(/if \(\w+ > 0\.5\) \{ break; \}/g)?.length ?? 0
  for (const language of ['glsl300', 'glsl100', 'wgsl']) {
    for (const loop of [
      'for (float i = 0.0; i < n; i++) s += sin(p.x * i);',
      'float i = 0.0; while (i < n) { i += 1.0; if (p.y > i) continue; s += sin(p.x * i); }',
      'for (float i = 0.0; i < n; i++) { s += sin(p.x * i); if (s > 9.0) break; }',
    ])
      assert.equal(countBreaks(codeOf(loop, language)), 1, loop)
    const nested = `for (float i = 0.0; i < n; i++)
      for (float j = 0.0; j < n; j++) s += sin(p.x * i + j);`
    assert.equal(countBreaks(codeOf(nested, language)), 2)
    const fixed = 'for (int i = 0; i < 60; i++) { if (s < 9.0) s += sin(p.x * float(i)); }'
    assert.equal(countBreaks(codeOf(fixed, language)), 0)
  }
})

test('nested loops whose maxIterations multiply are rejected when the source is read', () => {
  const source = `uniform float n;
    vec3 offset(vec3 p) {
      float s = 0.0;
      for (float i = 0.0; i < n; i++)
        for (float j = 0.0; j < n; j++) s += sin(p.x * i + j);
      return vec3(s, 0.0, 0.0);
    }`
  assert.ok(compileWarp(glslOffset(source, { maxIterations: 100 })).code.length < 2000)
  for (const maxIterations of [101, 512, 1024, 4096])
    assert.throws(() => glslOffset(source, { maxIterations }), {
      name: 'WarpError',
      message: `glslOffset: line 5, column 9: nested loops whose ends only the shader knows multiply the option maxIterations: expected at most 10000 iterations in all, got ${maxIterations} * ${maxIterations} = ${maxIterations ** 2}; set it to at most 100, or less if they are nested deeper.\n  ${source.split('\n')[4]}\n          ^`,
    })
})
