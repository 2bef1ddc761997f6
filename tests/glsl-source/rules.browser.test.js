// We accept and reject the same shaders as Chromium.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { glslOffset } from '../../dist/glsl.js'
import { declaring, reserved, rules, rulesOfFragments } from '../glsl/rules.js'
import { launchBrowser, openPage } from '../support/browser/browser.js'
import { servePages } from '../support/browser/server.js'

let browser, server, page
before(async () => {
  server = await servePages()
  browser = await launchBrowser()
  ;({ page } = await openPage(browser, server.page('<!doctype html><meta charset="utf-8">')))
})
after(async () => {
  await browser.close()
  await server.close()
})

/** Maps stage → the first line and the main of its shaders. */
const stages = {
  VERTEX_SHADER: ['', 'void main() { gl_Position = vec4(offset(vec3(0.5)), 1.0); }'],
  FRAGMENT_SHADER: ['precision highp float;\n', 'void main() { offset(vec3(0.5)); }'],
}

const heads = { 100: ['#version 100', 'webgl'], 300: ['#version 300 es', 'webgl2'] }

/** Cases where we differ on purpose. */
const known = [
  // GLSL 1.00 does not define numbers that do not fit in 32 bits.
  /a whole number: (?:0x100000000|4294967296|040000000000)$/,
  // We only support a uniform sampler2D by itself.
  /uniform sampler2D a\[2\]|uniform samplerCube a|sampler2D s; \}; uniform S a|^a samplerCube|^a sampler2D: uniform X a\[2\]/,
  // Chromium accepts in 1.00 what the specification allows only in 3.00.
  /float\[2\] x; \}|void f\(float\[2\]/,
  // In 3.00 a sequence is not a constant; Chromium accepts it here, and nowhere else.
  /above functions: float a = \(1\.0, 2\.0\);/,
  // WebGL has only std140, but the language has the other layouts too.
  /layout\((?:shared|packed)\) uniform B/,
  // Chromium looks for built-in names only among its own.
  /^field gl_Position$/,
  // A warp cannot use the variables of fragment shaders; source that uses none of them may be for either stage.
  /a fragment: (?:float x = gl_FragCoord\.x|bool b = gl_FrontFacing|vec2 x = gl_PointCoord|gl_Position|gl_PointSize|int i = gl_VertexID)/,
  /a fragment: gl_FragColor = gl_FragData/,
]

async function browserMessages(context, stage, texts) {
  return page.evaluate(
    ([context, stage, texts]) => {
      const gl = document.createElement('canvas').getContext(context)
      return texts.map((text) => {
        const shader = gl.createShader(gl[stage])
        gl.shaderSource(shader, text)
        gl.compileShader(shader)
        return gl.getShaderParameter(shader, gl.COMPILE_STATUS)
          ? ''
          : gl.getShaderInfoLog(shader) || 'rejected'
      })
    },
    [context, stage, texts],
  )
}

function ourMessage(text) {
  try {
    glslOffset(text, { function: 'offset', maxIterations: 8 })
    return ''
  } catch (error) {
    assert.equal(error.name, 'WarpError', error.stack)
    return error.message
  }
}

async function compare(version, stage, cases, least) {
  const [head, context] = heads[version]
  const [above, below] = stages[stage]
  const names = Object.keys(cases)
  const texts = names.map((name) => `${head}\n${above}${cases[name]}\n${below}\n`)
  const there = await browserMessages(context, stage, texts)
  const disagreeing = names.flatMap((name, i) => {
    const here = ourMessage(texts[i])
    if (!here === !there[i] || known.some((piece) => piece.test(name))) return []
    return [`${name}: here "${here}", there "${there[i]}"`]
  })
  assert.deepEqual(disagreeing, [])
  const rejected = there.filter(Boolean).length
  assert.ok(
    rejected >= least[0] && names.length - rejected >= least[1],
    `${rejected} of ${names.length}`,
  )
}

for (const version of [100, 300]) {
  test(`source of #version ${version} follows the same rules as in a browser`, () =>
    compare(version, 'VERTEX_SHADER', rules, [2300, 800]))

  test(`a fragment shader of #version ${version} follows the same rules, too`, () =>
    compare(version, 'FRAGMENT_SHADER', rulesOfFragments, [4, 5]))

  test(`source of #version ${version} may use the same names as in a browser`, () => {
    const cases = reserved.flatMap((word) =>
      Object.entries(declaring).map(([kind, make]) => [`${kind} ${word}`, make(word)]),
    )
    return compare(version, 'VERTEX_SHADER', Object.fromEntries(cases), [150, 200])
  })
}
