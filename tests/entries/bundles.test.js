// Tests the contents of the files in dist, and of bundles of them.
import assert from 'node:assert/strict'
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs'
import { describe, test } from 'node:test'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { gzipSync } from 'node:zlib'
import { rolldown } from 'rolldown'

const root = fileURLToPath(new URL('../../', import.meta.url))
const read = (file) => readFileSync(`${root}${file}`, 'utf8')
const { version, license } = JSON.parse(read('package.json'))

/** Maps the name of a wasm module → the beginning of its inlined text, by which `modulesIn` recognizes it. */
const wasm = Object.fromEntries(
  ['core', 'evaluation', 'mesh', 'glsl'].map((name) => {
    const [, text] = /export default "([^"]+)"/.exec(read(`js-bindings/generated/${name}-wasm.js`))
    assert.ok(text.length > 1000)
    return [name, text.slice(0, 400)]
  }),
)

/** Returns the names of the wasm modules that a file contains. */
const modulesIn = (text) => Object.keys(wasm).filter((name) => text.includes(wasm[name]))

const files = ['dist', 'dist/shared'].flatMap((folder) =>
  readdirSync(`${root}${folder}`)
    .filter((name) => name.endsWith('.js'))
    .map((name) => `${folder}/${name}`),
)

test('names of shared files do not change between releases', () => {
  const shared = [
    'basics',
    'compiler',
    'compute-passes',
    'detail-passes',
    'detailed-mesh',
    'evaluation',
    'front-end',
    'meshes',
    'operating',
    'p5-addon',
    'p5-hooks',
    'surface-variation',
    'three-warp',
    'translating',
    'with-mesh',
  ]
  assert.deepEqual(
    files.filter((file) => file.startsWith('dist/shared/')),
    shared.map((name) => `dist/shared/${name}.js`),
  )
})

test('every file has its version, its licence, and a source map', () => {
  for (const file of files) {
    const text = read(file)
    const lines = text.split('\n').slice(0, 2).join('\n')
    assert.match(
      lines,
      new RegExp(`/\\*! warpjet ${version.replaceAll('.', '\\.')} \\| ${license} `),
      file,
    )
    if (!existsSync(`${root}${file}.map`)) assert.doesNotMatch(text, /function|=>/, file)
    else
      assert.match(
        JSON.parse(read(`${file}.map`)).sources.join(),
        /js-bindings\/[\w./-]+\.ts/,
        file,
      )
  }
})

test('minified files keep the name of the error class', () => {
  for (const file of files.filter((name) => name.endsWith('.min.js')))
    if (!/warpjet\.(?:deformers|glsl|operators)\.min\.js$/.test(file))
      assert.match(read(file), /\bWarpError=class extends Error/, file)
})

