// loadWarpModel on each host: the geometry that it makes, pictures of it, and messages about mistakes.
import assert from 'node:assert/strict'
import { mkdirSync } from 'node:fs'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { openP5Hosts } from '../support/browser/p5-hosts.js'
import { path, red, triangle, white, writeModels } from '../support/browser/p5-models.js'
import { colorAt, litPixels, readPixels, readWebGPUPixels } from '../support/browser/pixels.js'

const size = 300
const folder = writeModels('model-test')

/** Code that converts a model to a value that can be passed out of the page. */
const report = `(model) => ({
  vertices: model.vertices.map(({ x, y, z }) => [x, y, z]),
  normals: model.vertexNormals.map(({ x, y, z }) => [x, y, z]),
  faces: model.faces,
  uvs: [...model.uvs],
  colors: [...model.vertexColors],
  texture: model.texture && [model.texture.width, model.texture.height],
  warnings: model.warnings,
  isGeometry: model instanceof p5.Geometry,
})`

for (const host of await openP5Hosts()) {
  const { isV1, isWebGPU, server, canvas } = host
  // p5 2.3 cuts off the front half of ortho() on WEBGPU.
  const ortho = isWebGPU ? 'ortho(-150, 150, -150, 150, -1000, 1000)' : 'ortho()'

  /** Runs a sketch: `loadCode` is the body of an async function that loads models, `drawCode` that of draw(). */
  const runModelSketch = (loadCode, drawCode = '') =>
    host.open(
      `let isReady = false
      const base = '${folder}/'
      async function load() { ${loadCode} }
      async function setup() {
        pixelDensity(1)
        ${canvas(size, size)}
        load().then(() => (isReady = true))
      }
      function draw() {
        if (!isReady) return
        background(0)
        noStroke()
        push()
        ${drawCode}
        pop()
        noLoop()
        window.done = true
      }`,
    )

  /** Loads models: maps each name → a report of the model. */
  async function loadReports(calls) {
    const { page, messages } = await runModelSketch(
      `window.reports = {}
      ${Object.entries(calls)
        .map(([name, call]) => `reports.${name} = (${report})(await loadWarpModel(${call}))`)
        .join('\n')}`,
    )
    const result = await page.evaluate('reports')
    await leavePage(page)
    assert.deepEqual(messages, [])
    return result
  }

  for (const name of ['parts.obj', 'painted.obj', 'white.obj', 'text.stl', 'binary.stl'])
    test(`${host.name}: ${name} has the triangles and colours of p5's own loadModel`, async () => {
      // p5 1.11 throws for a model that has colours on only some parts.
      const comparesColors = !isV1 || name !== 'parts.obj'
      const { page } = await runModelSketch(`
        const own = await new Promise((done) => loadModel(base + '${name}', done))
        const ours = await loadWarpModel(base + '${name}', { normalize: false, flipY: false })
        const round5 = (numbers) => [...numbers].map((x) => +x.toFixed(5))
        const corner = ({ vertices, vertexColors, vertexNormals }, i, channels) => ({
          position: vertices[i].array(),
          color: ${comparesColors} && round5(vertexColors.slice(channels * i, channels * i + 3)),
          normal: ${name.endsWith('stl')} && round5(vertexNormals[i].array()),
        })
        const corners = (model, channels) =>
          model.faces.map((face) => face.map((i) => corner(model, i, channels)))
        // The loader of p5 1.11 writes 3 numbers per colour, although p5 draws 4.
        window.reports = [corners(own, ${isV1 ? 3 : 4}), corners(ours, 4)]`)
      const [own, ours] = await page.evaluate('reports')
      await leavePage(page)
      assert.ok(own.length > 0)
      assert.deepEqual(ours, own)
    })

  const readPicture = (page) => (isWebGPU ? readWebGPUPixels(page, 'redraw()') : readPixels(page))

  async function drawPicture(loadCode, drawCode) {
    const { page, messages } = await runModelSketch(loadCode, drawCode)
    const image = await readPicture(page)
    await leavePage(page)
    assert.deepEqual(messages, [])
    return image
  }

  const assertColor = (image, x, y, color) =>
    colorAt(image, size / 2 + x, size / 2 + y).forEach((value, i) =>
      assert.ok(Math.abs(value - color[i]) <= 1, `channel ${i} at ${x}, ${y}: ${value}`),
    )

  describe(`loadWarpModel on ${host.name}`, () => {
    test('makes a p5.Geometry with all attributes, upright, whose longest side is 200', async () => {
      const { plain, colors, material, texture, obj } = await loadReports({
        plain: `base + 'plain.glb'`,
        colors: `base + 'colors.glb'`,
        material: `new URL(base + 'material.glb', location)`,
        texture: `base + 'picture.glb'`,
        obj: `base + 'tip.obj'`,
      })
      assert.deepEqual(plain, {
        vertices: [
          [-100, 50, 0],
          [100, 50, 0],
          [0, -50, 0],
        ],
        normals: [0, 1, 2].map(() => [0, 0, 1]),
        faces: [[0, 2, 1]],
        uvs: [0, 0, 0, 0, 0, 0],
        colors: [],
        texture: undefined,
        warnings: [],
        isGeometry: true,
      })
      assert.deepEqual(obj, plain)
      // sRGB of 0.25, 0.001 and 0, the same for each vertex.
      for (let i = 0; i < 12; i++)
        assert.ok(Math.abs(colors.colors[i] - [0.537099, 0.01292, 0, 1][i % 4]) < 1e-5, `${i}`)
      assert.equal(colors.colors.length, 12)
      assert.ok(Math.abs(material.colors[1] - 0.5) < 1e-5)
      assert.deepEqual(texture.uvs, [0, 1, 1, 1, 1, 0, 0, 0])
      assert.deepEqual(texture.texture, [2, 2])
      assert.deepEqual(texture.colors, [])
    })

    test("keeps the file's coordinates with normalize: false", async () => {
      const { flipped, sized, raw } = await loadReports({
        flipped: `base + 'plain.glb', { normalize: false }`,
        sized: `base + 'plain.glb', { flipY: false }`,
        raw: `base + 'plain.glb', { normalize: false, flipY: false }`,
      })
      assert.deepEqual(flipped.vertices[2], [5, -1, 0])
      assert.deepEqual(sized.vertices[2], [0, 50, 0])
      assert.deepEqual(raw.vertices.flat(), triangle.positions)
      assert.deepEqual(raw.faces, [[0, 1, 2]])
    })

    test('is drawn by model(), with and without a warp', async () => {
      const image = await drawPicture(
        `window.one = await loadWarpModel(base + 'material.glb')
        window.two = await loadWarpModel(base + 'plain.glb')
        window.shift = createWarp(({ glsl }) => glsl.vec3(40, 0, 0))`,
        `${ortho}
        translate(0, -60)
        model(one)
        translate(0, 120)
        fill('red')
        shift()
        model(two)`,
      )
      // Two triangles of 200 by 100, whose tips are at the top.
      assertColor(image, 0, -100, [0, 128, 0])
      assertColor(image, 40, -100, [0, 0, 0])
      assertColor(image, 90, -12, [0, 128, 0])
      assertColor(image, 40, 20, [255, 0, 0])
      assertColor(image, -10, 20, [0, 0, 0])
      assert.ok(Math.abs(litPixels(image).length - 20_000) < 1500)
    })

    test('shows the image of a file the right way up', async () => {
      const image = await drawPicture(
        `window.tile = await loadWarpModel(base + 'picture.glb')`,
        `${ortho}; texture(tile.texture); model(tile)`,
      )
      assertColor(image, -80, -80, red)
      assertColor(image, 80, 80, [0, 0, 255])
      assertColor(image, 80, -80, white)
      assertColor(image, -80, 80, white)
    })

    test('shows a bunny', async () => {
      const { page, messages } = await runModelSketch(
        `window.rabbit = await loadWarpModel(base + 'bunny.glb')
        window.lean = createWarp(({ glsl, position }) =>
          glsl.vec3(position.y().mult(0.02).sin().mult(25), 0, 0))`,
        'background(30); lights(); lean(); model(rabbit)',
      )
      mkdirSync(path('/.build/screenshots'), { recursive: true })
      await page.screenshot({ path: path(`/.build/screenshots/model-${host.name}.png`) })
      const image = await readPicture(page)
      const covered = litPixels(image).filter(({ color }) => color[0] > 60).length
      await leavePage(page)
      assert.deepEqual(messages, [])
      assert.ok(covered > 8000 && covered < 40_000, `${covered} pixels`)
    })

    test('has a message for each mistake', async () => {
      const { page } = await runModelSketch(
        `window.errors = []
        const attempt = async (...args) => {
          try { await loadWarpModel(...args) } catch (error) {
            errors.push([error instanceof warpjet.WarpError, error.message])
          }
        }
        await attempt()
        await attempt(42)
        await attempt(base + 'none.glb')
        await attempt(base + 'words.glb')
        await attempt(base + 'plain.glb', { size: 2 })
        await attempt(base + 'plain.glb', true)`,
      )
      const errors = await page.evaluate('errors')
      await leavePage(page)
      assert.ok(errors.every(([isWarpError]) => isWarpError))
      const url = `${server.url}${folder}`
      assert.deepEqual(
        errors.map(([, message]) => message),
        [
          'loadWarpModel: expected the address of a model such as "bunny.glb", got undefined.',
          'loadWarpModel: expected the address of a model such as "bunny.glb", got the number 42.',
          `loadWarpModel: cannot load ${url}/none.glb; the server answered 404.`,
          errors[3][1],
          'loadWarpModel: there is no option "size"; the options are normalize, flipY, decoders.',
          'loadWarpModel: expected an object of options, got the boolean true.',
        ],
      )
      assert.match(errors[3][1], /^loadWarpModel: .*\.$/)
      assert.doesNotMatch(errors[3][1], /loadMesh/)
    })
  })
}
