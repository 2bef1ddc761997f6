// Tests that functions whose values depend on a rule of the language have the same values as in Chromium.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { glslOffset } from '../../dist/glsl.js'
import { compileWarp } from '../../dist/warpjet.js'
import { blocks, values } from '../glsl/values.js'
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

const points = [
  [0.3, 0.7, -0.2],
  [-0.6, 0.1, 0.9],
  [0.9, -0.8, 0.4],
  [-0.2, -0.4, 0.5],
]

/** Maps a version → function that makes a vertex shader from the source of `own`. */
const shaderOf = {
  100: (text) =>
    `#version 100\n${text}\nattribute vec3 at; varying vec3 value;\nvoid main() { value = own(at); gl_Position = vec4(0.0); }\n`,
  300: (text) =>
    `#version 300 es\n${text}\nin vec3 at; out vec3 value;\nvoid main() { value = own(at); gl_Position = vec4(0.0); }\n`,
}

/**
 * Returns the values of each shader at the points; WebGL 2 compiles shaders of both languages. `block` is bound to every shader
 * that has one.
 */
const browserValues = (shaders, block) =>
  page.evaluate(
    ([shaders, points, block]) => {
      const gl = document.createElement('canvas').getContext('webgl2')
      const compile = (type, text) => {
        const shader = gl.createShader(type)
        gl.shaderSource(shader, text)
        gl.compileShader(shader)
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
          throw new Error(`${gl.getShaderInfoLog(shader)}\n${text}`)
        return shader
      }
      return shaders.map((text) => {
        const program = gl.createProgram()
        const is300 = text.startsWith('#version 300')
        gl.attachShader(program, compile(gl.VERTEX_SHADER, text))
        gl.attachShader(
          program,
          compile(
            gl.FRAGMENT_SHADER,
            is300
              ? '#version 300 es\nprecision highp float; out vec4 color;\nvoid main() { color = vec4(1.0); }'
              : 'void main() { gl_FragColor = vec4(1.0); }',
          ),
        )
        gl.transformFeedbackVaryings(program, ['value'], gl.INTERLEAVED_ATTRIBS)
        gl.bindAttribLocation(program, 0, 'at')
        gl.linkProgram(program)
        if (!gl.getProgramParameter(program, gl.LINK_STATUS))
          throw new Error(`${gl.getProgramInfoLog(program)}\n${text}`)
        gl.useProgram(program)
        if (block) {
          gl.bindBuffer(gl.UNIFORM_BUFFER, gl.createBuffer())
          gl.bufferData(gl.UNIFORM_BUFFER, new Float32Array(block), gl.STATIC_DRAW)
          const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORM_BLOCKS)
          for (let i = 0; i < count; i++) gl.uniformBlockBinding(program, i, i)
          const buffer = gl.getParameter(gl.UNIFORM_BUFFER_BINDING)
          for (let i = 0; i < count; i++) gl.bindBufferBase(gl.UNIFORM_BUFFER, i, buffer)
        }
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer())
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(points.flat()), gl.STATIC_DRAW)
        gl.enableVertexAttribArray(0)
        gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0)
        const size = points.length * 12
        gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, gl.createBuffer())
        gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, size, gl.STATIC_READ)
        gl.enable(gl.RASTERIZER_DISCARD)
        gl.beginTransformFeedback(gl.POINTS)
        gl.drawArrays(gl.POINTS, 0, points.length)
        gl.endTransformFeedback()
        const actual = new Float32Array(points.length * 3)
        gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, actual)
        return [...actual]
      })
    },
    [shaders, points, block],
  )

function ourValues(text) {
  const warp = compileWarp(glslOffset(text, { function: 'own' }), { normals: false })
  const { positions } = warp.evaluate({ positions: Float32Array.from(points.flat()) })
  return points.flat().map((x, i) => positions[i] - x)
}

/** Compares with a tolerance: Chromium's sine is off by up to 1e-4, and a loop adds these errors up. */
const isNear = (ours, theirs) =>
  ours.every((x, i) => Math.abs(x - theirs[i]) <= 1e-3 * Math.max(1, Math.abs(theirs[i])))

for (const version of [100, 300])
  test(`source of #version ${version} has the same values as in a browser`, async () => {
    const names = Object.keys(values[version])
    const shaders = names.map((name) => shaderOf[version](values[version][name]))
    const theirs = await browserValues(shaders)
    const wrong = names.flatMap((name, i) => {
      const ours = ourValues(shaders[i])
      return isNear(ours, theirs[i]) ? [] : [`${name}: ${ours}, not ${theirs[i]}`]
    })
    assert.deepEqual(wrong, [])
  })

test('blocks of uniforms have the declared layout', async () => {
  const numbers = Array.from({ length: 64 }, (_, i) => 0.25 + ((i * 7) % 5) * 0.5)
  const originals = [],
    ours = []
  for (const [declaration, text] of Object.values(blocks)) {
    originals.push(shaderOf[300](`${declaration}\n${text}`))
    const { code } = compileWarp(glslOffset(`#version 300 es\n${declaration}\n${text}`), {
      normals: false,
      names: { position: 'at' },
      outputs: { offset: 'value', position: 'moved' },
    })
    ours.push(
      `#version 300 es\n${declaration}\nin vec3 at; out vec3 value;\nvoid main() {\n${code.replace(/\bvec3 value, /, 'vec3 ')}\ngl_Position = vec4(0.0); }`,
    )
  }
  const [expected, actual] = [
    await browserValues(originals, numbers),
    await browserValues(ours, numbers),
  ]
  Object.keys(blocks).forEach((name, i) =>
    assert.ok(
      isNear(actual[i], expected[i]),
      `${name}: ${actual[i]}, not ${expected[i]}\n${ours[i]}`,
    ),
  )
})
