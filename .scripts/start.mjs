// npm start: set-up, build, then the gallery in the browser. Options: --port 8080, --host (for other devices).
import { existsSync } from 'node:fs'
import { parseArgs } from 'node:util'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { Stop, good, main, say } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

const { values } = parseArgs({
  options: { port: { type: 'string', default: '5173' }, host: { type: 'boolean', default: false } },
})

await main(async () => {
  await setup()
  await build()
  if (!existsSync(path('web/vite.config.js'))) throw new Stop('There is no web/vite.config.js.')

  const { createServer } = await import('vite')
  const server = await createServer({
    configFile: path('web/vite.config.js'),
    clearScreen: false,
    // Vite tries the next port if this one is taken.
    server: { port: Number(values.port), host: values.host },
  })
  await server.listen()
  say()
  good('The gallery is ready. Stop with Ctrl+C.')
  server.printUrls()
})
