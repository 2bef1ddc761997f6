// The gallery and the pages beside it as they are built for a server of files: built once for all tests that look at them.
import { build, preview } from 'vite'
import { step } from '../../../.scripts/lib/files.mjs'
import { locked } from '../../../.scripts/lib/lock.mjs'
import { config, path } from './bench.js'

const folder = '.build/gallery'

/** Serves it → Vite's server. `base` is the folder of the server that it stands in. */
export async function serveSite(port, base = './') {
  const outDir = path(folder)
  await locked(() =>
    step('Gallery', {
      inputs: ['package-lock.json', 'dist', 'examples', 'web'],
      outputs: [`${folder}/index.html`],
      work: () => build({ ...config, build: { outDir, emptyOutDir: true } }),
    }),
  )
  return preview({ ...config, base, preview: { port }, build: { outDir } })
}
