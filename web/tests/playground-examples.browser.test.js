// Opens every example of the gallery in the playground by its link, and checks that it draws as in the gallery, without errors.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { desktop } from '../../tests/support/browser/bench.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import {
  assertPicture,
  measurePicture,
  reduceSketches,
  sketchesForTests,
  still,
} from '../../tests/support/browser/examples.js'
import { keepFrames } from '../../tests/support/browser/frames.js'
import { visibleFrame, waitUntilSettled } from '../../tests/support/browser/playground.js'
import { serveSources } from '../../tests/support/browser/site.js'
import { sections } from '../catalogue.js'

let browser, server, page, messages
before(async () => {
  browser = await launchBrowser()
  server = await serveSources(5250, [sketchesForTests()])
  const context = await browser.newContext(desktop)
  const [url] = server.resolvedUrls.local
  await reduceSketches(context, url, { before: still })
  await context.addInitScript(keepFrames)
  ;({ page, messages } = await openPage(
    context,
    `${url}playground/index.html#example=displaced-plane`,
  ))
  await waitUntilSettled(page)
})
after(async () => {
  await page.context().close()
  await browser.close()
  await server.close()
})

/** Follows a link to an example in a tab in which the playground is already open. */
async function open(name) {
  await page.evaluate((name) => {
    document.querySelector('main').ariaBusy = 'true'
    location.hash = `example=${name}`
  }, name)
  await page.waitForFunction((name) => document.querySelector('#example').value === name, name, {
    timeout: 60_000,
  })
  await waitUntilSettled(page)
}

for (const { name, title } of sections.flatMap(({ examples }) => examples))
  test(`${name}: ${title}`, async () => {
    await open(name)
    assert.equal(await page.locator('.mistake').textContent(), '')
    assertPicture(await measurePicture(await visibleFrame(page)))
    await page.getByRole('tab', { name: 'Console' }).click()
    assert.deepEqual(await page.locator('.printed li').allTextContents(), [])
    assert.deepEqual(messages.splice(0), [])
  })
