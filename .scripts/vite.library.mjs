// How Vite bundles the library: ES modules that share chunks, and one script for a <script> tag.
import { path } from './lib/files.mjs'

const common = {
  configFile: false,
  root: path('.'),
  publicDir: false,
  logLevel: 'warn',
}

// p5 is the page's own: the addon is handed it, or finds it as a global. The command line runs in Node only.
const external = ['p5', /^node:/]

export const modules = {
  ...common,
  build: {
    outDir: 'dist',
    emptyOutDir: false,
    target: 'es2022',
    lib: {
      entry: {
        warpjet: path('js-bindings/index.ts'),
        p5: path('js-bindings/p5.ts'),
        'p5.browser': path('js-bindings/p5.browser.ts'),
        autodiff: path('js-bindings/autodiff.ts'),
        mesh: path('js-bindings/mesh.ts'),
        deformers: path('js-bindings/deformers.ts'),
        cli: path('js-bindings/cli.ts'),
      },
      formats: ['es'],
    },
    rolldownOptions: { external, output: { chunkFileNames: 'shared-[hash].js' } },
  },
}

/** One file for a <script> tag; `replaced` are modules that are others there. */
const scriptOf = (entry, fileName, replaced) => ({
  ...common,
  resolve: { alias: replaced },
  build: {
    outDir: 'dist',
    emptyOutDir: false,
    target: 'es2022',
    minify: true,
    lib: { entry: path(entry), formats: ['iife'], name: 'warpjet', fileName: () => fileName },
    rolldownOptions: { external, output: { globals: { p5: 'p5' } } },
  },
})

export const scripts = [
  // It stays one small file: what reads models is fetched from beside it.
  scriptOf('js-bindings/p5.global.ts', 'p5.warpjet.min.js', [
    { find: './mesh-module.js', replacement: path('js-bindings/p5/mesh-module.global.ts') },
  ]),
  scriptOf('js-bindings/deformers.global.ts', 'warpjet.deformers.min.js', [
    { find: /^\.\.?\/errors\.js$/, replacement: path('js-bindings/errors.global.ts') },
  ]),
]
