// Configures the site: `npm start` serves it, `npm run site` writes it to .build/site.
import { fileURLToPath } from 'node:url'
import { exampleFiles } from './plugins/example-files.js'
import { offline } from './plugins/offline.js'
import { ownTypesPlugin } from './plugins/own-types.js'
import { quietClient } from './plugins/quiet-client.js'
import { sitePagesPlugin, siteScripts } from './plugins/site-pages.js'
import { folderAddresses } from './site/folder-address.js'
import { policies } from './site/policy.js'

const path = (relative) => fileURLToPath(new URL(relative, import.meta.url))

export default {
  root: path('.'),
  // Relative, so that the built site works in any folder of any server.
  base: './',
  appType: 'mpa',
  publicDir: false,
  cacheDir: path('../.build/vite'),
  plugins: [
    sitePagesPlugin(),
    folderAddresses(),
    policies(),
    exampleFiles(),
    ownTypesPlugin(),
    offline(),
    quietClient(),
  ],
  server: { fs: { allow: [path('..')] } },
  optimizeDeps: {
    include: [
      'codemirror',
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
      'minisearch',
      'meshoptimizer',
      'draco3dgltf',
    ],
  },
  build: {
    outDir: path('../.build/site'),
    emptyOutDir: true,
    // The playground's chunk exceeds the default of 500.
    chunkSizeWarningLimit: 800,
    // Generating the models takes most of the build time, so Vite's warning about slow plugins is off below.
    rolldownOptions: {
      input: {
        ...siteScripts,
        ...Object.fromEntries(
          ['bench/index', 'bench/results', 'drop/index', 'playground/index'].map((name) => [
            name.replace('/', '-'),
            path(`${name}.html`),
          ]),
        ),
      },
      // The site's pages refer to their scripts by name before the build, so these have no hash.
      output: {
        entryFileNames: ({ name }) =>
          name.startsWith('site/') ? '[name].js' : 'assets/[name]-[hash].js',
      },
      checks: { pluginTimings: false },
    },
  },
}
