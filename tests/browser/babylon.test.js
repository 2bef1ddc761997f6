// 'warpjet/babylon' in a page: a motion that a matrix can do, done by a warp and by Babylon.js itself, is the same picture.
import assert from 'node:assert/strict'
import { mkdirSync, writeFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { build } from 'vite'
import { launchBrowser, openPage } from './support/browser.js'
import { servePages } from './support/server.js'
import { differing } from './support/three/pixels.js'

const root = fileURLToPath(new URL('../../', import.meta.url))
const project = '.build/babylon'

const code = `
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { ArcRotateCamera } from '@babylonjs/core/Cameras/arcRotateCamera.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js'
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { Matrix, Vector3, Quaternion } from '@babylonjs/core/Maths/math.vector.js'
import { MeshBuilder } from '@babylonjs/core/Meshes/meshBuilder.js'
import { Scene } from '@babylonjs/core/scene.js'
import { BabylonWarp } from 'warpjet/babylon'

const size = 96
const motion = Matrix.Compose(
  Vector3.One(), Quaternion.FromEulerAngles(0.4, 0.7, -0.3), new Vector3(0.2, 0.1, -0.15))
const m = motion.m

const offset = ({ glsl, position, millis, uniforms }) =>
  uniforms.linear.mult(position).sub(position).add(uniforms.shift.mult(millis.div(1000)))

const canvas = document.body.appendChild(document.createElement('canvas'))
canvas.width = canvas.height = size
const engine = new Engine(canvas, false, { preserveDrawingBuffer: true })

window.draw = async (kind, way) => {
  const scene = new Scene(engine)
  const camera = new ArcRotateCamera('camera', 0.7, 1.1, 4, Vector3.Zero(), scene)
  camera.minZ = 0.1
  new HemisphericLight('sky', new Vector3(0, 1, 0), scene).intensity = 0.3
  const sun = new DirectionalLight('sun', new Vector3(-0.5, -1, -0.6), scene)
  sun.position = new Vector3(2, 4, 3)
  const ground = MeshBuilder.CreateGround('ground', { width: 8, height: 8 }, scene)
  ground.position.y = -1
  const knot = MeshBuilder.CreateTorusKnot('knot', { radius: 0.5, tube: 0.18, radialSegments: 64, tubularSegments: 12 }, scene)
  const material = kind === 'PBR' ? new PBRMaterial('pbr', scene) : new StandardMaterial('standard', scene)
  if (kind === 'PBR') Object.assign(material, { metallic: 0.1, roughness: 0.5 })
  knot.material = material
  if (way === 'moved') {
    knot.setPivotMatrix(Matrix.Identity())
    motion.decompose(knot.scaling, (knot.rotationQuaternion = new Quaternion()), knot.position)
  }
  if (way !== 'moved' && way !== 'still') {
    const warp = new BabylonWarp(material, offset, {
      uniforms: { linear: [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]], shift: [0, 0, 0] },
    })
    if (way === 'without its normals') {
      const { getCustomCode } = warp
      warp.getCustomCode = (...args) => {
        const code = getCustomCode.apply(warp, args)
        const text = code?.CUSTOM_VERTEX_UPDATE_NORMAL.replaceAll('normalUpdated = warpjetTurned;', '')
        return code && { ...code, CUSTOM_VERTEX_UPDATE_NORMAL: text }
      }
      material.markDirty(true)
    }
    warp.values.shift = new Vector3(m[12], m[13], m[14])
    warp.millis = 1000
  }
  await scene.whenReadyAsync()
  for (let i = 0; i < 3; i++) {
    engine.beginFrame()
    scene.render()
    engine.endFrame()
  }
  const pixels = await engine.readPixels(0, 0, size, size)
  scene.dispose()
  return [...new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.byteLength)]
}
document.title = 'ready'
`

let browser, pages, page, messages
before(async () => {
  mkdirSync(`${root}${project}`, { recursive: true })
  writeFileSync(`${root}${project}/page.js`, code)
  await build({
    configFile: false,
    logLevel: 'error',
    root: `${root}${project}`,
    base: './',
    build: {
      outDir: 'dist',
      minify: false,
      target: 'es2022',
      rolldownOptions: {
        input: `${root}${project}/page.js`,
        output: { entryFileNames: 'page.js' },
      },
    },
  })
  browser = await launchBrowser()
  pages = await servePages()
  const html = `<!doctype html><body><script type="module" src="/${project}/dist/page.js"></script>`
  ;({ page, messages } = await openPage(browser, pages.page(html)))
  await page
    .waitForFunction(() => document.title === 'ready')
    .catch((error) => {
      throw new Error(`${error.message}\n${messages.join('\n')}`)
    })
})
after(async () => {
  await browser.close()
  await pages.close()
})

const draw = (...what) => page.evaluate((what) => draw(...what), what)

for (const kind of ['Standard', 'PBR'])
  test(`${kind}Material`, async () => {
    const [still, moved, warped, unlit] = [
      await draw(kind, 'still'),
      await draw(kind, 'moved'),
      await draw(kind, 'warped'),
      await draw(kind, 'without its normals'),
    ]
    assert.ok(differing(still, moved) > 300, `${differing(still, moved)} pixels are moved`)
    assert.equal(differing(warped, moved), 0)
    assert.ok(differing(unlit, moved) > 100, `${differing(unlit, moved)} differ without normals`)
    assert.deepEqual(
      messages.filter((text) => !text.startsWith('BJS - ')),
      [],
    )
  })
