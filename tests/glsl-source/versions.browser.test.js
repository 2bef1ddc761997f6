// Compares the features of each #version with a browser: WebGL 1 accepts GLSL ES 1.00, WebGL 2 accepts 3.00 too.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { glslOffset } from '../../dist/glsl.js'
import { sourceWithName, versions, words } from '../glsl/versions.js'
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

/**
 * Compares our messages about shaders with the browser's. Returns descriptions of the shaders that only we or only the browser rejects,
 * and how many the browser rejects.
 */
async function disagreements(head, context, texts) {
  const names = Object.keys(texts)
  const shaders = names.map(
    (name) =>
      `${head}\n${texts[name]}\nvoid main() { gl_Position = vec4(offset(vec3(0.5)), 1.0); }\n`,
  )
  const theirs = await browserMessages(context, shaders)
  const disagreeing = names.flatMap((name, i) => {
    const ours = ourMessage(shaders[i])
    return !ours === !theirs[i] ? [] : [`${name}: ours "${ours}", the browser's "${theirs[i]}"`]
  })
  return { disagreeing, rejected: theirs.filter(Boolean).length }
}

const heads = { 100: ['#version 100', 'webgl'], 300: ['#version 300 es', 'webgl2'] }

/** Returns the browser's message about each vertex shader; empty if it accepts. */
const browserMessages = (context, texts) =>
  page.evaluate(
    ([context, texts]) => {
      const gl = document.createElement('canvas').getContext(context)
      return texts.map((text) => {
        const shader = gl.createShader(gl.VERTEX_SHADER)
        gl.shaderSource(shader, text)
        gl.compileShader(shader)
        return gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? '' : gl.getShaderInfoLog(shader)
      })
    },
    [context, texts],
  )

function ourMessage(text) {
  try {
    glslOffset(text, { maxIterations: 8 })
    return ''
  } catch (error) {
    assert.equal(error.name, 'WarpError', error.stack)
    return error.message
  }
}

for (const [version, [head, context]] of Object.entries(heads)) {
  test(`source of ${head} has the same features as in a browser`, async () => {
    const { disagreeing, rejected } = await disagreements(head, context, versions)
    assert.deepEqual(disagreeing, [])
    assert.ok(rejected > (version === '100' ? 40 : 5), `${rejected} were rejected`)
  })

  test(`source of ${head} may use the same names of variables as in a browser`, async () => {
    const texts = Object.fromEntries(words.map((word) => [word, sourceWithName(word)]))
    const { disagreeing, rejected } = await disagreements(head, context, texts)
    assert.deepEqual(disagreeing, [])
    assert.ok(rejected > 60 && rejected < words.length - 3, `${rejected} were rejected`)
  })
}
