// How Vite bundles the library: ES modules that share one chunk, and one script for a <script> tag.
import { path } from './lib/files.mjs'

const common = {
  configFile: false,
  root: path('.'),
  publicDir: false,
  logLevel: 'warn',
}

// p5 is the page's own: the addon is handed it, or finds it as a global.
const external = ['p5']

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
      },
      formats: ['es'],
    },
    rolldownOptions: { external, output: { chunkFileNames: 'core-[hash].js' } },
  },
}

export const script = {
  ...common,
  build: {
    outDir: 'dist',
    emptyOutDir: false,
    target: 'es2022',
    minify: true,
    lib: {
      entry: path('js-bindings/p5.global.ts'),
      formats: ['iife'],
      name: 'warpjet',
      fileName: () => 'p5.warpjet.min.js',
    },
    rolldownOptions: { external, output: { globals: { p5: 'p5' } } },
  },
}
