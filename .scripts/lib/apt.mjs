// Installs Debian packages, if that is allowed.
import { exitCode, capture, run } from './run.mjs'
import { Stop, heading, say } from './terminal.mjs'
import { onPath } from './which.mjs'

const install = ['install', '--yes', '--no-install-recommends']

/** Returns [] for root, ['sudo', …] if sudo needs no password, null otherwise. */
export async function rootPrefix() {
  if (process.getuid?.() === 0) return []
  return (await capture('sudo', ['-n', 'true'])) === null ? null : ['sudo', '-n']
}

export async function installPackages(packages, names) {
  const what = names.join(', ')
  if (!onPath('apt-get'))
    throw new Stop(
      `Missing: ${what}. This system has no apt-get to install them with; please install them your own way and start again (on Windows, use Debian or Ubuntu in WSL).`,
    )
  const prefix = await rootPrefix()
  if (!prefix) {
    say('\nThis may not install packages here. Please type:\n')
    say(`  sudo apt-get update && sudo apt-get ${install.join(' ')} ${packages.join(' ')}\n`)
    throw new Stop(`Missing: ${what}.`)
  }
  heading(`Installing ${packages.join(' ')}`)
  const [command, ...args] = [...prefix, 'env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get']
  // Ignores errors of foreign package sources: the install shows whether the packages are available.
  await exitCode(command, [...args, 'update'])
  await run(command, [...args, '-o', 'DPkg::Lock::Timeout=300', ...install, ...packages])
  say()
}
