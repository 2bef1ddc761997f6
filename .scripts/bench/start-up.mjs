// npm run bench -- start-up: measures how long a page waits for warpjet's script to run, and for the first two calls of createWarp.
import { launchBrowser } from '../../tests/support/browser/browser.js'
import { servePages } from '../../tests/support/browser/server.js'
import { median } from '../lib/median.mjs'

const runs = 15

/** The page also records the milliseconds in `WebAssembly.Module` and `WebAssembly.Instance`. */
const html = `<!doctype html>
<meta charset="utf-8">
<script src="/node_modules/p5/lib/p5.min.js"></script>
<script>
const inWasm = { Module: 0, Instance: 0 }
for (const name of Object.keys(inWasm))
  WebAssembly[name] = new Proxy(WebAssembly[name], {
    construct(constructor, args) {
      const start = performance.now()
      const result = Reflect.construct(constructor, args)
      inWasm[name] += performance.now() - start
      return result
    },
  })
const start = performance.now()
</script>
<script src="/dist/p5.warpjet.min.js"></script>
<script>
const loaded = performance.now()
const offset = ({ glsl, position, millis }) => glsl.vec3(0, position.x().add(millis).sin(), 0)
function setup() {
  createCanvas(50, 50, WEBGL)
  noLoop()
  const times = [performance.now()]
  for (let i = 0; i < 2; i++) {
    createWarp(offset)
    times.push(performance.now())
  }
  window.stages = {
    script: loaded - start,
    'first warp': times[1] - times[0],
    'part of it: compile': inWasm.Module,
    'part of it: instantiate': inWasm.Instance,
    'second warp': times[2] - times[1],
  }
}
</script>`

export async function measure() {
  const server = await servePages()
  const browser = await launchBrowser()
  const times = []
  for (let i = 0; i < runs; i++) {
    // A new context has no compiled code in its cache.
    const context = await browser.newContext()
    const page = await context.newPage()
    await page.goto(server.page(html))
    times.push(await (await page.waitForFunction('window.stages')).jsonValue())
    await context.close()
  }
  await browser.close()
  await server.close()
  const medianOf = (stage) => Number(median(times.map((each) => each[stage])).toFixed(1))
  const stages = Object.keys(times[0]).map((stage) => [stage, medianOf(stage)])
  console.log(`p5.warpjet.min.js in Chromium, medians of ${runs} pages in ms`)
  console.table(Object.fromEntries(stages))
}
