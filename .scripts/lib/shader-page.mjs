// A page that times shaders with the modules of the interactive benchmark.
import { openPage } from '../../tests/support/browser/browser.js'

const html = `<!doctype html><meta charset="utf-8">
<script type="importmap">{ "imports": { "gl-matrix": "/node_modules/gl-matrix/esm/index.js" } }</script>
<script type="module">
import { Scene } from '/web/bench/scene.js'
import { quantile } from '/web/bench/statistics.js'
Object.assign(window, { Scene, quantile })
</script>`

/** Opens the page, which has the globals `Scene` and `quantile`. `server` is the result of `servePages`. */
export async function openShaderPage(browser, server) {
  const { page } = await openPage(browser, server.page(html))
  await page.waitForFunction('window.Scene')
  return page
}
