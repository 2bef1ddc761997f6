// npm run setup: finds the programs and libraries that the project needs, and installs those that are missing. Runs before `npm ci`, so
// it uses only Node itself.
import { existsSync, statSync } from 'node:fs'
import { installPackages, rootPrefix } from './lib/apt.mjs'
import { path } from './lib/files.mjs'
import { requirements } from './lib/requirements.mjs'
import { run } from './lib/run.mjs'
import { Stop, bad, good, heading, isMain, main, say } from './lib/terminal.mjs'
import { atLeast } from './lib/versions.mjs'

// Vite 8 needs it.
const minNode = '20.13'

/** Installs everything that is missing → { chromium }, the path of Chromium. */
export async function setup() {
  checkNode()
  let missing = await check(requirements)
  const packages = missing.flatMap(({ apt }) => apt)
  if (packages.length) {
    await installPackages(packages, names(missing))
    missing = await check(missing)
  }
  for (const { name, wrong, advice } of missing)
    if (wrong) throw new Stop(`${name}: ${wrong}; ${advice ?? 'please install a newer one'}.`)

  await installModules()
  const fetched = missing.filter(({ fetch }) => fetch)
  for (const { name, fetch } of fetched) await fetchWith(name, fetch)
  missing = [...missing.filter(({ fetch }) => !fetch), ...(await check(fetched))]
  if (missing.length) throw new Stop(`Still missing: ${names(missing).join(', ')}.`)
  return { chromium: requirements.find(({ name }) => name === 'Chromium').file }
}

const names = (list) => list.map(({ name }) => name)

function checkNode() {
  const version = process.versions.node
  if (!atLeast(version, minNode))
    throw new Stop(`Node ${version} is too old: warpjet is built with Node ${minNode} or newer.`)
  good(`Node.js ${version} (${process.execPath})`)
}

/** Prints what was found, and returns the requirements that are missing. */
async function check(list) {
  const answers = await Promise.all(list.map(({ find }) => find()))
  list.forEach((requirement, i) => {
    const { found, wrong, file } = answers[i]
    Object.assign(requirement, { found, wrong, file })
    if (found) good(`${requirement.name} ${found}`)
    else bad(`${requirement.name}: ${wrong ?? 'not found'}`)
  })
  return list.filter(({ found }) => !found)
}

async function installModules() {
  const installed = path('node_modules/.package-lock.json')
  const current =
    existsSync(installed) &&
    statSync(installed).mtimeMs >= statSync(path('package-lock.json')).mtimeMs
  if (!current) {
    heading('Installing npm packages')
    await npm('ci')
    say()
  }
  good(`npm packages ${current ? 'up to date' : 'installed'}`)
}

async function fetchWith(name, command) {
  if (!(await rootPrefix())) {
    say(`\nThis may not install packages here. Please type:\n\n  npx ${command.join(' ')}\n`)
    throw new Stop(`Missing: ${name}.`)
  }
  heading(`Fetching ${name}`)
  await npm('exec', '--', ...command)
  say()
}

/** Runs the npm that started this process, or the one on PATH. */
function npm(...args) {
  const cli = process.env.npm_execpath
  return cli ? run(process.execPath, [cli, ...args]) : run('npm', args)
}

if (isMain(import.meta)) await main(setup)
