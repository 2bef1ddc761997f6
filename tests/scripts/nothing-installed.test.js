// The two commands of the README install the packages that they need. The modules that they load before that must not import packages.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../..', import.meta.url))

/** A resolver that rejects packages, as Node does in a folder where `npm ci` has not run. */
const withoutPackages = `
export async function resolve(specifier, context, next) {
  const isPackage = !/^(node:|file:|data:|[./])/.test(specifier)
  if (isPackage) throw new Error('expected only files before the set-up, got ' + specifier)
  return next(specifier, context)
}`
const asUrl = (source) => `data:text/javascript,${encodeURIComponent(source)}`
const register = `import { register } from 'node:module'; register(${JSON.stringify(asUrl(withoutPackages))})`

for (const [script, output] of [
  ['test', /There are no tests named nonsense/],
  ['start', /nonsense/],
  ['setup', null],
  ['build', null],
])
  test(`${script}.mjs can be loaded before packages are installed`, () => {
    const args = output
      ? [`.scripts/${script}.mjs`, 'nonsense']
      : ['--input-type=module', '-e', `await import('./.scripts/${script}.mjs')`]
    const { stdout, stderr } = spawnSync(process.execPath, ['--import', asUrl(register), ...args], {
      cwd: root,
      encoding: 'utf8',
      env: { ...process.env, NO_COLOR: '1' },
    })
    assert.doesNotMatch(stderr, /expected only files/)
    if (output) assert.match(stdout + stderr, output)
  })
