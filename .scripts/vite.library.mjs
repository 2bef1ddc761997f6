// The Vite configuration of the library: ES modules that share files, and single files for pages without a bundler.
import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import { defaultClientConditions } from 'vite'
import { mainScript, modules, scriptsBeside, singleModules } from './lib/entries.mjs'
import { path } from './lib/files.mjs'

const { name, version, license } = JSON.parse(readFileSync(path('package.json'), 'utf8'))

// Users bring their own p5, three, react and decoders. The command line runs only in Node.
const external = ['p5', /^(three|react)(\/|$)/, '@react-three/fiber', /^@babylonjs\//, /^node:/]

const banner = `/*! ${name} ${version} | ${license} licence, third-party notices in NOTICE | https://www.npmjs.com/package/${name}/v/${version} */`

/** `output` has options of Rolldown, `lib` those of Vite. */
const settings = (lib, output, others) => ({
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
 * The files that hold what several entries need, so that each entry brings what it uses and no more. A module goes to the
 * first file whose pattern matches it or a module that imports it.
 */
const sharedFiles = [
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

export const moduleBuild = settings(
  {
    entry: Object.fromEntries(modules.map((name) => [name, path(`js-bindings/${name}.ts`)])),
    formats: ['es'],
  },
  {
    chunkFileNames: 'shared/[name].js',
    minifyInternalExports: false,
    codeSplitting: { groups: sharedFiles },
  },
)

// Keeps the names of classes, which error messages show.
const keepNames = { class: true, function: false }
const minified = {
  minify: { compress: { keepNames }, mangle: { keepNames }, codegen: true },
  comments: false,
}

/** One file. `wasm` names the wasm modules in it: the gzipped file is 1 KB smaller if they come first. */
const single = (entry, fileName, format, { wasm = [], conditions = [], ...others } = {}) =>
  settings({ entry, name, formats: [format], fileName: () => fileName }, minified, {
    ...others,
    resolve: { conditions: [...conditions, ...defaultClientConditions] },
    plugins: [withoutWasmInMaps, withFirst(entry, wasm), additions],
  })

const withFirst = (entry, wasm) => ({
  name: 'wasm-first',
  enforce: 'pre',
  transform: (code, id) =>
    id === entry && wasm.length
      ? {
          code: `${wasm.map((each) => `import './generated/${each}-wasm.js'; `).join('')}${code}`,
          // Only the first line shifts.
          map: null,
        }
      : null,
})

/** `add:x` adds the exports of the entry x to the global `warpjet`. */
const addition = /(?:^|\/)add:(.+)$/
const additions = {
  name: 'additions',
  enforce: 'pre',
  resolveId: (id) => (addition.test(id) ? id : null),
  load(id) {
    const [, name] = addition.exec(id) ?? []
    if (!name) return null
    const entry = JSON.stringify(path(`js-bindings/${name}.ts`))
    return `import * as names from ${entry}; Object.assign(globalThis.warpjet, names)`
  },
}

const wasmOf = { warpjet: ['core', 'evaluation'], mesh: ['mesh'] }

export const singleModuleBuilds = singleModules.map((name) =>
  single(path(`js-bindings/${name}.ts`), `${name}.min.js`, 'es', { wasm: wasmOf[name] }),
)

/** Files for <script> tags. They need the single modules, which the main script fetches when a sketch first needs them. */
export const scriptBuilds = () => [
  single(path('js-bindings/p5.global.ts'), `${mainScript}.min.js`, 'iife', {
    wasm: wasmOf.warpjet,
    conditions: ['main-script'],
    define: { meshIntegrity: JSON.stringify(integrityOf('dist/mesh.min.js')) },
  }),
  ...scriptsBeside.map((name) =>
    single(`add:${name}`, `warpjet.${name}.min.js`, 'iife', { conditions: ['page-script'] }),
  ),
]

const integrityOf = (file) =>
  `sha384-${createHash('sha384')
    .update(readFileSync(path(file)))
    .digest('base64')}`
