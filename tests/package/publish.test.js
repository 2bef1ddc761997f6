// Tests the publishing workflow: npm's messages about the tarball, the upload, and each command of the workflow.
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
const commands = [...readFileSync(file, 'utf8').matchAll(/^ *(?:- )?run: (.+)$/gm)].map(
  ([, command]) => command,
)
const findCommand = (pattern) => commands.find((command) => pattern.test(command))

/** The uploads to a local registry, which has no packages. */
const received = []
let server, home
before(async () => {
  home = mkdtempSync(`${tmpdir()}/warpjet-publish-`)
  server = createServer(async (request, response) => {
    const chunks = []
    for await (const chunk of request) chunks.push(chunk)
    const isPut = request.method === 'PUT'
    if (isPut)
      received.push({
        path: request.url,
        authorization: request.headers.authorization,
        document: JSON.parse(Buffer.concat(chunks)),
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
 * Runs a command of the workflow in a shell, with the local registry. Returns { output, status }. Does not block this process, which must
 * answer npm.
 */
async function run(command, cwd, env = {}) {
  const variables = Object.entries(process.env).filter(([name]) => !/^npm_/i.test(name))
  const child = spawn('sh', ['-ec', command], {
    cwd,
    env: {
      ...Object.fromEntries(variables),
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
/** Returns the command that publishes, without provenance, which only runs on GitHub can sign. */
const publishCommand = () => findCommand(/^npm publish/).replace(' --provenance', '')

test('npm has no warnings about the tarball, except that nobody is logged in', async () => {
  const { output, status } = await run(`${publishCommand()} --dry-run`, project)
  assert.equal(status, 0, output)
  const [warning, ...others] = warnings(output)
  assert.match(warning, /requires you to be logged in/)
  assert.deepEqual(others, [])
  assert.equal(received.length, 0)
})

test('with a token, the tested tarball itself is published without a warning', async () => {
  const token = findCommand(/_authToken/)
  assert.deepEqual(await run(token, project, { NPM_TOKEN: 'a-token' }), { output: '', status: 0 })
  const { output, status } = await run(publishCommand(), project)
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

test('a tag that differs from the version in package.json publishes nothing', async () => {
  const command = findCommand(/GITHUB_REF_NAME/)
  const statusFor = async (tag) => (await run(command, root, { GITHUB_REF_NAME: tag })).status
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
  const copyCommand = findCommand(/^cp /)
  assert.equal((await run(copyCommand.replace(/\.$/, `"${home}"`), root)).status, 0)
  assert.deepEqual(
    readdirSync(home).filter((name) => name.endsWith('.tgz')),
    [tarball()],
  )
  // web/tests/site.browser.test.js opens the output of `npm run site`.
  assert.ok(manifest.scripts.site)
  assert.deepEqual(commands, [
    findCommand(/GITHUB_REF_NAME/),
    '.ci/run',
    'npm run site',
    copyCommand,
    findCommand(/_authToken/),
    'npm publish ./warpjet-*.tgz --provenance --access public',
  ])
})
