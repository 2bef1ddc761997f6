// The npm project that the playground packs: installed with the package that is tested, it starts, is built, and draws the same.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { preview } from 'vite'
import { difference, pixels } from '../support/browser/bench.js'
import { bytesOf, launchBrowser, openPage } from '../support/browser/browser.js'
import {
  ball,
  canvasPixels,
  openPlayground,
  saved,
  settled,
  still,
  write,
} from '../support/browser/playground.js'
import { project, tarball } from './support/project.js'

const folder = `${project}/npm-project`

let page, context, close
before(async () => ({ page, context, close } = await openPlayground(5255, await launchBrowser())))
after(() => close())

/** Writes what is in an archive, whose files are as they are. */
function unpack(bytes) {
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(folder)
  for (let at = 0; bytes.readUInt32LE(at) === 0x04034b50;) {
    const [size, length] = [bytes.readUInt32LE(at + 18), bytes.readUInt16LE(at + 26)]
    const from = at + 30 + length
    const name = bytes.subarray(at + 30, from).toString()
    at = from + size
    writeFileSync(`${folder}/${name}`, bytes.subarray(from, at))
  }
}

/** npm in that folder, for as long as `isDone` of what it has said is not so → what that gives. */
async function npm(args, isDone = () => undefined) {
  const child = spawn('npm', args, {
    cwd: folder,
    env: { ...process.env, NODE_OPTIONS: '', NO_COLOR: '1' },
    detached: true,
  })
  let output = ''
  const ended = new Promise((resolve) => child.on('close', resolve))
  const done = new Promise((resolve) => {
    for (const stream of [child.stdout, child.stderr])
      stream.on('data', (text) => {
        output += text
        const found = isDone(output)
        if (found) resolve(found)
      })
  })
  const found = await Promise.race([done, ended.then((status) => ({ status }))])
  // npm hands no signal on to what it has started.
  const stop = () => process.kill(-child.pid)
  if (!('status' in Object(found))) return { found, stop }
  assert.equal(found.status, 0, output)
  return {}
}

/** Packs the sketch that is shown, and installs it with the tarball in the place of what npm has. */
async function install() {
  unpack(await bytesOf(await saved(page, 'npm project')))
  const file = `${folder}/package.json`
  const name = tarball()
  const manifest = JSON.parse(readFileSync(file))
  assert.ok(name.includes(manifest.dependencies.warpjet))
  manifest.dependencies.warpjet = `file:../${name}`
  writeFileSync(file, JSON.stringify(manifest))
  await npm(['install', '--prefer-offline', '--no-audit', '--no-fund'])
}

async function drawsAsInPlayground(url) {
  const before = await canvasPixels(page)
  const other = await openPage(context, url)
  assert.equal(difference(before, await pixels(other.page)), 0)
  assert.deepEqual(
    other.messages.filter((message) => !message.startsWith('[vite]')),
    [],
  )
  await other.page.close()
}

test('with p5 it starts, and draws as in the playground', async () => {
  await write(page, still('#ff8040', 'glsl.vec3(position.y().mult(3).cos().mult(0.4), 0, 0)'))
  await install()
  const { found, stop } = await npm(
    ['start', '--', '--port', '5256', '--host', '127.0.0.1'],
    (output) => /http:\/\/127\.0\.0\.1:\d+\//.exec(output)?.[0],
  )
  try {
    await drawsAsInPlayground(found)
  } finally {
    stop()
  }
})

test('with three.js it is built, and draws as in the playground', async () => {
  await page.getByLabel('Runs in').selectOption('three')
  await settled(page)
  await write(page, ball)
  await install()
  await npm(['run', 'build'])
  const server = await preview({
    configFile: false,
    root: folder,
    logLevel: 'error',
    preview: { port: 5257, host: '127.0.0.1' },
  })
  try {
    await drawsAsInPlayground(server.resolvedUrls.local[0])
  } finally {
    await server.close()
  }
})
