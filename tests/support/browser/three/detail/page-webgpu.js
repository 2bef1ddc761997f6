// A page that draws with the option `detail` by WebGPURenderer, on either backend.
import * as THREE from 'three/webgpu'
import 'warpjet/three/webgpu'
import { rendererFor } from '../webgpu-renderer.js'
import * as checks from './checks.js'
import { readBuffer } from './indirect.js'
import { size } from './pictures.js'

const target = new THREE.RenderTarget(size, size)

/** The objects that three.js draws, with the geometries that they have while they are drawn. */
let drawn = []

const isPosed = ({ isSkinnedMesh, geometry }) =>
  isSkinnedMesh || Object.keys(geometry.morphAttributes).length > 0

/** Tests whether compute passes will divide a mesh that the CPU has divided. */
const isWaiting = ({ object, geometry }) =>
  geometry !== object.geometry &&
  !geometry.indirect &&
  !isPosed(object) &&
  !Array.isArray(object.material)

async function countTriangles(renderer) {
  let count = renderer.info.render.triangles
  for (const { geometry } of drawn) {
    if (!geometry.indirect) continue
    const [indices, instances] = await readBuffer(renderer, geometry.indirect, Uint32Array)
    count += (indices / 3) * instances
  }
  return count
}

async function hostFor(backend, hasPasses) {
  const renderer = await rendererFor(backend, { hasPasses })
  renderer.setClearColor(0, 0)
  // Otherwise, each animation frame would reset the counts, too.
  renderer.info.autoReset = false
  if (!Object.hasOwn(renderer.backend, 'draw')) {
    const { draw } = renderer.backend
    renderer.backend.draw = function (renderObject, info) {
      drawn.push({ object: renderObject.object, geometry: renderObject.geometry })
      draw.call(this, renderObject, info)
    }
  }
  const render = (scene, view) => {
    drawn = []
    renderer.setRenderTarget(target)
    renderer.info.reset()
    try {
      renderer.render(scene, view)
    } finally {
      renderer.setRenderTarget(null)
    }
  }
  let triangles = 0
  return {
    async draw(scene, view) {
      render(scene, view)
      for (let i = 0; hasPasses && drawn.some(isWaiting); i++) {
        if (i > 1000) throw new Error('compute passes did not begin')
        // Without this pause, pictures would delay the idle callbacks that make the tessellations.
        await new Promise((resolve) => setTimeout(resolve, 100))
        render(scene, view)
      }
      triangles = await countTriangles(renderer)
      return renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size)
    },
    /** Compute passes draw the mesh of the frame before while their buffers grow. */
    framesUntilLargeEnough: hasPasses ? 4 : 1,
    triangles: () => triangles,
    geometries: () => renderer.info.memory.geometries,
  }
}

globalThis.detail = Object.fromEntries(
  Object.entries(checks).map(([name, check]) => [
    name,
    async ({ backend, hasPasses, ...settings }) =>
      check(await hostFor(backend, hasPasses), settings),
  ]),
)
document.title = 'ready'
