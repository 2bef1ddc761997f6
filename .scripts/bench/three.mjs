// npm run bench -- three [--frames] [--rounds 100] [--copies 1] [--batch 1] [--software]: measures warped meshes in three.js:
// - the intersection with a ray, compared with three-mesh-bvh on a baked mesh;
// - bounds();
// - a frame and the first frame, compared with the same warp and its derivatives written by hand in onBeforeCompile.
// --frames measures only frames.
import * as THREE from 'three'
import { MeshBVH, acceleratedRaycast } from 'three-mesh-bvh'
import { bakeWarp } from '../../dist/mesh.js'
import { fromBufferGeometry, toBufferGeometry, warp } from '../../dist/three.js'
import { compileWarp } from '../../dist/warpjet.js'
import { threePagesIn } from '../../tests/support/browser/three/open.js'
import { median, medianTime, time } from '../lib/median.mjs'
import { parseOptions } from '../lib/options.mjs'
import { launchFastest } from './frames/browsers.mjs'

const offset = ({ glsl, position, millis }) =>
  glsl.vec3(position.y().mult(5).add(millis).sin().mult(0.2), 0, 0)

const rays = Array.from({ length: 1000 }, (_, i) => {
  const angle = i * 2.4
  const from = new THREE.Vector3(5 * Math.cos(angle), 3 * Math.sin(i), 5 * Math.sin(angle))
  const to = new THREE.Vector3(Math.cos(i), Math.sin(2 * i), Math.cos(3 * i)).multiplyScalar(0.6)
  return new THREE.Raycaster(from, to.sub(from).normalize())
})
const microsecondsPerRay = (target) =>
  1000 * median(rays.map((ray) => time(() => ray.intersectObject(target))))

/**
 * Returns one row: microseconds per ray, and the milliseconds of the first ray, of bounds() and of a new bake after the time of the warp
 * changed.
 */
function measureRays(segments) {
  const geometry = new THREE.TorusKnotGeometry(0.7, 0.25, segments, 20)
  const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial())
  const warped = warp(mesh, offset)
  const compiled = compileWarp(offset)
  microsecondsPerRay(mesh)
  const ray = microsecondsPerRay(mesh)
  let now = 0
  const timeAfterChange = (work) =>
    median(
      Array.from({ length: 15 }, () => {
        warped.update(++now)
        return time(work)
      }),
    )
  const firstRay = timeAfterChange(() => rays[1].intersectObject(mesh))
  const bounds = timeAfterChange(() => warped.bounds())
  const bake = () => {
    const uniforms = { millis: now++ }
    return toBufferGeometry(bakeWarp(fromBufferGeometry(geometry), compiled, { uniforms }))
  }
  const baked = new THREE.Mesh(bake(), mesh.material)
  baked.raycast = acceleratedRaycast
  baked.geometry.boundsTree = new MeshBVH(baked.geometry)
  microsecondsPerRay(baked)
  const row = {
    triangles: geometry.index.count / 3,
    'µs a ray, warped': ray,
    'baked, BVH': microsecondsPerRay(baked),
    'ms first ray': firstRay,
    'ms bounds': bounds,
    'ms baking and BVH': medianTime(5, () => new MeshBVH(bake())),
  }
  warped.dispose()
  return row
}

/** On a GPU, set --copies (spheres per draw call) and --batch (frames per measurement) so high that drawing takes longer than waiting. */
export async function measure(args) {
  const { frames, software, rounds, copies, batch } = parseOptions(
    args,
    { rounds: 100, copies: 1, batch: 1 },
    { frames: { type: 'boolean' }, software: { type: 'boolean' } },
  )
  if (!frames) console.table([64, 256, 1024].map(measureRays))
  const browser = await launchFastest(software)
  const pages = await threePagesIn(browser)
  const { page } = await pages.open('three', 'page-bench.js')
  console.log(
    '\nMedian milliseconds; the quotient is the median of the quotients of consecutive frames.',
  )
  console.table(await page.evaluate((args) => bench(...args), [rounds, copies, batch]))
  await pages.close()
}
