// npm run bench -- detail: measures what the option `detail` costs on the CPU in a frame in which camera and time move, at about 10,000
// edges: how long an update takes, and what memory it uses.
import { cpus, loadavg } from 'node:os'
import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import * as THREE from 'three'
import { createDetail } from '../../dist/detail.js'
import { detailMemoryInUse, details, evaluationMemoryInUse } from '../../dist/memory.js'
import { compileWarp } from '../../dist/warpjet.js'
import { median, time } from '../lib/median.mjs'
import { say } from '../lib/terminal.mjs'
import { arraysOf, viewFrom } from '../report/detail/cases.mjs'

const edges = 10_000
const warmUp = 100
const updates = 300
/** Garbage is counted in series of this many updates. */
const series = 20

const components = (p) => ({ x: p.x(), y: p.y(), z: p.z() })

const alongPosition =
  (height) =>
  ({ glsl, position, millis }) => {
    const moving = position.mult(2).add(glsl.vec3(0, 0, millis.div(1000)))
    return glsl.normalize(position).mult(height(glsl, moving).mult(0.1))
  }

/** Maps a name → [offset function of a sphere of radius 1, aim in milliseconds]. */
const warps = {
  twist: [
    ({ glsl, position, millis }) => {
      const { x, y, z } = components(position)
      const angle = y.mult(millis.div(1000).sin().mult(2))
      const [c, s] = [angle.cos(), angle.sin()]
      return glsl.vec3(x.mult(c).sub(z.mult(s)), y, x.mult(s).add(z.mult(c))).sub(position)
    },
    2,
  ],
  bend: [
    ({ glsl, position, millis }) => {
      const { x, y, z } = components(position)
      const rate = millis.div(1000).sin().mult(0.4).add(0.6)
      const [angle, radius] = [y.mult(rate), glsl.val(1).div(rate)]
      const inner = radius.sub(x)
      return glsl
        .vec3(radius.sub(angle.cos().mult(inner)), angle.sin().mult(inner), z)
        .sub(position)
    },
    2,
  ],
  simplex: [alongPosition((glsl, p) => glsl.simplex(p)), undefined],
  'fbm of three octaves': [alongPosition((glsl, p) => glsl.fbm(p, { octaves: 3 })), 8],
}

/** Returns a sphere of about `edges` edges. A sphere has about three edges for each two triangles. */
function createSphere() {
  const rows = Math.round(Math.sqrt(edges / 6))
  return arraysOf(new THREE.SphereGeometry(1, 2 * rows, rows))
}

/** Returns the view in the frame `i`, in which the camera orbits and comes nearer. */
const viewOf = (i) =>
  viewFrom(new THREE.Vector3().setFromSphericalCoords(2.5 + Math.sin(i / 20), 1.2, i / 100), 1)

setFlagsFromString('--expose-gc')
const collectGarbage = runInNewContext('gc')

/** Returns the bytes in use. Arrays are freed some time after a collection. */
async function measureMemory() {
  for (let i = 0; i < 3; i++) {
    collectGarbage()
    await new Promise((resolve) => setTimeout(resolve, 20))
  }
  const { heapUsed, arrayBuffers } = process.memoryUsage()
  return { heapUsed, arrayBuffers, wasm: detailMemoryInUse() + evaluationMemoryInUse() }
}

/**
 * Makes `update` of the wasm record its time. The rest of an update's time is the evaluation of the warp. `stop` ends that, since it
 * creates garbage.
 */
function recordWasmTime() {
  const bound = details.get()
  const { _detail_update: update } = bound
  const spent = {
    milliseconds: 0,
    detail: undefined,
    args: [],
    repeat: () => bound._detail_update(...spent.args),
    stop: () => Object.assign(bound, { _detail_update: update }),
  }
  bound._detail_update = (...args) => {
    spent.args = args
    const start = performance.now()
    const isChanged = update(...args)
    spent.milliseconds += performance.now() - start
    return isChanged
  }
  const { prototype } = bound.Detail
  const { begin } = prototype
  prototype.begin = function () {
    spent.detail = this
    prototype.begin = begin
    this.begin()
  }
  return spent
}

