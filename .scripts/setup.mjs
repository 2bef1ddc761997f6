// npm run setup: installs what is missing. On Debian and Ubuntu it needs only Node; on other systems it lists what to install.
import { existsSync, statSync } from 'node:fs'
import { path } from './lib/files.mjs'
import { requirements } from './lib/requirements.mjs'
import { capture, exitCode, run } from './lib/run.mjs'
import { Stop, bad, good, heading, isMain, main, say } from './lib/terminal.mjs'
import { onPath } from './lib/which.mjs'

// The oldest Node that Vite 8 supports.
const minNode = '20.19'

/** Installs everything that is missing. Returns { chromium }, the path of Chromium. */
export async function setup() {
  const { node } = process.versions
  if (node.localeCompare(minNode, 'en', { numeric: true }) < 0)
    throw new Stop(`Node ${node} is too old: warpjet is built with Node ${minNode} or newer.`)
  let missing = await check(requirements)
  const packages = missing.flatMap(({ apt }) => apt)
  if (packages.length) {
    await installPackages(packages, namesOf(missing))
    missing = await check(missing)
  }
  await installModules()
  const fetched = missing.filter(({ fetch }) => fetch)
  for (const { name, fetch } of fetched) await fetchWith(name, fetch)
  if (fetched.length) missing = await check(missing)
  if (missing.length) throw new Stop(`Still missing: ${namesOf(missing)}.`)
  return { chromium: requirements.find(({ name }) => name === 'Chromium').file }
}

const namesOf = (list) => list.map(({ name }) => name).join(', ')

/** Searches for each requirement, stores its path in `file`, prints the result, and returns the requirements that are missing. */
async function check(list) {
  await Promise.all(list.map(async (requirement) => (requirement.file = await requirement.find())))
  for (const { name, file } of list)
    if (file) good(`${name} (${file})`)
    else bad(`${name}: not found`)
  return list.filter(({ file }) => !file)
}

/** Returns [] for root, ['sudo', '-n'] if sudo needs no password, null otherwise. */
async function rootPrefix() {
  if (process.getuid?.() === 0) return []
  return (await capture('sudo', ['-n', 'true'])) === null ? null : ['sudo', '-n']
}

/** Returns the prefix of commands that install packages. Throws, and prints what to type, if this process may not install any. */
async function requireRoot(names, command) {
  const prefix = await rootPrefix()
  if (prefix) return prefix
  say(`\nThis script may not install packages here. Please type:\n\n  ${command}\n`)
  throw new Stop(`Missing: ${names}.`)
}

async function installPackages(packages, names) {
  if (!onPath('apt-get'))
    throw new Stop(
      `Missing: ${names}. This system has no apt-get to install them with; please install them in another way and start again (on Windows, use Debian or Ubuntu in WSL).`,
    )
  const install = ['install', '--yes', '--no-install-recommends', ...packages]
  const commandLine = `sudo apt-get update && sudo apt-get ${install.join(' ')}`
  const prefix = await requireRoot(names, commandLine)
  heading(`Installing ${packages.join(' ')}`)
  const [command, ...args] = [...prefix, 'env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get']
  // Ignores the exit status, which is an error if any package source fails: the install shows whether the packages are available.
  await exitCode(command, [...args, 'update'])
  await run(command, [...args, '-o', 'DPkg::Lock::Timeout=300', ...install])
}

async function fetchWith(name, command) {
  await requireRoot(name, `npx ${command.join(' ')}`)
  heading(`Fetching ${name}`)
  await npm('exec', '--', ...command)
}

async function installModules() {
  const installed = path('node_modules/.package-lock.json')
  const locked = statSync(path('package-lock.json'))
  if (existsSync(installed) && statSync(installed).mtimeMs >= locked.mtimeMs) return
  heading('Installing npm packages')
  await npm('ci')
}

/** Runs the npm that started this process, or the one on PATH. */
function npm(...args) {
  const cli = process.env.npm_execpath
  return cli ? run(process.execPath, [cli, ...args]) : run('npm', args)
}

if (isMain(import.meta)) await main(setup)
