// The site: `npm start` serves it, `npm run site` writes it to .build/site.
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
  // The built page works in any folder of any server.
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
    // The playground is one.
    chunkSizeWarningLimit: 800,
    // Making the models takes most of a build.
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
      // The pages of the site name theirs before it is built.
      output: {
        entryFileNames: ({ name }) =>
          name.startsWith('site/') ? '[name].js' : 'assets/[name]-[hash].js',
      },
      checks: { pluginTimings: false },
    },
  },
}
