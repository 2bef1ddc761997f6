// Real models, such as the bunny and the teapot from npm, through the whole pipeline: loads an OBJ, warps, subdivides, exports a
// GLB that Khronos' validator accepts, and loads it again.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import validator from 'gltf-validator'
import { compileWarp } from 'warpjet'
import { bakeWarp, exportGLB, loadMesh, subdivide } from 'warpjet/mesh'
import { models, toOBJ } from '../../web/models/index.js'

const twist = compileWarp(({ glsl, position, millis }) => {
  const angle = position.y().mult(0.01).mult(millis.div(1000))
  return glsl.rotateY(angle).mult(position).sub(position)
})
const uniforms = { millis: 1500 }

async function assertValid(bytes) {
  const { issues } = await validator.validateBytes(bytes)
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages))
}

function assertClose(actual, expected, tolerance, what) {
  assert.equal(actual.length, expected.length, what)
  actual.forEach((x, i) => {
    if (Math.abs(x - expected[i]) > tolerance) assert.fail(`${what}[${i}]: ${x}, ${expected[i]}`)
  })
}

for (const [name, make] of Object.entries(models))
  describe(name, () => {
    const { positions, normals, uvs, indices } = make()
    const model = { positions, normals, uvs, indices }

    test('is the same after loading, exporting and loading again', async () => {
      const bytes = exportGLB(model)
      await assertValid(bytes)
      const loaded = await loadMesh(bytes)
      assert.deepEqual([...loaded.positions], [...Float32Array.from(positions)])
      assert.deepEqual([...loaded.indices], [...indices])
      assert.deepEqual(exportGLB(loaded), bytes)
    })

    test('can be loaded as OBJ, too', async () => {
      const loaded = await loadMesh(new TextEncoder().encode(toOBJ(model, name)))
      assert.equal(loaded.indices.length, indices.length)
      // The OBJ has three decimals, and its vertices in the order of its faces.
      const cornersOf = (mesh) =>
        [...mesh.indices].flatMap((i) => [...mesh.positions.slice(3 * i, 3 * i + 3)])
      assertClose(cornersOf(loaded), cornersOf(model), 6e-4, 'corner')
    })

    test('is a valid file after warping and subdividing, too', async () => {
      const baked = bakeWarp(model, twist, { uniforms })
      await assertValid(exportGLB(baked))
      const radius = (mesh, i) => Math.hypot(mesh.positions[3 * i], mesh.positions[3 * i + 2])
      for (let i = 0; i < positions.length / 3; i++) {
        assert.ok(
          Math.abs(radius(baked, i) - radius(model, i)) < 1e-4,
          'the twist changes the radius',
        )
        assert.equal(baked.positions[3 * i + 1], Math.fround(positions[3 * i + 1]))
      }
      const fine = subdivide(model, { warp: twist, uniforms, tolerance: 0.5 })
      assert.ok(fine.indices.length >= indices.length)
      await assertValid(exportGLB(bakeWarp(fine, twist, { uniforms })))
    })
  })
