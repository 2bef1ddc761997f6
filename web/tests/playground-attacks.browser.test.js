// Opens links that attack the page: they must do no harm. Runs in Chromium and Firefox, on the built site with its service worker, which
// once cached a page that a sketch had written.
import assert from 'node:assert/strict'
import { createServer } from 'node:http'
import { after, before, describe, test } from 'node:test'
import { attacks, hostileSketch, leave } from '../../tests/support/browser/hostile-sketch.js'
import { serveSite } from '../../tests/support/browser/site.js'
import { browsers } from '../../tests/support/browser/two-browsers.js'
import { fragmentOf } from '../playground/link.js'

const patience = { timeout: 60_000 }
const base = '/some/folder/'

let server, site
before(async () => {
  server = await serveSite(5345, base)
  site = server.resolvedUrls.local[0]
})
after(() => server.close())

/** Starts the attacker's server, which records its requests. Returns { address, requests, close() }. */
async function startEvilServer() {
  const requests = []
  const evil = createServer((request, response) => {
    requests.push(request.url)
    response.writeHead(200, { 'content-type': 'text/html', 'access-control-allow-origin': '*' })
    response.end('<title>evil</title>')
  })
  await new Promise((listening) => evil.listen(0, '127.0.0.1', listening))
  const address = `http://127.0.0.1:${evil.address().port}/`
  return { address, requests, close: () => evil.close() }
}

const still = `function setup() {
  createCanvas(120, 90, WEBGL)
}
function draw() {
  background('#00ff00')
}
`

const settle = (page) =>
  page.waitForFunction(() => document.querySelector('main')?.ariaBusy === 'false', patience)

const linkTo = async (text, host = 'p5') =>
  `${site}playground/index.html${await fragmentOf({ text, host, chosen: [] })}`

/** Returns the frame of the visible sketch, once the previous sketch's frame is removed from its host. */
async function frameOf(page) {
  const host = page.frames().find((frame) => /\/host(?:\.html)?$/.test(frame.url()))
  await host.waitForFunction(() => document.querySelectorAll('iframe').length === 1, patience)
  const [frame] = host.childFrames()
  return frame
}

