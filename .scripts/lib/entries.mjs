// The entries of the package, read from package.json: its `exports` are the one list of them.
import { readFileSync } from 'node:fs'
import { path } from './files.mjs'

const { bin, exports, imports } = JSON.parse(readFileSync(path('package.json'), 'utf8'))

const targetsOf = (entry) =>
  typeof entry === 'string' ? [entry] : Object.values(entry).flatMap(targetsOf)
const targets = [...new Set(targetsOf({ ...exports, ...bin }))]

/** Returns the names in the targets that match the pattern `form`, whose group is the name. */
const namesOf = (form) => targets.flatMap((target) => form.exec(target)?.[1] ?? [])

/** Modules whose bundles share chunks: `x` is built from js-bindings/x.ts into dist/x.js. `memory` is for tests, and not in the package. */
export const modules = [...namesOf(/^(?:\.\/)?dist\/((?!.*\.min\.js)[\w.-]+)\.js$/), 'memory']

/** Declarations: `x` is js-bindings/x.ts declared by dist/types/x.d.ts. */
export const declared = namesOf(/^\.\/dist\/types\/([\w.-]+)\.d\.ts$/)

const minified = namesOf(/^\.\/dist\/([\w.-]+)\.min\.js$/)

/** Modules of one file: `x` is built from js-bindings/x.ts into dist/x.min.js. */
export const singleModules = minified.filter((name) => modules.includes(name))

/** The script for a page with p5, which is built from js-bindings/p5.global.ts. */
export const mainScript = 'p5.warpjet'

/** Scripts to load after p5.warpjet: `x` is built from js-bindings/x.ts into dist/warpjet.x.min.js, and adds its exports to the global. */
export const scriptsBeside = minified.flatMap((name) => /^warpjet\.(.+)$/.exec(name)?.[1] ?? [])

/** The bundled files of dist. */
export const bundles = [...modules, ...minified.map((name) => `${name}.min`)].map(
  (name) => `dist/${name}.js`,
)

/** The sources of the entries. */
export const sources = [...modules, ...declared, 'p5.global'].map(
  (name) => `js-bindings/${name}.ts`,
)

/** Maps the `imports` of package.json to their files in another folder, such as that of the declarations. */
export const importsIn = (folder, extension) =>
  Object.fromEntries(
    Object.entries(imports).map(([name, { default: file }]) => [
      name,
      path(file.replace('./js-bindings', folder).replace(/\.ts$/, extension)),
    ]),
  )
