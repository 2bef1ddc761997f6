// The option `detail` on the WebGPU backend: compute passes divide meshes as the CPU does. detail.browser.test.js compares what they draw with fine meshes.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { webgpuFlags } from '../support/browser/browser.js'
import { countOpenSides } from '../support/browser/three/detail/sides.js'
import { threePages } from '../support/browser/three/open.js'
import { isUniform } from '../support/uniform-division.js'

let pages, page, messages
before(async () => {
  pages = await threePages(webgpuFlags)
  ;({ page, messages } = await pages.open('three', 'detail/page-compute.js'))
})
after(() => pages.close())

async function run(t, check, settings) {
  const result = await page.evaluate(
    ([check, settings]) => compute[check](settings),
    [check, settings],
  )
  t.diagnostic(JSON.stringify(result))
  assert.deepEqual([...result.errors, ...messages], [])
  return result
}

for (const [shape, name, space] of [
  ['box', 'twist'],
  ['box', 'bend'],
  ['sphere', 'noise'],
  ['box', 'twist', 'world'],
])
  test(`passes divide a ${shape} under a ${name} as the CPU does, ${space ?? 'local'}`, async (t) => {
    const { found } = await run(t, 'divide', { shape, name, space })
    for (const { triangles, expected, differing, farthest, openSides, beyond } of found) {
      assert.equal(openSides, 0)
      if (shape === 'box' && isUniform(expected, 12)) {
        assert.ok(beyond < 10, `${beyond} pixels`)
        continue
      }
      // If a need is a whole number except for rounding errors, only one of the two may round it up. Two such sides can make up for each
      // other in the number of triangles, but all triangles beside them differ.
      assert.ok(Math.abs(triangles - expected) <= 0.01 * expected, `${triangles}, ${expected}`)
      assert.ok(!(differing > 0.02 * expected), `${differing} of ${expected}`)
      if (differing === 0) assert.ok(farthest <= 1e-6, `${farthest}`)
      assert.equal(beyond, 0)
    }
    const equal = found.filter(({ differing }) => differing === 0).length
    assert.ok(equal > 0, `${equal} of ${found.length} equal`)
  })

test('an open side is found', () => {
  const square = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0])
  assert.equal(countOpenSides([0, 1, 2, 0, 2, 3], square), 4)
})

test('buffers grow, and the mesh of the frame before is drawn until then', async (t) => {
  const { before, after, isSame, beyond } = await run(t, 'approach', {
    shape: 'sphere',
    name: 'noise',
  })
  assert.ok(after > 2 * before, `${before}, ${after}`)
  assert.equal(isSame, false)
  // All pixels of the mesh would differ if none were drawn.
  assert.ok(Math.max(...beyond) < 3000, `${beyond} pixels`)
  assert.ok(beyond.at(-1) <= 3, `${beyond} pixels`)
})

test('a surface that becomes rougher is cut anew', async (t) => {
  const { triangles, beyond } = await run(t, 'refine')
  assert.ok(triangles > 1000)
  assert.deepEqual(beyond, [0, 0])
})

test('cameras, sizes and materials change, and dispose() frees the buffers', async (t) => {
  const { counts } = await run(t, 'countOverTime')
  const { pairs, large, held, left, ...others } = counts
  assert.deepEqual(pairs.slice(2), pairs.slice(0, 2))
  assert.ok(pairs[0] > 1.3 * pairs[1], `${pairs}`)
  assert.ok(large > 2 * pairs[0], `${large}, ${pairs}`)
  assert.ok(held > 10, `${held} buffers`)
  assert.equal(left, 0)
  assert.deepEqual(others, {
    isIndirectAsLines: false,
    isIndirectAgain: true,
    isIndirectByGroups: false,
    isIndirectIfCurved: false,
  })
})
