// loadWarpModel on each supported p5: the geometry from a file, how it looks, and the messages about broken files.
import assert from 'node:assert/strict'
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { after, before, describe, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { exportGLB } from '../../dist/mesh.js'
import { bunny } from '../../web/models/bunny.js'
import { launchBrowser, leavePage } from '../support/browser/browser.js'
import { colorAt, litPixels, readPixels } from '../support/browser/pixels.js'
import { servePages } from '../support/browser/server.js'
import { p5InThisRun, p5Versions, runSketch } from '../support/browser/sketch.js'
import { packedVariants } from '../support/models/packed-variants.js'
import { shapes } from '../support/models/shapes.js'
import { png } from '../support/png.js'

const addon = '/dist/p5.warpjet.min.js'
const size = 300
const folder = '/.build/model-test'
const alone = `${folder}/alone/p5.warpjet.min.js`
const path = (name) => fileURLToPath(new URL(`../..${name}`, import.meta.url))

/** A file in glTF's conventions: y upwards, counterclockwise front faces, linear colours. It is two wide and one high. */
const tip = {
  positions: [4, 0, 0, 6, 0, 0, 5, 1, 0],
  normals: [0, 0, 1, 0, 0, 1, 0, 0, 1],
  indices: [0, 1, 2],
}
const white = [255, 255, 255]
const red = [255, 0, 0]
const files = {
  'plain.glb': exportGLB(tip),
  'colors.glb': exportGLB({
    ...tip,
    colors: [0, 1, 2].flatMap(() => [0.5, 0.001, 1, 1]),
    material: { baseColor: [0.5, 1, 0, 1] },
  }),
  'material.glb': exportGLB({ ...tip, material: { baseColor: [0, 0.2140411, 0, 1] } }),
  'picture.glb': exportGLB({
    positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0],
    normals: Array.from({ length: 12 }, (_, i) => (i % 3 === 2 ? 1 : 0)),
    uvs: [0, 1, 1, 1, 1, 0, 0, 0],
    indices: [0, 1, 2, 0, 2, 3],
    material: {
      baseColor: [1, 1, 1, 1],
      baseColorTexture: {
        bytes: png(2, 2, (x, y) => (x === y ? [red, [0, 0, 255]][x] : white)),
        mimeType: 'image/png',
      },
    },
  }),
  'tip.obj': 'v 4 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\n',
  'words.glb': 'no model at all',
  'packed.glb': packedVariants['meshopt, vertices and triangles'](shapes.cube).file,
  // One face in the fill colour, one red, one white, one with a material that does not exist.
  'parts.obj': `mtllib parts.mtl
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0
f 1 2 3\nusemtl red\nf 1 3 4\nusemtl white\nf 1 2 4\nusemtl nowhere\nf 2 3 4\n`,
  'parts.mtl': 'newmtl red\nKd 0.8 0.1 0\n\nnewmtl white\nKa 0 0 0\nKd 1 1 1\nmap_Kd a.png\n',
  'painted.obj': `mtllib parts.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3
usemtl white\nv 0 0 1\nv 1 0 1\nv 1 1 1\nf 4 5 6\n`,
  'white.obj': 'mtllib parts.mtl\nusemtl white\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n',
  'text.stl': `solid a
facet normal 0.6 0 0.8\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet
facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 2\nendloop\nendfacet
endsolid a\n`,
  'binary.stl': binaryStl([
    [0.6, 0, 0.8, 0, 0, 0, 1, 0, 0, 1, 1, 0],
    [0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 2],
  ]),
}

/** The normal and corners of each facet. */
function binaryStl(facets) {
  const view = new DataView(new ArrayBuffer(84 + 50 * facets.length))
  view.setUint32(80, facets.length, true)
  facets.forEach((numbers, i) =>
    numbers.forEach((x, k) => view.setFloat32(84 + 50 * i + 4 * k, x, true)),
  )
  return new Uint8Array(view.buffer)
}

