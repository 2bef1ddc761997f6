/** Keeps the site for when there is no network, once the page has all that it needs itself. Only a built site has the worker. */

const idle = () =>
  new Promise((resolve) => {
    if (window.requestIdleCallback) requestIdleCallback(resolve, { timeout: 10_000 })
    else setTimeout(resolve, 2000)
  })

/** `root` is where the first page is. */
async function keep(root) {
  if (document.readyState !== 'complete')
    await new Promise((resolve) => addEventListener('load', resolve, { once: true }))
  await idle()
  await navigator.serviceWorker.register(new URL('sw.js', root))
}

export function keepForOffline(root) {
  if (import.meta.env.PROD && 'serviceWorker' in navigator && location.protocol.startsWith('http'))
    keep(root).catch(() => {})
}
