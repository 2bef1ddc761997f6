// Tests that warpjet accepts and rejects the same WGSL as Chromium.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { wgslOffset } from '../../dist/glsl.js'
import { launchBrowser, openPage, webgpuFlags } from '../support/browser/browser.js'
import { servePages } from '../support/browser/server.js'
import { declarers, rules, words } from '../wgsl/rules.js'

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
const knownDifferences = [
  // The function uses a feature that vertex shaders lack.
  /statement: (?:discard|let x = dpdx)/,
  // A warp needs loops that end.
  /statement: while true \{ \}/,
  // Source may be a piece of a shader, whose pipeline is unknown.
  /global declaration: var<uniform> x: f32;/,
  /global declaration: enable f16/,
  // An alias of a pointer type.
  /alias V = ptr/,
  // A variable whose name is also that of the address space in its declaration.
  /global private/,
  // The result of the offset function is then another vec3f.
  /structure vec3f/,
]

/** Returns the browser's error message about each source; empty if it accepts the source. */
const browserMessages = (texts) =>
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

function ourMessage(text) {
  try {
    wgslOffset(text, { function: 'offset', maxIterations: 8 })
    return ''
  } catch (error) {
    assert.equal(error.name, 'WarpError', `${error.stack}\n${text}`)
    return error.message
  }
}

async function compare(cases, minimums) {
  const names = Object.keys(cases)
  const theirs = await browserMessages(Object.values(cases))
  const disagreeing = names.flatMap((name, i) => {
    const ours = ourMessage(cases[name])
    if (!ours === !theirs[i] || knownDifferences.some((pattern) => pattern.test(name))) return []
    return [`${name}: ours "${ours.split('\n')[0]}", the browser's "${theirs[i]}"`]
  })
  assert.deepEqual(disagreeing, [])
  const rejected = theirs.filter(Boolean).length
  const counts = [rejected, names.length - rejected]
  assert.ok(counts[0] >= minimums[0] && counts[1] >= minimums[1], `${counts} of ${names.length}`)
}

test('source follows the same rules as in a browser', () => compare(rules, [1000, 500]))

test('source may use the same names as in a browser', () => {
  const cases = words.flatMap((word) =>
    Object.entries(declarers).map(([kind, make]) => [`${kind} ${word}`, make(word)]),
  )
  return compare(Object.fromEntries(cases), [400, 200])
})
