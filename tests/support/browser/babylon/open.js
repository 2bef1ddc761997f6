// Bundles a page with Babylon.js and 'warpjet/babylon', and opens it.
import { fileURLToPath } from 'node:url'
import { build } from 'vite'
import { launchBrowserWithWebGPU, openPage } from '../browser.js'
import { servePages } from '../server.js'

const root = fileURLToPath(new URL('../../../../', import.meta.url))

/** Opens a page that runs a script of this folder → { page, messages, close }; `messages` collects the console messages of the page. */
export async function openBabylonPage(script) {
  const project = `.build/babylon/${script.replace('.js', '')}`
  await build({
    configFile: false,
    logLevel: 'error',
    root,
    base: './',
    build: {
      outDir: `${root}${project}`,
      emptyOutDir: true,
      minify: false,
      target: 'es2022',
      rolldownOptions: {
        input: `${root}tests/support/browser/babylon/${script}`,
        output: { entryFileNames: 'page.js' },
      },
    },
  })
  const browser = await launchBrowserWithWebGPU()
  const pages = await servePages()
  const html = `<!doctype html><body><script type="module" src="/${project}/page.js"></script>`
  const { page, messages } = await openPage(browser, pages.page(html))
  await page
    .waitForFunction(() => document.title === 'ready')
    .catch((error) => {
      throw new Error(`${error.message}\n${messages.join('\n')}`)
    })
  return {
    page,
    messages,
    async close() {
      await browser.close()
      await pages.close()
    },
  }
}
