// npm run bench -- detail: what the option `detail` costs on the CPU in a frame in which camera and time move, at about 10,000 edges: how
// long an update takes, and what memory it uses.
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

const partsOf = (p) => ({ x: p.x(), y: p.y(), z: p.z() })

const along =
  (height) =>
  ({ glsl, position, millis }) => {
    const moving = position.mult(2).add(glsl.vec3(0, 0, millis.div(1000)))
    return glsl.normalize(position).mult(height(glsl, moving).mult(0.1))
  }

/** Maps a name → [offset function of a sphere of radius 1, aim in milliseconds]. */
const warps = {
  twist: [
    ({ glsl, position, millis }) => {
      const { x, y, z } = partsOf(position)
      const angle = y.mult(millis.div(1000).sin().mult(2))
      const [c, s] = [angle.cos(), angle.sin()]
      return glsl.vec3(x.mult(c).sub(z.mult(s)), y, x.mult(s).add(z.mult(c))).sub(position)
    },
    2,
  ],
  bend: [
    ({ glsl, position, millis }) => {
      const { x, y, z } = partsOf(position)
      const rate = millis.div(1000).sin().mult(0.4).add(0.6)
      const [angle, radius] = [y.mult(rate), glsl.val(1).div(rate)]
      const inner = radius.sub(x)
      return glsl
        .vec3(radius.sub(angle.cos().mult(inner)), angle.sin().mult(inner), z)
        .sub(position)
    },
    2,
  ],
  simplex: [along((glsl, p) => glsl.simplex(p)), undefined],
  'fbm of three octaves': [along((glsl, p) => glsl.fbm(p, { octaves: 3 })), 8],
}

/** A sphere has about three edges for each two triangles. */
function sphere() {
  const rows = Math.round(Math.sqrt(edges / 6))
  return arraysOf(new THREE.SphereGeometry(1, 2 * rows, rows))
}

/** Returns the view in the frame `i`, in which the camera orbits and comes nearer. */
const viewOf = (i) =>
  viewFrom(new THREE.Vector3().setFromSphericalCoords(2.5 + Math.sin(i / 20), 1.2, i / 100), 1)

setFlagsFromString('--expose-gc')
const collect = runInNewContext('gc')

/** Returns the bytes in use. Arrays are freed some time after a collection. */
async function memory() {
  for (let i = 0; i < 3; i++) {
    collect()
    await new Promise((resolve) => setTimeout(resolve, 20))
  }
  const { heapUsed, arrayBuffers } = process.memoryUsage()
  return { heapUsed, arrayBuffers, wasm: detailMemoryInUse() + evaluationMemoryInUse() }
}

/** Adds up the time of `update` in the wasm; what remains of an update is the evaluation of the warp. */
function timeInWasm() {
  const { prototype } = details.get().Detail
  const { update } = prototype
  const spent = { milliseconds: 0, detail: undefined, args: [] }
  prototype.update = function (...args) {
    Object.assign(spent, { detail: this, args })
    const start = performance.now()
    const isChanged = update.apply(this, args)
    spent.milliseconds += performance.now() - start
    return isChanged
  }
  return spent
}

function timeUpdates(update, spent) {
  const times = { total: [], evaluate: [], need: [], write: [] }
  for (let i = 0; i < warmUp + updates; i++) {
    spent.milliseconds = 0
    const total = time(() => update(i))
    const needAndWrite = spent.milliseconds
    // Nothing has changed since, so that a second update computes needs and writes nothing.
    spent.milliseconds = 0
    spent.detail.update(...spent.args)
    if (i < warmUp) continue
    times.total.push(total)
    times.evaluate.push(total - needAndWrite)
    times.need.push(spent.milliseconds)
    times.write.push(needAndWrite - spent.milliseconds)
  }
  return times
}

async function measureWarp([offset, aim], spent) {
  const warp = compileWarp(offset, { normals: false })
  const views = Array.from({ length: warmUp + updates }, (_, i) => viewOf(i))
  const mesh = sphere()
  const before = await memory()
  const divided = createDetail(mesh, warp)
  const update = (i, tolerance = 1) =>
    divided.update(views[i], { uniforms: { millis: 20 * i }, tolerance })
  update(0, 1e6)
  const undivided = await memory()
  const least = divided.indices.length / 3
  const times = timeUpdates(update, spent)
  const edges = spent.detail.pieces().length
  const garbage = countGarbage(update, views.length)
  const triangles = views.map((_, i) => (update(i), divided.indices.length / 3))
  const first = await memory()
  views.forEach((_, i) => update(i))
  const last = await memory()
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
        (last.wasm - undivided.wasm) / (Math.max(...triangles) - least),
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
  const found = []
  for (let first = 0; first + series <= count; first += series) {
    const { heapUsed } = process.memoryUsage()
    for (let i = first; i < first + series; i++) update(i)
    const grown = process.memoryUsage().heapUsed - heapUsed
    if (grown >= 0) found.push(grown / series)
  }
  return Math.round(median(found))
}

export async function measure() {
  const spent = timeInWasm()
  const found = {}
  for (const [name, warp] of Object.entries(warps)) found[name] = await measureWarp(warp, spent)
  const table = (key) =>
    console.table(
      Object.fromEntries(Object.entries(found).map(([name, each]) => [name, each[key]])),
    )
  say(`A sphere of about ${edges} edges; camera and time move in ${updates} updates.`)
  say('Milliseconds for 10,000 edges, medians:')
  table('times')
  say(`Memory for 10,000 edges, and what grows in ${warmUp + updates} more updates, in bytes:`)
  table('memory')
  say(`The wasm has a heap of ${kilobytes(details.get().HEAPU8.length)} kB, which never shrinks.`)
  say(`Load of the machine: ${loadavg()[0].toFixed(1)} on ${cpus().length} cores.`)
}
