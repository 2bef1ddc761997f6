// Materials with the same displacement share the warp that `exactNormals` makes of it, and keep their own uniforms and options.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { threePages } from '../support/browser/three/open.js'

let pages
before(async () => (pages = await threePages()))
after(() => pages.close())

/** The name of the function as which exactNormals passes a displacement to the front end. */
const functionName = 'warpjetMoved'

/** Returns the result of `code`, which can draw slopes z = a x, and count how often their source was passed to the front end. */
async function run(code) {
  const { page, messages } = await pages.listing(`
    let sources = 0
    const { encode } = TextEncoder.prototype
    TextEncoder.prototype.encode = function (text) {
      if (text.includes('${functionName}')) sources++
      return encode.call(this, text)
    }
    const THREE = await import('three/webgpu')
    window.requestIdleCallback = () => {}
    const { exactNormals } = await import('warpjet/three/webgpu')
    const { float, mx_noise_float, normalView, positionLocal, uniform, vec3 } = THREE.TSL
    const renderer = new THREE.WebGPURenderer({ forceWebGL: true })
    await renderer.init()
    const target = new THREE.RenderTarget(8, 8, { type: THREE.FloatType })
    const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 10)
    camera.position.z = 5
    /** Draws a slope and returns the x of its normal. */
    async function draw(slope, options, added = float(0)) {
      const material = new THREE.MeshBasicNodeMaterial({ side: THREE.DoubleSide })
      material.positionNode = positionLocal.add(vec3(0, 0, positionLocal.x.mul(slope).add(added)))
      material.colorNode = normalView.mul(0.5).add(0.5)
      const mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), exactNormals(material, options))
      renderer.setRenderTarget(target)
      renderer.render(new THREE.Scene().add(mesh), camera)
      const [x] = await renderer.readRenderTargetPixelsAsync(target, 4, 4, 1, 1)
      return 2 * x - 1
    }
    window.result = await (async () => { ${code} })()`)
  await page.waitForFunction(() => window.result, null, { timeout: 30_000 })
  assert.deepEqual(messages, [])
  return page.evaluate(() => window.result)
}

/** The x of the normal (-a, 0, 1) of z = a x. */
const slopeNormal = (a) => -a / Math.hypot(a, 1)

test('the source of a displacement is read once, and each material has its own uniforms', async () => {
  const { normals, counts } = await run(`
    const normals = [], counts = []
    for (const slope of [0.5, -1, 2]) {
      normals.push(await draw(uniform(slope), { normals: 'vertex' }))
      counts.push(sources)
    }
    return { normals, counts }`)
  assert.deepEqual(counts, [1, 1, 1])
  ;[0.5, -1, 2].forEach((slope, i) =>
    assert.ok(Math.abs(normals[i] - slopeNormal(slope)) < 1e-3, `${normals[i]}`),
  )
})

test('another displacement and another option are read again', async () => {
  const { normals, counts } = await run(`
    const normals = [], counts = []
    for (const [slope, option] of [[uniform(0.5), 'vertex'], [uniform(0.5), 'pixel'], [float(-1), 'vertex']]) {
      normals.push(await draw(slope, { normals: option }))
      counts.push(sources)
    }
    return { normals, counts }`)
  assert.deepEqual(counts, [1, 2, 3])
  ;[0.5, 0.5, -1].forEach((slope, i) =>
    assert.ok(Math.abs(normals[i] - slopeNormal(slope)) < 1e-3, `${normals[i]}`),
  )
})

test('the order in which three.js writes functions does not matter', async () => {
  const { normals, counts } = await run(`
    const normals = [], counts = []
    for (const slope of [0.5, -1]) {
      const noise = mx_noise_float(positionLocal.mul(3)).mul(uniform(0))
      normals.push(await draw(uniform(slope), { normals: 'vertex' }, noise))
      counts.push(sources)
    }
    return { normals, counts }`)
  assert.deepEqual(counts, [1, 1])
  ;[0.5, -1].forEach((slope, i) =>
    assert.ok(Math.abs(normals[i] - slopeNormal(slope)) < 1e-3, `${normals[i]}`),
  )
})
