// Measures the compute passes of the option `detail`, for `npm run bench -- detail-gpu`.
import * as THREE from 'three/webgpu'
import { warp } from 'warpjet/three'
import 'warpjet/three/webgpu'
import { camera, offsets, sceneOf } from './pictures.js'
import { timePasses } from './timed-passes.js'

const warps = {
  twist: offsets.twist,
  simplex: offsets.noise,
  'fbm of three octaves': ({ glsl, position, millis, uniforms }) =>
    glsl
      .normalize(position)
      .mult(
        glsl
          .fbm(position.mult(2).add(glsl.vec3(0, 0, millis.div(1000))), { octaves: 3 })
          .mult(uniforms.amount),
      ),
}

const amounts = { twist: 1.1, simplex: 0.1, 'fbm of three octaves': 0.1 }

const stages = ['evaluate', 'measure', 'choose', 'place', 'total', 'write']

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

async function makeRenderer(size, hasPasses) {
  const renderer = new THREE.WebGPURenderer({ antialias: false })
  await renderer.init()
  if (!renderer.backend.isWebGPUBackend) throw new Error('this browser has no WebGPU')
  renderer.setSize(size, size)
  if (!hasPasses)
    renderer.backend.device.createComputePipelineAsync = () => Promise.reject(new Error('none'))
  return renderer
}

/** Returns a sphere with about this number of edges. There are about three edges for every two triangles. */
function sphereOf(edges) {
  const rows = Math.round(Math.sqrt(edges / 6))
  return new THREE.SphereGeometry(1, 2 * rows, rows)
}

/** Warps a sphere. `frame(i)` moves the surface and the camera, and returns the milliseconds of `render`. */
function start(renderer, name, edges) {
  const { scene, mesh } = sceneOf(sphereOf(edges))
  // For culling, the bounds of the warped mesh would be computed in each frame.
  mesh.frustumCulled = false
  let drawn
  mesh.onBeforeRender = () => (drawn = mesh.geometry)
  const warped = warp(mesh, warps[name], { uniforms: { amount: amounts[name] }, detail: 1 })
  const view = camera()
  return {
    mesh,
    drawn: () => drawn,
    warped,
    frame(i) {
      warped.update(20 * i)
      mesh.rotation.y = i / 100
      view.position.setLength(2.5 + Math.sin(i / 20))
      const begin = performance.now()
      renderer.render(scene, view)
      return performance.now() - begin
    },
  }
}

const finish = (renderer) => renderer.backend.device.queue.onSubmittedWorkDone()

async function measureOne(name, { edges, frames, passes, cpu, read, split }) {
  const onGpu = start(passes, name, edges)
  for (let i = 0; !onGpu.drawn()?.indirect; i++) {
    if (i > 2000) throw new Error('compute passes did not begin')
    onGpu.frame(0)
    await new Promise((resolve) => setTimeout(resolve, 10))
  }
  const [all, renders, byStage] = [[], [], []]
  for (let i = 1; i <= 2 * frames; i++) {
    split(i > frames)
    const begin = performance.now()
    const render = onGpu.frame(i)
    await finish(passes)
    const times = read ? await read() : [performance.now() - begin]
    if (i > frames) byStage.push(times)
    else {
      renders.push(render)
      all.push(times[0])
    }
  }
  split(false)
  onGpu.warped.dispose()
  const onCpu = start(cpu, name, edges)
  onCpu.frame(0)
  const withoutPasses = []
  for (let i = 1; i <= frames; i++) {
    withoutPasses.push(onCpu.frame(i))
    await finish(cpu)
  }
  onCpu.warped.dispose()
  const stageTimes = stages.map((stage, k) => [stage, median(byStage.map((times) => times[k]))])
  return {
    [read ? 'ms, passes' : 'ms, frame']: median(all),
    ...(read && Object.fromEntries(stageTimes)),
    'render(), passes': median(renders),
    'render(), CPU': median(withoutPasses),
  }
}

globalThis.benchDetail = async ({ edges, size, frames }) => {
  const [passes, cpu] = [await makeRenderer(size, true), await makeRenderer(size, false)]
  let isSplit = false
  const split = (value) => (isSplit = value)
  const read = timePasses(passes.backend.device, 'warpjet detail', () => isSplit)
  const rows = {}
  for (const name of Object.keys(warps))
    rows[name] = await measureOne(name, { edges, frames, passes, cpu, read, split })
  const { vendor, architecture, description } = passes.backend.device.adapterInfo ?? {}
  return { rows, adapter: [vendor, architecture, description].filter(Boolean).join(' ') }
}
document.title = 'ready'
