// Checks the messages of mistakes in p5 sketches.
import assert from 'node:assert/strict'
import { leavePage } from './browser.js'

/**
 * Runs each statement of a table in a sketch, and compares the message of its WarpError:
 * - `files`: the scripts. Default: those of the host.
 * - `head`: statements before setup(). `setup`: statements of setup(), which may await on p5 2.x. `drawing`: statements of draw().
 * - `cases`: maps a statement, which may await, to a pattern of the message.
 * - `isRemoved`: `true` if the cases remove the sketch. Otherwise it must still draw after them.
 */
export async function checkMistakes(host, table) {
  const { files, head = '', setup = '', drawing = '', cases, isRemoved } = table
  const { page, messages } = await host.open(
    `${head}
    async function setup() {
      ${host.canvas(100, 100)}
      noLoop()
      ${setup}
      window.isSetUp = true
    }
    function draw() {
      // p5 1.11 draws before an async setup has finished.
      if (!window.isSetUp) return
      ${drawing}
      window.done = true
    }`,
    files,
  )
  for (const [code, message] of Object.entries(cases)) {
    const error = await page.evaluate(`(async () => {
      try { ${code} } catch (error) { return { name: error.name, message: error.message } }
    })()`)
    assert.equal(error?.name, 'WarpError', code)
    assert.match(error.message, message, code)
  }
  if (!isRemoved) await page.evaluate('redraw()')
  await leavePage(page)
  assert.deepEqual(messages, [])
}
