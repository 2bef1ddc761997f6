// How Vite bundles the library: ES modules that share files, and files that need no other, for pages without a bundler.
import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import { path } from './lib/files.mjs'

const { name, version, license } = JSON.parse(readFileSync(path('package.json'), 'utf8'))

// p5 is the page's own: the addon is handed it, or finds it as a global. So is three. Decoders of models are the user's choice. The command line runs in Node only.
const external = [
  'p5',
  /^(three|react)(\/|$)/,
  '@react-three/fiber',
  /^@babylonjs\//,
  /^node:/,
  'meshoptimizer',
  'draco3dgltf',
]

const banner = `/*! ${name} ${version} | ${license} licence, others' notices in the package's NOTICE | https://www.npmjs.com/package/${name}/v/${version} */`

/** `output` are options of Rolldown, `lib` those of Vite. */
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

/** A map tells where code comes from, and nobody reads base64. */
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
 * first that names it or something that needs it.
 */
const sharedFiles = [
  {
    name: 'basics',
    test: /\/js-bindings\/(errors\/.*|options\/.*|core\/inputs\/.*|cpu\/warp-program|core\/lazy-object|core\/expression\/(?:shapes|source-lines)|wasm\/start|wasm\/tables|generated\/version)\.ts$/,
  },
  { name: 'compiler', test: /\/js-bindings\/compile\/(compile|compile-warp-text)\.ts$/ },
  { name: 'evaluation', test: /\/js-bindings\/compile\/compile-warp\.ts$/ },
  {
    name: 'meshes',
    test: /\/js-bindings\/(mesh|wasm\/mesh|p5\/geometry\/(model|subdivide-geometry|vary-geometry|with-mesh))[/.-]/,
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
  { name: 'translating', test: /\/js-bindings\/operators\/|\/node_modules\/acorn\// },
]

export const modules = settings(
  {
    entry: {
      warpjet: path('js-bindings/index.ts'),
      text: path('js-bindings/text.ts'),
      p5: path('js-bindings/p5.ts'),
      'p5.browser': path('js-bindings/p5.browser.ts'),
      autodiff: path('js-bindings/autodiff.ts'),
      mesh: path('js-bindings/mesh.ts'),
      deformers: path('js-bindings/deformers.ts'),
      glsl: path('js-bindings/glsl.ts'),
      three: path('js-bindings/three.ts'),
      'three.webgpu': path('js-bindings/three.webgpu.ts'),
      react: path('js-bindings/react.ts'),
      babylon: path('js-bindings/babylon.ts'),
      cli: path('js-bindings/cli.ts'),
      operators: path('js-bindings/operators.ts'),
      'operators-runtime': path('js-bindings/operators-runtime.ts'),
      'operators-plugin': path('js-bindings/operators-plugin.ts'),
      memory: path('js-bindings/memory.ts'),
    },
    formats: ['es'],
  },
  {
    chunkFileNames: 'shared/[name].js',
    minifyInternalExports: false,
    codeSplitting: { groups: sharedFiles },
  },
)

// Errors name the class of what was thrown.
const keepNames = { class: true, function: false }
const minified = {
  minify: { compress: { keepNames }, mangle: { keepNames }, codegen: true },
  comments: false,
}

/** `wasm` names the modules that are in it: where they stand first, gzip packs the file better, by 1 KB. */
const single = (entry, fileName, format, { wasm = [], ...others } = {}) =>
  settings({ entry: path(entry), name, formats: [format], fileName: () => fileName }, minified, {
    ...others,
    plugins: [withoutWasmInMaps, withFirst(entry, wasm)],
  })

const withFirst = (entry, wasm) => ({
  name: 'wasm-first',
  enforce: 'pre',
  transform: (code, id) =>
    id === path(entry)
      ? `${wasm.map((each) => `import './generated/${each}-wasm.js'; `).join('')}${code}`
      : null,
})

/** Modules of one file each. */
export const singleModules = [
  single('js-bindings/index.ts', 'warpjet.min.js', 'es', { wasm: ['core', 'evaluation'] }),
  single('js-bindings/mesh.ts', 'mesh.min.js', 'es', { wasm: ['mesh'] }),
]

/** A script that stands beside the one with the compiler, and throws its errors. */
const beside = (entry, fileName) =>
  single(entry, fileName, 'iife', {
    resolve: {
      alias: [
        { find: /^.*\/errors\.js$/, replacement: path('js-bindings/errors/errors.global.ts') },
      ],
    },
  })

/** Files for <script> tags, when those modules are there. */
export const scripts = () => [
  single('js-bindings/p5.global.ts', 'p5.warpjet.min.js', 'iife', {
    wasm: ['core', 'evaluation'],
    // The script fetches what reads models when a sketch first needs it.
    resolve: {
      alias: [
        {
          find: /^.*\/mesh-module\.js$/,
          replacement: path('js-bindings/p5/geometry/mesh-module.global.ts'),
        },
      ],
    },
    define: { meshIntegrity: JSON.stringify(integrityOf('dist/mesh.min.js')) },
  }),
  // The compiler is that of the script of p5.
  single('js-bindings/glsl.global.ts', 'warpjet.glsl.min.js', 'iife', {
    resolve: {
      alias: [
        { find: /^.*\/errors\.js$/, replacement: path('js-bindings/errors/errors.global.ts') },
        {
          find: /^.*\/compile\/(compile|compile-warp-text)\.js$/,
          replacement: path('js-bindings/glsl-source/compile.global.ts'),
        },
      ],
    },
  }),
  beside('js-bindings/deformers.global.ts', 'warpjet.deformers.min.js'),
  beside('js-bindings/operators.global.ts', 'warpjet.operators.min.js'),
]

const integrityOf = (file) =>
  `sha384-${createHash('sha384')
    .update(readFileSync(path(file)))
    .digest('base64')}`
