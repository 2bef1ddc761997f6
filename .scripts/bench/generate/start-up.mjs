// Measures how long a page waits for warpjet: until its script has run, and until the first createWarp returns; and the same in Node.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { chromium } from 'playwright-core'
import { findBrowser } from '../../lib/browser.mjs'
import { path } from '../../lib/files.mjs'
import { softwareFlags } from '../../lib/flags.mjs'
import { median } from '../../lib/median.mjs'

const runs = 15

/** Code that both hosts run before warpjet. Records the milliseconds of `WebAssembly.Module` and `.Instance`. */
const watchWebAssembly = `
const inWasm = { compile: 0, instantiate: 0 }
for (const [name, stage] of [['Module', 'compile'], ['Instance', 'instantiate']])
  WebAssembly[name] = new Proxy(WebAssembly[name], {
    construct(constructor, args) {
      const start = performance.now()
      const result = Reflect.construct(constructor, args)
      inWasm[stage] += performance.now() - start
      return result
    },
  })
const offset = ({ glsl, position, millis }) => glsl.vec3(0, position.x().add(millis).sin(), 0)`

/** Returns code for the milliseconds of each stage. The parameters are expressions. */
const writeStages = (script, first, second) => `({
  'script': ${script}, 'first warp': ${first}, 'part of it: compile': inWasm.compile, 'part of it: instantiate': inWasm.instantiate, 'second warp': ${second},
})`

const page = `<!doctype html>
<meta charset="utf-8">
<script src="/node_modules/p5/lib/p5.min.js"></script>
<script>${watchWebAssembly}
const start = performance.now()</script>
<script src="/dist/p5.warpjet.min.js"></script>
<script>
const loaded = performance.now()
function setup() {
  createCanvas(50, 50, WEBGL)
  noLoop()
  const times = [performance.now()]
  for (let i = 0; i < 2; i++) {
    createWarp(offset)
    times.push(performance.now())
  }
  window.stages = ${writeStages('loaded - start', 'times[1] - times[0]', 'times[2] - times[1]')}
}
</script>`

async function measureInChromium() {
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: softwareFlags,
  })
  try {
    const times = []
    for (let i = 0; i < runs; i++) {
      // A new context has no compiled code in its cache.
      const context = await browser.newContext()
      await context.route('**/*', (route) => {
        const { pathname } = new URL(route.request().url())
        if (pathname === '/') return route.fulfill({ contentType: 'text/html', body: page })
        if (pathname === '/favicon.ico') return route.fulfill({ status: 204 })
        return route.fulfill({
          contentType: 'text/javascript; charset=utf-8',
          body: readFileSync(path(`.${pathname}`)),
        })
      })
      const tab = await context.newPage()
      await tab.goto('http://localhost/')
      times.push(await (await tab.waitForFunction('window.stages')).jsonValue())
      await context.close()
    }
    return times
  } finally {
    await browser.close()
  }
}

function measureInNode() {
  const code = `${watchWebAssembly}
    const times = [performance.now()]
    const { compileWarp } = await import('./dist/warpjet.js')
    times.push(performance.now())
    for (let i = 0; i < 2; i++) {
      compileWarp(offset)
      times.push(performance.now())
    }
    console.log(JSON.stringify(${writeStages('times[1] - times[0]', 'times[2] - times[1]', 'times[3] - times[2]')}))`
  const run = () =>
    execFileSync(process.execPath, ['--input-type=module', '--eval', code], {
      cwd: path('.'),
      encoding: 'utf8',
    })
  return Array.from({ length: runs }, () => JSON.parse(run()))
}

/** Returns the median milliseconds of each stage, by host. */
export async function measureStartUp() {
  const medians = (all) =>
    Object.keys(all[0]).map((stage) => {
      const ms = median(all.map((each) => each[stage]))
      return [stage, Number(ms.toFixed(1))]
    })
  return {
    'Chromium, p5.warpjet.min.js': Object.fromEntries(medians(await measureInChromium())),
    'Node, warpjet': Object.fromEntries(medians(measureInNode())),
  }
}
