// Compares shown normals with exact ones at each pixel. `draw(scene, camera)` returns a picture's numbers, four for each pixel from the
// bottom left; `normalMaterial` shows normals, and `seenMaterial` the attribute `seen`.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { addSurfaceVariation } from 'warpjet/three'
import { degreesBetween, exactNormal, mover, quantile } from './exact.js'
import { camera, kinds, objectFor, parts, seenOf, size } from './scenes.js'
import { heights, warps } from './warps.js'

export async function measure(
  { draw, normalMaterial, seenMaterial },
  {
    kind = 'plain',
    shape = 'sphere',
    name,
    normals = 'pixel',
    side = 'FrontSide',
    space,
    isBehind,
  },
) {
  const offset = shape === 'plane' ? heights[name] : warps[name]
  const { object, geometry } = objectFor(kind, shape, normalMaterial({ side: THREE[side] }))
  const varies = /flag|blob/.test(name)
  if (varies) await addSurfaceVariation(geometry)
  const scene = new THREE.Scene()
  scene.add(object)
  const view = camera()
  if (isBehind) {
    view.position.z = -8
    view.lookAt(0, 0, 0)
    view.updateMatrixWorld()
  }
  const warped = warp(object, offset, { normals, ...(space && { space }) })
  const shown = await draw(scene, view)
  object.material = seenMaterial({ side: THREE[side] })
  const seen = {}
  for (const part of parts) {
    if (!varies && part.endsWith('Gradient')) continue
    const numbers = seenOf(kind, geometry, part)
    const all = new Float32Array(4 * object.geometry.attributes.position.count)
    all.set(numbers)
    object.geometry.setAttribute('seen', new THREE.BufferAttribute(all, 4))
    object.geometry.attributes.seen.needsUpdate = true
    seen[part] = await draw(scene, view)
  }
  warped.dispose()
  return compare({ object, kind, view, offset, shown, seen, side })
}

function compare({ object, kind, view, offset, shown, seen, side }) {
  const move = mover(offset)
  const angles = []
  let skipped = 0
  for (let i = 0; i < 4 * size * size; i += 4) {
    if (shown[i + 3] === 0 || seen.position[i + 3] === 0) continue
    const at = (part, count) => Array.from((seen[part] ?? []).slice(i, i + count))
    const [x, y, z, length] = at('normal', 4)
    const normal = [x, y, z].map((k) => (k * length) / Math.hypot(x, y, z))
    const gradients = parts.slice(3).map((part) => (seen[part] ? at(part, 3) : [0, 0, 0]))
    const vertex = { position: at('position', 3), normal, uv: at('uv', 2), gradients }
    const exact = exactNormal(move, vertex)
    if (!exact) {
      skipped++
      continue
    }
    const matrix = new THREE.Matrix4().multiplyMatrices(view.matrixWorldInverse, object.matrixWorld)
    const { matrices } = kinds[kind]
    const column = ((i / 4) % size) + 0.5
    if (matrices) matrix.multiply(matrices[column < size / 2 ? 0 : 1])
    const expected = new THREE.Vector3(...exact).applyNormalMatrix(
      new THREE.Matrix3().getNormalMatrix(matrix),
    )
    const colour = [0, 1, 2].map((k) => 2 * shown[i + k] - 1)
    // Back faces show the other side. Of a coarse mesh these are not known by the normal: the colour decides.
    const angle = degreesBetween(colour, expected.toArray())
    angles.push(side === 'FrontSide' ? angle : Math.min(angle, 180 - angle))
  }
  return {
    covered: angles.length + skipped,
    skipped,
    median: quantile(angles, 0.5),
    most: quantile(angles, 0.999),
    finite: angles.every(Number.isFinite) && shown.every(Number.isFinite),
  }
}
