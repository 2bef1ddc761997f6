// We accept and reject the same WGSL as Chromium.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { wgslOffset } from '../../dist/glsl.js'
import { launchBrowser, openPage, webgpuFlags } from '../support/browser/browser.js'
import { servePages } from '../support/browser/server.js'
import { declaring, rules, words } from '../wgsl/rules.js'

let browser, server, page
before(async () => {
  server = await servePages()
  browser = await launchBrowser(webgpuFlags)
  ;({ page } = await openPage(browser, server.page('<!doctype html><meta charset="utf-8">')))
})
after(async () => {
  await browser.close()
  await server.close()
})

/** Cases where we differ on purpose. */
const known = [
  // The function itself uses a feature of other stages.
  /statement: (?:discard|let x = dpdx)/,
  // A warp needs loops that end.
  /statement: while true \{ \}/,
  // Source may be a piece of a shader, whose pipeline is unknown.
  /above: var<uniform> x: f32;/,
  /above: enable f16/,
  // A pointer by another name.
  /alias V = ptr/,
  // A name that is also an address space, in its own declaration.
  /global private/,
  // The result of the offset function is then another vec3f.
  /structure vec3f/,
]

/** Returns the errors of each source. */
const refusedThere = (texts) =>
  page.evaluate(async (texts) => {
    const device = await (await navigator.gpu.requestAdapter()).requestDevice()
    device.pushErrorScope('validation')
    const all = await Promise.all(
      texts.map(async (code) => {
        const { messages } = await device.createShaderModule({ code }).getCompilationInfo()
        return messages.find(({ type }) => type === 'error')?.message ?? ''
      }),
    )
    await device.popErrorScope()
    device.destroy()
    return all
  }, texts)

function refusedHere(text) {
  try {
    wgslOffset(text, { function: 'offset', maxIterations: 8 })
    return ''
  } catch (error) {
    assert.equal(error.name, 'WarpError', `${error.stack}\n${text}`)
    return error.message
  }
}

async function compare(cases, least) {
  const names = Object.keys(cases)
  const there = await refusedThere(Object.values(cases))
  const disagreeing = names.flatMap((name, i) => {
    const here = refusedHere(cases[name])
    if (!here === !there[i] || known.some((piece) => piece.test(name))) return []
    return [`${name}: here "${here.split('\n')[0]}", there "${there[i]}"`]
  })
  assert.deepEqual(disagreeing, [])
  const rejected = there.filter(Boolean).length
  const counts = [rejected, names.length - rejected]
  assert.ok(counts[0] >= least[0] && counts[1] >= least[1], `${counts} of ${names.length}`)
}

test('the same rules as in a browser', () => compare(rules, [1000, 500]))

test('names are those that a browser takes', () => {
  const cases = words.flatMap((word) =>
    Object.entries(declaring).map(([kind, make]) => [`${kind} ${word}`, make(word)]),
  )
  return compare(Object.fromEntries(cases), [400, 200])
})
