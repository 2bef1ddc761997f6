// npm run picture: draws examples/composition as web/docs/composition.png, the picture of web/docs/composition.md.
import { chromium } from 'playwright-core'
import { createServer } from 'vite'
import { build } from './build.mjs'
import { findBrowser } from './lib/browser.mjs'
import { path } from './lib/files.mjs'
import { softwareFlags } from './lib/flags.mjs'
import { good, main } from './lib/terminal.mjs'

const file = 'web/docs/composition.png'

await main(async () => {
  await build()
  const server = await createServer({
    configFile: path('web/vite.config.js'),
    logLevel: 'warn',
    server: { port: 5500, watch: null },
  })
  await server.listen()
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: softwareFlags,
  })
  try {
    const viewport = { width: 640, height: 480 }
    const page = await browser.newPage({ viewport, deviceScaleFactor: 1.25 })
    await page.goto(`${server.resolvedUrls.local[0]}examples/composition/index.html`)
    await page.waitForFunction(() => window.frameCount >= 1)
    // At the beginning its warps swing out furthest.
    await page.evaluate(async () => {
      window.noLoop()
      window.p5.instance.millis = () => 0
      await window.redraw()
    })
    await page.screenshot({ path: path(file) })
  } finally {
    await browser.close()
    await server.close()
  }
  good(file)
})
