// Tests completion and hover in the playground's editor: names of inputs, operations and deformers, each with its meaning.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { launchBrowser } from '../../tests/support/browser/browser.js'
import {
  editorText,
  openPlayground,
  stillSketch,
  waitUntilSettled,
  write,
} from '../../tests/support/browser/playground.js'

let page, messages, close
before(async () => ({ page, messages, close } = await openPlayground(5251, await launchBrowser())))
after(() => close())

const list = () => page.locator('.cm-tooltip-autocomplete')
const completionLabels = () => list().locator('.cm-completionLabel').allTextContents()

/** Writes a sketch with an expression, and types text after the expression. */
async function typeAfter(expression, typed) {
  await write(page, stillSketch('#ff0000', `glsl.vec3(${expression}, 0, 0)`))
  const place = await page.evaluate((expression) => {
    const { view } = document.querySelector('.cm-content').cmTile
    const anchor = view.state.doc.toString().indexOf(`(${expression}, `) + 1 + expression.length
    view.dispatch({ selection: { anchor } })
    return anchor
  }, expression)
  assert.ok(place > expression.length)
  await page.keyboard.type(typed)
  await list().waitFor()
}

/** Returns the texts shown when the pointer rests on a word of the sketch. */
async function meaningOf(word) {
  await page.mouse.move(0, 0)
  const box = await page.evaluate((word) => {
    const { view } = document.querySelector('.cm-content').cmTile
    const at = view.state.doc.toString().indexOf(word)
    const { left, top, bottom } = view.coordsAtPos(at + 1)
    return { x: left, y: (top + bottom) / 2 }
  }, word)
  await page.mouse.move(box.x + 3, box.y)
  await page.mouse.move(box.x + 4, box.y)
  const tip = page.locator('.cm-tooltip-hover .about')
  await tip.waitFor()
  const texts = await tip.evaluate((tip) => [...tip.children].map((each) => each.textContent))
  await page.mouse.move(0, 0)
  await tip.waitFor({ state: 'detached' })
  return texts
}

test('offers the operations after a dot, with their signatures and meanings', async () => {
  await typeAfter('position', '.fb')
  assert.equal((await completionLabels())[0], 'fbm')
  await page.locator('.cm-completionInfo').waitFor()
  assert.match(await page.locator('.cm-completionInfo').textContent(), /p\.fbm\(.*Noise of/)
  // CodeMirror ignores a choice made right after the list opens.
  await page.waitForTimeout(150)
  await page.keyboard.press('Enter')
  assert.match(await editorText(page), /\(position\.fbm, 0, 0\)/)
  await typeAfter('position', '.')
  const all = await completionLabels()
  for (const name of ['sin', 'mult', 'length', 'rotate', 'mix'])
    assert.ok(all.includes(name), `${name} of ${all.length}`)
})

test('offers the inputs and the deformers', async () => {
  await typeAfter('0', ' + mil')
  assert.deepEqual((await completionLabels()).slice(0, 1), ['millis'])
  await typeAfter('warpjet', '.tw')
  assert.equal((await completionLabels())[0], 'twist')
})

/** Returns the completions that the playground itself offers at `§` in the sketch, with the meaning of each. */
async function completionsOf(text) {
  await page.keyboard.press('Escape')
  await write(page, text.replace('§', ''))
  return page.evaluate(async (pos) => {
    const { state } = document.querySelector('.cm-content').cmTile.view
    const context = { state, pos, explicit: true, matchBefore: () => null }
    // CodeMirror's completion sources for JavaScript fail with this incomplete context, and their completions have no `info`.
    const all = await Promise.allSettled(
      state.languageDataAt('autocomplete', pos).map(async (source) => source(context).options),
    )
    const ours = all.flatMap(({ value = [] }) => value).filter(({ info }) => info)
    return Object.fromEntries(
      ours.map(({ label, info }) => [label, info().querySelector('p').textContent]),
    )
  }, text.indexOf('§'))
}

/** Returns the inputs that the compiler lists in its error for an unknown input. */
function listInputs() {
  try {
    compileWarp(({ nothing }) => nothing)
  } catch ({ message }) {
    return /it gets (.*), and uniforms by/.exec(message)[1].split(', ')
  }
}

test('offers every input in the offset function, and every option in the options of createWarp, each with its meaning', async () => {
  const words = await completionsOf(stillSketch('#ff0000', 'glsl.vec3(§, 0, 0)'))
  for (const name of [...listInputs(), 'uniforms', 'createWarp'])
    assert.match(words[name] ?? '', /\w+ \w+/, name)
  const options = await completionsOf(stillSketch('#ff0000', 'glsl.vec3(0, 0, 0)', ', { § }'))
  assert.deepEqual(Object.keys(options).sort(), [
    'defs',
    'detail',
    'fadeNoise',
    'hooks',
    'normals',
    'returns',
    'scope',
    'shader',
    'space',
    'stroke',
    'surfaceVariation',
    'type',
    'uniforms',
  ])
  for (const [name, meaning] of Object.entries(options)) assert.match(meaning, /\w+ \w+/, name)
})

test('offers only the inputs and functions of three.js in a three.js sketch', async () => {
  await page.getByLabel('Runs in').selectOption('three')
  await waitUntilSettled(page)
  const sketch = await editorText(page)
  const words = await completionsOf(sketch.replace('along.sin', '§.sin'))
  assert.ok(words.millis && words.warp && words.warpMaterial)
  assert.equal(words.mouseX ?? words.createWarp, undefined)
  const options = await completionsOf(sketch.replace(/^}\)$/m, '}, { § })'))
  assert.deepEqual(Object.keys(options).sort(), [
    'detail',
    'fadeNoise',
    'normals',
    'share',
    'space',
    'surfaceVariation',
    'uniforms',
  ])
  await page.getByLabel('Runs in').selectOption('p5')
  await waitUntilSettled(page)
})

test('shows the formula and the derivative of the operation under the pointer', async () => {
  await page.keyboard.press('Escape')
  await write(page, stillSketch('#ff0000', 'position.mult(2).fbm().sin().mult(uniforms.far)'))
  const [fbm, ...more] = await meaningOf('fbm')
  assert.match(fbm, /glsl\.fbm\(p, /)
  assert.ok(
    more.includes('Value: Σ gain^i * n(p * lacunarity^i + i * shift) / Σ gain^i.'),
    more.join('\n'),
  )
  assert.ok((await meaningOf('sin()')).includes('Value: sin(x). Derivative: cos(x).'))
  await write(page, stillSketch('#ff0000', 'position.length().mult(uniforms.far)'))
  assert.ok(
    (await meaningOf('length')).includes('length(v) is √(v · v). Derivative: v · dv / |v|.'),
  )
  await write(page, stillSketch('#ff0000', 'position.mult(2).fbm().sin().mult(uniforms.far)'))
  assert.match((await meaningOf('position')).join(' '), /from -1 to 1/)
  assert.match((await meaningOf('createWarp')).join(' '), /how far each vertex moves/)
  await write(page, stillSketch('#ff0000', 'glsl.vec3(0, 0, 0)', ", { space: 'world' }"))
  assert.match(
    (await meaningOf('space')).join(' '),
    /'local' \| 'world' \| 'camera' Default: 'local'\. The space/,
  )
  await write(page, stillSketch('#ff0000'))
  await waitUntilSettled(page)
})

test('logs nothing', () => assert.deepEqual(messages, []))
