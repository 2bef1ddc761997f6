// npm run setup: finds what the project needs, one line each, and installs what is missing.
// Runs before `npm ci`, so it uses nothing but Node itself.
import { existsSync, statSync } from 'node:fs'
import { installPackages, rootPrefix } from './lib/apt.mjs'
import { path } from './lib/files.mjs'
import { requirements } from './lib/requirements.mjs'
import { run } from './lib/run.mjs'
import { Stop, bad, good, heading, isMain, main, say } from './lib/terminal.mjs'
import { atLeast } from './lib/versions.mjs'

// Vite 8 starts on no older one.
const leastNode = '20.13'

/** Makes everything ready and answers where Chromium is. */
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
  if (!atLeast(version, leastNode))
    throw new Stop(`Node ${version} is too old: warpjet is built with Node ${leastNode} or newer.`)
  good(`Node.js ${version} (${process.execPath})`)
}

/** Says what was found, and returns what was not. */
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

/** npm as it was started, or the one on PATH. */
function npm(...args) {
  const cli = process.env.npm_execpath
  return cli ? run(process.execPath, [cli, ...args]) : run('npm', args)
}

if (isMain(import.meta)) await main(setup)
