// Installs the project that tests the package, in .build/package: the tarball that npm would publish, and the bundlers of tests/package,
// which are the environments in which the package must work.
import {
  copyFileSync,
  cpSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
} from 'node:fs'
import { path } from './files.mjs'
import { capture, exitCode, run } from './run.mjs'
import { NotRun, Stop } from './terminal.mjs'

const project = path('.build/package')
/** The files that determine which bundlers are installed. */
const packageFiles = ['package.json', 'package-lock.json']

/** Throws a NotRun if the registry is unreachable and the bundlers were not installed before. */
export async function installEnvironments() {
  mkdirSync(project, { recursive: true })
  if (!packageFiles.every(isCurrent) || !existsSync(`${project}/node_modules/.package-lock.json`))
    await installBundlers()
  for (const name of listTarballs()) rmSync(`${project}/${name}`)
  await run('npm', ['pack', '--silent', '--ignore-scripts', '--pack-destination', project])
  const [tarball] = listTarballs()
  const installed = `${project}/node_modules/warpjet`
  rmSync(installed, { recursive: true, force: true })
  mkdirSync(installed)
  await run('tar', ['-xzf', `${project}/${tarball}`, '-C', installed, '--strip-components=1'])
  cpSync(path('tests/package/project'), project, { recursive: true })
  cpSync(path('tests/types/shipped'), `${project}/types`, { recursive: true })
}

const listTarballs = () => readdirSync(project).filter((name) => name.endsWith('.tgz'))
const read = (file) => (existsSync(file) ? readFileSync(file, 'utf8') : null)
const isCurrent = (name) => read(`${project}/${name}`) === read(path('tests/package', name))

async function installBundlers() {
  for (const name of packageFiles) copyFileSync(path('tests/package', name), `${project}/${name}`)
  const options = ['--ignore-scripts', '--prefer-offline', '--no-audit', '--no-fund']
  // An installation takes half a minute, but may hang on a stalled network, so each of two attempts gets five minutes.
  const install = () => exitCode('npm', ['ci', ...options], { cwd: project, timeout: 300_000 })
  if ((await install()) === 0 || (await install()) === 0) return
  // Without these files, the next run tries again.
  for (const name of packageFiles) rmSync(`${project}/${name}`)
  if ((await capture('npm', ['ping'], { timeout: 30_000 })) === null)
    throw new NotRun('the npm registry, which has the bundlers, cannot be reached')
  throw new Stop('npm cannot install the dependencies of tests/package/package.json.')
}
