// What the tests of the playground do with it.
import { pixels } from './bench.js'

const patience = { timeout: 120_000 }

/** Until what was written is shown, or its mistake. */
export const settled = (page) =>
  page.waitForFunction(
    () =>
      document.querySelector('main')?.ariaBusy === 'false' &&
      document.querySelector('.cm-content') !== null,
    null,
    patience,
  )

/** The text in the editor, whole. */
export const text = (page) =>
  page.locator('.cm-content').evaluate((content) => content.cmTile.view.state.doc.toString())

/** Replaces the sketch, as one who pastes. */
export async function write(page, sketch) {
  await page.locator('.cm-content').focus()
  await page.keyboard.press('Control+a')
  await page.keyboard.insertText(sketch)
  await settled(page)
}

/** The line that the cursor is on. */
export const line = (page) => page.locator('.cm-activeLine').textContent()

/** The frame with the picture that is shown. */
export async function shown(page) {
  const element = await page.waitForSelector('iframe.shown', patience)
  return element.contentFrame()
}

/** Of the canvas that is shown → RGBA. */
export const canvasPixels = async (page) => pixels(await shown(page))
