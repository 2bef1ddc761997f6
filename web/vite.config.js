// The gallery's build, and with it its other pages: `npm start` serves them,
// `vite build --config web/vite.config.js` writes them to .build/gallery.
import { fileURLToPath } from 'node:url'
import { exampleFiles } from './plugins/example-files.js'
import { quietClient } from './plugins/quiet-client.js'

const path = (relative) => fileURLToPath(new URL(relative, import.meta.url))

export default {
  root: path('.'),
  // The built page works in any folder of any server.
  base: './',
  appType: 'mpa',
  publicDir: false,
  cacheDir: path('../.build/vite'),
  plugins: [exampleFiles(), quietClient()],
  server: { fs: { allow: [path('..')] } },
  optimizeDeps: {
    include: [
      'codemirror',
      '@codemirror/autocomplete',
      '@codemirror/commands',
      '@codemirror/lang-javascript',
      '@codemirror/language',
      '@codemirror/lint',
      '@codemirror/state',
      '@codemirror/view',
      '@lezer/highlight',
      'highlight.js/lib/core',
      'highlight.js/lib/languages/javascript',
      'highlight.js/lib/languages/glsl',
      '@observablehq/plot',
      'gl-matrix',
      'lil-gui',
    ],
  },
  build: {
    outDir: path('../.build/gallery'),
    emptyOutDir: true,
    // Making the models takes most of a build.
    rolldownOptions: {
      input: [
        'index.html',
        'bench/index.html',
        'bench/results.html',
        'drop/index.html',
        'playground/index.html',
      ].map(path),
      checks: { pluginTimings: false },
    },
  },
}
