// Helpers for the tests of the benchmark's pages.
import assert from 'node:assert/strict'
import { fileURLToPath } from 'node:url'

export const path = (relative) => fileURLToPath(new URL(`../../../${relative}`, import.meta.url))

export const timeoutOptions = { timeout: 60_000 }
export const desktop = { viewport: { width: 1280, height: 900 } }
export const phone = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true }

/** Returns the cells of each row of a table of figures, without the commas of large numbers. */
export const cells = (table) =>
  table
    .locator('tbody tr:not(.title)')
    .evaluateAll((rows) =>
      rows.map((row) => [...row.cells].map((cell) => cell.textContent.replaceAll(',', ''))),
    )

/**
 * Waits until no overlay covers the picture and all numbers are shown. The page may still be
 * loading: the elements are missing then.
 */
export function waitUntilMeasured(page) {
  return page.waitForFunction(
    () =>
      document.querySelector('.picture output')?.textContent === '' &&
      ['rate', 'frame', 'first', 'error'].every((name) =>
        /\d/.test(document.querySelector(`dd.${name}`)?.textContent),
      ),
    null,
    timeoutOptions,
  )
}

export async function choose(page, method) {
  await page.locator('.panel select').nth(1).selectOption(method)
  await page.locator('figcaption b').getByText(method, { exact: true }).waitFor(timeoutOptions)
  await waitUntilMeasured(page)
}

/** Returns the figures with these names. */
export const readFigures = (page, names) =>
  Promise.all(
    names.map(async (name) => {
      const text = await page.locator(`dd.${name}`).textContent()
      return parseFloat(text.replaceAll(',', ''))
    }),
  )

/** Returns the RGBA of the canvas in a frame in which it was drawn. */
export async function pixels(page) {
  const base64 = await page.evaluate(async () => {
    const source = document.querySelector('canvas')
    const { width, height } = source
    const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })
    // A browser clears the canvas after it has shown it, and the page does not draw in every frame. A callback that is requested between
    // two frames runs after the page's own, which is requested while the page draws.
    for (let i = 0; i < 600; i++) {
      await new Promise((drawn) => setTimeout(() => requestAnimationFrame(drawn)))
      copy.drawImage(source, 0, 0)
      const { data } = copy.getImageData(0, 0, width, height)
      if (data[3]) return new Uint8Array(data.buffer).toBase64()
    }
  })
  assert.ok(base64, 'nothing was drawn')
  return Buffer.from(base64, 'base64')
}

/** Returns the fraction of pixels that differ visibly. */
export function difference(a, b) {
  let count = 0
  for (let i = 0; i < a.length; i += 4)
    if ([0, 1, 2].some((channel) => Math.abs(a[i + channel] - b[i + channel]) > 16)) count++
  return (4 * count) / a.length
}
