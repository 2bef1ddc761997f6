/** Registers the service worker, which makes the site work offline, some time after the page loads. Only a built site has one. */

/** Milliseconds to wait after a page has loaded, so that network and CPU are free for what the visitor sees first. */
const delay = 5000

const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds))
const waitUntilIdle = () =>
  new Promise((resolve) => {
    if (window.requestIdleCallback) requestIdleCallback(resolve, { timeout: 10_000 })
    else resolve()
  })

async function registerWorker(root) {
  if (document.readyState !== 'complete')
    await new Promise((resolve) => addEventListener('load', resolve, { once: true }))
  await sleep(delay)
  await waitUntilIdle()
  await navigator.serviceWorker.register(new URL('sw.js', root))
}

/** @param root the address of the first page */
export function keepForOffline(root) {
  if (import.meta.env.PROD && 'serviceWorker' in navigator && location.protocol.startsWith('http'))
    registerWorker(root).catch(() => {})
}