test('warpjet.min.js and mesh.min.js need no other file', async () => {
  const folder = `${root}.build/alone`
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(folder, { recursive: true })
  for (const name of ['warpjet.min.js', 'mesh.min.js'])
    copyFileSync(`${root}dist/${name}`, `${folder}/${name.replace('.js', '.mjs')}`)
  const { compileWarp, WarpError } = await import(pathToFileURL(`${folder}/warpjet.min.mjs`))
  const { loadMesh, bakeWarp } = await import(pathToFileURL(`${folder}/mesh.min.mjs`))
  const warp = compileWarp(({ glsl }) => glsl.vec3(1, 0, 0))
  const mesh = await loadMesh(new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'))
  assert.equal(bakeWarp(mesh, warp).positions[0], 1)
  assert.throws(() => compileWarp(3), WarpError)
  assert.equal(WarpError.name, 'WarpError')
})

describe('an entry loads only the files that it needs', () => {
  /** Returns `file` and all files that it imports statically. */
  function closure(file, files = new Set()) {
    if (files.has(file)) return files
    files.add(file)
    for (const [, name] of read(file).matchAll(/^(?:import|export)[^;]*?"(\.[^"]+)";/gm))
      closure(new URL(name, `file:///${file}`).pathname.slice(1), files)
    return files
  }

  for (const [entry, expected] of Object.entries({
    warpjet: ['core', 'evaluation'],
    text: ['core'],
    autodiff: ['core'],
    p5: ['core', 'evaluation'],
    'p5.browser': ['core', 'evaluation'],
    mesh: ['mesh'],
    deformers: [],
    three: ['core', 'evaluation', 'glsl'],
    'three.webgpu': ['core', 'evaluation', 'mesh', 'glsl'],
    glsl: ['core', 'glsl'],
    operators: [],
    'operators-runtime': [],
    'operators-plugin': [],
    'p5.warpjet.min': ['core', 'evaluation'],
    'warpjet.deformers.min': [],
    'warpjet.glsl.min': ['glsl'],
    'warpjet.operators.min': [],
    'warpjet.min': ['core', 'evaluation'],
    'mesh.min': ['mesh'],
  }))
    test(`${entry}.js: ${expected.join(' and ') || 'no wasm'}`, () => {
      const text = [...closure(`dist/${entry}.js`)].map(read).join('\n')
      assert.deepEqual(modulesIn(text), expected)
    })
})

/** Bundles `code` with Rolldown. Returns the path of the bundle. */
async function bundle(name, code, platform) {
  const folder = `${root}.build/bundles`
  mkdirSync(folder, { recursive: true })
  writeFileSync(`${folder}/p5.js`, 'export default class P5 { static Graphics = class {} }')
  writeFileSync(`${folder}/${name}.js`, code)
  const file = `${folder}/${name}-bundle.mjs`
  const build = await rolldown({
    input: `${folder}/${name}.js`,
    platform,
    resolve: { alias: { p5: `${folder}/p5.js` } },
    external: /^(three|react)(\/|$)/,
  })
  await build.write({ file, minify: true, codeSplitting: false })
  return file
}

describe("import 'warpjet/p5' registers with the imported p5", () => {
  // Rollup's plugin for packages has no platform by default.
  for (const platform of ['browser', 'neutral'])
    test(`on the platform ${platform}`, async () => {
      const code = "import 'warpjet/p5'\nexport { default } from 'p5'"
      const { default: P5 } = await import(pathToFileURL(await bundle(platform, code, platform)))
      assert.equal(typeof P5.prototype.createWarp, 'function')
      assert.equal(typeof P5.Graphics.prototype.createWarp, 'function')
    })
})

test("a bundle of 'warpjet/p5' for Node does not contain p5", async () => {
  const file = await bundle('node', "export { default } from 'warpjet/p5'", 'node')
  assert.doesNotMatch(readFileSync(file, 'utf8'), /class P5/)
})

test('a bundle of warpjet/text cannot evaluate warps, and the message names the entry that can', async () => {
  const file = await bundle('text', "export { compileWarp } from 'warpjet/text'", 'browser')
  assert.deepEqual(modulesIn(readFileSync(file, 'utf8')), ['core'])
  const { compileWarp } = await import(pathToFileURL(file))
  const { compileWarp: completeCompileWarp } = await import('warpjet')
  const twist = ({ glsl, position }) => position.mult(glsl.val(2).sin())
  const warp = compileWarp(twist)
  assert.equal(warp.code, completeCompileWarp(twist).code)
  for (const method of ['evaluate', 'evaluateAt', 'bounds', 'foldover'])
    assert.throws(() => warp[method]({ positions: [] }), {
      name: 'WarpError',
      message: new RegExp(
        `^${method}: this compileWarp only writes shader code; .* script p5\\.warpjet\\.min\\.js, and of 'warpjet', also runs on the CPU\\.$`,
      ),
    })
})

test('a bundle that only imports warp from warpjet/three has no GLSL front end', async () => {
  const file = await bundle('warp-in-three', "export { warp } from 'warpjet/three'", 'browser')
  assert.deepEqual(modulesIn(readFileSync(file, 'utf8')), ['core', 'evaluation'])
})

test('warpjet contains no code of warpjet/three; prints the size that the latter adds', async () => {
  const measure = async (name, code) => {
    const text = readFileSync(await bundle(name, code, 'browser'), 'utf8')
    // Leaves out the inlined WebAssembly, which all of these bundles contain: with it, the difference would depend on where gzip's blocks
    // end.
    const script = text
      .split('"')
      .filter((part) => part.length < 50_000)
      .join('"')
    assert.ok(script.length < text.length - 300_000, `${script.length} of ${text.length}`)
    return { text, bytes: gzipSync(script, { level: 9 }).length }
  }
  const alone = await measure('alone', "export { compileWarp } from 'warpjet'")
  assert.doesNotMatch(alone.text, /onBeforeCompile|begin_vertex|"three/)
  // The code that loads models is a separate file, which addSurfaceVariation fetches.
  for (const [entry, names] of [
    ['three', 'warp, warpMaterial'],
    ['three/webgpu', 'warp, warpMaterial, warpNode'],
  ]) {
    const code = `export { compileWarp } from 'warpjet'\nexport { ${names} } from 'warpjet/${entry}'`
    const { bytes } = await measure(entry.replace('/', '-'), code)
    console.log(`warpjet/${entry} adds ${bytes - alone.bytes} bytes, gzipped`)
  }
})

// Excludes the translator of operators, whose parser has import(…) in its messages.
test('bundlers can resolve all imports', () => {
  for (const file of files.filter((name) => !/cli\.js$|min\.js$|translating\.js$/.test(name)))
    for (const [, specifier] of read(file).matchAll(/\bimport\s*\(([^)]*)\)/g))
      // Imports that bundlers must ignore are for Node only.
      if (!specifier.includes('/* webpackIgnore: true */'))
        assert.match(
          specifier,
          /^(["'])(\.\/(?:shared\/)?(?:compute-passes|surface-variation|with-mesh)\.js|https:.*)\1$/,
          file,
        )
})
