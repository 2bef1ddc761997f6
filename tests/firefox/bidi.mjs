// Firefox by WebDriver BiDi: JSON over a WebSocket, of which this has as much as that takes. playwright-core wants commands that
// Debian's firefox-esr lacks, and Node has had a WebSocket of its own only since 22.
import { spawn } from 'node:child_process'
import { randomBytes } from 'node:crypto'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { request } from 'node:http'
import { tmpdir } from 'node:os'
import { join } from 'node:path'

/** A message as one masked frame, as a client has to send it. */
function frameOf(text) {
  const bytes = Buffer.from(text)
  const mask = randomBytes(4)
  for (let i = 0; i < bytes.length; i++) bytes[i] ^= mask[i & 3]
  const head = Buffer.alloc(bytes.length < 126 ? 2 : bytes.length < 65536 ? 4 : 10)
  head[0] = 0x81
  head[1] = 0x80 | (head.length === 2 ? bytes.length : head.length === 4 ? 126 : 127)
  if (head.length === 4) head.writeUInt16BE(bytes.length, 2)
  if (head.length === 10) head.writeBigUInt64BE(BigInt(bytes.length), 2)
  return Buffer.concat([head, mask, bytes])
}

/** Calls `take` with each whole message. */
function reader(take) {
  let left = Buffer.alloc(0)
  let parts = []
  return (bytes) => {
    left = Buffer.concat([left, bytes])
    while (left.length >= 2) {
      let [length, at] = [left[1] & 127, 2]
      if (length === 126) [length, at] = [left.length >= 4 ? left.readUInt16BE(2) : Infinity, 4]
      if (length === 127)
        [length, at] = [left.length >= 10 ? Number(left.readBigUInt64BE(2)) : Infinity, 10]
      if (left.length < at + length) return
      const [kind, isLast] = [left[0] & 15, left[0] & 128]
      if (kind <= 1) parts.push(left.subarray(at, at + length))
      left = left.subarray(at + length)
      if (kind > 1 || !isLast) continue
      take(Buffer.concat(parts).toString())
      parts = []
    }
  }
}

const connect = (url) =>
  new Promise((resolve, reject) => {
    const headers = {
      Connection: 'Upgrade',
      Upgrade: 'websocket',
      'Sec-WebSocket-Key': randomBytes(16).toString('base64'),
      'Sec-WebSocket-Version': '13',
    }
    request(url, { headers })
      .on('upgrade', (_, socket, head) => resolve({ socket, head }))
      .on('response', ({ statusCode }) => reject(new Error(`${url} answered ${statusCode}`)))
      .on('error', reject)
      .end()
  })

/** Starts Firefox → { send(method, params), on(event), close() }; `on` gets what it tells. */
export async function startFirefox(program = 'firefox') {
  const profile = mkdtempSync(join(tmpdir(), 'warpjet-firefox-'))
  // Without a GPU it draws WebGL only where it is told to.
  writeFileSync(join(profile, 'user.js'), 'user_pref("webgl.force-enabled", true);\n')
  // Some without a GPU draw WebGL on a display alone, be it one of Xvfb.
  const headless = process.env.DISPLAY ? [] : ['--headless']
  const flags = [...headless, '--no-remote', '--profile', profile, '--remote-debugging-port', '0']
  const firefox = spawn(program, flags, { env: { ...process.env, HOME: profile } })
  const address = await new Promise((resolve, reject) => {
    let said = ''
    firefox.on('error', reject)
    firefox.on('close', () => reject(new Error(`Firefox has ended: ${said}`)))
    firefox.stderr.on('data', (text) => {
      said += text
      const [, found] = /BiDi listening on ws:\/\/(\S+)/.exec(said) ?? []
      if (found) resolve(found)
    })
  })
  const { socket, head } = await connect(`http://${address}/session`)
  const waiting = new Map()
  const listeners = []
  const read = reader((text) => {
    const { id, result, error, message, method, params } = JSON.parse(text)
    if (method) return listeners.forEach((listen) => listen(method, params))
    const { resolve, reject } = waiting.get(id)
    waiting.delete(id)
    if (error) reject(new Error(`${error}: ${message}`))
    else resolve(result)
  })
  socket.on('data', read)
  read(head)
  let last = 0
  const send = (method, params = {}) =>
    new Promise((resolve, reject) => {
      waiting.set(++last, { resolve, reject })
      socket.write(frameOf(JSON.stringify({ id: last, method, params })))
    })
  await send('session.new', { capabilities: {} })
  return {
    send,
    on: (listen) => listeners.push(listen),
    async close() {
      const ended = new Promise((resolve) => firefox.once('close', resolve))
      await send('browser.close').catch(() => firefox.kill())
      await ended
      rmSync(profile, { recursive: true, force: true })
    },
  }
}
