// Normals at pixels in p5's materials, spaces and shaders: the light of a coarse shape against that of a dense one.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { litPixels, readPixels } from '../support/browser/pixels.js'
import {
  drawScenes,
  openHosts,
  p5HostsInThisRun,
  p5InThisRun,
  p5Versions,
  runSketch,
} from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const { browsers, server } = await openHosts(p5HostsInThisRun)

/** Bumps that are small beside the triangles of p5's sphere, and in the space of the offset of about the same size. */
const bumps = (length, height) => `({ glsl, position, normal }) => {
  const bump = glsl.simplex(position.div(${length}))
  return ${length === 1 / 3 ? 'position' : 'glsl.vec3(0, 0, 1)'}.mult(bump.mult(${height})) }`

const spaces = {
  local: bumps(1 / 3, 0.05),
  world: bumps(25, 4),
  camera: bumps(25, 4),
}

const light = `directionalLight(255, 255, 255, 0.5, 0.6, -1); ambientLight(40); fill(220, 160, 90)`

/** Scenes with a coarse sphere by vertex and by pixel, and with a dense one. */
const scenesOf = (name, more = '') =>
  Object.fromEntries(
    [
      ['vertex', 24, 16],
      ['pixel', 24, 16],
      ['dense', 240, 160],
    ].map(([kind, columns, rows]) => [
      `${name} ${kind}`,
      `noStroke(); ${light}; ${more}; warps['${name} ${kind}'](); rotateX(0.5); sphere(75, ${columns}, ${rows})`,
    ]),
  )

const warpsOf = (name, offset, options) =>
  Object.entries({ vertex: 'vertex', pixel: 'pixel', dense: 'vertex' })
    .map(
      ([kind, normals]) =>
        `warps['${name} ${kind}'] = createWarp(${offset}, { ...${options}, normals: '${normals}' })`,
    )
    .join('\n')

/** Returns the mean difference from the dense picture, of pixels within 55 of the center: the outline stays coarse. */
function meanDifference(image, dense) {
  const inside = litPixels(dense).filter(({ x, y }) => Math.hypot(x, y) < 55)
  assert.ok(inside.length > 5000, `${inside.length} pixels`)
  const sum = inside.reduce((total, { x, y, color }) => {
    const at = 4 * ((y - 0.5 + dense.height / 2) * dense.width + (x - 0.5 + dense.width / 2))
    return total + [0, 1, 2].reduce((all, k) => all + Math.abs(image.data[at + k] - color[k]), 0)
  }, 0)
  return sum / (3 * inside.length)
}

for (const [version, renderer, scripts] of p5HostsInThisRun)
  describe(`p5 ${version} by ${renderer}: the light of 24 by 16 pieces is that of 240 by 160`, () => {
    for (const [space, offset] of Object.entries(spaces))
      for (const [material, more] of Object.entries({ specular: '', normal: '' }))
        test(`in ${space} space, as ${material}`, async () => {
          const name = `${space} ${material}`
          const images = await drawScenes(browsers[renderer], server, [...scripts, addon], {
            setup: warpsOf(name, offset, `{ space: '${space}', type: '${material}' }`),
            scenes: scenesOf(name, more),
            renderer,
          })
          const [vertex, pixel] = ['vertex', 'pixel'].map((kind) =>
            meanDifference(images[`${name} ${kind}`], images[`${name} dense`]),
          )
          assert.ok(pixel < 0.35 * vertex, `${pixel} by pixel, ${vertex} by vertex`)
        })

    test('a surface that a warp presses flat is lit by its triangles, at vertices and at pixels', async () => {
      const floor = '({ glsl, position }) => position.mult(3).floor().div(3).sub(position)'
      const images = await drawScenes(browsers[renderer], server, [...scripts, addon], {
        setup: warpsOf('floor', floor, '{}'),
        scenes: scenesOf('floor'),
        renderer,
      })
      for (const [name, { data }] of Object.entries(images)) {
        const shades = new Set(Array.from({ length: data.length / 4 }, (_, i) => data[4 * i]))
        assert.ok(shades.size > 3, `${name}: ${shades.size} shades`)
      }
    })
  })

for (const [version, p5] of p5InThisRun)
  describe(`p5 ${version}: shaders of the sketch`, () => {
    const isOld = version === '1.11'
    const afterwards = isOld
      ? `{ 'vec3 getWorldNormal': '(vec3 n) { return -n; }' }`
      : `{ 'Vertex getCameraInputs': '(Vertex v) { v.normal = -v.normal; return v; }' }`
    const noise = `({ glsl, position }) => position.mult(glsl.simplex(position).mult(0.2))`

    test('a hook that changes normals after the warp gets them at vertices; asked for pixels, the console says so', async () => {
      const { page, messages } = await runSketch(
        browsers.WEBGL,
        server,
        [p5, addon],
        `function setup() {
          createCanvas(100, 100, WEBGL)
          const mine = baseMaterialShader().modify(${afterwards})
          const warps = [{}, { normals: 'pixel' }].map((options) =>
            createWarp(${noise}, { shader: mine, ...options }))
          for (const warp of warps) {
            warp()
            sphere(20)
          }
          window.chosen = warps.map(({ normals }) => normals)
          noLoop()
          window.done = true
        }`,
      )
      assert.deepEqual(await page.evaluate('chosen'), ['vertex', 'vertex'])
      await leavePage(page)
      assert.equal(messages.length, 1)
      assert.match(
        messages[0],
        /createWarp: the normals of this warp are computed at vertices, although its option "normals" is 'pixel': the hook get(World|Camera)(Normal|Inputs) of its shader changes normals after the warp\./,
      )
    })

    test('what was chosen can be read', async () => {
      const { page, messages } = await runSketch(
        browsers.WEBGL,
        server,
        [p5, addon],
        `function setup() {
          createCanvas(100, 100, WEBGL)
          noLoop()
          window.chosen = [createWarp(${noise}), createWarp(({ glsl, position }) => glsl.vec3(0, 0, position.x())),
            createWarp(${noise}, { normals: 'vertex' })].map(({ normals }) => normals)
          window.done = true
        }`,
      )
      assert.deepEqual(await page.evaluate('chosen'), ['pixel', 'vertex', 'vertex'])
      await leavePage(page)
      assert.deepEqual(messages, [])
    })
  })

if (p5InThisRun.some(([version]) => version === '1.11'))
  test('p5 1.11 on WebGL 1 draws as on WebGL 2', async () => {
    const draw = async (version) => {
      const { page, messages } = await runSketch(
        browsers.WEBGL,
        server,
        [p5Versions['1.11'], addon],
        `function setup() {
          pixelDensity(1)
          createCanvas(200, 200, WEBGL)
          setAttributes({ version: ${version}, antialias: false })
          noLoop(); noStroke()
          ${light}
          createWarp(${spaces.local}, { normals: 'pixel' })()
          sphere(75)
          window.done = true
        }`,
      )
      const image = await readPixels(page)
      await leavePage(page)
      assert.deepEqual(messages, [])
      return image
    }
    const [one, two] = [await draw(1), await draw(2)]
    assert.ok(meanDifference(one, two) < 0.5)
  })
