// Draws web/docs/detail.webp: four warped shapes, in the upper row with their own triangles, in the lower row with the option `detail`.
import teapot from 'teapot'
import { angleWeightedNormals, createMesh, fit, frontUVs, toScreen } from '../../web/models/mesh.js'
import { weld } from '../../web/models/subdivide.js'

/** The size of each picture. */
const size = 300
const maxBytes = 60_000

const html = `<!doctype html>
<script src="node_modules/p5/lib/p5.min.js"></script>
<script src="dist/p5.warpjet.min.js"></script>
<script src="dist/warpjet.deformers.min.js"></script>
<script>
const cases = [
  {
    offset: () => warpjet.bend({ axis: 'z', along: 'y', from: -0.5, to: 0.5, angle: 1.2 }),
    draw: () => (rotateX(-0.4), rotateY(-0.5), box(120)),
  },
  {
    offset: () => warpjet.twist({ axis: 'y', length: 1, angle: 2 }),
    draw: () => (rotateX(-0.45), rotateY(0.3), box(120)),
  },
  {
    offset: () => ({ glsl, position }) => {
      const looseness = position.x().add(0.5)
      const wave = position.x().mult(11).add(position.y().mult(3)).sin()
      return glsl.vec3(0, 0, wave.mult(looseness).mult(30))
    },
    draw: () => (rotateX(-0.35), rotateY(0.5), plane(210, 140)),
  },
  {
    offset: () => warpjet.twist({ axis: 'y', length: 200, angle: 0.6 }),
    detail: { tolerance: 1, curved: true },
    draw: () => (translate(-165, 45), rotateX(-0.3), rotateY(0.4), scale(3.4), model(coarseTeapot)),
  },
]
const colors = ['#ff8a5b', '#43c6ac']
let coarseTeapot
function setup() {
  pixelDensity(1)
  createCanvas(${size}, ${size}, WEBGL)
  noStroke()
  noLoop()
}
let scene = () => {}
function draw() {
  background('#151823')
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)
  specularMaterial(90)
  shininess(40)
  scene()
  window.done = true
}
async function drawAll({ positions, normals, uvs, indices }, maxBytes) {
  const splitIntoTriples = (list) => list.flatMap((_, i) => (i % 3 ? [] : [list.slice(i, i + 3)]))
  coarseTeapot = new p5.Geometry(1, 1, function () {
    const vectors = (list) => splitIntoTriples(list).map((xyz) => new p5.Vector(...xyz))
    Object.assign(this, { vertices: vectors(positions), vertexNormals: vectors(normals), uvs })
    Object.assign(this, { faces: splitIntoTriples(indices), gid: 'coarseTeapot' })
  })
  const sheet = Object.assign(document.createElement('canvas'), { width: 4 * width, height: 2 * height })
  const context = sheet.getContext('2d')
  for (const [column, { offset, detail = 1, draw }] of cases.entries())
    for (const [row, options] of [{}, { detail }].entries()) {
      const warp = createWarp(offset(), options)
      scene = () => (fill(colors[row]), warp(), draw())
      await redraw()
      context.drawImage(document.querySelector('canvas'), column * width, row * height)
    }
  for (let quality = 0.9; quality > 0.1; quality -= 0.05) {
    const dataUrl = sheet.toDataURL('image/webp', quality)
    // Base64 has 4 characters per 3 bytes.
    if (dataUrl.length * 0.75 < maxBytes) return dataUrl.split(',')[1]
  }
}
</script>`

function createCoarseTeapot() {
  const { points, triangles } = weld(teapot.positions, teapot.cells)
  const normals = angleWeightedNormals(points, triangles)
  const mesh = toScreen(fit(createMesh({ points, normals, uvs: frontUVs(points), triangles })))
  return Object.fromEntries(Object.entries(mesh).map(([name, list]) => [name, [...list]]))
}

/** Returns the picture as WebP. `url` is the URL of a gallery server. */
export async function drawDetail(page, url) {
  // Opens any file of the server, because the document that setContent writes keeps the origin from which relative script URLs resolve.
  await page.goto(`${url}recorder.js`)
  await page.setContent(html)
  await page.waitForFunction(() => window.done, null, { timeout: 240_000 })
  const args = [createCoarseTeapot(), maxBytes]
  return Buffer.from(await page.evaluate((list) => window.drawAll(...list), args), 'base64')
}
