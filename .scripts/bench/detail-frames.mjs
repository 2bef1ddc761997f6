// npm run bench -- detail-frames [--host p5] [--warp name] [--normals vertex]: compares frames of meshes with the option `detail`, updates
// included, with frames of uniformly subdivided meshes of the same error, for the warps of `npm run report -- detail`. three.js and p5 draw
// with WebGL in software, at 600 × 600 pixels.
import { readdirSync } from 'node:fs'
import { loadavg } from 'node:os'
import { parseArgs } from 'node:util'
import * as THREE from 'three'
import { createDetail } from '../../dist/detail.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { servePages } from '../../tests/support/browser/server.js'
import { p5Versions } from '../../tests/support/browser/sketch.js'
import { threePages } from '../../tests/support/browser/three/open.js'
import { screenErrors } from '../../tests/support/screen-error.js'
import { randomNumbers } from '../../tests/support/three-meshes.js'
import { path } from '../lib/files.mjs'
import { median } from '../lib/median.mjs'
import { Stop, say } from '../lib/terminal.mjs'
import {
  chooseTriangles,
  countUniformPieces,
  galleryWarps,
  meshes,
  robustMax,
  scale,
  viewFrom,
} from '../report/detail/cases.mjs'

const shapes = ['box', 'sphere', 'teapot']

/**
 * Returns into how many pieces each side must be split so that in the first frame the uniform mesh has the same error as the mesh that
 * `detail` divides.
 */
function countPieces(mesh, warp, uniforms, distance, halfSize) {
  const random = randomNumbers(7)
  const cameraPosition = new THREE.Vector3().setFromSphericalCoords(distance, 1.1, 0)
  const view = viewFrom(cameraPosition, halfSize)
  const warpPositions = (vertices) => warp.evaluate(vertices, { uniforms }).positions
  const divided = createDetail(mesh, warp)
  divided.update(view, { uniforms })
  const allTriangles = chooseTriangles(random, divided, Infinity)
  const error = robustMax(screenErrors(divided, warpPositions, view, allTriangles))
  divided.dispose()
  return countUniformPieces(mesh, warpPositions, view, error, random)
}

/** The import map of the pages, which have no node:fs. */
const imports = { 'node:fs': '/tests/support/browser/three/detail/page-fs.js' }

/** Maps the name of a host → a function that opens its page: { page, close() }. */
const openHost = {
  async three() {
    const pages = await threePages()
    const { page } = await pages.open('three', 'detail/page-frames.js', imports)
    return { page, close: pages.close }
  },
  async p5() {
    const server = await servePages()
    const browser = await launchBrowser()
    const html = `<!doctype html><body>
      <script type="importmap">${JSON.stringify({ imports })}</script>
      <script src="${p5Versions['2.x']}"></script>
      <script type="module" src="/tests/support/browser/p5-detail/page-frames.js"></script>`
    const { page } = await openPage(browser, server.page(html))
    await page.waitForFunction(() => document.title === 'ready')
    return { page, close: () => Promise.all([browser.close(), server.close()]) }
  },
}

/** Returns the cases for warps whose name contains `partOfName`: [{ title, settings }], with settings for `measureFrames` in the page. */
async function createCases(partOfName) {
  // The lotus has a `param`, which `warp` of three.js does not support.
  const warps = (await galleryWarps()).filter(
    ({ name }) => name !== 'lotus' && name.includes(partOfName),
  )
  return warps.flatMap(({ name, warp, sizes, uniforms }) =>
    shapes.map((shape) => {
      const halfSize = Math.max(...sizes)
      const distance = 3.2 * halfSize
      const scaled = scale(meshes[shape], sizes)
      const pieces = countPieces(scaled, warp, uniforms, distance, halfSize)
      const mesh = Object.fromEntries(Object.entries(scaled).map(([key, list]) => [key, [...list]]))
      return {
        title: `${name}, ${shape}`,
        settings: { name, mesh, pieces, sizes, uniforms, distance },
      }
    }),
  )
}

async function measureCase(page, settings) {
  const { triangles, divided, uniform, ratio } = await page.evaluate(
    (settings) => measureFrames(settings),
    settings,
  )
  return {
    triangles: triangles.divided,
    uniform: triangles.uniform,
    ms: round(divided),
    'ms, uniform': round(uniform),
    ratio: round(ratio),
  }
}

const round = (x) => Number(x.toFixed(2))

export async function measure(args) {
  const { values } = parseArgs({
    args,
    options: {
      host: { type: 'string' },
      warp: { type: 'string', default: '' },
      normals: { type: 'string', default: 'vertex' },
    },
  })
  const hosts = Object.keys(openHost).filter((host) => host === (values.host ?? host))
  if (!hosts.length)
    throw new Stop(`--host: expected ${Object.keys(openHost).join(' or ')}, got ${values.host}.`)
  const cases = await createCases(values.warp)
  for (const host of hosts) {
    const { page, close } = await openHost[host]()
    await page.evaluate((folders) => startFrames(folders), readdirSync(path('examples')))
    for (const moves of [false, true]) {
      const rows = {}
      for (const { title, settings } of cases) {
        rows[title] = await measureCase(page, { ...settings, normals: values.normals, moves })
        say(`${host}, ${title}: ${rows[title].ratio}`)
      }
      console.table(rows)
      const ratio = median(Object.values(rows).map((row) => row.ratio))
      say(
        `${host}, ${moves ? 'camera and surface move' : 'only the camera moves'}: median ${ratio}.`,
      )
    }
    await close()
  }
  say(`Load of the machine: ${loadavg()[0].toFixed(1)}.`)
}