let browser, server
before(async () => {
  mkdirSync(path(folder), { recursive: true })
  for (const [name, bytes] of Object.entries(files)) writeFileSync(path(`${folder}/${name}`), bytes)
  // The y axis points downwards, as in p5.
  const { positions, normals, uvs, indices } = bunny()
  for (const numbers of [positions, normals])
    for (let i = 1; i < numbers.length; i += 3) numbers[i] *= -1
  for (let i = 0; i < indices.length; i += 3)
    [indices[i + 1], indices[i + 2]] = [indices[i + 2], indices[i + 1]]
  const material = { baseColor: [0.9, 0.3, 0.15, 1] }
  writeFileSync(
    path(`${folder}/bunny.glb`),
    exportGLB({ positions, normals, uvs, indices, material }),
  )
  // A copy of the script without other files next to it.
  mkdirSync(path(`${folder}/alone`), { recursive: true })
  copyFileSync(path(addon), path(alone))
  server = await servePages()
  browser = await launchBrowser()
})
after(async () => {
  await browser.close()
  await server.close()
})

/** The parts of a model that can be passed out of the page. */
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

for (const [version, p5] of p5InThisRun) {
  /** Runs a sketch with the code `loading`, which loads models in an async function, and `drawing`, which draws → { page, messages }. */
  const sketch = (loading, drawing = '', scripts = [p5, addon]) =>
    runSketch(
      browser,
      server,
      scripts,
      `let isReady = false
      const base = '${folder}/'
      async function load() { ${loading} }
      function setup() {
        pixelDensity(1)
        createCanvas(${size}, ${size}, WEBGL)
        load().then(() => (isReady = true))
      }
      function draw() {
        if (!isReady) return
        background(0)
        noStroke()
        ${drawing}
        noLoop()
        window.done = true
      }`,
    )

  /** Converts the reports about models to an object by name. */
  async function reports(calls) {
    const { page, messages } = await sketch(
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
    test(`p5 ${version}: ${name} has the triangles and colours of p5's own loadModel`, async () => {
      // p5 1.11 throws for a model that has colours on only some parts.
      const areColorsJudged = version !== '1.11' || name !== 'parts.obj'
      const { page } = await sketch(`
        const own = await new Promise((done) => loadModel(base + '${name}', done))
        const ours = await loadWarpModel(base + '${name}', { normalize: false, flipY: false })
        const round5 = (numbers) => [...numbers].map((x) => +x.toFixed(5))
        const corner = ({ vertices, vertexColors, vertexNormals }, i, partsOfColor) => ({
          position: vertices[i].array(),
          color: ${areColorsJudged} && round5(vertexColors.slice(partsOfColor * i, partsOfColor * i + 3)),
          normal: ${name.endsWith('stl')} && round5(vertexNormals[i].array()),
        })
        const corners = (model, partsOfColor) =>
          model.faces.map((face) => face.map((i) => corner(model, i, partsOfColor)))
        // The loader of p5 1.11 writes 3 numbers per colour, although p5 draws 4.
        window.reports = [corners(own, ${version === '1.11' ? 3 : 4}), corners(ours, 4)]`)
      const [own, ours] = await page.evaluate('reports')
      await leavePage(page)
      assert.ok(own.length > 0)
      assert.deepEqual(ours, own)
    })

  test(`p5 ${version}: a model compressed by meshopt needs the decoder's script, and the message says so`, async () => {
    const loading = `window.reports = await loadWarpModel(base + 'packed.glb')
      .then(({ faces }) => faces.length, ({ message }) => message)`
    const decoder = '/node_modules/meshoptimizer/meshopt_decoder.cjs'
    for (const [scripts, expected] of [
      [[p5, decoder, addon], /^12$/],
      [
        [p5, addon],
        /^loadWarpModel: the model is compressed by EXT_meshopt_compression, .* MeshoptDecoder/,
      ],
    ]) {
      const { page } = await sketch(loading, '', scripts)
      assert.match(String(await page.evaluate('reports')), expected)
      await leavePage(page)
    }
  })

  async function picture(loading, drawing, scripts) {
    const { page, messages } = await sketch(loading, drawing, scripts)
    const image = await readPixels(page)
    await leavePage(page)
    assert.deepEqual(messages, [])
    return image
  }

  const assertColor = (image, x, y, color) =>
    colorAt(image, size / 2 + x, size / 2 + y).forEach((value, i) =>
      assert.ok(Math.abs(value - color[i]) <= 1, `channel ${i} at ${x}, ${y}: ${value}`),
    )

  describe(`loadWarpModel on p5 ${version}`, () => {
    test('makes a p5.Geometry: upright, 200 units at its longest, with all attributes', async () => {
      const { plain, colors, material, texture, obj } = await reports({
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
      const { flipped, sized, raw } = await reports({
        flipped: `base + 'plain.glb', { normalize: false }`,
        sized: `base + 'plain.glb', { flipY: false }`,
        raw: `base + 'plain.glb', { normalize: false, flipY: false }`,
      })
      assert.deepEqual(flipped.vertices[2], [5, -1, 0])
      assert.deepEqual(sized.vertices[2], [0, 50, 0])
      assert.deepEqual(raw.vertices.flat(), tip.positions)
      assert.deepEqual(raw.faces, [[0, 1, 2]])
    })

    test('is drawn by model(), and by createWarp', async () => {
      const image = await picture(
        `window.one = await loadWarpModel(base + 'material.glb')
        window.two = await loadWarpModel(base + 'plain.glb')
        window.shift = createWarp(({ glsl }) => glsl.vec3(40, 0, 0))`,
        `ortho()
        translate(0, -60)
        model(one)
        translate(0, 120)
        fill('red')
        shift()
        model(two)`,
      )
      // A triangle of 200 by 100 with the tip at the top: narrow at the top, wide at the bottom.
      assertColor(image, 0, -100, [0, 128, 0])
      assertColor(image, 40, -100, [0, 0, 0])
      assertColor(image, 90, -12, [0, 128, 0])
      assertColor(image, 40, 20, [255, 0, 0])
      assertColor(image, -10, 20, [0, 0, 0])
      assert.ok(Math.abs(litPixels(image).length - 20_000) < 1500)
    })

    test('shows the image of a file the right way up', async () => {
      const image = await picture(
        `window.tile = await loadWarpModel(base + 'picture.glb')`,
        `ortho(); texture(tile.texture); model(tile)`,
      )
      assertColor(image, -80, -80, red)
      assertColor(image, 80, 80, [0, 0, 255])
      assertColor(image, 80, -80, white)
      assertColor(image, -80, 80, white)
    })

    test('shows a bunny', async () => {
      const { page, messages } = await sketch(
        `window.rabbit = await loadWarpModel(base + 'bunny.glb')
        window.lean = createWarp(({ glsl, position }) =>
          glsl.vec3(position.y().mult(0.02).sin().mult(25), 0, 0))`,
        'background(30); lights(); lean(); model(rabbit)',
      )
      mkdirSync(path('/.build/screenshots'), { recursive: true })
      await page.screenshot({ path: path(`/.build/screenshots/model-${version}.png`) })
      const image = await readPixels(page)
      const covered = litPixels(image).filter(({ color }) => color[0] > 60).length
      await leavePage(page)
      assert.deepEqual(messages, [])
      assert.ok(covered > 8000 && covered < 40_000, `${covered} pixels`)
    })

    test('has a message for each mistake', async () => {
      const { page } = await sketch(
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
          'loadWarpModel: there is no option "size"; there are normalize, flipY, decoders.',
          'loadWarpModel: expected an object of options, got the boolean true.',
        ],
      )
      assert.match(errors[3][1], /^loadWarpModel: .*\.$/)
      assert.doesNotMatch(errors[3][1], /loadMesh/)
    })

    test('names the missing file next to a script that was copied alone', async () => {
      const { page } = await sketch(
        `await loadWarpModel(base + 'plain.glb').then(null, ({ message }) => (window.problem = message))`,
        '',
        [p5, alone],
      )
      const problem = await page.evaluate('problem')
      await leavePage(page)
      assert.equal(
        problem,
        `loadWarpModel: cannot load ${server.url}${folder}/alone/mesh.min.js; copy it there, from the package's folder dist.`,
      )
    })
  })
}

describe('loadWarpModel in preload, on p5 1.11', () => {
  for (const mode of isRun('p5 1.11') ? ['global', 'instance'] : ['global'])
    test(`is loaded before setup in ${mode} mode`, async () => {
      const [own, start] = mode === 'global' ? ['window', ''] : ['p', 'new p5((p) => {']
      const { page, messages } = await runSketch(
        browser,
        server,
        [p5Versions['1.11'], addon],
        `${start}
        let tip, bunny
        ${own}.preload = () => {
          tip = ${own}.loadWarpModel('${folder}/plain.glb')
          bunny = ${own}.loadWarpModel('${folder}/bunny.glb')
        }
        ${own}.setup = () => {
          window.report = [tip.vertices.length, tip instanceof p5.Geometry, 'then' in tip, bunny.faces.length]
          ${own}.createCanvas(${size}, ${size}, ${own}.WEBGL)
          ${own}.noLoop()
        }
        ${own}.draw = () => {
          ${own}.background(0); ${own}.noStroke(); ${own}.fill(255, 0, 0); ${own}.ortho()
          ${own}.model(tip)
          window.done = true
        }
        ${start && '})'}`,
      )
      const image = await readPixels(page)
      assert.deepEqual(await page.evaluate('report'), [3, true, false, 3674])
      await leavePage(page)
      assert.deepEqual(messages, [])
      assert.deepEqual(colorAt(image, size / 2, size / 2), red)
    })
})

describe('loadWarpModel from other servers', () => {
  test('fetches mesh.min.js from the server of the script', async () => {
    const context = await browser.newContext()
    const cdn = server.url.replace('localhost', '127.0.0.1')
    const fetched = []
    await context.route(`${cdn}/**`, async (route) => {
      fetched.push(new URL(route.request().url()).pathname)
      const response = await route.fetch()
      await route.fulfill({
        response,
        headers: { ...response.headers(), 'access-control-allow-origin': '*' },
      })
    })
    const { page, messages } = await runSketch(
      context,
      server,
      [p5Versions['2.x'], `${cdn}${addon}`],
      `async function setup() {
        window.tip = await loadWarpModel('${folder}/plain.glb')
        window.done = true
      }`,
    )
    assert.deepEqual(messages, [])
    assert.equal(await page.evaluate('tip.faces.length'), 1)
    await context.close()
    assert.ok(fetched.includes('/dist/mesh.min.js'), fetched.join())
  })

  test('logs an error about a model that preload waits for forever', async () => {
    const { page, messages } = await runSketch(
      browser,
      server,
      [p5Versions['1.11'], addon],
      `function preload() { loadWarpModel('${folder}/words.glb') }
      function setup() { window.isSetUp = true }`,
    )
    assert.equal(await page.evaluate('window.isSetUp'), undefined)
    await leavePage(page)
    assert.deepEqual(
      messages.map((text) =>
        /^(uncaught|\s*🌸 p5\.js says): loadWarpModel: /.exec(text)?.[1].trim(),
      ),
      ['🌸 p5.js says', 'uncaught'],
    )
  })
})

test("'warpjet/p5' as a module fetches the mesh module on first use", async () => {
  assert.match(readFileSync(path('/dist/p5.warpjet.min.js'), 'utf8'), /import\(\w+\)/)
  const { page, messages } = await runSketch(
    browser,
    server,
    [p5Versions['2.x']],
    `import '/dist/p5.js'
    const hasFetchedMesh = () => performance.getEntriesByType('resource').some(({ name }) => name.endsWith('/meshes.js'))
    window.report = [hasFetchedMesh()]
    new p5((p) => {
      p.setup = async () => {
        const tip = await p.loadWarpModel('${folder}/plain.glb')
        report.push(hasFetchedMesh(), tip.vertices.length)
        window.done = true
      }
    })`,
    'module',
  )
  assert.deepEqual(await page.evaluate('report'), [false, true, 3])
  await leavePage(page)
  assert.deepEqual(messages, [])
})
