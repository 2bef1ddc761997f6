/**
 * Runs sketches: a new one begins unseen behind the one that is shown, and replaces it once it has drawn. One that fails before is
 * removed, and the last good picture stays. Sketches may be anybody's: each runs in a sandbox, and the page sends and receives
 * nothing but messages.
 */
import { make } from '../bench/dom.js'
import { readMessage } from './messages.js'
import { partsOf } from './parts.js'
import { makeSandbox } from './sandbox.js'
import { root, siteFile } from './site-files.js'

/**
 * `listen` gets the messages of frames, of the one that is seen or of the one that is coming. `run` takes as settings what the frame
 * reads at first: { clock, view, values, files, mayLoad }.
 */
export function makeStage(place, listen) {
  const host = make('iframe', { src: './host.html', title: 'Stage' })
  const isReady = new Promise((resolve) => host.addEventListener('load', resolve, { once: true }))
  place.append(host)
  /** { frame, port, state, questions } each. */
  let shown, coming
  let latest

  async function run(sketch, { files, mayLoad, ...settings }) {
    const mine = (latest = {})
    remove(coming)
    coming = undefined
    try {
      const [parts] = await Promise.all([partsOf(sketch, files), isReady])
      if (mine !== latest) return
      begin(sketch.host, { mayLoad }, { ...parts, ...settings, root })
    } catch (error) {
      if (mine === latest) listen({ kind: 'error', message: error.message })
    }
  }

  function begin(sketchHost, options, start) {
    const owner = host.contentDocument
    const frame = makeSandbox(owner, sketchHost, options)
    frame.className = 'coming'
    const running = { frame, state: { frames: 0, millis: 0 }, questions: [] }
    coming = running
    const connect = ({ source, origin, data, ports: [port] }) => {
      // The first message is of boot.js, before anything of the sketch runs, and no other window is its source.
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
    if (message.kind === 'answer') return settle(running, message)
    if (message.kind === 'wanted') return send(running, message)
    if (message.kind === 'made') running.made = message
    // Once: a sketch that says so again has the page redo its tabs for nothing.
    else if (message.kind === 'drawn' && running === shown) return
    else if (message.kind === 'drawn') show(running)
    // It goes on only after the listener has looked at it.
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
  /** Calls one without an answer, in the sketch that is coming, too. */
  function tell(method, ...args) {
    for (const { port } of [shown, coming].filter(Boolean))
      port?.postMessage({ kind: 'ask', method, args })
  }

  return {
    run,
    ask,
    tell,
    isEmpty: () => !shown,
    /** { frames, millis } of the sketch that is seen, as it has last reported them. */
    state: () => shown?.state ?? { frames: 0, millis: 0 },
    /** { warps, uniforms } of the sketch that is seen. */
    made: () => shown?.made ?? { warps: [], uniforms: [] },
  }
}

function settle({ questions }, { id, value, error }) {
  const { resolve, reject } = questions[id] ?? {}
  if (error === undefined) resolve?.(value)
  else reject?.(new Error(error))
}

async function send({ port }, { id, address }) {
  const blob = await siteFile(address).catch(() => undefined)
  port.postMessage({ kind: 'ask', method: 'file', args: [id, blob] })
}

function remove(running) {
  if (!running) return
  running.disconnect()
  running.port?.close()
  for (const { reject } of running.questions) reject(new Error('The sketch has changed meanwhile.'))
  // At once, so that its context is not one too many.
  running.frame.remove()
}
