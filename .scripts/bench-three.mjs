// npm run bench:three: what a ray costs on a warped mesh, beside three-mesh-bvh on a baked one; what bounds cost; and the time of
// a frame and of the first one, warped, beside the same with derivatives by hand in onBeforeCompile.
import { performance } from 'node:perf_hooks'
import { build } from './build.mjs'
import { main } from './lib/terminal.mjs'
import { median } from './lib/median.mjs'

await main(async () => {
  if (!process.argv.includes('--no-build')) await build()
  await rays()
  await frames()
})

async function rays() {
  const THREE = await import('three')
  const { MeshBVH, acceleratedRaycast } = await import('three-mesh-bvh')
  const { compileWarp } = await import('../dist/warpjet.js')
  const { bakeWarp } = await import('../dist/mesh.js')
  const { fromBufferGeometry, toBufferGeometry, warp } = await import('../dist/three.js')
  const offset = ({ glsl, position, millis }) =>
    glsl.vec3(position.y().mult(5).add(millis).sin().mult(0.2), 0, 0)
  console.log(
    'Microseconds a ray, medians of 1,000; and milliseconds that a change of the time costs.\n',
  )
  console.log(
    'triangles   warped   baked, three-mesh-bvh   first ray after a change   bounds   baking and building a BVH',
  )
  for (const segments of [64, 256, 1024]) {
    const geometry = new THREE.TorusKnotGeometry(0.7, 0.25, segments, 20)
    const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial())
    const warped = warp(mesh, offset)
    const compiled = compileWarp(offset)
    const rays = Array.from({ length: 1000 }, (_, i) => {
      const angle = i * 2.4
      const from = new THREE.Vector3(5 * Math.cos(angle), 3 * Math.sin(i), 5 * Math.sin(angle))
      const to = new THREE.Vector3(Math.cos(i), Math.sin(2 * i), Math.cos(3 * i)).multiplyScalar(
        0.6,
      )
      return new THREE.Raycaster(from, to.sub(from).normalize())
    })
    const time = (work) => {
      const start = performance.now()
      work()
      return performance.now() - start
    }
    const each = (target) =>
      median(rays.map((ray) => time(() => ray.intersectObject(target)))) * 1000
    each(mesh)
    const ray = each(mesh)
    let now = 0
    const rebuilt = () =>
      toBufferGeometry(
        bakeWarp(fromBufferGeometry(geometry), compiled, { uniforms: { millis: now } }),
      )
    const first = median(
      Array.from({ length: 15 }, () => {
        warped.update(++now)
        return time(() => rays[1].intersectObject(mesh))
      }),
    )
    const bounds = median(
      Array.from({ length: 15 }, () => {
        warped.update(++now)
        return time(() => warped.bounds())
      }),
    )
    const other = new THREE.Mesh(rebuilt(), mesh.material)
    other.raycast = acceleratedRaycast
    other.geometry.boundsTree = new MeshBVH(other.geometry)
    each(other)
    const tree = each(other)
    const building = median(
      Array.from({ length: 5 }, () => time(() => (now++, new MeshBVH(rebuilt())))),
    )
    console.log(
      [
        String(geometry.index.count / 3).padStart(9),
        ray.toFixed(0).padStart(9),
        tree.toFixed(0).padStart(24),
        first.toFixed(1).padStart(27),
        bounds.toFixed(2).padStart(9),
        building.toFixed(1).padStart(29),
      ].join(''),
    )
    warped.dispose()
  }
}

async function frames() {
  const { threePages } = await import('../tests/support/browser/three/open.js')
  const pages = await threePages()
  const { page } = await pages.open('three', 'page-bench.js')
  console.log(
    '\nMilliseconds, medians: warped, by hand, and the median of the quotients of neighbours.\n',
  )
  for (const [name, { warped, byHand, quotient }] of Object.entries(
    await page.evaluate(() => bench()),
  ))
    console.log(
      `${name.padEnd(12)} ${warped.toFixed(2).padStart(9)} ${byHand.toFixed(2).padStart(9)} ${quotient.toFixed(3).padStart(8)}`,
    )
  await pages.close()
}
