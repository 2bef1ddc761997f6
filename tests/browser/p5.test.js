// createWarp in p5 sketches, on each p5 that it promises to work with: the picture on the canvas is what is judged.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { launchBrowser } from './support/browser.js'
import * as m from './support/matrix.js'
import { colorAt, differingPixels, litPixels, readPixels } from './support/pixels.js'
import { servePages } from './support/server.js'
import { drawScenes, p5Versions, runSketch } from './support/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const size = 200

let browser, server
before(async () => {
  server = await servePages()
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

/**
 * f(p) = u g(p / u) with g(p) = (0.15 sin(2.4 y + 1), 0.11 sin(3.2 z), 0.12 sin(2 x)), as a sketch writes it and as
 * the oracle has it. The unit u is 1 for p5's own shapes, which are of size 1 in their local space, and scaled.
 */
const waves = (u) => ({
  code: `({ glsl, position }) => glsl.vec3(
    position.y().mult(${2.4 / u}).add(1).sin().mult(${0.15 * u}),
    position.z().mult(${3.2 / u}).sin().mult(${0.11 * u}),
    position.x().mult(${2 / u}).sin().mult(${0.12 * u}),
  )`,
  offset: ([x, y, z]) => [
    0.15 * u * Math.sin((2.4 / u) * y + 1),
    0.11 * u * Math.sin((3.2 / u) * z),
    0.12 * u * Math.sin((2 / u) * x),
  ],
  identityPlusJacobian: ([x, y, z]) =>
    m.linear([
      [1, 0.36 * Math.cos((2.4 / u) * y + 1), 0],
      [0, 1, 0.352 * Math.cos((3.2 / u) * z)],
      [0.24 * Math.cos((2 / u) * x), 0, 1],
    ]),
})

for (const [version, p5] of Object.entries(p5Versions)) {
  const draw = (options) => drawScenes(browser, server, [p5, addon], { size, ...options })

  describe(`createWarp on p5 ${version}`, () => {
    describe('shows the exact normal as colour', () => {
      // The same scene twice: as p5 calls, and as matrices.
      const scene = `
        perspective(PI / 3, 1, 10, 2000)
        camera(60, -90, 300, 10, 5, 0, 0, 1, 0)
        translate(20, -15, 10)
        rotateZ(0.5)
        rotateY(-0.8)
        rotateX(0.4)
        scale(1.3, 0.8, 1.1)
        distort()
        sphere(80, 160, 120)`
      const view = m.lookAt([60, -90, 300], [10, 5, 0], [0, 1, 0])
      const model = m.product(
        m.translation(20, -15, 10),
        m.rotation(0.5, 0, 1),
        m.rotation(-0.8, 2, 0),
        m.rotation(0.4, 1, 2),
        m.scaling(1.3, 0.8, 1.1),
        m.scaling(80, 80, 80),
      )
      const identity = m.scaling(1, 1, 1)
      const focal = 1 / Math.tan(Math.PI / 6)

      for (const [space, unit, before, after] of [
        ['local', 1, identity, m.product(view, model)],
        ['world', 80, model, view],
        ['camera', 80, m.product(view, model), identity],
      ]) {
        test(`of an offset in ${space} space`, async () => {
          const { code, offset, identityPlusJacobian } = waves(unit)
          const setup = `distort = createWarp(${code}, { type: 'normal', space: '${space}' })`
          const { image } = await draw({ setup, scenes: { image: scene } })

          const seen = directions(120)
            .map((direction) => {
              const p = m.movePoint(before, direction)
              const [x, y, z] = m.movePoint(after, m.add(p, offset(p)))
              const moved = m.product(after, identityPlusJacobian(p), before)
              return {
                normal: m.turnNormal(moved, direction),
                toEye: m.normalize([-x, -y, -z]),
                screen: [x, y].map((c) => ((1 + (focal * c) / -z) * size) / 2),
              }
            })
            .filter(({ normal, toEye }) => m.dot(normal, toEye) > 0.3)

          assert.ok(seen.length >= 15, `${seen.length} points face the camera`)
          for (const { normal, screen } of seen) {
            const color = colorAt(image, ...screen)
            const expected = normal.map((value) => 255 * Math.max(value, 0))
            const error = Math.max(...color.map((value, i) => Math.abs(value - expected[i])))
            assert.ok(error <= 3, `at ${screen}: ${color} for ${expected}`)
          }
        })
      }
    })

    test('is lit like a mesh that was moved vertex by vertex, by each material', async () => {
      const { code, offset, identityPlusJacobian } = waves(1)
      const sphere = sphereMesh(32, 24)
      const warped = {
        ...sphere,
        vertices: sphere.vertices.map((p) => m.add(p, offset(p))),
        normals: sphere.normals.map((n) => m.turnNormal(identityPlusJacobian(n), n)),
      }
      const materials = {
        lights: 'orbitControl(); lights()',
        fill: `lights(); fill('orange')`,
        specular: 'lights(); specularMaterial(250, 80, 80); shininess(20)',
        texture: 'texture(stripes)',
        'lit texture': 'lights(); texture(stripes)',
        imageLight: 'imageLight(stripes)',
        normalMaterial: 'normalMaterial()',
      }
      const setup = `
        distort = createWarp(${code})
        stripes = createImage(32, 32)
        for (let y = 0; y < 32; y++)
          for (let x = 0; x < 32; x++) stripes.set(x, y, color(y < 20 ? 'purple' : 'yellow'))
        stripes.updatePixels()
        plain = ${geometryCode(sphere, 'plain')}
        moved = ${geometryCode(warped, 'moved')}`
      const scenes = {}
      for (const [name, material] of Object.entries(materials)) {
        scenes[name] = `scale(60); ${material}; distort(); model(plain)`
        scenes[`${name} after the warp`] = `scale(60); distort(); ${material}; model(plain)`
        scenes[`${name} by vertex`] = `scale(60); noStroke(); ${material}; model(moved)`
      }
      const images = await draw({ setup, scenes })

      for (const name of Object.keys(materials)) {
        const image = images[name]
        const lit = litPixels(image).length
        assert.ok(lit > 5000, `${name}: ${lit} pixels are lit`)
        for (const other of [`${name} after the warp`, `${name} by vertex`]) {
          const differing = differingPixels(images[other], image, 2)
          assert.ok(differing < 0.005 * lit, `${other}: ${differing} of ${lit} pixels differ`)
        }
        for (const other of Object.keys(materials))
          if (other !== name) assert.notDeepEqual(image, images[other], `${name} and ${other}`)
      }
    })

    test('keeps the normals in view under lights and textures', async () => {
      const setup = `
        distort = createWarp(${waves(1).code}, { type: 'normal' })
        stripes = createImage(8, 8)`
      const { alone, ...others } = await draw({
        setup,
        scenes: {
          alone: 'distort(); sphere(60)',
          lit: 'lights(); distort(); sphere(60)',
          textured: 'distort(); texture(stripes); sphere(60)',
        },
      })
      for (const [name, image] of Object.entries(others)) assert.deepEqual(image, alone, name)
    })

    test('moves by each input and by the uniforms of defs', async () => {
      const warps = {
        position: `({ glsl, position }) => glsl.vec3(position.x().add(40), 0, 0)`,
        normal: `({ glsl, normal }) => glsl.vec3(normal.z().mult(40), 0, 0)`,
        uv: `({ glsl, uv }) => glsl.vec3(uv.x().mult(80), 0, 0)`,
        color: `({ glsl, color }) => glsl.vec3(color.x().add(color.w()).mult(20), 0, 0)`,
        millis: `({ glsl, millis }) => glsl.vec3(millis.min(40), 0, 0)`,
        size: `({ glsl, size }) => glsl.vec3(size.x().mult(0.2), 0, 0)`,
        width: `({ glsl, width, height }) => glsl.vec3(width.add(height).mult(0.1), 0, 0)`,
        pixelDensity: `({ glsl, pixelDensity }) => glsl.vec3(pixelDensity.mult(40), 0, 0)`,
        mouse: `({ glsl, mouse, mouseY }) => glsl.vec3(mouse.x().add(mouseY).add(40), 0, 0)`,
        defs: `({ glsl }) => glsl.vec3(glsl.param('amount'), glsl.vec3Param('shift').x(), 0)`,
      }
      const defs = '{ space: "world", defs: "uniform float amount; uniform vec3 shift;" }'
      const setups = Object.entries(warps).map(
        ([name, code]) => `warps.${name} = createWarp(${code}, ${defs})`,
      )
      const shape = `fill('red'); plane(20)`
      const scenes = Object.fromEntries(
        Object.keys(warps).map((name) => [name, `warps.${name}(); ${shape}`]),
      )
      scenes.defs = `warps.defs({ amount: 40, shift: [0, 0, 0] }); ${shape}`
      scenes.kept = `warps.defs(); ${shape}`
      scenes.vector = `warps.defs({ amount: 0, shift: createVector(40, 0, 0) }); ${shape}`
      const images = await draw({ setup: `window.warps = {}; ${setups.join('\n')}`, scenes })

      const middle = (image) => {
        const lit = litPixels(image)
        const mean = (axis) => lit.reduce((sum, pixel) => sum + pixel[axis], 0) / lit.length
        return [mean('x'), mean('y')].map(Math.round)
      }
      for (const [name, image] of Object.entries(images))
        assert.deepEqual(middle(image), [40, 0], name)
    })

    test('lights a flattened or stepped model without holes', async () => {
      const setup = `
        flat = createWarp(({ glsl, position }) => glsl.vec3(0, 0, position.z().neg()))
        steps = createWarp(({ glsl, position }) => {
          const x = position.x()
          return glsl.vec3(x.mult(5).floor().div(5).sub(x), 0, 0)
        })`
      const light = 'ambientLight(60); directionalLight(200, 200, 200, 0, 0, -1)'
      const images = await draw({
        setup,
        scenes: {
          flat: `${light}; flat(); sphere(60)`,
          steps: `${light}; steps(); noStroke(); plane(120, 120, 40, 40)`,
        },
      })
      for (const [name, image] of Object.entries(images)) {
        const lit = litPixels(image).filter(({ x, y }) => Math.max(Math.abs(x), Math.abs(y)) < 35)
        const dark = lit.filter(({ color }) => color[0] < 59)
        assert.deepEqual([lit.length, dark.length], [70 * 70, 0], name)
      }
    })

    test('works in instance mode and in a p5.Graphics', async () => {
      const { page, messages } = await runSketch(
        browser,
        server,
        [p5, addon],
        `new p5((p) => {
          let distort, layer
          p.setup = () => {
            p.pixelDensity(1)
            p.createCanvas(${size}, ${size}, p.WEBGL)
            layer = p.createGraphics(100, 100, p.WEBGL)
            distort = layer.createWarp(({ glsl, size, millis }) =>
              glsl.vec3(size.x().mult(0.2), millis.mult(0).add(10), 0), { space: 'world' })
            own = p.createWarp(({ glsl }) => glsl.vec3(-60, 0, 0), { space: 'world' })
            p.noLoop()
          }
          p.draw = () => {
            p.background(0)
            layer.background(0)
            layer.fill('red')
            distort()
            layer.plane(20)
            p.image(layer, -50, -50)
            p.fill('lime')
            own()
            p.plane(20)
            window.done = true
          }
        })`,
      )
      const image = await readPixels(page)
      assert.deepEqual(colorAt(image, size / 2 + 20, size / 2 + 10), [255, 0, 0])
      assert.deepEqual(colorAt(image, size / 2 - 60, size / 2), [0, 255, 0])
      await page.close()
      assert.deepEqual(messages, [])
    })

    test('takes the addon before p5, and twice', async () => {
      const setup = `distort = createWarp(${waves(1).code})`
      const scenes = { image: 'lights(); distort(); sphere(60)' }
      const first = await draw({ setup, scenes })
      for (const scripts of [
        [addon, p5],
        [p5, addon, addon],
      ])
        assert.deepEqual(await drawScenes(browser, server, scripts, { size, setup, scenes }), first)
    })

    test('says in a WarpError what is wrong, and goes on drawing', async () => {
      const cases = {
        'createWarp(3)': /a function was expected, but the number 3 came/,
        'createWarp(() => 3)': /must return a vec3/,
        'createWarp(warp, 3)': /options must be an object/,
        'createWarp(warp, { colour: 1 })': /no option "colour"/,
        'createWarp(warp, { type: "shiny" })': /"type" must be "specular" or "normal"/,
        'createWarp(warp, { space: "moon" })': /"space" must be "local" or "world" or "camera"/,
        'createWarp(warp, { defs: 3 })': /"defs" must be a text of GLSL/,
        'flat2d.createWarp(warp)': /needs a 3D canvas/,
        'distort(3)': /takes an object of uniforms/,
        'distort([3])': /takes an object of uniforms/,
        'distort({ speed: 3 })': /no uniform "speed"/,
        'distort({ amount: undefined })': /uniform "amount" must be a number, but is undefined/,
        'distort({ amount: NaN })': /uniform "amount" must be a number/,
        'distort({ shift: 3 })': /uniform "shift" must be an array of numbers/,
        'layer.remove(); inLayer()': /canvas that this warp was made for is gone/,
        'remove(); distort()': /canvas that this warp was made for is gone/,
      }
      const { page, messages } = await runSketch(
        browser,
        server,
        [p5, addon],
        `const warp = ({ glsl }) => glsl.vec3Param('shift').add(glsl.param('amount'))
        function setup() {
          createCanvas(100, 100, WEBGL)
          const defs = 'uniform vec3 shift; uniform float amount; uniform float unused;'
          distort = createWarp(warp, { defs })
          flat2d = createGraphics(10, 10)
          layer = createGraphics(10, 10, WEBGL)
          inLayer = layer.createWarp(warp, { defs })
          noLoop()
        }
        function draw() {
          inLayer()
          layer.sphere(5)
          distort({ unused: 1 })
          sphere(20)
          window.done = true
        }`,
      )
      for (const [code, message] of Object.entries(cases)) {
        const error = await page.evaluate(`(() => {
          try { ${code} } catch (error) { return { name: error.name, message: error.message } }
        })()`)
        assert.equal(error?.name, 'WarpError', code)
        assert.match(error.message, message)
      }
      await page.close()
      assert.deepEqual(messages, [])
    })

    test('follows the canvas when setAttributes replaces it', async () => {
      const setup = `
        distort = createWarp(({ glsl }) => glsl.vec3(40, 0, 0), { space: 'world' })
        distort()
        setAttributes('antialias', false)`
      const { image } = await draw({
        setup,
        scenes: { image: `distort(); fill('red'); plane(20)` },
      })
      assert.deepEqual(colorAt(image, size / 2 + 40, size / 2), [255, 0, 0])
    })
  })
}

describe('the modules', () => {
  test('register with an imported p5', async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [],
      `import p5 from '/node_modules/p5/lib/p5.esm.js'
      import warpjet, { createWarp } from '/dist/p5.js'
      p5.registerAddon(warpjet)
      warpjet(p5)
      new p5((p) => {
        let left, right
        const by = (x) => [({ glsl }) => glsl.vec3(x, 0, 0), { space: 'world' }]
        p.setup = () => {
          p.pixelDensity(1)
          p.createCanvas(${size}, ${size}, p.WEBGL)
          left = p.createWarp(...by(-40))
          right = createWarp(p, ...by(40))
          p.noLoop()
        }
        p.draw = () => {
          p.background(0)
          p.fill('red')
          left()
          p.plane(20)
          right()
          p.plane(20)
          window.done = true
        }
      })`,
      'module',
    )
    const image = await readPixels(page)
    await page.close()
    assert.deepEqual(messages, [])
    for (const x of [-40, 40]) assert.deepEqual(colorAt(image, size / 2 + x, size / 2), [255, 0, 0])
  })

  test('load without a browser', async () => {
    const { default: warpjet, createWarp } = await import('../../dist/p5.js')
    class Sketch {}
    Sketch.Graphics = class {}
    warpjet(Sketch)
    const { createWarp: method } = Sketch.prototype
    warpjet(Sketch)
    assert.equal(Sketch.prototype.createWarp, method)
    assert.equal(typeof Sketch.Graphics.prototype.createWarp, 'function')
    assert.throws(() => createWarp({}, () => 0), { name: 'WarpError', message: /3D canvas/ })
  })
})

