/**
 * Runs sketches. A new one starts hidden behind the visible one and replaces it once it has drawn; if it fails before that, it is
 * removed and the last good picture stays. Sketches are untrusted: each runs in a sandbox, and the page exchanges only messages
 * with it.
 */
import { make } from '../bench/dom.js'
import { readMessage } from './messages.js'
import { partsOf } from './parts.js'
import { makeSandbox } from './sandbox.js'
import { root, siteFile } from './site-files.js'

/**
 * `listen` is called with the messages of the visible frame, and of the one that will replace it. The settings of `run` are the frame's
 * initial state: { clock, view, values, files, mayLoad }.
 */
export function makeStage(place, listen) {
  const host = make('iframe', { src: './host.html', title: 'Stage' })
  const isReady = new Promise((resolve) => host.addEventListener('load', resolve, { once: true }))
  place.append(host)
  /** The visible frame, and the one that will replace it: { frame, port, state, questions } each. */
  let shown, coming
  let latestRun

  async function run(sketch, { files, mayLoad, ...settings }) {
    const thisRun = (latestRun = {})
    remove(coming)
    coming = undefined
    try {
      const [parts] = await Promise.all([partsOf(sketch, files), isReady])
      if (thisRun !== latestRun) return
      begin(sketch.host, { mayLoad }, { ...parts, ...settings, root })
    } catch (error) {
      if (thisRun === latestRun) listen({ kind: 'error', message: error.message })
    }
  }

  function begin(sketchHost, options, start) {
    const owner = host.contentDocument
    const frame = makeSandbox(owner, sketchHost, options)
    frame.className = 'coming'
    const running = { frame, state: { frames: 0, millis: 0 }, questions: [] }
    coming = running
    const connect = ({ source, origin, data, ports: [port] }) => {
      // boot.js sends the first message before any code of the sketch runs; accept it only from this frame.
      if (source !== frame.contentWindow || origin !== 'null' || data !== 'ready' || !port) return
      removeEventListener('message', connect)
      running.port = port
      port.onmessage = ({ data }) => receive(running, readMessage(data))
      port.postMessage({ kind: 'start', ...start })
    }
    running.disconnect = () => removeEventListener('message', connect)
    addEventListener('message', connect)
    owner.body.append(frame)
  }

  function receive(running, message) {
    if (!message || (running !== shown && running !== coming)) return
    if (message.kind === 'state') return (running.state = message)
    if (message.kind === 'answer') return resolveQuestion(running, message)
    if (message.kind === 'wanted') return sendFile(running, message)
    if (message.kind === 'made') running.made = message
    // Ignore a repeated 'drawn', with which a sketch could make the page rebuild its tabs again and again.
    else if (message.kind === 'drawn' && running === shown) return
    else if (message.kind === 'drawn') show(running)
    // The warps of the next sketch are shown with its first picture.
    if (message.kind !== 'made' || running === shown) listen(message)
    if (message.kind === 'error' && running === coming) {
      coming = undefined
      remove(running)
    }
  }

  function show(running) {
    remove(shown)
    ;[shown, coming] = [running, undefined]
    running.frame.className = 'shown'
    place.classList.add('drawn')
  }

  /** Calls one of the `answers` of the visible sketch's frame. */
  function ask(method, ...args) {
    return new Promise((resolve, reject) => {
      const id = shown.questions.push({ resolve, reject }) - 1
      shown.port.postMessage({ kind: 'ask', id, method, args })
    })
  }
  /** Calls one of the `answers` without waiting for its result, in the visible and the next sketch. */
  function send(method, ...args) {
    for (const { port } of [shown, coming].filter(Boolean))
      port?.postMessage({ kind: 'ask', method, args })
  }

  return {
    run,
    ask,
    send,
    isEmpty: () => !shown,
    /** The last { frames, millis } that the visible sketch reported. */
    state: () => shown?.state ?? { frames: 0, millis: 0 },
    /** The visible sketch's { warps, uniforms }. */
    made: () => shown?.made ?? { warps: [], uniforms: [] },
  }
}

function resolveQuestion({ questions }, { id, value, error }) {
  const { resolve, reject } = questions[id] ?? {}
  if (error === undefined) resolve?.(value)
  else reject?.(new Error(error))
}

async function sendFile({ port }, { id, address }) {
  const blob = await siteFile(address).catch(() => undefined)
  port.postMessage({ kind: 'ask', method: 'file', args: [id, blob] })
}

function remove(running) {
  if (!running) return
  running.disconnect()
  running.port?.close()
  for (const { reject } of running.questions)
    reject(new Error('The sketch has changed in the meantime.'))
  // Remove the frame immediately, because browsers limit the number of WebGL contexts.
  running.frame.remove()
}
