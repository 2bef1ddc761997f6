// Tests the contents of the package that `npm i warpjet` installs.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync, readFileSync, readdirSync } from 'node:fs'
import { createRequire } from 'node:module'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { bundles, entriesWithTypes, sources } from '../../.scripts/lib/entries.mjs'

const root = fileURLToPath(new URL('../../', import.meta.url))

let packed

/** Returns the files that npm would put into the package. */
function packedFiles() {
  if (packed) return packed
  const output = execFileSync('npm', ['pack', '--dry-run', '--json', '--ignore-scripts'], {
    cwd: root,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'ignore'],
  })
  const report = JSON.parse(output)
  const [{ files }] = Array.isArray(report) ? report : Object.values(report)
  return (packed = files)
}

test('the package contains what users need and nothing else', () => {
  const files = packedFiles()
  const others = files
    .map(({ path }) => path)
    .filter(
      (path) =>
        !/^dist\/(shared\/)?[\w.-]+\.js(\.map)?$|^dist\/types\/[\w.-]+\.d\.ts$|^web\/docs\//.test(
          path,
        ),
    )
  assert.deepEqual(others.sort(), [
    'CHANGELOG.md',
    'LICENSE',
    'NOTICE',
    'README.md',
    'package.json',
    'web/gallery.png',
  ])
  const paths = new Set(files.map(({ path }) => path))
  const ours = bundles.filter((file) => file !== 'dist/memory.js')
  for (const file of [...ours, ...entriesWithTypes.map((name) => `dist/types/${name}.d.ts`)])
    assert.ok(paths.has(file), file)
  assert.ok(!files.some(({ path }) => path.startsWith('dist/memory.')))
})

test('files with side effects are files of the package and their sources', () => {
  const { sideEffects } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'))
  for (const file of sideEffects) assert.ok(existsSync(`${root}${file}`), file)
  // Bundlers must keep the side effects of an entry.
  const hasSideEffects = (file) => /^[\w.]+\(/m.test(readFileSync(`${root}${file}`, 'utf8'))
  const sourcesWithEffects = sources.filter(hasSideEffects)
  assert.ok(sourcesWithEffects.includes('js-bindings/glsl.ts'))
  for (const file of sourcesWithEffects) assert.ok(sideEffects.includes(`./${file}`), file)
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
  const { exports } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'))
  const entries = Object.keys(exports).filter((key) =>
    /^\.\/dist\/(?!.*\.min\.js$)/.test(exports[key].default),
  )
  assert.ok(entries.length > 10)
  for (const entry of entries.map((key) => key.slice(1)))
    assert.ok(Object.keys(require(`warpjet${entry}`)).length, entry)
  // In these release lines, the first versions whose require loads ES modules.
  const { engines } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'))
  assert.equal(engines.node, '^20.19.0 || >=22.12.0')
})

test('glsl-autodiff’s global script name works: AutoDiff.gen', async () => {
  await import('../../dist/p5.warpjet.min.js')
  assert.equal(typeof globalThis.AutoDiff.gen, 'function')
})

test('links and pictures in shipped Markdown work on npm and on the CDN', () => {
  const { version, homepage } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'))
  const cdn = `https://cdn.jsdelivr.net/npm/warpjet@${version.replace(/\.\d+$/, '')}/`
  const paths = new Set(packedFiles().map(({ path }) => path))
  /** Tests whether the site has a page. Each page of the docs is generated from a shipped file. */
  const isOfSite = (page) =>
    ['', 'docs/', 'playground/'].includes(page) || paths.has(`web/${page.replace(/html$/, 'md')}`)
  const wrong = [...paths]
    .filter((path) => path.endsWith('.md'))
    .flatMap((path) => {
      const text = readFileSync(`${root}${path}`, 'utf8')
      const links = [...text.matchAll(/\]\(([^)\s]+)\)|(?:src|href)="([^"]+)"/g)]
      return links.map(([, inText, inHtml]) => ({ path, link: inText ?? inHtml }))
    })
    .filter(({ path, link }) => {
      if (link.startsWith('#')) return false
      // npm shows only the README, so its links must be absolute. The CDN serves the other pages, with the files to which they link.
      const { href } = new URL(link, path === 'README.md' ? undefined : `${cdn}${path}`)
      const page = href.replace(/#.*/, '')
      if (page.startsWith(homepage)) return !isOfSite(page.slice(homepage.length))
      return href.startsWith('https://cdn.jsdelivr.net/npm/warpjet')
        ? !paths.has(page.replace(cdn, ''))
        : !href.startsWith('https://')
    })
  assert.deepEqual(wrong, [])
})

test('package.json names the repository and the issue tracker for npm', () => {
  const { repository, homepage, bugs } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'))
  const source = 'https://github.com/warpjet/warpjet'
  assert.deepEqual(repository, { type: 'git', url: `git+${source}.git` })
  // The address to which the workflow deploys the site.
  assert.equal(homepage, 'https://warpjet.github.io/warpjet/')
  assert.equal(bugs, `${source}/issues`)
})

test('NOTICE names every library that is compiled in', () => {
  const notice = readFileSync(`${root}NOTICE`, 'utf8').toLowerCase()
  // Libraries that the linker adds, and libraries that Vite bundles. .cmake/wasm.cmake selects the allocators.
  const linkedLibraries = [
    'emscripten',
    'embind',
    'dlmalloc',
    'musl',
    'libc++',
    'libc++abi',
    'libunwind',
  ]
  const bundled = ['acorn', 'magic-string', 'mikktspace', 'fast-png', 'iobuffer', 'fflate']
  for (const name of [...linkedLibraries, 'compiler-rt', ...bundled])
    assert.match(notice, new RegExp(`${name.replaceAll('+', '\\+')}(?![+\\w])`), name)
  const cmake = readFileSync(`${root}.cmake/wasm.cmake`, 'utf8')
  for (const [, name] of cmake.matchAll(/-sMALLOC=(\w+)/g)) assert.ok(notice.includes(name), name)
  const libraries = readdirSync(`${root}.build/wasm/include`)
  assert.ok(libraries.length > 0)
  for (const library of libraries) {
    const name = library.replace(/\.h(pp)?$/, '').replace('tiny_', 'tiny')
    assert.ok(notice.includes(name), `${library} is not in NOTICE`)
  }
})
