// The option `detail` on the WebGPU backend: compute passes divide meshes as the CPU does.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { leavePage, webgpuFlags } from '../support/browser/browser.js'
import { threePages } from '../support/browser/three/open.js'

let pages, page, messages
before(async () => {
  pages = await threePages(webgpuFlags)
  ;({ page, messages } = await pages.open('three', 'detail/page-compute.js'))
})
after(() => pages.close())

const run = (check, settings) =>
  page.evaluate(([check, settings]) => compute[check](settings), [check, settings])

for (const [shape, name, space] of [
  ['box', 'twist'],
  ['box', 'bend'],
  ['sphere', 'noise'],
  ['box', 'twist', 'world'],
])
  test(`passes divide a ${shape} under ${name} as the CPU does ${space ?? ''}`, async (t) => {
    const { waited, found, errors } = await run('divide', { shape, name, space })
    t.diagnostic(JSON.stringify({ waited, found }))
    assert.deepEqual([...errors, ...messages], [])
    for (const { isEqual, farthest, beyond, triangles } of found) {
      assert.ok(isEqual)
      assert.ok(farthest < 1e-6, `${farthest}`)
      assert.equal(beyond, 0)
      assert.ok(triangles > 12)
    }
  })
void [describe, leavePage]
