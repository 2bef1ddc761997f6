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
import { threePagesIn } from '../../tests/support/browser/three/open.js'
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

/** Maps a name → a function that opens a page of that host in a browser → { page, close() }. */
const openHost = {
  async three(browser) {
    const pages = await threePagesIn(browser)
    const { page } = await pages.open('three', 'detail/page-frames.js', imports)
    return { page, close: pages.close }
  },
  async p5(browser) {
    const server = await servePages()
    const html = `<!doctype html><body>
      <script type="importmap">${JSON.stringify({ imports })}</script>
      <script src="${p5Versions['2.x']}"></script>
      <script type="module" src="/tests/support/browser/p5-detail/page-frames.js"></script>`
    const { page } = await openPage(browser, server.page(html))
    await page.waitForFunction(() => document.title === 'ready')
    return { page, close: server.close }
  },
}

/** Returns the frames of a case while the camera moves, and while the surface moves, too, as a row. */
async function measureRow(page, settings) {
  const measureMoving = (moves) =>
    page.evaluate((settings) => measureFrames(settings), { ...settings, moves })
  const [still, moving] = [await measureMoving(false), await measureMoving(true)]
  return {
    triangles: still.triangles.divided,
    uniform: still.triangles.uniform,
    'ms, camera moves': round(still.divided),
    'ms, uniform': round(still.uniform),
    ratio: round(still.ratio),
    'ms, surface moves': round(moving.divided),
    'ms, uniform ': round(moving.uniform),
    'ratio ': round(moving.ratio),
  }
}

async function measureAll(opened, warps, normals) {
  const rows = {}
  for (const { name, warp, sizes, uniforms } of warps)
    for (const shape of shapes) {
      const size = Math.max(...sizes)
      const distance = 3.2 * size
      const mesh = scale(meshes[shape], sizes)
      const pieces = countPieces(mesh, warp, uniforms, distance, size)
      const plainMesh = Object.fromEntries(
        Object.entries(mesh).map(([key, list]) => [key, [...list]]),
      )
      for (const [host, { page }] of Object.entries(opened)) {
        const settings = { name, mesh: plainMesh, pieces, sizes, uniforms, normals, distance }
        const row = await measureRow(page, settings)
        ;(rows[host] ??= {})[`${name}, ${shape}`] = row
        say(`${host}, ${name}, ${shape}: ${row.ratio} ${row['ratio ']}`)
      }
    }
  return rows
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
  // The lotus has a `param`, which `warp` of three.js does not support.
  const warps = (await galleryWarps()).filter(
    ({ name }) => name !== 'lotus' && name.includes(values.warp),
  )
  const browser = await launchBrowser()
  const opened = {}
  for (const host of hosts) {
    opened[host] = await openHost[host](browser)
    await opened[host].page.evaluate(
      (folders) => startFrames(folders),
      readdirSync(path('examples')),
    )
  }
  const rows = await measureAll(opened, warps, values.normals)
  for (const { close } of Object.values(opened)) await close()
  await browser.close()
  for (const host of hosts) {
    console.table(rows[host])
    const medianOf = (key) => median(Object.values(rows[host]).map((row) => row[key])).toFixed(2)
    say(
      `${host}, medians: ${medianOf('ratio')} if the camera moves, ${medianOf('ratio ')} if the surface moves, too.`,
    )
  }
  say(`Load of the machine: ${loadavg()[0].toFixed(1)}.`)
}