function timeUpdates(update, spent) {
  const times = { total: [], evaluate: [], need: [], write: [] }
  for (let i = 0; i < warmUp + updates; i++) {
    spent.milliseconds = 0
    const total = time(() => update(i))
    const needAndWrite = spent.milliseconds
    // Nothing has changed since, so a second update computes how far edges must be split, but writes nothing.
    spent.milliseconds = 0
    spent.repeat()
    if (i < warmUp) continue
    times.total.push(total)
    times.evaluate.push(total - needAndWrite)
    times.need.push(spent.milliseconds)
    times.write.push(needAndWrite - spent.milliseconds)
  }
  return times
}

async function measureWarp([offset, aim]) {
  const warp = compileWarp(offset, { normals: false })
  const views = Array.from({ length: warmUp + updates }, (_, i) => viewOf(i))
  const mesh = createSphere()
  const before = await measureMemory()
  const divided = createDetail(mesh, warp)
  const spent = recordWasmTime()
  const update = (i, tolerance = 1) =>
    divided.update(views[i], { uniforms: { millis: 20 * i }, tolerance })
  update(0, 1e6)
  const undivided = await measureMemory()
  const minTriangles = divided.indices.length / 3
  const times = timeUpdates(update, spent)
  spent.stop()
  const edges = spent.detail.pieces().length
  const garbage = countGarbage(update, views.length)
  const triangles = views.map((_, i) => (update(i), divided.indices.length / 3))
  const first = await measureMemory()
  views.forEach((_, i) => update(i))
  const last = await measureMemory()
  divided.dispose()
  const scale = 10_000 / edges
  const format = (ms) => (scale * ms).toFixed(2)
  return {
    times: {
      edges,
      triangles: median(triangles),
      ...Object.fromEntries(Object.entries(times).map(([name, ms]) => [name, format(median(ms))])),
      'min of total': format(Math.min(...times.total)),
      aim: aim ?? '',
    },
    memory: {
      'wasm, kB': kilobytes(scale * (undivided.wasm - before.wasm)),
      'arrays, kB': kilobytes(scale * (undivided.arrayBuffers - before.arrayBuffers)),
      'wasm, bytes per triangle': Math.round(
        (last.wasm - undivided.wasm) / (Math.max(...triangles) - minTriangles),
      ),
      'garbage, bytes per update': garbage,
      ...Object.fromEntries(
        Object.keys(last).map((name) => [`${name} grows by`, last[name] - first[name]]),
      ),
    },
  }
}

const kilobytes = (bytes) => Math.round(bytes / 1024)

/** Returns the bytes of garbage in an update, in the median of series in which none was collected. */
function countGarbage(update, count) {
  const bytesPerUpdate = []
  for (let first = 0; first + series <= count; first += series) {
    const { heapUsed } = process.memoryUsage()
    for (let i = first; i < first + series; i++) update(i)
    const grown = process.memoryUsage().heapUsed - heapUsed
    if (grown >= 0) bytesPerUpdate.push(grown / series)
  }
  return Math.round(median(bytesPerUpdate))
}

export async function measure() {
  const results = {}
  for (const [name, warp] of Object.entries(warps)) results[name] = await measureWarp(warp)
  const table = (key) =>
    console.table(
      Object.fromEntries(Object.entries(results).map(([name, result]) => [name, result[key]])),
    )
  say(`A sphere of about ${edges} edges; camera and time move in ${updates} updates.`)
  say('Milliseconds for 10,000 edges, medians:')
  table('times')
  say(`Memory for 10,000 edges, and its growth in ${warmUp + updates} more updates, in bytes:`)
  table('memory')
  say(`The wasm has a heap of ${kilobytes(details.get().HEAPU8.length)} kB, which never shrinks.`)
  say(`Load of the machine: ${loadavg()[0].toFixed(1)} on ${cpus().length} cores.`)
}
