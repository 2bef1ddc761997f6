// Sketches in p5.strands on WEBGPU with exactNormals: compares the light with that of meshes that were moved in double precision, and
// whose normals are finite differences.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHost, p5HostsInThisRun, runSketch } from '../support/browser/sketch.js'
import { lifts, meshesByHand, redAt, sphere } from './strands-oracle.js'
import { sketches } from './strands-sketches.js'

const [, , scripts] = p5HostsInThisRun.find(([, renderer]) => renderer === 'WEBGPU') ?? []
const only = process.env.WARPJET_ONLY ?? ''
const entries = Object.entries(sketches).filter(([name]) => name.includes(only))

/** The default distance of p5's camera. */
const eye = 800

const setup = `
  p5.prototype.millis = () => 1700
  Object.defineProperty(window, 'millis', { value: () => 1700 })
  const geometryOf = ({ vertices, normals, uvs, faces }, name) =>
    new p5.Geometry(1, 1, function () {
      this.gid = name
      this.vertices = vertices.map((p) => createVector(...p))
      this.vertexNormals = normals.map((n) => createVector(...n))
      this.uvs = uvs
      this.faces = faces
    })
  warps.ball = geometryOf(${JSON.stringify(sphere())}, 'ball')
  warps.heights = createImage(16, 16)
  warps.heights.loadPixels()
  const reds = ${JSON.stringify(Array.from({ length: 256 }, (_, i) => redAt(i % 16, i >> 4)))}
  reds.forEach((red, i) => warps.heights.pixels.set([red, 0, 0, 255], 4 * i))
  warps.heights.updatePixels()
  warps.lifts = createStorage(new Float32Array(${JSON.stringify(lifts)}))
  warps.places = createStorage(
    [0, 1, 2].map((i) => ({ height: 0.1 * (i + 1), place: createVector((i - 1) * 1.25, 0, 0.25 * i) })),
  )`

const shaderCode = ({ hooks }) => `baseMaterialShader().modify(() => { ${hooks} })`

const lit = `noStroke(); ambientLight(60); fill(255); directionalLight(255, 0, 0, 1, 0, -0.3)
  directionalLight(0, 255, 0, 0, 1, -0.3); directionalLight(0, 0, 255, 0, 0, -1);`

if (scripts) {
  const { browser, server } = await openHost('WEBGPU')
  const allScripts = [...scripts, '/dist/p5.warpjet.min.js', '/dist/warpjet.glsl.min.js']

  test('sketches in p5.strands have the light of meshes that were moved in double precision', async (t) => {
    const problems = []
    for (const [name, sketch] of entries.filter(([, { rejected }]) => !rejected)) {
      const meshes = meshesByHand(sketch, eye)
      const model = `rotateX(0.4); scale(40); model(warps.ball, ${sketch.instances ?? 1})`
      const images = await drawScenes(browser, server, allScripts, {
        renderer: 'WEBGPU',
        setup: `${setup}
          warps.plain = ${shaderCode(sketch)}
          warps.own = exactNormals(warps.plain)
          warps.byHand = ${JSON.stringify(meshes)}.map((mesh, i) => geometryOf(mesh, 'hand' + i))`,
        scenes: {
          own: `${lit} shader(warps.own); ${model}`,
          plain: `${lit} shader(warps.plain); ${model}`,
          byHand: `${lit} warps.byHand.forEach((geometry) => model(geometry))`,
        },
      }).catch((error) => void problems.push(`${name}: ${error.message}`))
      if (!images) continue
      const { length } = litPixels(images.byHand)
      const differing = differingPixels(images.own, images.byHand, 3)
      const plain = differingPixels(images.plain, images.byHand, 8)
      t.diagnostic(
        `${name}: ${differing} of ${length} pixels differ, ${plain} without exactNormals`,
      )
      if (!(differing < 0.01 * length && plain > 0.05 * length && length > 2000))
        problems.push(
          `${name}: ${differing} of ${length} pixels differ, ${plain} without exactNormals`,
        )
    }
    assert.deepEqual(problems, [])
  })

  test('sketches without exact normals stay as they are, with a message', async () => {
    for (const [name, sketch] of entries.filter(([, { rejected }]) => rejected)) {
      const { page, messages } = await runSketch(
        browser,
        server,
        allScripts,
        `const warps = {}
        async function setup() {
          await createCanvas(60, 60, WEBGPU)
          ${setup}
          const plain = ${shaderCode(sketch)}
          if (exactNormals(plain) !== plain) throw new Error('exactNormals returned another shader')
          window.done = true
        }`,
      )
      await leavePage(page)
      assert.equal(messages.length, 1, `${name}: ${messages.join()}`)
      assert.match(messages[0], /^exactNormals: the shader stays as it is\. /, name)
      assert.match(messages[0], sketch.rejected, name)
    }
  })
}
