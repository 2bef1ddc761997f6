// Starts browsers that the test files share, because starting a browser takes 2 s of CPU time.
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { testFlags } from './flags.mjs'

/** The environment variable that `borrow` in tests/support/browser reads: JSON with a folder of locks (`taken`) and the `addresses`. */
export const browsersVariable = 'WARPJET_BROWSERS'

/** Starts `count` browsers for the processes that `work` starts, and stops the browsers when `work` ends. */
export async function withBrowsers(count, work) {
  // Imported late, because set-up may have to install it first.
  const { chromium } = await import('playwright-core')
  const options = { executablePath: process.env.WARPJET_CHROMIUM, args: testFlags }
  const servers = await Promise.all(
    Array.from({ length: count }, () => chromium.launchServer(options)),
  )
  const taken = mkdtempSync(join(tmpdir(), 'warpjet-browsers-'))
  process.env[browsersVariable] = JSON.stringify({
    taken,
    addresses: servers.map((server) => server.wsEndpoint()),
  })
  try {
    return await work()
  } finally {
    delete process.env[browsersVariable]
    rmSync(taken, { recursive: true })
    await Promise.all(servers.map((server) => server.close()))
  }
}
