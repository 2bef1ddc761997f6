// npm run build: C++ -> wasm -> js-bindings/generated -> dist. A step whose inputs are unchanged is left out.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { cmakeBuild } from './lib/cmake.mjs'
import { path, step, walk } from './lib/files.mjs'
import { locked } from './lib/lock.mjs'
import { run } from './lib/run.mjs'
import { reportSizes } from './lib/sizes.mjs'
import { Stop, isMain, main } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

const scripts = ['.scripts/build.mjs', '.scripts/lib', 'package-lock.json']
const generated = 'js-bindings/generated'

const sources = (pattern) =>
  walk('js-bindings', pattern).filter((file) => !file.startsWith(`${generated}/`))

// Of .cmake/wasm.cmake.
const withGlue = ['evaluation', 'mesh']
const packed = ['core', ...withGlue]
const compiled = [
  ...withGlue.map((name) => `.build/wasm/${name}.mjs`),
  ...[...packed, 'unpack'].map((name) => `.build/wasm/${name}.wasm`),
]

const shared = ['text', 'p5', 'p5.browser', 'autodiff', 'mesh', 'deformers', 'cli']
const single = ['warpjet', 'mesh', 'p5.warpjet', 'warpjet.deformers']
const bundles = ['warpjet', ...shared, ...single.map((name) => `${name}.min`)].map(
  (name) => `dist/${name}.js`,
)
const entries = ['index', ...shared, 'p5.global', 'deformers.global'].map(
  (name) => `js-bindings/${name}.ts`,
)

export const build = () => locked(buildAll)

async function buildAll() {
  await step('WebAssembly', {
    inputs: [
      ...scripts,
      'package.json',
      'CMakeLists.txt',
      'CMakePresets.json',
      '.cmake/wasm.cmake',
      '.cmake/mesh.js',
      '.cmake/math.cpp',
      'src',
      ...sources(/\.[ch]pp$/),
    ],
    outputs: compiled,
    work: () => cmakeBuild('wasm'),
  })

  await step('WebAssembly as JavaScript', {
    inputs: [...scripts, 'package.json', ...compiled],
    outputs: [
      ...withGlue.map((name) => `${name}.js`),
      ...[...packed, 'unpack'].map((name) => `${name}-wasm.js`),
      'version.ts',
    ].map((name) => `${generated}/${name}`),
    work: generateModules,
  })

  const missing = entries.filter((file) => !sources(/\.ts$/).includes(file))
  if (missing.length) throw new Stop(`The library has no entry ${missing.join(', ')}`)

  const inputs = [...scripts, 'tsconfig.json', ...sources(/\.ts$/), generated]
  await step('Bundles', {
    inputs: [...inputs, '.scripts/vite.library.mjs', 'package.json'],
    outputs: bundles,
    work: bundle,
  })

  await step('Types', {
    inputs: [...inputs, '.scripts/tsconfig.types.json'],
    outputs: ['index', 'text', 'p5', 'autodiff', 'mesh', 'deformers'].map(
      (name) => `dist/types/${name}.d.ts`,
    ),
    work: declareTypes,
  })

  reportSizes(walk('dist', /\.js$/), { 'dist/p5.warpjet.min.js': 150 * 1024 })
}

async function generateModules() {
  mkdirSync(path(generated), { recursive: true })
  withGlue.forEach(generateGlue)
  // Base64 hides the repetitions from the server's gzip, so they are taken out before.
  const { LZMA } = (await import('lzma')).default
  for (const name of packed) writeBase64(name, LZMA().compress(readWasm(name), 9))
  writeBase64('unpack', readWasm('unpack'))
  const { version } = JSON.parse(readFileSync(path('package.json'), 'utf8'))
  writeGenerated('version.ts', `export const version: string = '${version}'\n`)
}

const readWasm = (name) => readFileSync(path(`.build/wasm/${name}.wasm`))

/** The compiler's output as a module that any bundler takes: the wasm is handed in, so its address never matters. */
function generateGlue(name) {
  const glue = readFileSync(path(`.build/wasm/${name}.mjs`), 'utf8')
  writeGenerated(`${name}.js`, glue.replaceAll('import.meta.url', '"file:///"'))
  writeGenerated(
    `${name}.d.ts`,
    'export default function instantiate<Module>(options: { wasmBinary: Uint8Array }): Module\n',
  )
}

function writeBase64(name, bytes) {
  const base64 = Buffer.from(bytes).toString('base64')
  writeGenerated(`${name}-wasm.js`, `export default '${base64}'\n`)
  writeGenerated(`${name}-wasm.d.ts`, 'declare const base64: string\nexport default base64\n')
}

const writeGenerated = (name, text) => writeFileSync(path(generated, name), text)

async function bundle() {
  const vite = await import('vite')
  const { modules, singleModules, scripts } = await import('./vite.library.mjs')
  for (const file of walk('dist', /\.js(\.map)?$/)) rmSync(path(file))
  await vite.build(modules)
  for (const module of singleModules) await vite.build(module)
  for (const script of scripts()) await vite.build(script)
}

async function declareTypes() {
  rmSync(path('dist/types'), { recursive: true, force: true })
  await run(process.execPath, [
    'node_modules/typescript/bin/tsc',
    '--project',
    '.scripts/tsconfig.types.json',
  ])
}

if (isMain(import.meta))
  await main(async () => {
    await setup()
    await build()
  })
