// What `npm i warpjet` brings.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdirSync, writeFileSync } from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../../', import.meta.url))

test('the package holds what a user needs and nothing else', () => {
  const packed = execFileSync('npm', ['pack', '--dry-run', '--json', '--ignore-scripts'], {
    cwd: root,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'ignore'],
  })
  const report = JSON.parse(packed)
  const [{ files }] = Array.isArray(report) ? report : Object.values(report)
  const others = files
    .map(({ path }) => path)
    .filter((path) => !/^dist\/[\w.-]+\.js$|^dist\/types\/.*\.d\.ts$/.test(path))
  assert.deepEqual(others.sort(), ['CHANGELOG.md', 'LICENSE', 'README.md', 'package.json'])
  for (const file of ['warpjet', 'p5', 'p5.browser', 'autodiff', 'p5.warpjet.min'])
    assert.ok(
      files.some(({ path }) => path === `dist/${file}.js`),
      file,
    )
  assert.ok(files.some(({ path }) => path === 'dist/types/index.d.ts'))
})

test('the shipped types stand on their own', () => {
  const project = `${root}.build/consumer`
  mkdirSync(project, { recursive: true })
  writeFileSync(
    `${project}/use.ts`,
    "import { compileWarp, version } from 'warpjet'\nimport { gen } from 'warpjet/autodiff'\n" +
      "import { createWarp } from 'warpjet/p5'\nexport const all: unknown[] = [compileWarp, gen, createWarp]\n" +
      'export const text: string = version\n',
  )
  for (const [module, moduleResolution] of [
    ['nodenext', 'nodenext'],
    ['esnext', 'bundler'],
  ]) {
    const options = {
      strict: true,
      noEmit: true,
      module,
      moduleResolution,
      target: 'es2022',
      types: [],
    }
    writeFileSync(
      `${project}/tsconfig.json`,
      JSON.stringify({ compilerOptions: options, files: ['use.ts'] }),
    )
    execFileSync(process.execPath, ['node_modules/typescript/bin/tsc', '-p', project], {
      cwd: root,
      encoding: 'utf8',
    })
  }
})

test('every entry loads in Node, without a DOM and without p5', async () => {
  const core = await import('warpjet')
  const autodiff = await import('warpjet/autodiff')
  const addon = await import('warpjet/p5')
  assert.equal(autodiff.gen, core.gen)
  assert.equal(typeof addon.default, 'function')
  assert.equal(typeof globalThis.window, 'undefined')
})

test('glsl-autodiff’s global script name works: AutoDiff.gen', async () => {
  await import('../../dist/p5.warpjet.min.js')
  assert.equal(typeof globalThis.AutoDiff.gen, 'function')
})
