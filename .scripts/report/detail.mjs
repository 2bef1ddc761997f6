// Measures the option `detail`: how far the triangles are from the warped surface, in pixels, and how many triangles there are.
import * as THREE from 'three'
import { createDetail } from '../../dist/detail.js'
import { quantile, screenErrors } from '../../tests/support/screen-error.js'
import { randomNumbers } from '../../tests/support/three-meshes.js'
import { say } from '../lib/terminal.mjs'
import { markdownTable } from '../reference/parts.mjs'
import {
  chooseTriangles,
  countUniformPieces,
  galleryWarps,
  meshes,
  robustMax,
  scale,
  viewFrom,
} from './detail/cases.mjs'
import { measurePops } from './detail/pops.mjs'

const cameraCount = 200
/** All triangles are measured for the first 10 cameras of each case, and 1,000 random ones for the others. */
const completeCameras = 10
const maxTriangles = 1000
/** The uniform mesh of the same error is determined for the first 3 cameras of each case. */
const comparedCameras = 3

/** Returns a view from a random direction, at 2 to 4.6 times half of the mesh's size. */
function randomView(random, halfSize) {
  const polar = Math.acos(2 * random() - 1)
  const direction = new THREE.Vector3().setFromSphericalCoords(1, polar, 2 * Math.PI * random())
  return viewFrom(direction.multiplyScalar(halfSize * (2 + 2.6 * random())), halfSize)
}

function measureCase(warp, mesh, sizes, uniforms) {
  const random = randomNumbers(7)
  const halfSize = Math.max(...sizes)
  const scaled = scale(mesh, sizes)
  const warpPositions = (vertices) => warp.evaluate(vertices, { uniforms }).positions
  const detail = createDetail(scaled, warp)
  const allErrors = []
  const triangleCounts = []
  // The number of triangles, relative to the uniform mesh of the same error.
  const ratios = []
  for (let i = 0; i < cameraCount; i++) {
    const view = randomView(random, halfSize)
    detail.update(view, { uniforms })
    const { positions, normals, indices } = detail
    const divided = {
      positions: positions.slice(),
      normals: normals.slice(),
      indices: indices.slice(),
    }
    const max = i < completeCameras ? Infinity : maxTriangles
    const errors = screenErrors(divided, warpPositions, view, chooseTriangles(random, divided, max))
    for (const error of errors) allErrors.push(error)
    triangleCounts.push(indices.length / 3)
    if (i >= comparedCameras) continue
    const pieces = countUniformPieces(scaled, warpPositions, view, robustMax(errors), random)
    ratios.push(indices.length / scaled.indices.length / pieces ** 2)
  }
  detail.dispose()
  return {
    quantile999: quantile(allErrors, 0.999),
    max: quantile(allErrors, 1),
    triangles: quantile(triangleCounts, 0.5),
    ratio: quantile(ratios, 0.5),
    ratios,
  }
}

const meshNames = Object.keys(meshes)

function describePops(all) {
  const sum = (key) => all.reduce((total, each) => total + each[key], 0)
  const max = (key) => Math.max(...all.map((each) => each[key])).toFixed(2)
  return `In ${sum('changes')} changes of the division, 99.9% of the points move by no more than ${max('pop999')} pixels. In ${sum('pops')} of these changes, a point moves by more than a pixel, the farthest by ${max('pop')}.`
}

export async function measure() {
  const results = {}
  for (const { name, warp, sizes, uniforms } of await galleryWarps()) {
    results[name] = meshNames.map((mesh) => ({
      ...measureCase(warp, meshes[mesh], sizes, uniforms),
      ...measurePops(warp, meshes[mesh], sizes, uniforms),
    }))
    say(`${name}: ${results[name].map(({ quantile999 }) => quantile999.toFixed(2)).join(' ')}`)
  }
  const all = Object.values(results).flat()
  const ratios = all.flatMap((each) => each.ratios)
  const countCases = (condition) => `${all.filter(condition).length} of ${all.length}`
  const table = (key, digits) =>
    markdownTable(
      ['warp', ...meshNames],
      Object.entries(results).map(([name, cells]) => [
        `\`${name}\``,
        ...cells.map((each) => each[key].toFixed(digits)),
      ]),
      true,
    )
  return {
    summary: `99.9% of the points are within a pixel in ${countCases(({ quantile999 }) => quantile999 <= 1)} cases, and all are within 1.5 pixels in ${countCases(({ max }) => max <= 1.5)}. In the median there are ${quantile(ratios, 0.5).toFixed(2)} times as many triangles as in the uniform mesh of the same error, and at most ${Math.max(...ratios).toFixed(2)} times as many.`,
    'nearly all': table('quantile999', 2),
    max: table('max', 2),
    triangles: table('triangles', 0),
    ratios: table('ratio', 2),
    pops: table('pop', 2),
    'pop summary': describePops(all),
  }
}
