// npm run bench -- detail-frames [--warp name] [--normals vertex]: compares frames of meshes with the option `detail`, updates included,
// with frames of a uniformly subdivided mesh of the same error: in three.js on WebGL in software, at 600 x 600 pixels, for the warps
// of `npm run report -- detail`.
import { readdirSync } from 'node:fs'
import { loadavg } from 'node:os'
import { parseArgs } from 'node:util'
import * as THREE from 'three'
import { createDetail } from '../../dist/detail.js'
import { launchBrowser } from '../../tests/support/browser/browser.js'
import { threePagesIn } from '../../tests/support/browser/three/open.js'
import { screenErrors } from '../../tests/support/screen-error.js'
import { randomNumbers } from '../../tests/support/three-meshes.js'
import { path } from '../lib/files.mjs'
import { median } from '../lib/median.mjs'
import { say } from '../lib/terminal.mjs'
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

async function measureAll(page, warps, normals) {
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
      const results = {}
      for (const moves of [false, true])
        results[moves] = await page.evaluate((settings) => measureFrames(settings), {
          name,
          mesh: plainMesh,
          ...{ pieces, sizes, uniforms, normals, distance, moves },
        })
      const [still, moving] = [results.false, results.true]
      rows[`${name}, ${shape}`] = {
        triangles: still.triangles.divided,
        uniform: still.triangles.uniform,
        'ms, camera moves': round(still.divided),
        'ms, uniform': round(still.uniform),
        ratio: round(still.ratio),
        'ms, surface moves': round(moving.divided),
        'ms, uniform ': round(moving.uniform),
        'ratio ': round(moving.ratio),
      }
      say(`${name}, ${shape}: ${still.ratio.toFixed(2)} ${moving.ratio.toFixed(2)}`)
    }
  return rows
}

const round = (x) => Number(x.toFixed(2))

export async function measure(args) {
  const { values } = parseArgs({
    args,
    options: {
      warp: { type: 'string', default: '' },
      normals: { type: 'string', default: 'vertex' },
    },
  })
  // The lotus has a `param`, which `warp` of three.js does not support.
  const warps = (await galleryWarps()).filter(
    ({ name }) => name !== 'lotus' && name.includes(values.warp),
  )
  const pages = await threePagesIn(await launchBrowser())
  const imports = { 'node:fs': '/tests/support/browser/three/detail/page-fs.js' }
  const { page } = await pages.open('three', 'detail/page-frames.js', imports)
  await page.evaluate((folders) => startFrames(folders), readdirSync(path('examples')))
  const rows = await measureAll(page, warps, values.normals)
  await pages.close()
  console.table(rows)
  const medianOf = (key) => median(Object.values(rows).map((row) => row[key])).toFixed(2)
  say(
    `Medians: ${medianOf('ratio')} if the camera moves, ${medianOf('ratio ')} if the surface moves, too.`,
  )
  say(`Load of the machine: ${loadavg()[0].toFixed(1)}.`)
}
