// Runs first in a sketch's frame. The frame has a unique opaque origin and can load nothing from the site, so the page sends scripts,
// modules and files as blobs over a private channel.
{
  const { page } = document.currentScript.dataset
  const { port1: port, port2 } = new MessageChannel()
  // A sandbox has no sensors. p5 listens to them in every sketch, and the browser would log a warning each time.
  const { addEventListener } = window
  window.addEventListener = (type, ...rest) =>
    /^device(?:motion|orientation)$/.test(type) ? undefined : addEventListener(type, ...rest)

  const isLoaded = new Promise((resolve) => addEventListener('load', resolve, { once: true }))
  // The page is complete already, but p5 and sketches must wait for `load`, which `start` dispatches after their scripts have run.
  Object.defineProperty(document, 'readyState', { configurable: true, get: () => 'interactive' })
  // No Content-Security-Policy covers WebRTC, which could reveal the visitor's IP address.
  for (const name of ['RTCPeerConnection', 'webkitRTCPeerConnection']) delete window[name]

  const addressOf = (blob) => URL.createObjectURL(blob)
  const mapAddresses = (blobs) =>
    Object.fromEntries(Object.entries(blobs).map(([name, blob]) => [name, addressOf(blob)]))

  /** Runs the script at `src`. Code that reads the address of its own script gets `href`, the address of the script on the site. */
  function run({ src, href, isModule }, parent) {
    const tag = document.createElement('script')
    const hasRun = new Promise((resolve) => (tag.onload = tag.onerror = resolve))
    // Run scripts in the order in which they are appended.
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

  /** Answers a request of the page with the function of that name. The page ignores the answer to a request without `id`. */
  async function answer({ id, method, args }) {
    try {
      const value = await window.playground.answers[method](...args)
      port.postMessage({ kind: 'answer', id, value })
    } catch (error) {
      port.postMessage({ kind: 'answer', id, error: String(error?.message ?? error) })
    }
  }

  port.onmessage = ({ data }) => (data.kind === 'start' ? start(data) : answer(data))
  // The playground's page is two levels up: the frame's parent is host.html.
  parent.parent.postMessage('ready', page, [port2])
}
