// Tests the built site in a folder of a server: every page causes no console message and no finding of axe, works by keyboard, and fits a
// phone. site-motion.browser.test.js tests motion, site-offline.browser.test.js opens the pages offline.
import assert from 'node:assert/strict'
import { mkdirSync, readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { after, before, describe, test } from 'node:test'
import { walk } from '../../.scripts/lib/files.mjs'
import { checkSite } from '../../.scripts/lib/site-budget.mjs'
import { folder } from '../../.scripts/site.mjs'
import { desktop, path, phone } from '../../tests/support/browser/bench.js'
import { launchBrowser, openPage } from '../../tests/support/browser/browser.js'
import { drawLittle } from '../../tests/support/browser/frames.js'
import { waitUntilSettled } from '../../tests/support/browser/playground.js'
import { serveSite, withReducedMotion, withoutWorker } from '../../tests/support/browser/site.js'

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')
const screenshots = path('.build/screenshots')
const patience = { timeout: 120_000 }

let browser, server, url, pages
before(async () => {
  mkdirSync(screenshots, { recursive: true })
  browser = await launchBrowser()
  server = await serveSite(5340, '/some/folder/')
  url = server.resolvedUrls.local[0]
  const files = walk(folder, /\.html$/).map((file) => file.slice(folder.length + 1))
  // Pages shown in a frame contain only a sketch.
  pages = files.filter(
    (file) => !/^(?:examples|playground\/host|bench\/(?:driven|p5-sketch))/.test(file),
  )
})
after(async () => {
  await browser.close()
  await server.close()
})

/**
 * Returns the violations of axe's default and optional rules. Not enabled are `color-contrast-enhanced`, which requires more contrast
 * than WCAG's level AA, and `focus-order-semantics`, which forbids focus on scrolling tables, although another rule
 * requires it.
 */
const findViolations = (page) =>
  page.evaluate(async () => {
    const optional = [
      'css-orientation-lock',
      'hidden-content',
      'label-content-name-mismatch',
      'p-as-heading',
      'table-fake-caption',
      'target-size',
      'td-has-header',
    ]
    const rules = Object.fromEntries(optional.map((id) => [id, { enabled: true }]))
    // Reporting only violations saves most of the work.
    const output = { resultTypes: ['violations'], selectors: false, ancestry: false }
    const { violations } = await window.axe.run(document, { iframes: false, rules, ...output })
    return violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 160)}`)
  })

/** Finds focusable elements that are not visible, or have no focus ring, while they have the focus. */
const findInvisibleFocus = (page) =>
  page.evaluate(() => {
    const wrong = []
    const stops = 'a[href], button, input, select, textarea, summary, [tabindex]'
    for (const stop of document.querySelectorAll(stops)) {
      if (stop.tabIndex < 0 || stop.disabled || !stop.checkVisibility()) continue
      stop.focus({ focusVisible: true })
      const { width, height, right, left } = stop.getBoundingClientRect()
      const hasRing = (element) => getComputedStyle(element).outlineStyle !== 'none'
      const isSeen = width && height && right > 0 && left < innerWidth
      const isMarked =
        hasRing(stop) || hasRing(stop.parentElement.closest('.editor, label') ?? stop)
      if (document.activeElement !== stop || !isSeen || !isMarked)
        wrong.push(`no focus to be seen: ${stop.outerHTML.slice(0, 160)}`)
    }
    return wrong
  })

/** Finds tables of words that are wider than the page. Tables of figures may be wider than a phone. */
const findWideTables = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('.table:not(.figures)')]
      .filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth)
      .map((table) => `a table is wider than its page: ${table.textContent.trim().slice(0, 80)}`),
  )

for (const [name, size, colorScheme] of [
  ['a desktop', desktop, 'light'],
  ['a phone', phone, 'dark'],
])
  test(`on ${name} every page has no axe findings, shows the focus, prints nothing, and fits`, async () => {
    const context = await browser.newContext({ ...withReducedMotion(size), colorScheme })
    await context.addInitScript(withoutWorker)
    await drawLittle(context)
    await context.addInitScript(axe)
    const { page, messages } = await openPage(context, url)
    const wrong = []
    for (const file of pages) {
      await page.goto(url + file, patience)
      if (file.startsWith('playground')) await waitUntilSettled(page)
      for (const find of [findViolations, findInvisibleFocus, findWideTables])
        for (const finding of await find(page)) wrong.push(`${file}: ${finding}`)
      const width = await page.evaluate(() => document.documentElement.scrollWidth)
      if (width > size.viewport.width) wrong.push(`${file} is ${width} wide`)
      for (const message of messages.splice(0)) wrong.push(`${file}: ${message}`)
    }
    await context.close()
    assert.deepEqual(wrong, [])
  })

/** One page of each kind. */
for (const file of [
  'index.html',
  'docs/units.html',
  'gallery/lotus/index.html',
  'gallery/lotus/full.html',
  'playground/index.html',
  'drop/index.html',
  'bench/results.html',
])
  test(`the Tab key goes through ${file}, stops at every control, and leaves it`, async () => {
    const context = await browser.newContext(withReducedMotion(desktop))
    await context.addInitScript(withoutWorker)
    await drawLittle(context)
    const { page } = await openPage(context, url + file)
    if (file.startsWith('playground')) await waitUntilSettled(page)
    const expected = await page.evaluate(() => {
      const stops = 'a[href], button, input, select, textarea, summary, [tabindex]'
      const all = [...document.querySelectorAll(stops)].filter(
        (stop) => stop.tabIndex >= 0 && !stop.disabled && stop.checkVisibility(),
      )
      for (const [i, stop] of all.entries()) stop.dataset.stop = i
      // In a group of radio buttons, the key stops only at the checked one.
      return all
        .filter((stop) => stop.type !== 'radio' || stop.checked)
        .map((stop) => stop.dataset.stop)
    })
    await page.evaluate(() => document.activeElement.blur())
    const reached = []
    for (let i = 0; i < expected.length + 20; i++) {
      await page.keyboard.press('Tab')
      const stop = await page.evaluate(() => {
        const { activeElement } = document
        return activeElement === document.body
          ? 'end'
          : (activeElement.dataset.stop ?? activeElement.tagName)
      })
      if (stop === 'end' || reached.includes(stop)) break
      reached.push(stop)
    }
    await context.close()
    const missed = expected.filter((stop) => !reached.includes(stop))
    assert.deepEqual(missed, [], `${reached}`)
  })

test('every page has a policy that blocks foreign and injected scripts', () => {
  for (const file of walk(folder, /\.html$/)) {
    const html = readFileSync(path(file), 'utf8')
    const [, policy] =
      /<meta\s+http-equiv="Content-Security-Policy"\s+content="([^"]*)"/.exec(html) ?? []
    assert.ok(policy, `${file} has no policy`)
    // A policy applies only to content after it.
    assert.ok(
      html.indexOf('Content-Security-Policy') < html.search(/<(?:script|link|style)\b/),
      file,
    )
    const [, scripts] = /script-src ([^;]*)/.exec(policy)
    assert.match(policy, /default-src 'none'/)
    // The host page of sketches has no script; the playground tightens the policy of each sketch.
    if (file.endsWith('playground/host.html')) {
      assert.doesNotMatch(html, /<script/)
      assert.match(policy, /frame-src 'none'/)
      continue
    }
    assert.doesNotMatch(scripts, /'unsafe-inline'|https?:|\*/, file)
    const isSketch = /\/examples\//.test(file)
    assert.equal(/'unsafe-eval'/.test(scripts), isSketch, file)
    assert.match(policy, /base-uri 'none'/, file)
  }
})

test('the pages are within their size budgets', () => checkSite(folder))

describe('the first page', () => {
  let context, page, messages
  before(async () => {
    context = await browser.newContext({ ...desktop })
    await context.addInitScript(withoutWorker)
    await drawLittle(context)
    ;({ page, messages } = await openPage(context, url))
  })
  after(() => context.close())

  const takePicture = () => page.locator('.hero canvas').screenshot()

  test('has an animated warp', async () => {
    await page.waitForSelector('.hero canvas', patience)
    const first = await takePicture()
    await page.waitForTimeout(500)
    assert.notDeepEqual(await takePicture(), first)
    await page.screenshot({ path: `${screenshots}/site-first.png` })
  })

  test('shows the first examples on a desktop’s first screen', async () => {
    const isSeen = await page
      .locator('.tiles img')
      .evaluateAll((images) =>
        images.map((image) => image.getBoundingClientRect().bottom <= innerHeight),
      )
    assert.deepEqual(isSeen.slice(0, 4), [true, true, true, true])
  })

  test('copies the script tag', async () => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    await page.getByRole('button', { name: 'Copy' }).click()
    await page.getByRole('button', { name: 'Copied' }).waitFor()
    const copied = await page.evaluate(() => navigator.clipboard.readText())
    assert.equal(copied, await page.locator('.install code').textContent())
    assert.match(copied, /^<script src="https:\/\/\S+\.js"><\/script>$/)
  })

  test('filters its pictures by words and by section', async () => {
    const tiles = page.locator('.tiles > li:visible')
    const all = await tiles.count()
    await page.locator('#words').fill('bunny')
    assert.ok((await tiles.count()) > 0 && (await tiles.count()) < all)
    for (const text of await tiles.evaluateAll((list) => list.map(({ dataset }) => dataset.words)))
      assert.match(text, /bunny/)
    await page.locator('#words').fill('')
    await page.locator('#section').selectOption('Deformers')
    assert.equal(await tiles.count(), 13)
    await page.locator('#section').selectOption('')
    assert.equal(await tiles.count(), all)
  })

  test('works by keyboard: past the bar, into the search, and to a result', async () => {
    await page.goto(url, patience)
    await page.keyboard.press('Tab')
    assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Skip to the page')
    await page.keyboard.press('Enter')
    assert.equal(await page.evaluate(() => location.hash), '#main')
    await page.keyboard.press('/')
    assert.equal(await page.evaluate(() => document.activeElement.id), 'search')
    await page.keyboard.type('rotate about an axis')
    await page.waitForSelector('#found a', patience)
    await page.keyboard.press('ArrowDown')
    await page.keyboard.press('ArrowUp')
    await page.keyboard.press('Enter')
    await page.waitForURL(/docs\//)
    assert.match(await page.locator('h1').textContent(), /Rotate about an axis/)
  })

  for (const [question, answer] of [
    ['Rotate about an axis', /how-to-rotate/],
    ['use noise', /docs\/(?:tutorial-3-)?noise/],
    ["what is space: 'world'", /docs\/spaces/],
    ['waving flag', /how-to-flag/],
    ['melting bunny', /tutorial-5|deformers\.html#melt/],
  ])
    test(`answers “${question}” with the first result`, async () => {
      await page.goto(url, patience)
      await page.locator('#search').fill(question)
      const first = page.locator('#found a').first()
      await first.waitFor(patience)
      await page.waitForTimeout(100)
      assert.match(await first.getAttribute('href'), answer)
    })

  test('logs nothing', () => assert.deepEqual(messages, []))
})

test('the list beside a page of the docs shows the current page, and the page starts at its top', async () => {
  const context = await browser.newContext(desktop)
  await context.addInitScript(withoutWorker)
  const { page, messages } = await openPage(context, `${url}docs/develop.html`)
  const isVisible = await page.evaluate(() => {
    const box = (selector) => document.querySelector(selector).getBoundingClientRect()
    const [list, entry] = [box('.contents'), box('.contents [aria-current]')]
    return entry.top >= list.top && entry.bottom <= Math.min(list.bottom, innerHeight)
  })
  assert.ok(isVisible)
  assert.equal(await page.evaluate(() => scrollY), 0)
  await context.close()
  assert.deepEqual(messages, [])
})

test('the pages with their own header link to the docs and to the search, whose field gets the focus', async () => {
  const context = await browser.newContext(withReducedMotion(desktop))
  await context.addInitScript(withoutWorker)
  await drawLittle(context)
  const { page, messages } = await openPage(context, `${url}playground/index.html`)
  for (const file of ['playground/index', 'drop/index', 'bench/index', 'bench/results']) {
    await page.goto(`${url}${file}.html`, patience)
    await page.getByRole('link', { name: 'Docs', exact: true }).click()
    await page.waitForURL(/docs\/$/)
  }
  await page.goto(`${url}bench/results.html`, patience)
  await page.getByRole('link', { name: 'Search' }).click()
  await page.waitForURL(/\/#search$/)
  await page.waitForFunction(() => document.activeElement.id === 'search', null, patience)
  await context.close()
  assert.deepEqual(messages, [])
})

test('a slider changes the sketch, and the picture follows', async () => {
  const context = await browser.newContext({ ...desktop })
  await context.addInitScript(withoutWorker)
  await drawLittle(context)
  const { page, messages } = await openPage(context, `${url}gallery/deformer-twist/index.html`)
  const frame = await page.waitForSelector('iframe.shown', patience)
  await page.getByLabel('Angle').fill('0')
  await page.getByText('.cos().mult(0)').waitFor(patience)
  await page.waitForFunction((old) => !old.isConnected, frame, patience)
  await page.waitForSelector('iframe.shown', patience)
  assert.equal(await page.locator('iframe').count(), 1)
  assert.deepEqual(messages, [])
  await context.close()
})

test('the slider in the docs moves the border between two pictures, by mouse and by keyboard', async () => {
  const context = await browser.newContext({ ...desktop })
  await context.addInitScript(withoutWorker)
  const { page, messages } = await openPage(context, `${url}docs/normals.html`)
  const figure = page.locator('.compare')
  const shareOfFirst = () =>
    figure.evaluate((element) => {
      const { clipPath } = getComputedStyle(element.querySelector('img + img'))
      return Number(/([\d.]+)%\)$/.exec(clipPath)[1])
    })
  await figure.scrollIntoViewIfNeeded()
  assert.equal(await shareOfFirst(), 50)
  const { width, height } = await figure.locator('img').first().boundingBox()
  await figure.click({ position: { x: 0.8 * width, y: height / 3 } })
  assert.ok(Math.abs((await shareOfFirst()) - 80) < 2, `${await shareOfFirst()}%`)
  await page.keyboard.press('Home')
  assert.equal(await shareOfFirst(), 0)
  assert.deepEqual(messages, [])
  await context.close()
})
