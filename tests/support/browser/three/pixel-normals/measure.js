// Compares drawn normals with exact ones at each pixel. The first parameter describes a renderer: `draw(scene, camera)` returns a picture,
// four floats per pixel from the bottom left; `normalMaterial` makes a material that draws normals as colours, which `decode` converts to
// those of WebGLRenderer; `attributeMaterial` makes a material that draws the attribute `shownAttribute`.
import * as THREE from 'three'
import { addSurfaceVariation, warp } from 'warpjet/three'
import { degreesBetween, exactVertex, makeMover, quantile } from './exact.js'
import { makeNormalMap } from './pictures.js'
import { attributeNames, camera, kinds, makeObject, readUnwarped, size } from './scenes.js'
import { heights, warps } from './warps.js'

/**
 * Draws a warped object and measures the errors of its normals. `map` is the direction in a normal map, in the frame of the vertex
 * tangents.
 */
export async function measure(
  { draw, decode = (picture) => picture, normalMaterial, attributeMaterial },
  {
    kind = 'plain',
    shape = 'sphere',
    name,
    normals = 'pixel',
    side = 'FrontSide',
    space,
    isBehind,
    map,
  },
) {
  const offset = shape === 'plane' ? heights[name] : warps[name]
  const options = { side: THREE[side] }
  const { object, geometry } = makeObject(
    kind,
    shape,
    normalMaterial({ ...options, ...(map && { normalMap: makeNormalMap(map) }) }),
  )
  const varies = /flag|blob/.test(name)
  if (varies) await addSurfaceVariation(geometry)
  if (map) geometry.computeTangents()
  const scene = new THREE.Scene()
  scene.add(object)
  const view = camera()
  if (isBehind) {
    view.position.z = -8
    view.lookAt(0, 0, 0)
    view.updateMatrixWorld()
  }
  const warped = warp(object, offset, { normals, fadeNoise: false, ...(space && { space }) })
  const shown = decode(await draw(scene, view))
  object.material = attributeMaterial(options)
  const drawnAttributes = {}
  for (const attributeName of attributeNames) {
    if (!geometry.attributes[attributeName] && !(varies && attributeName.endsWith('Gradient')))
      continue
    const all = new Float32Array(4 * object.geometry.attributes.position.count)
    const numbers = readUnwarped(kind, geometry, attributeName)
    all.set(space === 'world' ? transformToWorld(attributeName, numbers, object) : numbers)
    object.geometry.setAttribute('shownAttribute', new THREE.BufferAttribute(all, 4))
    drawnAttributes[attributeName] = await draw(scene, view)
  }
  warped.dispose()
  return compare({ object, kind, view, offset, shown, drawnAttributes, side, map, space })
}

/** Returns the matrix from the space of the warp to view space, for a pixel's column: instances are on the left and on the right. */
function getMatrix({ object, kind, view, space }, column) {
  const matrix = view.matrixWorldInverse.clone()
  if (space === 'world') return matrix
  matrix.multiply(object.matrixWorld)
  const { matrices } = kinds[kind]
  return matrices ? matrix.multiply(matrices[column < size / 2 ? 0 : 1]) : matrix
}

/** Transforms an attribute, with four numbers per vertex, to world space, for warps in that space. */
function transformToWorld(attributeName, numbers, { matrixWorld }) {
  const normalMatrix = new THREE.Matrix3().getNormalMatrix(matrixWorld)
  const linear = new THREE.Matrix3().setFromMatrix4(matrixWorld)
  const transforms = {
    position: (vector) => vector.applyMatrix4(matrixWorld),
    normal: (vector) => vector.applyMatrix3(normalMatrix).normalize(),
    tangent: (vector) => vector.applyMatrix3(linear),
  }
  const vector = new THREE.Vector3()
  for (let i = 0; transforms[attributeName] && i < numbers.length; i += 4)
    transforms[attributeName](vector.fromArray(numbers, i)).toArray(numbers, i)
  return numbers
}

function compare(all) {
  const { offset, shown, drawnAttributes, side, map } = all
  const move = makeMover(offset)
  const angles = []
  let [skipped, facing] = [0, 0]
  for (let i = 0; i < 4 * size * size; i += 4) {
    if (shown[i + 3] === 0 || drawnAttributes.position[i + 3] === 0) continue
    const read = (attributeName, count) =>
      Array.from((drawnAttributes[attributeName] ?? []).slice(i, i + count))
    const [x, y, z, length] = read('normal', 4)
    const normal = [x, y, z].map((k) => (k * length) / Math.hypot(x, y, z))
    const gradients = attributeNames
      .filter((attributeName) => attributeName.endsWith('Gradient'))
      .map((attributeName) => (drawnAttributes[attributeName] ? read(attributeName, 3) : [0, 0, 0]))
    const tangent = map && read('tangent', 4)
    const vertex = { position: read('position', 3), normal, uv: read('uv', 2), gradients, tangent }
    const exact = exactVertex(move, vertex)
    if (!exact) {
      skipped++
      continue
    }
    const matrix = getMatrix(all, ((i / 4) % size) + 0.5)
    const expected = new THREE.Vector3(...exact.normal).applyNormalMatrix(
      new THREE.Matrix3().getNormalMatrix(matrix),
    )
    if (map) {
      const tangentInView = new THREE.Vector3(...exact.tangent).transformDirection(matrix)
      const bitangent = new THREE.Vector3()
        .crossVectors(expected, tangentInView)
        .multiplyScalar(tangent[3])
        .normalize()
      expected
        .multiplyScalar(map[2])
        .addScaledVector(tangentInView, map[0])
        .addScaledVector(bitangent, map[1])
    }
    const colour = [0, 1, 2].map((k) => 2 * shown[i + k] - 1)
    if (colour[2] > 0) facing++
    const angle = degreesBetween(colour, expected.toArray())
    // The normal of a back face may be reversed.
    angles.push(side === 'FrontSide' ? angle : Math.min(angle, 180 - angle))
  }
  return {
    covered: angles.length + skipped,
    skipped,
    facing: facing / angles.length,
    median: quantile(angles, 0.5),
    max: quantile(angles, 0.999),
    finite: angles.every(Number.isFinite) && shown.every(Number.isFinite),
  }
}