/** Reads everything that the site stores in the browser, and the state of its page. */
const readState = (page) =>
  page.evaluate(async () => {
    const cached = []
    for (const key of await caches.keys()) {
      const cache = await caches.open(key)
      const addresses = (await cache.keys()).map(({ url }) => url)
      cached.push(key, ...addresses)
      for (const address of addresses.filter((each) => /\/(?:index|host)\.html$/.test(each)))
        if (!address.includes('/gallery/')) cached.push(await (await cache.match(address)).text())
    }
    return {
      address: location.href.replace(/#.*/, ''),
      title: document.title,
      local: localStorage.secret,
      session: sessionStorage.secret,
      cookie: document.cookie,
      databases: (await indexedDB.databases()).map(({ name }) => name),
      workers: (await navigator.serviceWorker.getRegistrations()).map(
        ({ active }) => active.scriptURL,
      ),
      cached,
      added: document.querySelectorAll('body > iframe, body > script, img[src="x"]').length,
    }
  })

const mistakeOf = (page) => page.$eval('.mistake', ({ textContent }) => textContent)

for (const [name, launch] of Object.entries(browsers))
  describe(`in ${name}`, () => {
    let browser, page, evil, stateBefore
    before(async () => {
      browser = await launch()
      evil = await startEvilServer()
      page = await browser.newPage()
      // This sketch has a small picture: without a GPU, a large picture takes all of the machine's time.
      await page.goto(await linkTo(still), patience)
      await settle(page)
      await page.waitForFunction(() => navigator.serviceWorker.controller, patience)
      await page.evaluate(async () => {
        localStorage.secret = sessionStorage.secret = 'mine'
        document.cookie = 'secret=mine; path=/'
        await new Promise((resolve) => (indexedDB.open('secrets').onsuccess = resolve))
        const channel = new BroadcastChannel('secrets')
        setInterval(() => channel.postMessage('mine'), 200)
      })
      stateBefore = await readState(page)
    })
    after(async () => {
      await browser.close()
      evil.close()
    })

    /** Follows a link in a tab in which the site is already open. */
    async function follow(link) {
      await page.evaluate((hash) => {
        document.querySelector('main').ariaBusy = 'true'
        location.hash = hash
      }, new URL(link).hash)
      await settle(page)
    }

    test(`a hostile sketch obtains nothing, in ${name}`, async () => {
      const addresses = { site, evil: evil.address }
      await follow(await linkTo(hostileSketch(addresses)))
      assert.equal((await mistakeOf(page)).includes('Line'), false, await mistakeOf(page))
      const frame = await frameOf(page)
      await frame.waitForFunction(() => 'obtained' in window, patience)
      const all = await frame.evaluate(async () =>
        JSON.parse(JSON.stringify(await window.obtained)),
      )
      const obtained = all.filter(([name, value]) => name in attacks && value)
      assert.deepEqual(obtained, [])
      assert.ok(all.length > Object.keys(attacks).length)
      await new Promise((go) => setTimeout(go, 1500))
      assert.deepEqual(evil.requests.splice(0), [])
    })

    test(`the page, its storage, and other windows are unchanged, in ${name}`, async () => {
      assert.deepEqual(await readState(page), stateBefore)
      assert.equal(
        (await browser.pages()).filter((each) => each.url().startsWith('http')).length,
        1,
      )
    })

    test(`a sketch that navigates its own frame sends nothing and shows nothing, in ${name}`, async () => {
      const leaving = `${still}\n;(${leave})(${JSON.stringify({ evil: evil.address })})\n`
      await page.evaluate((hash) => (location.hash = hash), new URL(await linkTo(leaving)).hash)
      await new Promise((go) => setTimeout(go, 3000))
      assert.deepEqual(evil.requests.splice(0), [])
      assert.equal(
        page
          .frames()
          .some((frame) => frame.url().startsWith(evil.address) && frame !== page.mainFrame()) &&
          name === 'Chromium',
        false,
      )
      assert.deepEqual((await readState(page)).title, stateBefore.title)
    })

    test(`forged messages of a sketch change nothing but its own output, in ${name}`, async () => {
      await follow(
        await linkTo(`${still}
const { port1, port2 } = new MessageChannel()
const forged = [
  { kind: 'error', message: '<img src=x onerror="document.title = 1">', line: 1e300 },
  { kind: 'printed', level: 'x" onclick="alert(1)', text: '<script>document.title = 1</' + 'script>' },
  { kind: 'printed', level: 'log', text: '<img src=x onerror="document.title = 1">' },
  { kind: 'made', warps: [{ maker: '<img src=x>' }], uniforms: [] },
  { kind: 'made', warps: null, uniforms: [{ name: '<img src=x>', value: 'x' }] },
  { kind: 'drawn', milliseconds: 'x' },
  { kind: 'state', frames: -1, millis: NaN },
  { kind: 'answer', id: 0, value: 'x' },
  { kind: 'wanted', id: 0, address: 'https://example.com/' },
  { kind: '__proto__' }, { kind: 'constructor' }, null, 7, 'ready',
]
for (const message of forged) {
  playground.report(message)
  for (const window of [parent, parent.parent, top]) window.postMessage(message, '*', [])
}
for (const window of [parent, parent.parent, top])
  window.postMessage('ready', '*', [new MessageChannel().port2])
`),
      )
      await new Promise((go) => setTimeout(go, 500))
      assert.deepEqual(await readState(page), stateBefore)
      await follow(await linkTo(still))
      assert.equal(await mistakeOf(page), '')
    })

    test(`another window can neither run code in the page nor send it messages, in ${name}`, async () => {
      const link = await linkTo(still)
      const other = await browser.newPage()
      await other.goto(evil.address)
      const known = new Set(browser.targets())
      await other.evaluate((link) => {
        window.opened = window.open(link)
      }, link)
      const target = await browser.waitForTarget(
        (target) => target.type() === 'page' && !known.has(target),
        patience,
      )
      const opened = await target.page()
      await settle(opened)
      await other.evaluate(() => {
        const { opened } = window
        const send = (target, message) => {
          const { port2 } = new MessageChannel()
          target.postMessage(message, '*', [port2])
        }
        const start = { kind: 'start', scripts: [], imports: {}, files: {} }
        for (const target of [opened, opened[0], opened[0][0]])
          for (const message of ['ready', { kind: 'error', message: 'forged' }, start])
            send(target, message)
      })
      await new Promise((go) => setTimeout(go, 500))
      assert.equal(await mistakeOf(opened), '')
      assert.equal((await readState(opened)).title, stateBefore.title)
      await opened.close()
      await other.close()
      evil.requests.length = 0
    })

    test(`names and texts with tags and comments cannot end a script, in ${name}`, async () => {
      const nasty = `</script><script>parent.parent.document.title = 'owned'</script> --> <!-- "'`
      await follow(await linkTo(`// ${nasty}\nconst text = ${JSON.stringify(nasty)}\n${still}`))
      assert.equal(await mistakeOf(page), '')
      assert.equal(await (await frameOf(page)).evaluate('text'), nasty)
      const names = [
        `Bob's cat.obj`,
        `"><img src=x>.obj`,
        `100%.obj`,
        `%2e%2e%2f.obj`,
        `--><b>.obj`,
      ]
      for (const file of names) {
        await page.evaluate((file) => {
          const dataTransfer = new DataTransfer()
          const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n'
          dataTransfer.items.add(new File([text], file))
          document.querySelector('main').ariaBusy = 'true'
          document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true }))
        }, file)
        const loading = `let shape
async function setup() {
  createCanvas(120, 90, WEBGL)
  shape = await loadModel(${JSON.stringify(file)})
}
function draw() {
  background('#00ff00')
  model(shape)
}
`
        await follow(await linkTo(loading))
        assert.equal(await mistakeOf(page), '', file)
        assert.equal(await (await frameOf(page)).evaluate('shape.faces.length'), 4, file)
      }
      assert.deepEqual(await readState(page), stateBefore)
    })

    test(`an honest sketch draws, and reports the line of a mistake, in ${name}`, async () => {
      await follow(await linkTo(still))
      const color = await (
        await frameOf(page)
      ).evaluate(async () => {
        const source = document.querySelector('canvas')
        const copy = new OffscreenCanvas(1, 1).getContext('2d')
        for (let i = 0; i < 100; i++) {
          await new Promise((drawn) => setTimeout(() => requestAnimationFrame(drawn)))
          copy.drawImage(source, 0, 0, 1, 1)
          const { data } = copy.getImageData(0, 0, 1, 1)
          if (data[3]) return [...data]
        }
      })
      assert.deepEqual(color, [0, 255, 0, 255])
      await follow(await linkTo(still.replace('WEBGL)', 'WEBGL)\n  createWarp(() => 1)')))
      assert.match(await mistakeOf(page), /^Line 3 .*vec3/)
      await follow(await linkTo(`import * as THREE from 'three'\nlet a\na.b()\n`, 'three'))
      assert.match(await mistakeOf(page), /^Line 3 TypeError/)
    })

    test(`a sketch loads from other sites only with permission, which the next sketch does not inherit, in ${name}`, async () => {
      const loading = `${still}\nfetch('https://127.0.0.1:9/x.json').catch(() => {})\n`
      await follow(await linkTo(loading))
      await page.waitForFunction(
        () => /tick “Load from other sites”/.test(document.querySelector('.mistake').textContent),
        patience,
      )
      await page.click('#network')
      await page.waitForFunction(() => document.querySelector('main').ariaBusy === 'true', patience)
      await settle(page)
      assert.equal(await mistakeOf(page), '')
      await follow(await linkTo(`${loading}\n`))
      assert.equal(await page.$eval('#network', ({ checked }) => checked), false)
    })
  })
