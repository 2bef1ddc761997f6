// Measures how far the drawn surface jumps when `createDetail` divides a mesh anew.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import * as THREE from 'three'
import { compileWarp } from 'warpjet'
import { createDetail } from 'warpjet/detail'
import { copyDivision, markPlaces, popsBetween } from '../support/pops.js'
import { quantile } from '../support/screen-error.js'

const twist = compileWarp(
  ({ glsl, position: p, uniforms }) => {
    const angle = p.y().mult(uniforms.turn)
    const [c, s] = [angle.cos(), angle.sin()]
    const x = p.x().mult(c).sub(p.z().mult(s))
    return glsl.vec3(x, p.y(), p.x().mult(s).add(p.z().mult(c))).sub(p)
  },
  { normals: false, uniforms: { turn: 1 } },
)
const bumps = compileWarp(
  ({ glsl, normal, position, millis }) =>
    normal.mult(glsl.simplex(position.mult(2).add(millis.div(1000))).mult(0.2)),
  { normals: false, surfaceVariation: false },
)

function arraysOf({ attributes, index }) {
  return {
    positions: attributes.position.array,
    normals: attributes.normal.array,
    indices: index.array,
  }
}
const box = arraysOf(new THREE.BoxGeometry(1.6, 1.6, 1.6))
const sphere = arraysOf(new THREE.SphereGeometry(1, 12, 8))

function viewFrom(distance, angle) {
  const camera = new THREE.PerspectiveCamera(60, 1, 0.1, 20)
  camera.position.setFromSphericalCoords(distance, 1.1, angle)
  camera.lookAt(0, 0, 0)
  camera.updateMatrixWorld()
  const { elements } = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse)
  return { matrix: elements, width: 400, height: 400 }
}

const frames = 60
/** The number of triangles of each division that are measured, at equal intervals. */
const measuredCount = 200

const choose = ({ indices }) =>
  Array.from({ length: measuredCount }, (_, i) =>
    Math.floor((i * indices.length) / 3 / measuredCount),
  )

/** Moves the camera and the inputs of the warp slowly. Returns the jumps of each change. */
function watch(mesh, warp, inputsAt, tolerance = 1) {
  const detail = createDetail(markPlaces(mesh), warp)
  const changes = []
  let division, before
  for (let frame = 0; frame < frames; frame++) {
    const uniforms = inputsAt(frame)
    const view = viewFrom(4 - frame / 50, frame / 100)
    const isChanged = detail.update(view, { uniforms, tolerance })
    if (isChanged) division = copyDivision(detail)
    const warpPositions = (vertices) => warp.evaluate(vertices, { uniforms }).positions
    const now = { division, warpPositions, view }
    if (isChanged && before) changes.push(popsBetween(before, now, choose))
    before = now
  }
  detail.dispose()
  return changes
}

test('jumps are measured between the same places of both divisions', () => {
  // A triangle whose sides along x and y rise by 0.125 and 0.25 in the middle, seen from the side, with 10 pixels per unit.
  const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0]
  const flat = { positions: corners, normals: corners, indices: [0, 1, 2] }
  const { positions, normals, colors } = markPlaces(flat)
  assert.deepEqual(colors, [0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1])
  const coarse = { positions, normals, colors, indices: [0, 1, 2] }
  const middles = { x: [0.5, 0, 0], y: [0, 0.5, 0], xy: [0.5, 0.5, 0] }
  const places = [...corners, ...middles.x, ...middles.y, ...middles.xy]
  const fine = {
    positions: places,
    normals: places,
    colors: Array.from({ length: 6 }, (_, v) => [0, places[3 * v], places[3 * v + 1], 1]).flat(),
    indices: [0, 3, 4, 3, 1, 5, 4, 5, 2, 3, 5, 4],
  }
  // A motion of the whole surface is no jump.
  const raiseBy =
    (all) =>
    ({ positions: p }) =>
      Float32Array.from(p, (number, i) =>
        i % 3 === 2 ? all + 0.5 * p[i - 2] * (1 - p[i - 2]) + p[i - 1] * (1 - p[i - 1]) : number,
      )
  // prettier-ignore
  const view = { matrix: [0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1], width: 20, height: 20 }
  const pops = popsBetween(
    { division: coarse, warpPositions: raiseBy(0), view },
    { division: fine, warpPositions: raiseBy(0.1), view },
  )
  // The middle of the longest side rises by the sum of both.
  assert.ok(Math.abs(quantile(pops, 1) - 3.75) < 1e-5, `${quantile(pops, 1)}`)
  assert.equal(quantile(pops, 0), 0)
})

test('jumps are as small as errors while camera and surface move slowly', (t) => {
  const cases = {
    box: [box, twist, (frame) => ({ turn: 1 + frame / 50 })],
    sphere: [sphere, bumps, (frame) => ({ millis: 16 * frame })],
  }
  for (const [name, given] of Object.entries(cases)) {
    const changes = watch(...given)
    const found = [0.999, 1].map((share) => quantile(changes.flat(), share))
    t.diagnostic(`${name}: ${found} pixels, ${changes.length} changes`)
    assert.ok(changes.length > 10, `${name}: ${changes.length} changes`)
    assert.ok(found[0] > 0.1 && found[0] <= 1 && found[1] <= 1.5, `${name}: ${found} pixels`)
    const coarse = quantile(watch(...given, 4).flat(), 0.999)
    assert.ok(coarse > 1, `${name}: ${coarse} pixels with a tolerance of 4`)
  }
})

test('small movements of the camera do not change the triangles', () => {
  for (const [mesh, warp, uniforms] of [
    [box, twist, { turn: 1 }],
    [sphere, bumps, { millis: 0 }],
  ]) {
    const detail = createDetail(mesh, warp)
    const tremble = () =>
      [3, 3.05, 3.1, 3.05].filter((distance) =>
        detail.update(viewFrom(distance, 0.5), { uniforms }),
      )
    tremble()
    assert.deepEqual(tremble(), [])
    detail.dispose()
  }
})
