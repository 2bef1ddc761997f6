// Differences of the fragment code from the vertex code. At the border of a mesh, the operand of an operation such as sqrt may leave its
// domain in a pixel: the fragment code reflects it at the border of the domain. Also, it fades noise. Checks the code;
// tests/p5/pixel-light.browser.test.js checks pictures.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'

const alongZ = (height) => (inputs) => inputs.glsl.vec3(0, 0, height(inputs))

const withBorders = {
  sqrt: alongZ(({ position }) => position.x().sqrt()),
  // The normal reads only the derivative, 1 / x.
  log: alongZ(({ position }) => position.x().mult(2).log()),
  log2: alongZ(({ position }) => position.x().log2()),
  pow: alongZ(({ position }) => position.x().pow(0.3)),
  asin: alongZ(({ position }) => position.x().asin()),
  acos: alongZ(({ position }) => position.x().acos()),
  atanh: alongZ(({ position }) => position.x().atanh()),
  acosh: alongZ(({ position }) => position.x().acosh()),
  noise: alongZ(({ glsl, position }) => glsl.simplex(position).sqrt()),
}

const withoutBorders = {
  waves: alongZ(({ position }) => position.x().sin()),
  length: alongZ(({ position }) => position.length()),
  normalize: ({ position }) => position.normalize(),
  clamped: alongZ(({ glsl, position }) => glsl.max(position.x(), 0).sqrt()),
  'whole power': alongZ(({ position }) => position.x().pow(3)),
}

/** Returns whether the code reflects operands at the border of a domain. */
const isReflected = ({ code }) => /\bwarpjetAcross\(/.test(code)

for (const target of ['glsl300', 'wgsl'])
  test(`${target}: the fragment code reflects operands of each operation whose domain has a border, the vertex code does not`, () => {
    for (const [name, offset] of Object.entries(withBorders)) {
      const warp = compileWarp(offset, { target, normals: 'pixel', fadeNoise: false })
      assert.ok(isReflected(warp.emitFragment()), name)
      assert.ok(!isReflected(compileWarp(offset, { target })), name)
    }
    for (const [name, offset] of Object.entries(withoutBorders)) {
      const warp = compileWarp(offset, { target, normals: 'pixel', fadeNoise: false })
      assert.ok(!isReflected(warp.emitFragment()), name)
    }
  })

test('glsl100 code does not reflect operands: it has no screen-space derivatives', () => {
  for (const offset of Object.values(withBorders))
    assert.ok(
      !isReflected(compileWarp(offset, { target: 'glsl100', normals: 'pixel' }).emitFragment()),
    )
})

test('operands in loops are not reflected', () => {
  for (const step of [(x) => x.sqrt().add(0.1), (x) => x.mult(x).sub(0.2).sqrt()]) {
    const offset = alongZ(({ glsl, position }) => glsl.repeat(3, position.x(), step))
    const { code } = compileWarp(offset, { target: 'glsl300', normals: 'pixel' }).emitFragment()
    assert.match(code, /\bfor\b/)
    assert.ok(!/for[^]*warpjetAcross/.test(code), code)
  }
})

test('debug names the same lines of the user’s code in fragment code with fading noise and reflected operands as in vertex code', () => {
  const offset = ({ glsl, position }) => {
    const height = position.x().sin()
    const noise = glsl.fbm(position.mult(3))
    const rough = noise.mult(height)
    const root = rough.sqrt()
    return glsl.vec3(0, 0, root.mult(noise.cos()))
  }
  const linesOf = ({ code }) => new Set(code.match(/\/\/ From .*:\d+:\d+/g))
  const [vertex, fragment] = [true, false].map((isVertex) => {
    const options = { debug: true, normals: isVertex ? 'vertex' : 'pixel' }
    const warp = compileWarp(offset, options)
    return isVertex ? warp : warp.emitFragment()
  })
  assert.match(fragment.code, /Fading\w*\(/)
  assert.match(fragment.code, /\bwarpjetAcross\(/)
  assert.ok(linesOf(fragment).size >= 5, fragment.code)
  const vertexLines = linesOf(vertex)
  for (const line of linesOf(fragment)) assert.ok(vertexLines.has(line), line)
})
