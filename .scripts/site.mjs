// npm run site: writes the site to .build/site as static files, which work in any folder of any server, and checks its budgets.
import { rmSync } from 'node:fs'
import { build } from './build.mjs'
import { path, step } from './lib/files.mjs'
import { withLock } from './lib/lock.mjs'
import { checkSite } from './lib/site-budget.mjs'
import { good, isMain, main } from './lib/terminal.mjs'
import { viteBuild } from './lib/vite.mjs'
import { setup } from './setup.mjs'

export const folder = '.build/site'

/** Builds the site. Needs `dist`. */
export const buildSite = () =>
  withLock(() =>
    step('Site', {
      inputs: ['package-lock.json', 'dist', 'examples', 'web'],
      outputs: [`${folder}/index.html`, `${folder}/sw.js`],
      work: async () => {
        rmSync(path(folder), { recursive: true, force: true })
        await viteBuild({ configFile: path('web/vite.config.js'), logLevel: 'warn' })
      },
    }),
  )

if (isMain(import.meta))
  await main(async () => {
    await setup()
    await build()
    await buildSite()
    checkSite(folder)
    good(`The site is in ${folder}: put it into any folder of any server.`)
  })
