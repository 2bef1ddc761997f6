// Measures frames of meshes with the option `detail` against uniform meshes, for `npm run bench -- detail-frames`.
import { splitUniformly } from '../screen-error.js'

/** The side of the canvas, in pixels. */
export const size = 600
const framesPerBatch = 4
const batches = 9

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

/** Waits until the GPU has drawn. */
function finish(gl) {
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))
}

/** Draws a batch of frames and returns the milliseconds of each. The camera moves by a quarter of a degree per frame. */
async function measureBatch({ gl, frame }, first, { distance, millis, moves }) {
  const begin = performance.now()
  for (let i = first; i < first + framesPerBatch; i++) {
    const angle = (i * Math.PI) / 720
    const radius = distance * Math.sin(1.1)
    const place = [radius * Math.sin(angle), distance * Math.cos(1.1), radius * Math.cos(angle)]
    await frame(place, millis + (moves ? 16 * i : 0))
  }
  finish(gl)
  return (performance.now() - begin) / framesPerBatch
}

/** Measures a mesh with detail, and the same mesh with each side of its triangles split into `pieces` pieces. */
async function measureCase(start, offset, { mesh, pieces, sizes, uniforms, normals, ...settings }) {
  const { millis = 0, ...own } = uniforms
  const options = { normals, ...(Object.keys(own).length && { uniforms: own }) }
  const extent = Math.max(...sizes)
  const meshes = {
    divided: start(mesh, offset, { ...options, detail: 1 }, extent),
    uniform: start(splitUniformly(mesh, pieces), offset, options, extent),
  }
  const times = { divided: [], uniform: [] }
  const triangles = {}
  for (let i = -2; i < batches; i++)
    for (const [name, each] of Object.entries(meshes)) {
      const time = await measureBatch(each, (i + 2) * framesPerBatch, { millis, ...settings })
      if (i >= 0) times[name].push(time)
      triangles[name] = each.triangles()
    }
  for (const { dispose } of Object.values(meshes)) dispose()
  return {
    divided: median(times.divided),
    uniform: median(times.uniform),
    ratio: median(times.divided.map((time, i) => time / times.uniform[i])),
    triangles,
  }
}

/**
 * Lets the page measure: `start(mesh, offset, options, extent)` warps a mesh and returns { gl, frame(place, millis), triangles(),
 * dispose() }. `frame` draws a frame as seen from `place`, and `triangles` returns how many triangles it had.
 */
export function offerFrames(start) {
  globalThis.startFrames = async (folders) => {
    globalThis.sketchFolders = folders
    const { sketchWarps } = await import('../../warps/sketches.js')
    const warps = await sketchWarps()
    globalThis.measureFrames = ({ name, ...settings }) =>
      measureCase(start, warps.find((each) => each.name === name).warp, settings)
  }
  document.title = 'ready'
}
