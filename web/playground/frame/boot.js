// Runs first in the frame of a sketch. The frame has an origin of its own, which no page shares: it can load nothing from the site, so
// the page sends the scripts, modules and files as blobs, over a channel that only the two of them have.
{
  const { page } = document.currentScript.dataset
  const { port1: port, port2 } = new MessageChannel()
  // A sandbox has no sensors. p5 listens to them for every sketch, of which the browser would warn each time.
  const { addEventListener } = window
  window.addEventListener = (type, ...how) =>
    /^device(?:motion|orientation)$/.test(type) ? undefined : addEventListener(type, ...how)

  const isLoaded = new Promise((resolve) => addEventListener('load', resolve, { once: true }))
  // p5 and sketches wait for the page to be complete, which it is once their scripts have run.
  Object.defineProperty(document, 'readyState', { configurable: true, get: () => 'interactive' })
  // No Content-Security-Policy covers WebRTC, which would tell others the visitor's address.
  for (const name of ['RTCPeerConnection', 'webkitRTCPeerConnection']) delete window[name]

  const addressOf = (blob) => URL.createObjectURL(blob)
  const mapAddresses = (blobs) =>
    Object.fromEntries(Object.entries(blobs).map(([name, blob]) => [name, addressOf(blob)]))

  /** Runs a script at `src`. To those that read it, its address is `href`, where the site has it. */
  function run({ src, href, isModule }, parent) {
    const tag = document.createElement('script')
    const hasRun = new Promise((resolve) => (tag.onload = tag.onerror = resolve))
    // In the order in which they are appended.
    tag.async = false
    if (isModule) tag.type = 'module'
    tag.src = src
    if (href) Object.defineProperty(tag, 'src', { value: href })
    parent.append(tag)
    return hasRun
  }

  async function start({ scripts, imports, files, sketch, ...settings }) {
    await isLoaded
    window.sketchFiles = mapAddresses(files)
    const source = addressOf(sketch.blob)
    const report = (message) => port.postMessage(message)
    window.playground = { ...settings, source, report, answers: {} }
    const map = document.createElement('script')
    map.type = 'importmap'
    map.textContent = JSON.stringify({ imports: mapAddresses(imports) })
    document.head.append(map)
    await Promise.all([
      ...scripts.map(({ href, blob }) => run({ src: addressOf(blob), href }, document.head)),
      run({ src: source, isModule: sketch.isModule }, document.body),
    ])
    delete document.readyState
    document.dispatchEvent(new Event('DOMContentLoaded', { bubbles: true }))
    dispatchEvent(new Event('load'))
  }

  /** Answers a question of the page by the function of that name. One without `id` awaits no answer. */
  async function answer({ id, method, args }) {
    try {
      const value = await window.playground.answers[method](...args)
      port.postMessage({ kind: 'answer', id, value })
    } catch (error) {
      port.postMessage({ kind: 'answer', id, error: String(error?.message ?? error) })
    }
  }

  port.onmessage = ({ data }) => (data.kind === 'start' ? start(data) : answer(data))
  // The page around the host of this frame.
  parent.parent.postMessage('ready', page, [port2])
}
