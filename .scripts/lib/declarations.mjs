// Bundles the declarations of the package: one file per entry, and two for shared types, with and without those of three.js.
import { copyFileSync, rmSync } from 'node:fs'
import { entriesWithTypes, importsIn } from './entries.mjs'
import { path } from './files.mjs'
import { run } from './run.mjs'

/** The folder into which the compiler writes one declaration per source file. */
const unbundled = '.build/types'

/** globals.d.ts only refers to exports of the entries. It is copied, not bundled. */
const globals = 'globals.d.ts'

const entries = entriesWithTypes.filter((name) => `${name}.d.ts` !== globals)

export const declarations = [
  ...entries.map((name) => `${name}.d.ts`),
  'shared.d.ts',
  'three.shared.d.ts',
  globals,
]

const importDeclarations = importsIn(unbundled, '.d.ts')

/**
 * Resolves imports such as `#mesh` (package.json, `imports`) to their .d.ts in `unbundled`. rolldown-plugin-dts alone would look for them
 * in js-bindings.
 */
const withImports = {
  name: 'imports-of-declarations',
  resolveId: { order: 'pre', handler: (id) => importDeclarations[id] ?? null },
}

export async function bundleDeclarations() {
  for (const folder of [unbundled, 'dist/types'])
    rmSync(path(folder), { recursive: true, force: true })
  await run(process.execPath, [
    'node_modules/typescript-7/bin/tsc',
    '--project',
    '.scripts/tsconfig.types.json',
  ])
  const { rolldown } = await import('rolldown')
  const { dts } = await import('rolldown-plugin-dts')
  const bundle = await rolldown({
    input: Object.fromEntries(entries.map((name) => [name, path(unbundled, `${name}.d.ts`)])),
    // Users have these types already.
    external: /^(three|react|@react-three\/fiber|@babylonjs\/core)(\/|$)/,
    plugins: [withImports, dts({ dtsInput: true, tsconfig: false })],
    experimental: { attachDebugInfo: 'none' },
  })
  await bundle.write({
    dir: path('dist/types'),
    chunkFileNames: '[name].d.ts',
    minifyInternalExports: false,
    codeSplitting: {
      groups: [
        // Keeps three's types out of the file that users without three.js load.
        { name: 'shared', test: /^(?!.*[\\/]types[\\/]three[\\/])/, minShareCount: 2, priority: 2 },
        { name: 'three.shared', minShareCount: 2 },
      ],
    },
  })
  copyFileSync(path(unbundled, globals), path('dist/types', globals))
}
