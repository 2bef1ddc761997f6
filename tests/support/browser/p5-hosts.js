// The hosts of p5 sketches as objects: a host is a version of p5 with one of its renderers. Each run of the tests uses only some of them.
import { leavePage } from './browser.js'
import { drawScenes, openHosts, p5HostsInThisRun, runSketch } from './sketch.js'

export const addon = '/dist/p5.warpjet.min.js'
export const glslAddon = '/dist/warpjet.glsl.min.js'
export const font = '/node_modules/@fontsource/fredoka/files/fredoka-latin-700-normal.woff'

/**
 * Opens the browsers of the hosts until the tests of the calling file have finished. Returns an object for each host. `hosts` are rows of the
 * table in sketch.js, and the scripts `more` are loaded after p5 and the addon. The code of a sketch starts with `async function setup() {
 * ${host.canvas(100, 100)}`.
 */
export async function openP5Hosts({ hosts = p5HostsInThisRun, more = [] } = {}) {
  const { browsers, server } = await openHosts([['2.x', 'WEBGL'], ...hosts])
  return hosts.map(([version, renderer, p5]) => {
    const [browser, scripts] = [browsers[renderer], [...p5, addon, ...more]]
    const open = (code, files = scripts) => runSketch(browser, server, files, code)
    return {
      name: `p5 ${version}, ${renderer}`,
      ...{ version, renderer, p5, scripts, server, browser, open },
      // p5 1.11 has no WebGPU, instances, text models or ordered hooks.
      isV1: version === '1.11',
      isWebGPU: renderer === 'WEBGPU',
      /** A browser for pages that need WebGL on any host. */
      webgl: browsers.WEBGL,
      canvas: (width, height) =>
        `${renderer === 'WEBGPU' ? 'await ' : ''}createCanvas(${width}, ${height}, ${renderer})`,
      draw: ({ files = scripts, ...options }) =>
        drawScenes(browser, server, files, { renderer, ...options }),
      /** Runs a sketch that sets `result`. Returns { result, messages }, the result and the lines on the console. */
      async run(code, files) {
        const { page, messages } = await open(code, files)
        const result = await page.evaluate('window.result')
        await leavePage(page)
        return { result, messages }
      },
    }
  })
}
