/** The playground's page: a sketch beside its picture, and what comes of it below. */
import './style.css'
import { make } from '../bench/dom.js'
import { makeEditor } from './editor.js'
import { exampleSketch, sections, starters } from './examples.js'
import { hosts, isThree, scripts } from './hosts.js'
import { fragmentOf, holdsSketch, sketchOf } from './link.js'
import { makeOutput } from './output.js'
import { makeStage } from './stage.js'

/** Milliseconds without a key, after which the sketch is built again. */
const PAUSE = 400
const REPORT_EVERY = 500

const find = (selector) => document.querySelector(selector)
const state = find('.state')
const mistakePlace = find('.mistake')

const output = makeOutput(find('.tabs'), find('#panel'))
const stage = makeStage(find('.stage'), listen)
const editor = makeEditor(find('.editor'), { changed })

/** Follows the editor once nobody has changed anything for a while. */
let timer
function changed() {
  showSetting()
  find('main').ariaBusy = 'true'
  clearTimeout(timer)
  timer = setTimeout(run, PAUSE)
}

function run() {
  const sketch = editor.sketch()
  state.textContent = 'Building…'
  output.print()
  stage.run(sketch, {
    clock: { time: 0, isPlaying: true },
    files: {},
    valueOf: (name, value) => value,
  })
  keepInAddress(sketch)
}

/** So that a reload, or a copy of the address, has the sketch as it is. */
async function keepInAddress(sketch) {
  history.replaceState(null, '', await fragmentOf(sketch))
}

function listen(message) {
  if (message.kind === 'printed') return output.print(message)
  find('main').ariaBusy = 'false'
  state.textContent = ''
  if (message.kind === 'error') return complain(message)
  complain()
  const { warps = [] } = stage.inside()
  output.show({ warps, first: message.milliseconds })
}

/** { message, line }, or nothing. */
function complain(mistake) {
  editor.mark(mistake)
  mistakePlace.replaceChildren()
  if (!mistake) return
  if (mistake.line) {
    const button = make('button', { type: 'button', textContent: `Line ${mistake.line}` })
    button.addEventListener('click', () => editor.goTo(mistake.line))
    mistakePlace.append(button, ' ')
  }
  mistakePlace.append(mistake.message)
}

/** Frames a second, as the frame counts them. */
let counted = { frames: 0, at: 0 }
setInterval(() => {
  const frames = stage.inside()?.frames?.() ?? 0
  const at = performance.now()
  const passed = frames - counted.frames
  if (passed > 0 && counted.frames) output.rate((1000 * passed) / (at - counted.at))
  counted = { frames, at }
}, REPORT_EVERY)

// What one chooses above

const [example, host] = ['#example', '#host'].map(find)
example.append(make('option', { value: '', textContent: 'A wave' }))
for (const { title, examples } of sections)
  example.append(
    make(
      'optgroup',
      { label: title },
      ...examples.map(({ name, title }) => make('option', { value: name, textContent: title })),
    ),
  )
host.append(
  ...Object.entries(hosts).map(([value, { title }]) =>
    make('option', { value, textContent: title }),
  ),
)
const boxes = Object.entries(scripts)
  .filter(([, { title }]) => title)
  .map(([name, { title }]) => {
    const box = make('input', { type: 'checkbox', name })
    find('.choices fieldset').append(make('label', {}, box, title))
    box.addEventListener('change', () =>
      editor.set({ chosen: boxes.filter(({ checked }) => checked).map(({ name }) => name) }),
    )
    return box
  })

function showSetting() {
  const { host: name, chosen } = editor.sketch()
  host.value = name
  for (const box of boxes) {
    box.checked = chosen.includes(box.name)
    box.disabled = isThree(name)
  }
}

const begin = { text: starters.p5, host: 'p5', chosen: [] }
const choose = async (name) => {
  try {
    editor.set(name ? await exampleSketch(name) : begin)
  } catch (error) {
    complain(error)
  }
}
example.addEventListener('change', () => choose(example.value))
host.addEventListener('change', () => {
  const { text, host: before } = editor.sketch()
  const isOther = isThree(before) !== isThree(host.value)
  editor.set({
    host: host.value,
    text: isOther ? starters[isThree(host.value) ? 'three' : 'p5'] : text,
  })
})

const copyLink = find('#copy-link')
copyLink.addEventListener('click', async () => {
  await keepInAddress(editor.sketch())
  // Only safe origins have a clipboard; elsewhere the address bar has the link.
  await navigator.clipboard?.writeText(location.href)
  copyLink.textContent = navigator.clipboard ? 'Copied' : 'It is in the address bar'
  setTimeout(() => (copyLink.textContent = 'Copy link'), 2000)
})

/** #sketch=… holds a sketch, #example=… names one of the gallery. */
async function follow() {
  const { hash } = location
  const [, name] = /^#example=([\w-]+)$/.exec(hash) ?? []
  if (name) {
    example.value = name
    return choose(name)
  }
  if (!holdsSketch(hash)) return editor.set(begin)
  try {
    const { text, host: named, chosen = [] } = await sketchOf(hash)
    editor.set({
      text,
      host: named in hosts ? named : 'p5',
      chosen: chosen.filter((each) => each in scripts),
    })
  } catch (error) {
    if (!editor.sketch().text) editor.set(begin)
    complain(error)
  }
}
addEventListener('hashchange', follow)
follow()
