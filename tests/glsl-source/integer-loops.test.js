// Loops whose ints and uints do more than count stay loops in the shader. Their values and derivatives are compared with plain loops in
// JavaScript and with finite differences.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { glslOffset, wgslOffset } from '../../dist/glsl.js'
import { compile } from '../../dist/warpjet.js'

const add = (a, b) => (a + b) >>> 0
const multiply = (a, b) => Math.imul(a, b) >>> 0

/** Loops in GLSL, WGSL and JavaScript. Each adds terms to a sum s, which depends on p and on a uniform n. */
const loops = {
  'a u32 counter that a break ends': {
    glsl: 'for (uint i = 0u; i < 400u; i++) { if (s > 30.0 * p.y) break; s += sin(p.x * float(i)) + 0.75; }',
    wgsl: 'for (var i = 0u; i < 400u; i++) { if (s > 30.0 * p.y) { break; } s += sin(p.x * f32(i)) + 0.75; }',
    run(p) {
      let s = 0
      for (let i = 0; i < 400 && s <= 30 * p[1]; i++) s += Math.sin(p[0] * i) + 0.75
      return s
    },
  },
  'a u32 that counts down to a break': {
    glsl: 'for (uint i = 90u; i < 100u; i -= 3u) { if (s > 30.0 * p.y) break; s += sin(p.x * float(i)) + 0.75; }',
    wgsl: 'for (var i = 90u; i < 100u; i -= 3u) { if (s > 30.0 * p.y) { break; } s += sin(p.x * f32(i)) + 0.75; }',
    run(p) {
      let s = 0
      for (let i = 90; i >= 0 && s <= 30 * p[1]; i -= 3) s += Math.sin(p[0] * i) + 0.75
      return s
    },
  },
  'a u32 that a while counts to a uniform': {
    glsl: 'uint i = 3u; while (float(i) < n) { if (s > 30.0 * p.y) break; s += sin(p.x * float(i)) + 0.75; i += 2u; } s += float(i);',
    wgsl: 'var i = 3u; while (f32(i) < n) { if (s > 30.0 * p.y) { break; } s += sin(p.x * f32(i)) + 0.75; i += 2u; } s += f32(i);',
    run(p, n) {
      let [s, i] = [0, 3]
      for (; i < n && s <= 30 * p[1]; i += 2) s += Math.sin(p[0] * i) + 0.75
      return s + i
    },
  },
  'a hash of 32 bits': {
    glsl: 'uint h = 7u; for (uint i = 0u; i < 400u; i++) { if (s > 30.0 * p.y) break; h = h * 1664525u + 1013904223u; s += sin(p.x * float(h >> 8u) / 4194304.0) + 0.75; }',
    wgsl: 'var h = 7u; for (var i = 0u; i < 400u; i++) { if (s > 30.0 * p.y) { break; } h = h * 1664525u + 1013904223u; s += sin(p.x * f32(h >> 8u) / 4194304.0) + 0.75; }',
    run(p) {
      let [s, h] = [0, 7]
      for (let i = 0; i < 400 && s <= 30 * p[1]; i++) {
        h = add(multiply(h, 1664525), 1013904223)
        s += Math.sin((p[0] * (h >>> 8)) / 4194304) + 0.75
      }
      return s
    },
  },
  'ints that wrap around, of either sign': {
    glsl: 'int a = -70001, b = 65537; for (float i = 0.0; i < n; i++) { a = a * 5 - b; b = b + a * 3; s += sin(p.x * float(a / 65536) / 8192.0) + float(b % 7); }',
    wgsl: 'var a = -70001; var b = 65537; for (var i = 0.0; i < n; i += 1.0) { a = a * 5 - b; b = b + a * 3; s += sin(p.x * f32(a / 65536) / 8192.0) + f32(b % 7); }',
    run(p, n) {
      let [s, a, b] = [0, -70001, 65537]
      for (let i = 0; i < n; i++) {
        a = (Math.imul(a, 5) - b) | 0
        b = (b + Math.imul(a, 3)) | 0
        s += Math.sin((p[0] * Math.trunc(a / 65536)) / 8192) + (b % 7)
      }
      return s
    },
  },
}

const points = [
  [0.3, 0.9, 0.2],
  [-0.7, 0.25, 0.4],
  [1.3, 2.1, -0.6],
]
const n = 37

for (const [name, { run, ...sources }] of Object.entries(loops))
  test(`${name} stays a loop, with the right value and derivative`, () => {
    for (const [language, loop] of Object.entries(sources)) {
      const isWgsl = language === 'wgsl'
      const source = isWgsl
        ? `var<uniform> n : f32;\nfn offset(p : vec3<f32>) -> vec3<f32> { var s = 0.0; ${loop} return vec3<f32>(s, 0.0, 0.0); }`
        : `uniform float n;\nvec3 offset(vec3 p) { float s = 0.0; ${loop} return vec3(s, 0.0, 0.0); }`
      const read = (isWgsl ? wgslOffset : glslOffset)(source, { maxIterations: 64 })
      const compiled = compile(
        (glsl) => {
          const position = glsl.vec3Param('p')
          const uniforms = { n: glsl.param('n') }
          const value = read({ glsl, position, uniforms }).x()
          return { value, gradient: glsl.gradient(value, position) }
        },
        { target: isWgsl ? 'wgsl' : 'glsl300' },
      )
      assert.match(compiled.code, /\bfor \(/)
      assert.ok(compiled.code.length < 2500, `${compiled.code.length} characters`)
      for (const p of points) {
        const { value, gradient } = compiled.evaluate({ p, n })
        const expected = run(p, n)
        assert.ok(
          Math.abs(value - expected) < 1e-9 * Math.max(1, Math.abs(expected)),
          `${language} at ${p}: ${value}, not ${expected}`,
        )
        const h = 1e-6
        const slope = (run([p[0] + h, p[1], p[2]], n) - run([p[0] - h, p[1], p[2]], n)) / (2 * h)
        assert.ok(
          Math.abs(gradient[0] - slope) < 1e-5 * Math.max(1, Math.abs(slope)),
          `${language} by x at ${p}: ${gradient[0]}, not ${slope}`,
        )
        assert.equal(gradient[1], 0)
      }
    }
  })

test('an int that does more than count stays a loop in GLSL 1.00, too', () => {
  const offset = glslOffset(
    'vec3 offset(vec3 p) { int a = 1; for (int i = 0; i < 90; i++) { a = a * 3; if (a > 1000) a = a - 999; p.x += sin(p.x + float(a)); } return p; }',
  )
  const { code } = compile(
    (glsl) => ({ moved: offset({ glsl, position: glsl.vec3Param('p'), uniforms: {} }) }),
    { target: 'glsl100' },
  )
  assert.match(code, /\bfor \(/)
  assert.ok(code.length < 1500, `${code.length} characters`)
})
