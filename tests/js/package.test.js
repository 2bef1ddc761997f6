// What `npm i warpjet` brings.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { createRequire } from 'node:module'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
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
    .filter((path) => !/^dist\/(shared\/)?[\w.-]+\.js(\.map)?$|^dist\/types\/.*\.d\.ts$/.test(path))
  assert.deepEqual(others.sort(), ['CHANGELOG.md', 'LICENSE', 'README.md', 'package.json'])
  const modules = ['warpjet', 'text', 'p5', 'p5.browser', 'autodiff', 'mesh', 'deformers', 'cli']
  const single = ['warpjet.min', 'mesh.min', 'p5.warpjet.min', 'warpjet.deformers.min']
  for (const file of [...modules, ...single])
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
      "import { compileWarp as compileText } from 'warpjet/text'\n" +
      "import { createWarp } from 'warpjet/p5'\nimport { loadMesh, type Mesh } from 'warpjet/mesh'\n" +
      "import { chain, twist, type TwistOptions } from 'warpjet/deformers'\n" +
      'export const all: unknown[] = [compileWarp, compileText, gen, createWarp, chain(twist())]\n' +
      'export const options: TwistOptions = { axis: "x", angle: ({ millis }) => millis.div(1000) }\n' +
      'export const mesh: Promise<Mesh> = loadMesh(new Uint8Array(8))\n' +
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
  const mesh = await import('warpjet/mesh')
  const text = await import('warpjet/text')
  assert.equal(autodiff.gen, core.gen)
  assert.equal(text.gen, core.gen)
  assert.equal(typeof addon.default, 'function')
  assert.equal(mesh.WarpError, core.WarpError)
  const { twist } = await import('warpjet/deformers')
  assert.throws(() => twist(5), core.WarpError)
  assert.match(core.compileWarp(twist()).code, /warpedNormal/)
  assert.equal(typeof globalThis.window, 'undefined')
})

test('require loads every entry, in the versions of Node that package.json names', () => {
  const require = createRequire(import.meta.url)
  for (const entry of ['', '/text', '/p5', '/autodiff', '/mesh', '/deformers'])
    assert.ok(Object.keys(require(`warpjet${entry}`)).length, entry)
  // The first of each line that has require for modules.
  const { engines } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'))
  assert.equal(engines.node, '^20.19.0 || >=22.12.0')
})

test('glsl-autodiff’s global script name works: AutoDiff.gen', async () => {
  await import('../../dist/p5.warpjet.min.js')
  assert.equal(typeof globalThis.AutoDiff.gen, 'function')
})
