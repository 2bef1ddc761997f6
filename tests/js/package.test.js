// What `npm i warpjet` brings.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
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
  const modules = ['warpjet', 'p5', 'p5.browser', 'autodiff', 'mesh', 'deformers', 'cli']
  for (const file of [...modules, 'p5.warpjet.min', 'warpjet.deformers.min'])
    assert.ok(
      files.some(({ path }) => path === `dist/${file}.js`),
      file,
    )
  assert.ok(files.some(({ path }) => path === 'dist/types/index.d.ts'))
})

test('every entry loads in Node, without a DOM and without p5', async () => {
  const core = await import('warpjet')
  const autodiff = await import('warpjet/autodiff')
  const addon = await import('warpjet/p5')
  const mesh = await import('warpjet/mesh')
  assert.equal(autodiff.gen, core.gen)
  assert.equal(typeof addon.default, 'function')
  assert.equal(mesh.WarpError, core.WarpError)
  const { twist } = await import('warpjet/deformers')
  assert.throws(() => twist(5), core.WarpError)
  assert.match(core.compileWarp(twist()).code, /warpedNormal/)
  assert.equal(typeof globalThis.window, 'undefined')
})

test('glsl-autodiff’s global script name works: AutoDiff.gen', async () => {
  await import('../../dist/p5.warpjet.min.js')
  assert.equal(typeof globalThis.AutoDiff.gen, 'function')
})

test('the deformers bring no compiler: they use the one that is there', () => {
  for (const name of ['core', 'evaluation', 'mesh']) {
    const wasm = readFileSync(`${root}js-bindings/generated/${name}-wasm.js`, 'utf8')
    const [, base64] = /'([^']+)'/.exec(wasm)
    const script = readFileSync(`${root}dist/warpjet.deformers.min.js`, 'utf8')
    assert.ok(!script.includes(base64.slice(0, 200)), name)
  }
})

test('a page with a warp of p5 carries neither the evaluation nor the meshes', () => {
  for (const name of ['evaluation', 'mesh']) {
    const wasm = readFileSync(`${root}js-bindings/generated/${name}-wasm.js`, 'utf8')
    const [, base64] = /'([^']+)'/.exec(wasm)
    const script = readFileSync(`${root}dist/p5.warpjet.min.js`, 'utf8')
    assert.ok(base64.length > 1000)
    assert.ok(!script.includes(base64.slice(0, 200)), name)
  }
})
