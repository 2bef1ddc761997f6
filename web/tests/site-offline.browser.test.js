// Tests the built site offline, after one visit, from a host that removes .html from addresses. This is harder than a host that serves
// each file at its own address, since a worker must not answer a navigation with a redirected response.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { buildSite, folder } from '../../.scripts/site.mjs'
import { desktop, path } from '../../tests/support/browser/bench.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { serveCleanly } from '../../tests/support/browser/clean-urls.js'
import { drawLittle } from '../../tests/support/browser/frames.js'
import { visibleFrame, waitUntilSettled } from '../../tests/support/browser/playground.js'
import { withReducedMotion, withoutWorker } from '../../tests/support/browser/site.js'

const patience = { timeout: 120_000 }

let browser, server, url
before(async () => {
  await buildSite()
  browser = await launchBrowser()
  server = await serveCleanly(path(folder), '/some/folder')
  url = server.url
})
after(async () => {
  await browser.close()
  server.close()
})

test('after one visit, the whole site works offline', async () => {
  const context = await browser.newContext(desktop)
  await drawLittle(context)
  const { page, messages } = await openPage(context, url)
  // The worker takes over once it has cached all files.
  await page.waitForFunction(() => navigator.serviceWorker.controller, null, patience)
  await context.setOffline(true)
  await page.reload(patience)
  await page.waitForSelector('.hero canvas', patience)
  await page.locator('#search').fill('noise')
  await page.waitForSelector('#found a', patience)
  // Use addresses with .html, as in links, and without, as they are in the address bar with this host.
  for (const [address, title] of [
    ['docs/plots.html', /plotted/],
    ['docs/plots', /plotted/],
    ['gallery/lotus/', /Lotus/],
    ['gallery/text-bulge', /./],
    ['gallery/text-bulge/index.html', /./],
  ]) {
    await page.goto(url + address, patience)
    assert.match(await page.locator('h1').textContent(), title)
    const { width } = await page.locator('.bar').boundingBox()
    assert.equal(width, desktop.viewport.width, `${address} has no style`)
  }
  const frame = await (await page.waitForSelector('iframe.shown', patience)).contentFrame()
  await frame.waitForFunction(() => window.frameCount >= 2, null, patience)
  await page.goto(`${url}playground/index.html#example=bunny`, patience)
  await waitUntilSettled(page)
  assert.equal(await page.locator('.mistake').textContent(), '')
  const bunny = await visibleFrame(page)
  await bunny.waitForFunction(() => window.frameCount >= 2, null, patience)
  await page.locator('#example').selectOption('airplane-twist')
  await page.waitForFunction(() => document.querySelector('main').ariaBusy === 'true')
  await waitUntilSettled(page)
  assert.equal(await page.locator('.mistake').textContent(), '')
  assert.deepEqual(messages, [])
  await context.close()
})

test('a host that serves x/index.html at the address x serves the whole site, too', async (t) => {
  const bare = await serveCleanly(path(folder), '/some/folder', { slashes: false })
  t.after(() => bare.close())
  const context = await browser.newContext(withReducedMotion(desktop))
  await context.addInitScript(withoutWorker)
  await drawLittle(context)
  const { page, messages } = await openPage(context, bare.url)
  const places = ['', 'docs/', 'gallery/lotus/', 'drop/', 'bench/', 'playground/']
  for (const place of places) {
    await page.goto(bare.url + place, patience)
    // The files to which the page links exist and are served at these addresses.
    const links = await page.locator('a[href]').evaluateAll((all) => all.map(({ href }) => href))
    for (const link of new Set(links.filter((link) => link.startsWith(bare.url)))) {
      const response = await page.request.get(link)
      assert.equal(response.status(), 200, `${place} leads to ${link}`)
      if (link.endsWith('/')) assert.equal(response.url(), link)
    }
  }
  await waitUntilSettled(page)
  assert.equal(await page.locator('.mistake').textContent(), '')
  assert.deepEqual(messages, [])
  // A page opened without its slash adds one, after the browser has preloaded some files from wrong addresses.
  for (const place of places) {
    await page.goto((bare.url + place).slice(0, -1), patience)
    assert.equal(page.url(), bare.url + place)
    assert.ok(await page.evaluate(() => document.styleSheets.length), `${place} has no style`)
    assert.deepEqual(
      messages.splice(0).filter((text) => !text.includes('404')),
      [],
    )
  }
  await waitUntilSettled(page)
  assert.equal(await page.locator('.mistake').textContent(), '')
  await context.close()
})
