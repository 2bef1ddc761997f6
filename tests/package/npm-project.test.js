// The npm project that the playground exports, with the tested package, must start, build, and draw the same picture as the playground.
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
  downloadFromMenu,
  openPlayground,
  stillSketch,
  waitUntilSettled,
  write,
} from '../support/browser/playground.js'
import { project, tarball } from './support/project.js'

const folder = `${project}/npm-project`

let page, context, close
before(async () => ({ page, context, close } = await openPlayground(5255, await launchBrowser())))
after(() => close())

/** Writes the files of an uncompressed ZIP archive to `folder`. */
function unpack(bytes) {
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(folder)
  for (let offset = 0; bytes.readUInt32LE(offset) === 0x04034b50;) {
    const [size, nameLength] = [bytes.readUInt32LE(offset + 18), bytes.readUInt16LE(offset + 26)]
    const start = offset + 30 + nameLength
    const name = bytes.subarray(offset + 30, start).toString()
    offset = start + size
    writeFileSync(`${folder}/${name}`, bytes.subarray(start, offset))
  }
}

/**
 * Runs npm in `folder` until it ends, or until `find(output)` returns a value. Returns { found, stop }: that value, and a function that
 * stops npm. If npm ends, its status must be 0.
 */
async function npm(args, find = () => undefined) {
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
        const found = find(output)
        if (found) resolve(found)
      })
  })
  const found = await Promise.race([done, ended.then((status) => ({ status }))])
  // npm does not forward signals to its child processes.
  const stop = () => process.kill(-child.pid)
  if (!('status' in Object(found))) return { found, stop }
  assert.equal(found.status, 0, output)
  return {}
}

/** Exports the current sketch, and installs it with the tarball instead of the package from npm. */
async function install() {
  unpack(await bytesOf(await downloadFromMenu(page, 'npm project')))
  const file = `${folder}/package.json`
  const name = tarball()
  const manifest = JSON.parse(readFileSync(file))
  assert.ok(name.includes(manifest.dependencies.warpjet))
  manifest.dependencies.warpjet = `file:../${name}`
  writeFileSync(file, JSON.stringify(manifest))
  await npm(['install', '--prefer-offline', '--no-audit', '--no-fund'])
}

async function assertDrawsAsInPlayground(url) {
  const expected = await canvasPixels(page)
  const other = await openPage(context, url)
  assert.equal(difference(expected, await pixels(other.page)), 0)
  assert.deepEqual(
    other.messages.filter((message) => !message.startsWith('[vite]')),
    [],
  )
  await other.page.close()
}

test('with p5 it starts, and draws as in the playground', async () => {
  await write(page, stillSketch('#ff8040', 'glsl.vec3(position.y().mult(3).cos().mult(0.4), 0, 0)'))
  await install()
  const { found, stop } = await npm(
    ['start', '--', '--port', '5256', '--host', '127.0.0.1'],
    (output) => /http:\/\/127\.0\.0\.1:\d+\//.exec(output)?.[0],
  )
  try {
    await assertDrawsAsInPlayground(found)
  } finally {
    stop()
  }
})

test('with three.js it builds, and draws as in the playground', async () => {
  await page.getByLabel('Runs in').selectOption('three')
  await waitUntilSettled(page)
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
    await assertDrawsAsInPlayground(server.resolvedUrls.local[0])
  } finally {
    await server.close()
  }
})
