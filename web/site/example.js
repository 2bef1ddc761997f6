/** The page of an example: runs it while it is visible, shows its source and shader code, and reruns it when a slider moves. */
import { highlight } from '../highlighting.js'
import { makeStage } from '../stage.js'
import { setUpCopyButton } from './copy.js'
import { setUpPauseButton } from './pause.js'

const find = (selector) => document.querySelector(selector)
const main = find('main')
const { sketch, page, sliders } = JSON.parse(find('#sketch').textContent)

/* Source and shader code. The running sketch provides the latter. */

const code = find('.block code')
const tabs = [...document.querySelectorAll('.tabs [value]')]
const texts = { sketch: code.innerHTML, glsl: 'Available when the sketch has started.' }
let shown = 'sketch'

function show(tab) {
  shown = tab
  code.innerHTML = texts[tab]
  code.parentElement.ariaLabel = tab === 'sketch' ? 'Sketch' : 'GLSL'
  for (const button of tabs) button.ariaPressed = String(button.value === tab)
}
for (const button of tabs)
  button.addEventListener('click', () => {
    show(button.value)
    code.parentElement.scrollTo(0, 0)
  })
setUpCopyButton(find('.tabs .copy'), () =>
  page.replace(sketch.trimEnd(), () => currentSketch().trimEnd()),
)

let shader
function setShader(text) {
  if (text === shader) return
  shader = text
  texts.glsl = highlight(text, 'glsl')
  if (shown === 'glsl') show('glsl')
}

/* The sliders. */

const inputs = [...document.querySelectorAll('.sliders input')]
const short = new Intl.NumberFormat('en', { maximumSignificantDigits: 3, useGrouping: false })

/** Returns the sketch with the numbers of the sliders that were moved. */
function currentSketch() {
  let text = sketch
  const moved = sliders
    .map((slider, index) => ({ ...slider, input: inputs[index] }))
    .filter(({ input, value }) => input.dataset.moved && Number(input.value) !== value)
    .sort((a, b) => b.at - a.at)
  for (const { at, length, input } of moved)
    text = text.slice(0, at) + short.format(input.value) + text.slice(at + length)
  return text
}

let timer
for (const input of inputs)
  input.addEventListener('input', () => {
    input.dataset.moved = 'yes'
    input.nextElementSibling.textContent = short.format(input.value)
    clearTimeout(timer)
    timer = setTimeout(() => {
      texts.sketch = highlight(currentSketch(), 'javascript')
      if (shown === 'sketch') show('sketch')
      stage.setSketch(currentSketch())
    }, 250)
  })

/* The picture. */

const rate = find('.rate')
const { name, title } = main.dataset
const stage = makeStage(
  find('.stage'),
  { page: `../../examples/${name}/gallery.html`, title },
  ({ frames, rate: perSecond, code }) => {
    rate.textContent = perSecond
      ? `frame ${frames} · ${perSecond.toFixed(perSecond < 10 ? 1 : 0)} fps`
      : ''
    if (code) setShader(code)
  },
)

setUpPauseButton(find('.pause'), rate, stage)
