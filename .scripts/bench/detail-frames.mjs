// npm run bench -- detail-frames [--host p5] [--warp name] [--normals vertex]: compares frames of meshes with the option `detail`, updates
// included, with frames of a uniformly subdivided mesh of the same error: in three.js and p5 on WebGL in software, at 600 x 600 pixels,
// for the warps of `npm run report -- detail`.
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
 * Returns into how many pieces each side must be split so that the uniform mesh has the same error as the divided one in the first frame.
 */
function countPieces(mesh, warp, uniforms, distance, size) {
  const random = randomNumbers(7)
  const place = new THREE.Vector3().setFromSphericalCoords(distance, 1.1, 0)
  const view = viewFrom(place, size)
  const warpPositions = (vertices) => warp.evaluate(vertices, { uniforms }).positions
  const divided = createDetail(mesh, warp)
  divided.update(view, { uniforms })
  const all = chooseTriangles(random, divided, Infinity)
  const error = robustMax(screenErrors(divided, warpPositions, view, all))
  divided.dispose()
  return countUniformPieces(mesh, warpPositions, view, error, random)
}

/** Takes the place of node:fs in the pages. */
const imports = { 'node:fs': '/tests/support/browser/three/detail/page-fs.js' }

/** Maps a name → a function that opens a page of that host: { page, close() }. */
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

/** Returns the cases: [{ title, settings }], where `settings` are for `measureFrames` in the page. */
async function createCases(chosen) {
  // The lotus has a `param`, which `warp` of three.js does not support.
  const warps = (await galleryWarps()).filter(
    ({ name }) => name !== 'lotus' && name.includes(chosen),
  )
  return warps.flatMap(({ name, warp, sizes, uniforms }) =>
    shapes.map((shape) => {
      const size = Math.max(...sizes)
      const distance = 3.2 * size
      const scaled = scale(meshes[shape], sizes)
      const pieces = countPieces(scaled, warp, uniforms, distance, size)
      const mesh = Object.fromEntries(Object.entries(scaled).map(([key, list]) => [key, [...list]]))
      return {
        title: `${name}, ${shape}`,
        settings: { name, mesh, pieces, sizes, uniforms, distance },
      }
    }),
  )
}

async function measureRow(page, settings) {
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
        rows[title] = await measureRow(page, { ...settings, normals: values.normals, moves })
        say(`${host}, ${title}: ${rows[title].ratio}`)
      }
      console.table(rows)
      const ratio = median(Object.values(rows).map((row) => row.ratio))
      say(`${host}, ${moves ? 'the surface moves, too' : 'the camera moves'}: median ${ratio}.`)
    }
    await close()
  }
  say(`Load of the machine: ${loadavg()[0].toFixed(1)}.`)
}
