import { launchBrowser, openPage } from '/work/wt/site/tests/browser/support/browser.js'
import { serveSources } from '/work/wt/site/tests/browser/support/site.js'
import { drawLittle, framesInPlayground } from '/work/wt/site/tests/browser/support/frames.js'
const browser = await launchBrowser()
const server = await serveSources(5998)
const context = await browser.newContext({ viewport: { width: 1280, height: 900 } })
await drawLittle(context, framesInPlayground)
const { page, messages } = await openPage(context, server.resolvedUrls.local[0] + 'playground/index.html' + (process.argv[2] ?? ''))
await page.waitForTimeout(Number(process.argv[3] ?? 8000))
console.log(messages, await page.locator('main').getAttribute('aria-busy'), await page.locator('.mistake').textContent(), (await page.locator('#panel').textContent()).slice(0, 200))
console.log(page.frames().map((f) => f.url()))
await page.screenshot({ path: '/tmp/try.png' })
await browser.close(); await server.close(); process.exit()
