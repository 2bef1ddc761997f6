// Compares the normals that a material computes at each vertex with finite differences of the oracle along the surface.
import * as THREE from 'three'
import { addSurfaceVariation, exactNormals } from 'warpjet/three'
import { probe } from './probe.js'

export const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50)
camera.position.set(0.4, 1.2, 5)
camera.lookAt(0, 0, 0)

const { sin, cos, PI } = Math

/** Maps a name → a function that makes a geometry, and its surface: `at(u, v)` returns position, normal and uv. */
const shapes = {
  plane: {
    geometry: () => new THREE.PlaneGeometry(2, 2, 30, 30),
    at: (u, v) => ({ p: [2 * u - 1, 2 * v - 1, 0], n: [0, 0, 1], uv: [u, v] }),
  },
  blade: {
    geometry: () => new THREE.PlaneGeometry(0.3, 1, 2, 10),
    at: (u, v) => ({ p: [0.3 * (u - 0.5), v - 0.5, 0], n: [0, 0, 1], uv: [u, v] }),
  },
  sphere: {
    geometry: () => new THREE.SphereGeometry(1, 40, 24),
    at(u, v) {
      const n = [
        -cos(2 * PI * u) * sin(PI * (1 - v)),
        cos(PI * (1 - v)),
        sin(2 * PI * u) * sin(PI * (1 - v)),
      ]
      return { p: n, n, uv: [u, v] }
    },
  },
}

export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const unit = (a) => a.map((x) => x / Math.sqrt(dot(a, a)))
export const angle = (a, b) => (Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)) * 180) / PI
const transform = (p, matrix) => new THREE.Vector3(...p).applyMatrix4(matrix).toArray()

/** The matrix of the bone. */
const bone = new THREE.Matrix4().makeRotationZ(0.6).setPosition(0.2, 0.1, 0)
/** The motion of the morph target. */
const delta = [0.1, 0.2, 0.3]

function makeMesh({ shape, kind }, geometry, material) {
  if (shape === 'blade') return new THREE.InstancedMesh(geometry, material, 5)
  const { count } = geometry.attributes.position
  if (kind === 'morph') {
    const numbers = Float32Array.from({ length: 3 * count }, (_, i) => delta[i % 3])
    geometry.morphAttributes.position = [new THREE.BufferAttribute(numbers, 3)]
    geometry.morphTargetsRelative = true
    const mesh = new THREE.Mesh(geometry, material)
    mesh.morphTargetInfluences[0] = 0.5
    return mesh
  }
  if (kind !== 'skin') return new THREE.Mesh(geometry, material)
  geometry.setAttribute('skinIndex', new THREE.BufferAttribute(new Uint16Array(4 * count), 4))
  const weights = Float32Array.from({ length: 4 * count }, (_, i) => Number(i % 4 === 0))
  geometry.setAttribute('skinWeight', new THREE.BufferAttribute(weights, 4))
  const mesh = new THREE.SkinnedMesh(geometry, material)
  const joint = new THREE.Bone()
  mesh.add(joint)
  mesh.bind(new THREE.Skeleton([joint]), new THREE.Matrix4())
  joint.applyMatrix4(bone)
  return mesh
}

const poses = {
  skin: (p) => transform(p, bone),
  morph: (p) => p.map((x, i) => x + 0.5 * delta[i]),
}

/** Returns the local position of a displaced and posed vertex, before the matrices of instances and of the object. */
function localPosition(row, { p, n, uv }, instance, world) {
  const pose = poses[row.kind] ?? ((p) => p)
  const move = row.moved ?? ((p) => p)
  return row.isPosedFirst ? move(pose(p)) : pose(move(p, n, uv, instance, world))
}

/**
 * Measures the errors of a row's normals, with `exactNormals` if `normals`, its option or all of its options, is present. `hasChunks` says whether the material's shaders
 * consist of three's chunks. With `isRaw`, returns the computed values instead.
 */
