// The project that `npm test -- --all package` sets up, and the programs installed in it.
import { spawnSync } from 'node:child_process'
import { readdirSync } from 'node:fs'
import { createRequire } from 'node:module'
import { fileURLToPath, pathToFileURL } from 'node:url'

export const project = fileURLToPath(new URL('../../../.build/package', import.meta.url))
export const folder = '.build/package'

const require = createRequire(`${project}/package.json`)

/** Returns the file name of the packed package in the project. */
export const tarball = () => readdirSync(project).find((name) => name.endsWith('.tgz'))

/** Imports a module from the project's node_modules. */
export const load = (name) => import(pathToFileURL(require.resolve(name)).href)

/** Runs a program in the project. Returns { output, status }. */
export function runIn(command, args, env = {}) {
  const { stdout, stderr, status, error } = spawnSync(command, args, {
    cwd: project,
    encoding: 'utf8',
    env: { ...process.env, NODE_OPTIONS: '', ...env },
  })
  if (error) throw error
  return { output: stdout + stderr, status }
}