/** `count` unit vectors spread evenly over the sphere: steps of the golden angle from pole to pole. */
function directions(count) {
  return Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * i + 1) / count
    const angle = i * Math.PI * (3 - Math.sqrt(5))
    const radius = Math.sqrt(1 - y * y)
    return [radius * Math.cos(angle), y, radius * Math.sin(angle)]
  })
}

/** A sphere of radius 1 → { vertices, normals, uvs, faces }. */
function sphereMesh(columns, rows) {
  const grid = Array.from({ length: (columns + 1) * (rows + 1) }, (_, i) => [
    (i % (columns + 1)) / columns,
    Math.floor(i / (columns + 1)) / rows,
  ])
  const vertices = grid.map(([u, v]) => {
    const [longitude, latitude] = [2 * Math.PI * u, Math.PI * v]
    const radius = Math.sin(latitude)
    return [radius * Math.sin(longitude), -Math.cos(latitude), radius * Math.cos(longitude)]
  })
  const faces = []
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const a = row * (columns + 1) + column
      const c = a + columns + 1
      faces.push([a, a + 1, c], [c, a + 1, c + 1])
    }
  return { vertices, normals: vertices, uvs: grid.flat(), faces }
}

/** The p5 code that makes a mesh a p5.Geometry. */
const geometryCode = ({ vertices, normals, uvs, faces }, name) => `
  new p5.Geometry(1, 1, function () {
    const vector = ([x, y, z]) => createVector(x, y, z)
    this.gid = '${name}'
    this.vertices = ${JSON.stringify(vertices)}.map(vector)
    this.vertexNormals = ${JSON.stringify(normals)}.map(vector)
    this.uvs = ${JSON.stringify(uvs)}
    this.faces = ${JSON.stringify(faces)}
  })`