export async function measure(row, normals, hasChunks, isRaw) {
  const { shape, space = 'view' } = row
  const { geometry: create, at } = shapes[shape]
  const geometry = create()
  if (!isRaw) await addSurfaceVariation(geometry)
  const material = row.material()
  if (normals) exactNormals(material, typeof normals === 'string' ? { normals } : normals)
  const mesh = makeMesh(row, geometry, material)
  mesh.rotation.set(0.4, 0.5, 0.1)
  // Shaders that compute normals in world space are correct only for uniform scales.
  mesh.scale.set(...(space === 'world' ? [1.2, 1.2, 1.2] : [1.2, 0.8, 1]))
  for (let i = 0; mesh.isInstancedMesh && i < mesh.count; i++)
    mesh.setMatrixAt(i, new THREE.Matrix4().makeRotationY(i).setPosition(i * 0.4 - 1, 0, 0))
  mesh.updateMatrixWorld()
  const shown = probe(mesh, camera, hasChunks ? 'vec4(normal, 1.0)' : undefined)
  if (isRaw) return [...shown]
  const clips = probe(mesh, camera, hasChunks ? 'vec4(normal, 1.0)' : undefined, true)
  return compare(row, mesh, { at, space, shown, clips })
}

function compare(row, mesh, { at, space, shown, clips }) {
  const { uv, position } = mesh.geometry.attributes
  const angles = []
  let [skipped, farthest, total] = [0, 0, 0]
  for (let k = 0; k < (mesh.isInstancedMesh ? mesh.count : 1); k++) {
    const instance = new THREE.Matrix4()
    if (mesh.isInstancedMesh) mesh.getMatrixAt(k, instance)
    const toWorld = new THREE.Matrix4().multiplyMatrices(mesh.matrixWorld, instance)
    const positionAt = (u, v, isMoved = true) => {
      const { p, n, uv } = at(u, v)
      const local = isMoved
        ? localPosition(row, { p, n, uv }, instance.elements, transform(p, toWorld))
        : p
      const world = transform(local, toWorld)
      const inWorld = isMoved && row.movedInWorld ? row.movedInWorld(world) : world
      const inView = transform(inWorld, camera.matrixWorldInverse)
      return { world: inWorld, view: isMoved && row.movedInView ? row.movedInView(inView) : inView }
    }
    for (let i = 0; i < position.count; i++) {
      const [u, v] = [uv.getX(i), uv.getY(i)]
      // At the poles of a sphere, u is undefined.
      if (row.shape === 'sphere' && (v < 0.01 || v > 0.99)) continue
      total++
      const e = 1e-6
      const slope = (du, dv, isMoved) => {
        const [from, to] = [
          positionAt(u - du * e, v - dv * e, isMoved),
          positionAt(u + du * e, v + dv * e, isMoved),
        ]
        return to[space].map((x, k) => (x - from[space][k]) / (2 * e))
      }
      const normalAt = (isMoved) => cross(slope(1, 0, isMoved), slope(0, 1, isMoved))
      const expected = unit(normalAt(true)).map((x) => (row.isBack ? -x : x))
      // At kinks, one-sided differences disagree.
      const oneSidedNormal = (sign) => {
        const here = positionAt(u, v)[space]
        const along = (du, dv) =>
          positionAt(u + sign * du * e, v + sign * dv * e)[space].map(
            (x, k) => sign * (x - here[k]),
          )
        return cross(along(1, 0), along(0, 1))
      }
      if (angle(oneSidedNormal(1), oneSidedNormal(-1)) > 0.05) {
        skipped++
        continue
      }
      const start = 4 * (k * position.count + i)
      angles.push(angle(expected, [...shown.subarray(start, start + 3)]))
      const clip = new THREE.Vector4(...positionAt(u, v).view, 1).applyMatrix4(
        camera.projectionMatrix,
      )
      farthest = Math.max(farthest, ...clip.toArray().map((x, j) => Math.abs(x - clips[start + j])))
    }
  }
  angles.sort((a, b) => a - b)
  return {
    count: angles.length,
    skipped,
    total,
    median: angles[angles.length >> 1],
    worst: angles.at(-1),
    farthest,
    finite: angles.every(Number.isFinite),
  }
}
