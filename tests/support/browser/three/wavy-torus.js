// A torus whose vertices a warp moves along their normals by a wave over uv, compared with vertices moved in double precision.
import * as THREE from 'three/webgpu'
import { warp } from 'warpjet/three'
import { countDiffering } from './pixels.js'
import * as scenes from './scenes.js'
import { draw, rendererFor } from './webgpu-renderer.js'

const [radius, tube] = [0.7, 0.3]

/** The distance by which a point of the torus moves; `u` goes around the ring, `v` around the tube. */
const height = (u, v) => 0.12 * Math.sin(12 * Math.PI * u) * Math.cos(8 * Math.PI * v)

const offset = ({ normal, uv }) =>
  normal.mult(
    uv
      .x()
      .mult(12 * Math.PI)
      .sin()
      .mult(
        uv
          .y()
          .mult(8 * Math.PI)
          .cos(),
      )
      .mult(0.12),
  )

function pointAt(u, v) {
  const [a, b] = [2 * Math.PI * u, 2 * Math.PI * v]
  const r = tube + height(u, v)
  return new THREE.Vector3(
    (radius + r * Math.cos(b)) * Math.cos(a),
    (radius + r * Math.cos(b)) * Math.sin(a),
    r * Math.sin(b),
  )
}

/** Computes the normal by finite differences. */
function normalAt(u, v) {
  const step = 1e-5
  const tangent = pointAt(u + step, v).sub(pointAt(u - step, v))
  return tangent.cross(pointAt(u, v + step).sub(pointAt(u, v - step))).normalize()
}

function makeTorus({ isMoved, hasTangents }) {
  const geometry = new THREE.TorusGeometry(radius, tube, 64, 160)
  const { uv, position, normal } = geometry.attributes
  if (isMoved)
    for (let i = 0; i < uv.count; i++) {
      // Three's u goes around the ring, its v around the tube.
      const [u, v] = [uv.getX(i), uv.getY(i)]
      position.setXYZ(i, ...pointAt(u, v))
      normal.setXYZ(i, ...normalAt(u, v))
    }
  if (hasTangents) {
    geometry.computeTangents()
    geometry.setAttribute('uv1', uv.clone())
  }
  return geometry
}

/**
 * Counts differing and moved pixels. With `hasTangents`, the geometry also has a second uv, and the material reads tangents and the second
 * uv.
 */
export async function compare(backend, { hasTangents, exact = true }, addSurfaceVariation) {
  const renderer = await rendererFor(backend)
  const ao = new THREE.DataTexture(new Uint8Array([200, 255, 220, 255]), 1, 1)
  ao.channel = 1
  ao.needsUpdate = true
  const material = new THREE.MeshPhysicalMaterial(
    hasTangents
      ? { normalMap: scenes.shapes['normal map']().material.normalMap, aoMap: ao }
      : { color: 0xff9060 },
  )
  const geometry = makeTorus({ hasTangents })
  if (exact) await addSurfaceVariation(geometry)
  const object = new THREE.Mesh(geometry, material)
  warp(object, offset, exact ? {} : { surfaceVariation: false })
  const pictures = []
  for (const mesh of [
    object,
    new THREE.Mesh(makeTorus({ isMoved: true, hasTangents }), material),
    new THREE.Mesh(makeTorus({ hasTangents }), material),
  ])
    pictures.push(await draw(renderer, scenes.sceneOf(mesh, 'directional')))
  const [shown, expected, before] = pictures
  return { differing: countDiffering(shown, expected), moved: countDiffering(expected, before) }
}
