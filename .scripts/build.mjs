// npm run build: C++ -> wasm -> js-bindings/generated -> dist. A step whose inputs are unchanged is left out.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { cmakeBuild } from './lib/cmake.mjs'
import { declarations, declareTypes } from './lib/declarations.mjs'
import { bundles, sources as entries } from './lib/entries.mjs'
import { path, step, walk } from './lib/files.mjs'
import { inline } from './lib/inline.mjs'
import { locked } from './lib/lock.mjs'
import { reportSizes } from './lib/sizes.mjs'
import { Stop, isMain, main } from './lib/terminal.mjs'
import { viteBuild } from './lib/vite.mjs'
import { setup } from './setup.mjs'

const scripts = ['.scripts/build.mjs', '.scripts/lib', 'package-lock.json']
const generated = 'js-bindings/generated'

const sources = (pattern) =>
  walk('js-bindings', pattern).filter((file) => !file.startsWith(`${generated}/`))

// Of .cmake/wasm.cmake.
const inlined = ['core', 'evaluation', 'mesh', 'glsl']
const compiled = ['mesh.mjs', ...inlined.map((name) => `${name}.wasm`)].map(
  (name) => `.build/wasm/${name}`,
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
      'src',
      ...sources(/\.[ch]pp$/),
    ],
    outputs: compiled,
    work: () => cmakeBuild('wasm'),
  })

  await step('WebAssembly as JavaScript', {
    inputs: [...scripts, 'package.json', ...compiled],
    outputs: ['mesh.js', ...inlined.map((name) => `${name}-wasm.js`), 'version.ts'].map(
      (name) => `${generated}/${name}`,
    ),
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
    outputs: declarations.map((name) => `dist/types/${name}`),
    work: declareTypes,
  })

  reportSizes(walk('dist', /\.js$/))
}

function generateModules() {
  mkdirSync(path(generated), { recursive: true })
  // Any bundler takes it: the wasm is handed in, so its address never matters.
  const glue = readFileSync(path('.build/wasm/mesh.mjs'), 'utf8')
  writeGenerated('mesh.js', glue.replaceAll('import.meta.url', '"file:///"'))
  writeGenerated(
    'mesh.d.ts',
    'export default function instantiate<Module>(options: { wasmBinary: Uint8Array }): Module\n',
  )
  for (const name of inlined) {
    const text = JSON.stringify(inline(readFileSync(path(`.build/wasm/${name}.wasm`))))
    writeGenerated(`${name}-wasm.js`, `export default ${text}\n`)
    writeGenerated(
      `${name}-wasm.d.ts`,
      "declare const inlined: import('../wasm/start.js').Inlined\nexport default inlined\n",
    )
  }
  const { version } = JSON.parse(readFileSync(path('package.json'), 'utf8'))
  writeGenerated(
    'version.ts',
    `/** The version of this package. */\nexport const version: string = '${version}'\n`,
  )
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
