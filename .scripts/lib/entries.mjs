// The entries of the package, derived from `exports` and `bin` of package.json, so that they are listed only there.
import { readFileSync } from 'node:fs'
import { path } from './files.mjs'

const { bin, exports, imports } = JSON.parse(readFileSync(path('package.json'), 'utf8'))

const targetsOf = (entry) =>
  typeof entry === 'string' ? [entry] : Object.values(entry).flatMap(targetsOf)
const targets = [...new Set(targetsOf({ ...exports, ...bin }))]

/** Returns a name for each target that `pattern` matches: the first group of the match. */
const namesOf = (pattern) => targets.flatMap((target) => pattern.exec(target)?.[1] ?? [])

/** Modules whose bundles share chunks: `x` is built from js-bindings/x.ts into dist/x.js. `memory` is for tests, and not in the package. */
export const modules = [...namesOf(/^(?:\.\/)?dist\/((?!.*\.min\.js)[\w.-]+)\.js$/), 'memory']

/** Entries with types: dist/types/x.d.ts declares the exports of js-bindings/x.ts. */
export const entriesWithTypes = namesOf(/^\.\/dist\/types\/([\w.-]+)\.d\.ts$/)

const minified = namesOf(/^\.\/dist\/([\w.-]+)\.min\.js$/)

/** Modules of one file: `x` is built from js-bindings/x.ts into dist/x.min.js. */
export const singleModules = minified.filter((name) => modules.includes(name))

/** The script for a page with p5, which is built from js-bindings/p5.global.ts. */
export const mainScript = 'p5.warpjet'

/**
 * Scripts to load after p5.warpjet: `x` is built from js-bindings/x.ts into dist/warpjet.x.min.js, and adds its exports to the global
 * `warpjet`.
 */
export const scriptsBeside = minified.flatMap((name) => /^warpjet\.(.+)$/.exec(name)?.[1] ?? [])

/** The bundled files of dist. */
export const bundles = [...modules, ...minified.map((name) => `${name}.min`)].map(
  (name) => `dist/${name}.js`,
)

/** The sources of the entries. */
export const sources = [...modules, ...entriesWithTypes, 'p5.global'].map(
  (name) => `js-bindings/${name}.ts`,
)

/** Maps each name in `imports` of package.json → its file in another folder than js-bindings, such as the folder of the declarations. */
export const importsIn = (folder, extension) =>
  Object.fromEntries(
    Object.entries(imports).map(([name, { default: file }]) => [
      name,
      path(file.replace('./js-bindings', folder).replace(/\.ts$/, extension)),
    ]),
  )
