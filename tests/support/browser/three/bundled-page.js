// Opens a page whose script Vite bundles, for packages that browsers cannot import by themselves.
import { fileURLToPath } from 'node:url'
import { build } from 'vite'
import { launchBrowser, openPage } from '../browser.js'
import { servePages } from '../server.js'

const root = fileURLToPath(new URL('../../../../', import.meta.url))

/** `script` is in this folder, `project` the folder of the bundle → { page, messages, close() }. */
export async function bundledPage(script, project) {
  await build({
    configFile: false,
    logLevel: 'error',
    root,
    publicDir: false,
    resolve: { dedupe: ['three', 'react'] },
    define: { 'process.env.NODE_ENV': '"development"' },
    build: {
      outDir: project,
      minify: false,
      target: 'es2022',
      rolldownOptions: {
        input: `${root}tests/support/browser/three/${script}`,
        output: { entryFileNames: 'page.js' },
      },
    },
  })
  const browser = await launchBrowser()
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
