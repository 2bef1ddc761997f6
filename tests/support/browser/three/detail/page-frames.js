// Measures frames of meshes with the option `detail` against uniform meshes, for `npm run bench -- detail-frames`.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { splitUniformly } from '../../../screen-error.js'

const size = 600
const framesPerBatch = 4
const batches = 9

const renderer = new THREE.WebGLRenderer({ antialias: false })
renderer.setSize(size, size)
document.body.append(renderer.domElement)

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

function geometryOf({ positions, normals, indices }) {
  const geometry = new THREE.BufferGeometry()
  geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(positions), 3))
  geometry.setAttribute('normal', new THREE.BufferAttribute(Float32Array.from(normals), 3))
  geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(indices), 1))
  return geometry
}

/** Returns a function that draws a batch of frames and returns the milliseconds of each. The camera moves by a quarter of a degree per frame. */
function start(mesh, offset, { options, millis, distance, extent, moves }) {
  const material = new THREE.MeshNormalMaterial({ side: THREE.DoubleSide })
  const scene = new THREE.Scene()
  const object = new THREE.Mesh(geometryOf(mesh), material)
  // Three.js computes the bounds of a mesh that moves in each frame nevertheless, to sort: the frames of both meshes contain that.
  object.frustumCulled = false
  scene.add(object)
  const warped = warp(object, offset, options)
  const camera = new THREE.PerspectiveCamera(60, 1, 0.03 * extent, 20 * extent)
  const gl = renderer.getContext()
  const pixel = new Uint8Array(4)
  let frame = 0
  return {
    batch() {
      const begin = performance.now()
      for (let i = 0; i < framesPerBatch; i++, frame++) {
        camera.position.setFromSphericalCoords(distance, 1.1, (frame * Math.PI) / 720)
        camera.lookAt(0, 0, 0)
        warped.update(millis + (moves ? 16 * frame : 0))
        renderer.render(scene, camera)
      }
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel)
      return (performance.now() - begin) / framesPerBatch
    },
    triangles: () => renderer.info.render.triangles,
    dispose() {
      warped.dispose()
      object.geometry.dispose()
      material.dispose()
    },
  }
}

/** `pieces` are those of each side in the uniform mesh. */
function measureCase({ name, mesh, pieces, sizes, uniforms, normals, ...settings }, warps) {
  const { warp: offset } = warps.find((each) => each.name === name)
  const { millis, ...own } = uniforms
  const options = { normals, ...(Object.keys(own).length && { uniforms: own }) }
  const shared = { millis: millis ?? 0, extent: Math.max(...sizes), ...settings }
  const ways = {
    divided: start(mesh, offset, { options: { ...options, detail: 1 }, ...shared }),
    uniform: start(splitUniformly(mesh, pieces), offset, { options, ...shared }),
  }
  const times = { divided: [], uniform: [] }
  const triangles = {}
  for (let i = -2; i < batches; i++)
    for (const [way, { batch, triangles: count }] of Object.entries(ways)) {
      const time = batch()
      if (i >= 0) times[way].push(time)
      triangles[way] = count()
    }
  for (const { dispose } of Object.values(ways)) dispose()
  return {
    divided: median(times.divided),
    uniform: median(times.uniform),
    ratio: median(times.divided.map((time, i) => time / times.uniform[i])),
    triangles,
  }
}

globalThis.startFrames = async (folders) => {
  globalThis.sketchFolders = folders
  const { sketchWarps } = await import('../../../../warps/sketches.js')
  const warps = await sketchWarps()
  globalThis.measureFrames = (settings) => measureCase(settings, warps)
}
document.title = 'ready'
