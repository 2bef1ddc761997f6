// Tests when operators are translated automatically, and the warnings and errors if they are not.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { BoxGeometry, Mesh } from 'three'
import { mask } from '../../dist/deformers.js'
import { operators } from '../../dist/operators.js'
import { warp } from '../../dist/three.js'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { runTranslated, uniforms } from '../support/operator-tests.js'

test('compileWarp, compile and compositions translate operators automatically', () => {
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

test('a variable whose value is read only once causes a warning with its name and a suggested uniform', () => {
  const warnings = []
  const { warn } = console
  console.warn = (message) => warnings.push(message)
  try {
    globalThis.mouseX = 20
    globalThis.warpjetLevel = 0.5
    globalThis.warpjetCenter = [1, 2, 3]
    compileWarp(operators((0, eval)('({ position }) => position * (mouseX + warpjetLevel)')))
    compileWarp(operators((0, eval)('({ position }) => position - warpjetCenter')))
    runTranslated(
      `let level = 2\nfunction draw() { level = 3 }\nout.push(createWarp(({ position }) => position * (level + p.frameCount + keyCode)))`,
      { p: { frameCount: 1 }, keyCode: 1 },
    )
  } finally {
    console.warn = warn
  }
  for (const name of [
    'mouseX',
    'warpjetLevel',
    'warpjetCenter',
    'level',
    'p.frameCount',
    'keyCode',
  ]) {
    const label = name.replace('p.', '')
    assert.equal(
      warnings.filter(
        (note) =>
          note.includes(`reads ${name} once`) &&
          note.includes(
            `write uniforms.${label} in its place, with the option { uniforms: { ${label}: () => ${name} } }`,
          ),
      ).length,
      1,
      `${name} in ${warnings.join('\n')}`,
    )
  }
})

test('code that is ignored or has a different meaning causes a warning', () => {
  const warnings = []
  const { warn } = console
  console.warn = (message) => warnings.push(message)
  try {
    compileWarp(
      operators((0, eval)('({ position }) => { let v = position * 1; v.mult(2); return v }')),
    )
    compileWarp(operators((0, eval)('({ position: { x, y, z } }) => [noise(x * 2, y, z), 0, 0]')))
  } finally {
    console.warn = warn
  }
  assert.match(warnings[0], /^v\.mult\(2\) has no effect: .* as in v = v\.mult\(2\)/)
  assert.match(
    warnings[1],
    /^noise: p5's noise\(\) works on numbers; for expressions it becomes warpjet's glsl\.fbm/,
  )
  assert.throws(
    () => compileWarp(operators((0, eval)('({ position }) => position * (position.x & 3)'))),
    /^WarpError: & works on the bits of whole numbers/,
  )
})

test("noise() is warpjet's fbm, scaled to 0 to 1", () => {
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
        const scaledFbm = (p) => glsl.fbm(p, { octaves: 4 }).mult(0.5).add(0.5)
        return glsl.vec3(scaledFbm(glsl.vec3(x, y, z)), scaledFbm(x), scaledFbm(glsl.vec2(x, y)))
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
