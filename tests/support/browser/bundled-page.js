// Opens a page whose script Vite bundles, for packages that browsers cannot import by themselves.
import { fileURLToPath } from 'node:url'
import { build } from 'vite'
import { launchBrowser, launchBrowserWithWebGPU, openPage } from './browser.js'
import { servePages } from './server.js'

const root = fileURLToPath(new URL('../../../', import.meta.url))

/**
 * Opens a page that runs `script`, a file of this folder that sets the title "ready" when it has loaded. Returns { page, messages, close() };
 * `messages` collects the console messages of the page.
 */
export async function bundledPage(script, { hasWebGPU = false } = {}) {
  const folder = `.build/bundled/${script.replace('.js', '')}`
  await build({
    configFile: false,
    logLevel: 'error',
    root,
    base: './',
    publicDir: false,
    resolve: { dedupe: ['three', 'react'] },
    define: { 'process.env.NODE_ENV': '"development"' },
    build: {
      outDir: folder,
      minify: false,
      target: 'es2022',
      rolldownOptions: {
        input: `${root}tests/support/browser/${script}`,
        output: { entryFileNames: 'page.js' },
      },
    },
  })
  const browser = await (hasWebGPU ? launchBrowserWithWebGPU() : launchBrowser())
  const pages = await servePages()
  const html = `<!doctype html><body><script type="module" src="/${folder}/page.js"></script>`
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
