// The Vite configuration of the library: ES modules that share chunks, and single files for pages without a bundler.
import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import { defaultClientConditions } from 'vite'
import { mainScript, modules, scriptsBeside, singleModules } from './lib/entries.mjs'
import { path } from './lib/files.mjs'

const { name, version, license } = JSON.parse(readFileSync(path('package.json'), 'utf8'))

// Not bundled: users install p5, three.js, React and Babylon.js themselves, and only code for Node imports its modules.
const external = ['p5', /^(three|react)(\/|$)/, '@react-three/fiber', /^@babylonjs\//, /^node:/]

const banner = `/*! ${name} ${version} | ${license} licence, third-party notices in NOTICE | https://www.npmjs.com/package/${name}/v/${version} */`

/** Returns a configuration. `lib` and `output` are options of Vite and of Rolldown; `others` replaces options outside of `build`. */
const createConfig = (lib, output, others) => ({
  configFile: false,
  root: path('.'),
  publicDir: false,
  logLevel: 'warn',
  plugins: [withoutWasmInMaps],
  ...others,
  build: {
    outDir: 'dist',
    emptyOutDir: false,
    target: 'es2022',
    sourcemap: true,
    minify: false,
    lib,
    rolldownOptions: { external, output: { postBanner: banner, ...output } },
  },
})

/** Removes wasm from source maps: nobody debugs encoded bytes. */
const withoutWasmInMaps = {
  name: 'without-wasm-in-maps',
  generateBundle(_, files) {
    for (const { map } of Object.values(files))
      map?.sources.forEach((source, i) => {
        if (source.endsWith('-wasm.js')) map.sourcesContent[i] = null
      })
  },
}

/**
 * The chunks of code that several entries share, divided so that an entry loads no code that it does not use. A module goes to the
 * first chunk whose pattern matches it or a module that imports it.
 */
const sharedChunks = [
  {
    name: 'basics',
    test: /\/js-bindings\/(errors\/.*|options\/.*|detail\/option|core\/inputs\/.*|cpu\/warp-program|core\/lazy-object|core\/expression\/shapes|wasm\/inlined|wasm\/instance|wasm\/tables|generated\/version)\.ts$/,
  },
  {
    name: 'compiler',
    test: /\/js-bindings\/compile\/(compile|compile-warp-text|text-compiler)\.ts$/,
  },
  { name: 'evaluation', test: /\/js-bindings\/compile\/compile-warp\.ts$/ },
  { name: 'detailed-mesh', test: /\/js-bindings\/(detail\/(?!option|gpu)|wasm\/detail)/ },
  // 'warpjet/three/webgpu' loads it when a mesh first needs it.
  { name: 'detail-passes', test: /\/js-bindings\/detail\/gpu\// },
  {
    name: 'meshes',
    test: /\/js-bindings\/(mesh|wasm\/(mesh|mikktspace)|p5\/geometry\/(model|subdivide-geometry|vary-geometry|with-mesh))[/.-]|\/node_modules\/(fast-png|iobuffer|fflate)\//,
  },
  {
    // The addon and exactNormals share these modules; only exactNormals needs the front end.
    name: 'p5-hooks',
    test: /\/js-bindings\/p5\/(host|settings|hooks\/(struct-hooks|wgsl-hooks)|variation\/(variation-buffers|variation-text))\.ts$/,
  },
  {
    name: 'p5-addon',
    test: /\/js-bindings\/p5\/(?!exact-normals)/,
  },
  {
    name: 'front-end',
    test: /\/js-bindings\/(glsl-source\/|glsl\.|wasm\/glsl|p5\/exact-normals|generated\/glsl)/,
  },
  { name: 'three-warp', test: /\/js-bindings\/three\/(?!nodes|webgpu|react)/ },
  {
    name: 'operating',
    test: /\/js-bindings\/operators\/(runtime|calls|functions|messages|values)\.ts$/,
  },
  {
    name: 'translating',
    test: /\/js-bindings\/operators\/|\/node_modules\/(acorn|magic-string|@jridgewell\/sourcemap-codec)\//,
  },
]

export const moduleBuild = createConfig(
  {
    entry: Object.fromEntries(modules.map((name) => [name, path(`js-bindings/${name}.ts`)])),
    formats: ['es'],
  },
  {
    chunkFileNames: 'shared/[name].js',
    minifyInternalExports: false,
    codeSplitting: { groups: sharedChunks },
  },
)

// Keeps the names of classes: they are visible in error messages.
const keepNames = { class: true, function: false }
const minified = {
  minify: { compress: { keepNames }, mangle: { keepNames }, codegen: true },
  comments: false,
}

/**
 * Returns the configuration of a single file. `wasm` names its wasm modules, which are imported first: that makes the gzipped file 1 KB
 * smaller.
 */
const createSingleFile = (
  entry,
  fileName,
  format,
  { wasm = [], conditions = [], ...others } = {},
) =>
  createConfig({ entry, name, formats: [format], fileName: () => fileName }, minified, {
    ...others,
    resolve: { conditions: [...conditions, ...defaultClientConditions] },
    plugins: [withoutWasmInMaps, importWasmFirst(entry, wasm), additions],
  })

const importWasmFirst = (entry, wasm) => ({
  name: 'wasm-first',
  enforce: 'pre',
  transform: (code, id) =>
    id === entry && wasm.length
      ? {
          code: `${wasm.map((each) => `import './generated/${each}-wasm.js'; `).join('')}${code}`,
          // The inserted code is in the first line, so all others keep their places.
          map: null,
        }
      : null,
})

/** A module with the id `add:x` adds the exports of the entry x to the global `warpjet`. */
const additionPattern = /(?:^|\/)add:(.+)$/
const additions = {
  name: 'additions',
  enforce: 'pre',
  resolveId: (id) => (additionPattern.test(id) ? id : null),
  load(id) {
    const [, name] = additionPattern.exec(id) ?? []
    if (!name) return null
    const entry = JSON.stringify(path(`js-bindings/${name}.ts`))
    return `import * as names from ${entry}; Object.assign(globalThis.warpjet, names)`
  },
}

/** Maps a single file → the wasm modules in it. */
const wasmOf = { warpjet: ['core', 'evaluation'], mesh: ['mesh'] }

export const singleModuleBuilds = singleModules.map((name) =>
  createSingleFile(path(`js-bindings/${name}.ts`), `${name}.min.js`, 'es', { wasm: wasmOf[name] }),
)

/**
 * Returns the configurations of files for <script> tags. Build the single modules first: the main script contains the hash of
 * mesh.min.js, which it fetches when a sketch needs it.
 */
export const scriptBuilds = () => [
  createSingleFile(path('js-bindings/p5.global.ts'), `${mainScript}.min.js`, 'iife', {
    wasm: wasmOf.warpjet,
    conditions: ['main-script'],
    define: { meshIntegrity: JSON.stringify(integrityOf('dist/mesh.min.js')) },
  }),
  ...scriptsBeside.map((name) =>
    createSingleFile(`add:${name}`, `warpjet.${name}.min.js`, 'iife', {
      conditions: ['page-script'],
    }),
  ),
]

const integrityOf = (file) =>
  `sha384-${createHash('sha384')
    .update(readFileSync(path(file)))
    .digest('base64')}`
