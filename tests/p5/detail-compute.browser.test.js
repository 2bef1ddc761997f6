// The option `detail` on WEBGPU: compute passes divide shapes as the CPU does. detail.browser.test.js compares what the CPU divides with dense shapes.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { launchBrowserWithWebGPU } from '../support/browser/browser.js'
import { addon } from '../support/browser/p5-hosts.js'
import { servePages } from '../support/browser/server.js'
import { p5Versions, p5WebGPU, runSketch } from '../support/browser/sketch.js'
import { checkPictures, placesAround } from '../support/places-around.js'
import { isUniform } from '../support/uniform-division.js'

let browser, server, page, messages
before(async () => {
  browser = await launchBrowserWithWebGPU()
  server = await servePages()
  const code = `import('/tests/support/browser/p5-detail/page-compute.js').then(() => (window.done = true))`
  const scripts = [p5Versions['2.x'], p5WebGPU, addon]
  ;({ page, messages } = await runSketch(browser, server, scripts, code))
})
after(async () => {
  await browser.close()
  await server.close()
})

async function run(t, check, settings, warnings = []) {
  const result = await page.evaluate(
    ([check, settings]) => compute[check](settings),
    [check, settings],
  )
  t.diagnostic(JSON.stringify(result))
  assert.deepEqual([...result.errors, ...messages.splice(0)], warnings)
  return result
}

for (const [shape, name, others] of [
  ['box', 'twist'],
  // The tolerance is small, so that a side is less than a hundredth of the vertices.
  ['plane', 'flag', { detail: 0.5, frames: 6 }],
  ['ball', 'noise'],
  ['box', 'bend', { space: 'world' }],
  ['ball', 'swelling', { space: 'world' }],
  ['box', 'bend', { space: 'camera', hasPlaces: true }],
  ['box', 'twist', { hasPlaces: true }],
  ['box', 'twist', { isInside: true }],
])
  test(`passes divide a ${shape} under ${name} as the CPU does, ${JSON.stringify(others ?? {})}`, async (t) => {
    // Spaces and places differ in matrices, which fewer frames show.
    const frames = others?.frames ?? (others ? 3 : 6)
    const { found } = await run(t, 'divide', { shape, name, frames, ...others })
    assert.equal(found.length, others?.hasPlaces ? 3 * frames : frames)
    for (const each of found) {
      const { isIndirect, triangles, expected, vertices, strays, isEqual, openSides, beyond } = each
      assert.ok(isIndirect)
      // A plane has a border.
      if (shape !== 'plane') assert.equal(openSides, 0)
      if (shape === 'box' && isUniform(expected, 12)) {
        // Only the last place of a picture has the number of pixels.
        assert.ok((beyond ?? 0) < 10, `${beyond} pixels`)
        continue
      }
      assert.ok(!beyond, `${beyond} pixels`)
      // If a need is a whole number except for rounding errors, only one of the two may round it up: then a few sides have more pieces.
      assert.ok(Math.abs(triangles - expected) <= 0.01 * expected, `${triangles}, ${expected}`)
      assert.ok(strays <= (isEqual ? 0 : 0.01 * vertices), `${strays} of ${vertices}`)
    }
    const uniform = found.filter(({ expected }) => shape === 'box' && isUniform(expected, 12))
    assert.ok(uniform.length < found.length / 2)
  })

for (const [name, coarse, dense] of [
  ['twist', ['box', 120], ['warpBox', 120, 120, 120, 48]],
  ['flag', ['plane', 170, 170, 1, 1], ['plane', 170, 170, 120, 120]],
])
  test(`${coarse} under a ${name} looks like a dense one`, async (t) => {
    const { before, after } = await run(t, 'resemble', { name, coarse, dense })
    assert.ok(before > 1000, `the coarse one differs at ${before} pixels`)
    assert.ok(after < 250, `the divided one differs at ${after} pixels`)
  })

// Each place takes ten pictures.
test('a divided box is within a pixel of a dense one from 10 places', async (t) => {
  checkPictures(await run(t, 'compareAround', { places: placesAround(120).slice(0, 10) }))
})

test('buffers grow, and the shape of the frame before is drawn until then', async (t) => {
  const { before, after, isSame, beyond, left } = await run(t, 'approach')
  assert.ok(after > 2 * before, `${before}, ${after}`)
  assert.equal(isSame, false)
  assert.equal(beyond.at(-1), 0)
  assert.equal(left, 0)
})

for (const hasPasses of [true, false])
  test(`redraw(3) shows the third picture, ${hasPasses ? 'by passes' : 'by the CPU'}`, async (t) => {
    const { differing } = await run(t, 'redrawOften', { hasPasses })
    assert.deepEqual(differing, [0, 0, 0, 0])
  })

for (const [change, name, minTriangles] of [
  ['becomes rougher', 'waves', 1000],
  ['has a bump that moves', 'bump', 300],
])
  test(`a surface that ${change} is cut anew`, async (t) => {
    const { triangles, beyond } = await run(t, 'refine', { name })
    assert.ok(triangles > minTriangles, `${triangles} triangles`)
    assert.deepEqual(beyond, [0, 0])
  })

for (const kind of ['strokes', 'instances'])
  test(`the CPU takes over for ${kind}`, async (t) => {
    const isDivided = kind === 'strokes'
    const warning =
      'createWarp: a shape is drawn with its own vertices, although the option detail asks for more: instances are not divided.'
    const { areIndirect, differing } = await run(t, 'leave', { kind }, isDivided ? [] : [warning])
    assert.deepEqual(areIndirect, [[true], isDivided ? [false] : [], [true]])
    assert.equal(differing, 0)
  })

for (const [kind, isIndirect] of [
  ['box', true],
  ['curved', false],
  ['an edge of no face', false],
  ['a shape that changes', false],
])
  test(`${kind}: passes ${isIndirect ? '' : 'do not '}divide it`, async (t) => {
    const { found } = await run(t, 'begin', { kind })
    assert.deepEqual(found, [isIndirect])
  })

test('freeGeometry(), or a change of the shape, frees the buffers', async (t) => {
  const { counts } = await run(t, 'life')
  const { held, freed, differing, again, areIndirect, changed } = counts
  assert.ok(held > 30, `${held} buffers`)
  // The buffer of tessellations remains for other shapes.
  assert.equal(freed, 1)
  assert.ok(differing < 50, `${differing} pixels`)
  assert.deepEqual([again, changed], [held, held])
  assert.deepEqual(areIndirect, [false, false, false])
})
