// npm start: sets up, builds, and serves the gallery. Options: --port 8080, --host (for other devices).
import { parseArgs } from 'node:util'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { good, main } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

await main(async () => {
  const { values } = parseArgs({
    options: {
      port: { type: 'string', default: '5173' },
      host: { type: 'boolean', default: false },
    },
  })
  await setup()
  await build()
  const { createServer } = await import('vite')
  const server = await createServer({
    configFile: path('web/vite.config.js'),
    clearScreen: false,
    // Vite tries the next port if this one is taken.
    server: { port: Number(values.port), host: values.host },
  })
  await server.listen()
  good('The gallery is ready. Stop with Ctrl+C.')
  server.printUrls()
})
