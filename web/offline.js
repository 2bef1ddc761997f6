/** Keeps the site for when there is no network, once the page has been there for a while. Only a built site has the worker. */

/** Milliseconds from the load of a page: who comes in has the network and the machine for what they see first. */
const patience = 5000

const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds))
const idle = () =>
  new Promise((resolve) => {
    if (window.requestIdleCallback) requestIdleCallback(resolve, { timeout: 10_000 })
    else resolve()
  })

/** `root` is where the first page is. */
async function keep(root) {
  if (document.readyState !== 'complete')
    await new Promise((resolve) => addEventListener('load', resolve, { once: true }))
  await sleep(patience)
  await idle()
  await navigator.serviceWorker.register(new URL('sw.js', root))
}

export function keepForOffline(root) {
  if (import.meta.env.PROD && 'serviceWorker' in navigator && location.protocol.startsWith('http'))
    keep(root).catch(() => {})
}
