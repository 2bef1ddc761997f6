// npm run build: C++ → wasm → js-bindings/generated → dist. Steps whose inputs are unchanged are skipped.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { cmakeBuild } from './lib/cmake.mjs'
import { bundleDeclarations, declarations } from './lib/declarations.mjs'
import { embindTypes } from './lib/embind-types.mjs'
import { bundles, sources as entries } from './lib/entries.mjs'
import { path, step, walk } from './lib/files.mjs'
import { withLock } from './lib/lock.mjs'
import { reportSizes } from './lib/sizes.mjs'
import { Stop, isMain, main } from './lib/terminal.mjs'
import { viteBuild } from './lib/vite.mjs'
import { setup } from './setup.mjs'

const scripts = [
  ...['build.mjs', 'vite.library.mjs', 'tsconfig.types.json'].map((name) => `.scripts/${name}`),
  ...walk('.scripts/lib', /^(?:cmake|declarations|embind-types|entries|vite)/),
  'package-lock.json',
]
const generated = 'js-bindings/generated'

const sources = (pattern) =>
  walk('js-bindings', pattern).filter((file) => !file.startsWith(`${generated}/`))

// The modules of .cmake/wasm.cmake.
const wasmModules = ['core', 'evaluation', 'mesh', 'glsl', 'detail']
// The wasm of the package mikktspace. js-bindings/wasm/mikktspace.ts replaces the JavaScript of the package, which
// imports the wasm or reads it from a file.
const mikktspace = 'node_modules/mikktspace/dist/module/mikktspace_module_bg.wasm'
const compiledFiles = wasmModules.flatMap((name) => [
  `.build/wasm/${name}.mjs`,
  `.build/wasm/${name}.wasm`,
])

export const build = () => withLock(buildAll)

async function buildAll() {
  await step('WebAssembly', {
    inputs: [
      ...scripts,
      'package.json',
      'CMakeLists.txt',
      'CMakePresets.json',
      '.cmake/wasm.cmake',
      '.cmake/embind-array.js',
      '.cmake/embind-invoker.js',
      '.cmake/embind-text.js',
      'src',
      ...sources(/\.[ch]pp$/),
    ],
    outputs: compiledFiles,
    work: () => cmakeBuild('wasm'),
  })

  await step('WebAssembly as JavaScript', {
    inputs: [...scripts, 'package.json', ...compiledFiles, mikktspace],
    outputs: [
      ...wasmModules.flatMap(generatedFiles),
      'mikktspace-wasm.js',
      'mikktspace-wasm.d.ts',
      'version.ts',
    ].map((name) => `${generated}/${name}`),
    work: generateModules,
  })

  const missing = entries.filter((file) => !sources(/\.ts$/).includes(file))
  if (missing.length) throw new Stop(`The library has no entry ${missing.join(', ')}`)

  const inputs = [...scripts, 'tsconfig.json', ...sources(/\.ts$/), generated]
  await step('Bundles', {
    inputs: [...inputs, 'package.json'],
    outputs: bundles,
    work: bundle,
  })

  await step('Types', {
    inputs,
    outputs: declarations.map((name) => `dist/types/${name}`),
    work: bundleDeclarations,
  })

  reportSizes()
}

/**
 * Lists the generated files of a module, except the .d.ts of the first two: its bytes as hexadecimal text, Emscripten's factory, and the
 * types of its bindings.
 */
const generatedFiles = (name) => [`${name}-wasm.js`, `${name}.js`, `${name}-bindings.ts`]

function generateModules() {
  mkdirSync(path(generated), { recursive: true })
  for (const name of wasmModules) {
    const glue = readFileSync(path(`.build/wasm/${name}.mjs`), 'utf8')
    const bytes = readFileSync(path(`.build/wasm/${name}.wasm`))
    writeInlined(name, bytes)
    // Replaces import.meta.url, which some bundlers reject. The URL is never read, since the wasm is passed in.
    writeGenerated(`${name}.js`, glue.replaceAll('import.meta.url', '"file:///"'))
    writeGenerated(
      `${name}.d.ts`,
      "declare const factory: import('../wasm/instance.js').Factory\nexport default factory\n",
    )
    writeGenerated(`${name}-bindings.ts`, embindTypes(glue, bytes))
  }
  writeInlined('mikktspace', readFileSync(path(mikktspace)))
  const { version } = JSON.parse(readFileSync(path('package.json'), 'utf8'))
  writeGenerated(
    'version.ts',
    `/** The version of this package. */\nexport const version: string = '${version}'\n`,
  )
}

function writeInlined(name, bytes) {
  writeGenerated(`${name}-wasm.js`, `export default ${JSON.stringify(bytes.toString('hex'))}\n`)
  writeGenerated(`${name}-wasm.d.ts`, 'declare const inlined: string\nexport default inlined\n')
}

const writeGenerated = (name, text) => writeFileSync(path(generated, name), text)

async function bundle() {
  const { moduleBuild, scriptBuilds, singleModuleBuilds } = await import('./vite.library.mjs')
  for (const file of walk('dist', /\.js(\.map)?$/)) rmSync(path(file))
  await viteBuild(moduleBuild, ...singleModuleBuilds)
  await viteBuild(...scriptBuilds())
}

if (isMain(import.meta))
  await main(async () => {
    await setup()
    await build()
  })
