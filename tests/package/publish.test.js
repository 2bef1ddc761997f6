// The publishing workflow: npm's messages about the tarball, the upload, and each command of the workflow.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { accessSync, constants, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs'
import { createServer } from 'node:http'
import { tmpdir } from 'node:os'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { project, runIn, tarball } from './support/project.js'

const root = fileURLToPath(new URL('../../', import.meta.url))
const manifest = JSON.parse(readFileSync(`${root}package.json`, 'utf8'))
const file = `${root}.github/workflows/publish.yml`
/** The commands of the workflow, in order; each is one line. */
const runs = [...readFileSync(file, 'utf8').matchAll(/^ *(?:- )?run: (.+)$/gm)].map(
  ([, run]) => run,
)
const runOf = (pattern) => runs.find((run) => pattern.test(run))

/** A registry without packages, which records uploads. */
const received = []
let server, home
before(async () => {
  home = mkdtempSync(`${tmpdir()}/warpjet-publish-`)
  server = createServer(async (request, response) => {
    const parts = []
    for await (const part of request) parts.push(part)
    const isPut = request.method === 'PUT'
    if (isPut)
      received.push({
        path: request.url,
        authorization: request.headers.authorization,
        document: JSON.parse(Buffer.concat(parts)),
      })
    response.writeHead(isPut ? 201 : 404, { 'Content-Type': 'application/json' }).end('{}')
  })
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve))
})
after(() => {
  server.close()
  rmSync(home, { recursive: true })
})

/**
 * Runs a command of the workflow in a shell, with that registry → { output, status }. Does not block the test, which must answer npm.
 */
async function run(line, cwd, env = {}) {
  const own = Object.entries(process.env).filter(([name]) => !/^npm_/i.test(name))
  const child = spawn('sh', ['-ec', line], {
    cwd,
    env: {
      ...Object.fromEntries(own),
      NODE_OPTIONS: '',
      npm_config_registry: `http://127.0.0.1:${server.address().port}/`,
      npm_config_userconfig: `${home}/npmrc`,
      npm_config_update_notifier: 'false',
      ...env,
    },
  })
  let output = ''
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (text) => (output += text))
  const status = await new Promise((resolve) => child.on('close', resolve))
  return { output, status }
}

const warnings = (output) => output.match(/^npm (?:warn|error).*$/gim) ?? []
/** Provenance is signed only for runs at GitHub. */
const publish = () => runOf(/^npm publish/).replace(' --provenance', '')

test('npm has no complaints about the tarball, except that nobody has logged in', async () => {
  const { output, status } = await run(`${publish()} --dry-run`, project)
  assert.equal(status, 0, output)
  const [warning, ...others] = warnings(output)
  assert.match(warning, /requires you to be logged in/)
  assert.deepEqual(others, [])
  assert.equal(received.length, 0)
})

test('with a token the tested tarball itself is published, without a warning', async () => {
  const token = runOf(/_authToken/)
  assert.deepEqual(await run(token, project, { NPM_TOKEN: 'a-token' }), { output: '', status: 0 })
  const { output, status } = await run(publish(), project)
  assert.equal(status, 0, output)
  assert.deepEqual(warnings(output), [])
  const [{ path, authorization, document }] = received
  assert.deepEqual([path, authorization], ['/warpjet', 'Bearer a-token'])
  assert.equal(document.access, 'public')
  assert.deepEqual(document['dist-tags'], { latest: manifest.version })
  assert.deepEqual(document.versions[manifest.version].exports, manifest.exports)
  const [{ data }] = Object.values(document._attachments)
  assert.ok(Buffer.from(data, 'base64').equals(readFileSync(`${project}/${tarball()}`)))
})

test('a tag that is not the version of package.json publishes nothing', async () => {
  const line = runOf(/GITHUB_REF_NAME/)
  const statusFor = async (tag) => (await run(line, root, { GITHUB_REF_NAME: tag })).status
  assert.equal(await statusFor(`v${manifest.version}`), 0)
  assert.equal(await statusFor(manifest.version), 1)
  assert.equal(await statusFor('v9.9.9'), 1)
})

test('there is one workflow, and each of its commands is tested', async () => {
  const { output, status } = runIn(process.execPath, [
    'node_modules/@action-validator/cli/cli.mjs',
    file,
  ])
  assert.equal(status, 0, output)
  accessSync(`${root}.ci/run`, constants.X_OK)
  const copied = runOf(/^cp /)
  assert.equal((await run(copied.replace(/\.$/, `"${home}"`), root)).status, 0)
  assert.deepEqual(
    readdirSync(home).filter((name) => name.endsWith('.tgz')),
    [tarball()],
  )
  // web/tests/site.browser.test.js opens the output of `npm run site`.
  assert.ok(manifest.scripts.site)
  assert.deepEqual(runs, [
    runOf(/GITHUB_REF_NAME/),
    '.ci/run',
    'npm run site',
    copied,
    runOf(/_authToken/),
    'npm publish ./warpjet-*.tgz --provenance --access public',
  ])
})
