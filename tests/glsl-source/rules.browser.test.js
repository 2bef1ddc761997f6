// Tests that warpjet accepts and rejects the same shaders as Chromium.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { glslOffset } from '../../dist/glsl.js'
import { declarers, reserved, rules, rulesOfFragments } from '../glsl/rules.js'
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

/** Maps a stage → the first line and the main function of its shaders. */
const stages = {
  VERTEX_SHADER: ['', 'void main() { gl_Position = vec4(offset(vec3(0.5)), 1.0); }'],
  FRAGMENT_SHADER: ['precision highp float;\n', 'void main() { offset(vec3(0.5)); }'],
}

const versionHeads = { 100: ['#version 100', 'webgl'], 300: ['#version 300 es', 'webgl2'] }

/** Cases where we differ on purpose. */
const knownDifferences = [
  // GLSL 1.00 does not define numbers that do not fit in 32 bits.
  /an integer literal: (?:0x100000000|4294967296|040000000000)$/,
  // We support no samplers but a uniform sampler2D that is not part of an array or structure.
  /uniform sampler2D a\[2\]|uniform samplerCube a|sampler2D s; \}; uniform S a|^a samplerCube|^a sampler2D: uniform X a\[2\]/,
  // Chromium accepts in 1.00 what the specification allows only in 3.00.
  /float\[2\] x; \}|void f\(float\[2\]/,
  // In 3.00 a sequence expression is not a constant; Chromium accepts it only as the value of a global.
  /a global declaration: float a = \(1\.0, 2\.0\);/,
  // WebGL has only std140, but the language has the other layouts too.
  /layout\((?:shared|packed)\) uniform B/,
  // Chromium does not reject gl_Position as the name of a field.
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

async function compare(version, stage, cases, minimums) {
  const [head, context] = versionHeads[version]
  const [above, below] = stages[stage]
  const names = Object.keys(cases)
  const texts = names.map((name) => `${head}\n${above}${cases[name]}\n${below}\n`)
  const theirMessages = await browserMessages(context, stage, texts)
  const disagreeing = names.flatMap((name, i) => {
    const ours = ourMessage(texts[i])
    if (!ours === !theirMessages[i] || knownDifferences.some((pattern) => pattern.test(name)))
      return []
    return [`${name}: ours "${ours}", the browser's "${theirMessages[i]}"`]
  })
  assert.deepEqual(disagreeing, [])
  const rejected = theirMessages.filter(Boolean).length
  assert.ok(
    rejected >= minimums[0] && names.length - rejected >= minimums[1],
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
      Object.entries(declarers).map(([kind, make]) => [`${kind} ${word}`, make(word)]),
    )
    return compare(version, 'VERTEX_SHADER', Object.fromEntries(cases), [150, 200])
  })
}
