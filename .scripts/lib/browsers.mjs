// Starts browsers that the test files share: starting one takes 2 s of a core, and there are thirty files.
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { testFlags } from './flags.mjs'

/** The environment variable that `borrow` in tests/support/browser reads: a folder of locks, and the addresses. */
export const variable = 'WARPJET_BROWSERS'

/** Starts `count` browsers for the processes that `work` starts, and stops them after it. */
export async function withBrowsers(count, work) {
  // Imported late, because set-up may have to install it first.
  const { chromium } = await import('playwright-core')
  const options = { executablePath: process.env.WARPJET_CHROMIUM, args: testFlags }
  const servers = await Promise.all(
    Array.from({ length: count }, () => chromium.launchServer(options)),
  )
  const taken = mkdtempSync(join(tmpdir(), 'warpjet-browsers-'))
  process.env[variable] = JSON.stringify({
    taken,
    addresses: servers.map((server) => server.wsEndpoint()),
  })
  try {
    return await work()
  } finally {
    delete process.env[variable]
    rmSync(taken, { recursive: true })
    await Promise.all(servers.map((server) => server.close()))
  }
}
