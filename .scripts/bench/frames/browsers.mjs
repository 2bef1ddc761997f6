// Opens the two browsers of the benchmark: one without a limit of the frame rate (uncapped) and one with vsync (capped), both on the
// machine's GPU if it has one.
import { chromium } from 'playwright-core'
import { webgpuFlags } from '../../../tests/support/browser/browser.js'
import { gpuFlags, softwareFlags, uncappedFlags } from '../../lib/flags.mjs'
import { Stop, good } from '../../lib/terminal.mjs'

const softwareRenderers = /swiftshader|llvmpipe|softpipe|basic render/i

const launch = (args) => chromium.launch({ executablePath: process.env.WARPJET_CHROMIUM, args })

/** Runs in the page: returns the name of the WebGL 2 renderer, or null. */
function findRenderer() {
  const gl = document.createElement('canvas').getContext('webgl2')
  const extension = gl?.getExtension('WEBGL_debug_renderer_info')
  return gl && gl.getParameter(extension ? extension.UNMASKED_RENDERER_WEBGL : gl.RENDERER)
}

async function readRenderer(launch, flags) {
  const browser = await launch(flags)
  try {
    const page = await browser.newPage()
    return await page.evaluate(findRenderer)
  } finally {
    await browser.close()
  }
}

/** Chooses the machine's GPU, or software if there is no GPU or if `withoutGpu` is true. Returns { flags, renderer, isSoftware }. */
export async function chooseRenderer(launch, withoutGpu) {
  // A GPU whose driver crashes the browser counts as no GPU.
  const gpu = withoutGpu ? null : await readRenderer(launch, gpuFlags).catch(() => null)
  if (gpu && !softwareRenderers.test(gpu))
    return { flags: gpuFlags, renderer: gpu, isSoftware: false }
  const renderer = await readRenderer(launch, softwareFlags)
  if (!renderer) throw new Stop('This Chromium has no WebGL 2: name another one in CHROME_PATH.')
  return { flags: softwareFlags, renderer, isSoftware: true }
}

/**
 * Starts a browser that draws on the machine's GPU, if it has one, and prints the name of the renderer. If a list of further flags for
 * WebGPU is passed, the pages of the browser have WebGPU.
 */
export async function launchFastest(withoutGpu, moreWebgpuFlags) {
  const { flags, renderer, isSoftware } = await chooseRenderer(launch, withoutGpu)
  good(`${isSoftware ? 'No GPU' : 'GPU'}: ${renderer}`)
  const adapterFlags = isSoftware
    ? [...webgpuFlags, '--use-vulkan=swiftshader']
    : ['--enable-unsafe-webgpu']
  return launch([...flags, ...(moreWebgpuFlags ? [...adapterFlags, ...moreWebgpuFlags] : [])])
}

/** Opens the benchmark's page twice, uncapped and capped. Returns { version, renderer, isSoftware, uncapped, capped, close() }. */
export async function openBrowsers(url, size, withoutGpu) {
  const { flags, renderer, isSoftware } = await chooseRenderer(launch, withoutGpu)
  const browsers = []
  const close = () => Promise.all(browsers.map((browser) => browser.close()))
  async function open(moreFlags) {
    const browser = await launch([...flags, ...moreFlags])
    browsers.push(browser)
    const page = await browser.newPage({ viewport: { width: size, height: size } })
    await page.goto(`${url}bench/driven.html`)
    await page.waitForFunction('window.bench')
    await page.evaluate((size) => void window.bench.open(size), size)
    return page
  }
  try {
    const pages = { uncapped: await open(uncappedFlags), capped: await open([]) }
    return { version: browsers[0].version(), renderer, isSoftware, ...pages, close }
  } catch (error) {
    await close()
    throw error
  }
}
