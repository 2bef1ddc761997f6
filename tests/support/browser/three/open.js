// Opens pages with a version of three.js and 'warpjet/three'.
import { launchBrowser, openPage } from '../browser.js'
import { servePages } from '../server.js'

/** The versions of three.js, as folders of node_modules. */
export const versions = ['three', 'three-oldest']

const html = (version, imports = {}) => `<!doctype html><body style="margin:0">
<script type="importmap">${JSON.stringify({
  imports: {
    three: `/node_modules/${version}/build/three.module.js`,
    'three/webgpu': `/node_modules/${version}/build/three.webgpu.js`,
    'three/tsl': `/node_modules/${version}/build/three.tsl.js`,
    'three/addons/': `/node_modules/${version}/examples/jsm/`,
    warpjet: '/dist/warpjet.js',
    'warpjet/mesh': '/dist/mesh.js',
    'warpjet/deformers': '/dist/deformers.js',
    'three-custom-shader-material/vanilla':
      '/node_modules/three-custom-shader-material/vanilla/three-custom-shader-material.es.js',
    'warpjet/three': '/dist/three.js',
    'warpjet/glsl': '/dist/glsl.js',
    'warpjet/three/webgpu': '/dist/three.webgpu.js',
    ...imports,
  },
})}</script>`

/** Starts a browser and a server. Returns { open(version, script), listing(code), close() }. `open` and `listing` return { page, messages }. */
export const threePages = async (flags) => threePagesIn(await launchBrowser(flags))

/** Does the same as `threePages` in a running browser, which `close()` closes. */
export async function threePagesIn(browser) {
  const pages = await servePages()
  return {
    async open(version, script = 'page.js', imports) {
      const from = `/tests/support/browser/three/${script}`
      const source = `${html(version, imports)}<script type="module" src="${from}"></script>`
      const opened = await openPage(browser, pages.page(source))
      await opened.page
        .waitForFunction(() => document.title === 'ready', null, { timeout: 30_000 })
        .catch((error) => {
          throw new Error(`${error.message}\n${opened.messages.join('\n')}`)
        })
      return opened
    },
    /** Opens a page that runs a listing of the docs. */
    listing: (code) =>
      openPage(browser, pages.page(`${html('three')}<script type="module">${code}</script>`)),
    async close() {
      await browser.close()
      await pages.close()
    },
  }
}
