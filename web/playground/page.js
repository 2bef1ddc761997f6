/** The playground's page: a sketch beside its picture, and what comes of it below. */
import './style.css'
import { make } from '../bench/dom.js'
import { makeChecks } from './checks.js'
import { makeChoices } from './choices.js'
import { takeFiles } from './drop.js'
import { makeEditor } from './editor.js'
import { help } from './help.js'
import { hosts, isThree, scripts } from './hosts.js'
import { fragmentOf, holdsSketch, sketchOf } from './link.js'
import { makeMenu } from './menu.js'
import { draggableNumbers } from './numbers.js'
import { makeOutput } from './output.js'
import { download, pageAlone, pageWithTags } from './save.js'
import { makeSliders } from './sliders.js'
import { makeStage } from './stage.js'
import { makeTime } from './time.js'

/** Milliseconds without a key, after which the sketch is built again. */
const PAUSE = 400
const REPORT_EVERY = 500

const find = (selector) => document.querySelector(selector)
const state = find('.state')
const mistakePlace = find('.mistake')

const checks = makeChecks(() => {
  const { innerWidth: width, innerHeight: height } = window
  const millis = stage.inside()?.clock?.now() ?? 0
  return { millis, mouse: [width / 2, height / 2], size: [width, height], pixelDensity: 1 }
})
const output = makeOutput(find('.tabs'), find('#panel'), { checks })
const stage = makeStage(find('.stage'), listen)
const time = makeTime(find('.time'), () => stage.inside()?.clock)
const sliders = makeSliders(find('.sliders'))
const editor = makeEditor(find('.editor'), { changed, extensions: [draggableNumbers, help] })
const normals = find('#normals')
const choices = makeChoices(editor, complain)
/** By name, those that were dropped. */
const files = {}

/** Follows the editor once nobody has changed anything for a while. */
let timer
let isPending = false
function changed() {
  choices.show()
  normals.disabled = isThree(editor.sketch().host)
  find('main').ariaBusy = 'true'
  isPending = true
  clearTimeout(timer)
  timer = setTimeout(run, PAUSE)
}

function run() {
  isPending = false
  const sketch = editor.sketch()
  state.textContent = 'Building…'
  output.print()
  stage.run(sketch, {
    clock: time.start(),
    files,
    view: normals.checked ? 'normals' : 'picture',
    valueOf: sliders.valueOf,
  })
  keepInAddress(sketch)
}

/** So that a reload, or a copy of the address, has the sketch as it is. */
async function keepInAddress(sketch) {
  history.replaceState(null, '', await fragmentOf({ ...sketch, values: sliders.moved() }))
}

function listen(message) {
  if (message.kind === 'printed') return output.print(message)
  if (!isPending) {
    find('main').ariaBusy = 'false'
    state.textContent = ''
  }
  if (message.kind === 'error') return complain(message)
  complain()
  const { warps = [], uniforms } = stage.inside()
  sliders.show(uniforms)
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

normals.addEventListener('change', changed)
find('.sliders').addEventListener('change', () => keepInAddress(editor.sketch()))

const copyLink = find('#copy-link')
copyLink.addEventListener('click', async () => {
  await keepInAddress(editor.sketch())
  // Only safe origins have a clipboard; elsewhere the address bar has the link.
  await navigator.clipboard?.writeText(location.href)
  copyLink.textContent = navigator.clipboard ? 'Copied' : 'It is in the address bar'
  setTimeout(() => (copyLink.textContent = 'Copy link'), 2000)
})

const say = (word) => {
  state.textContent = word
  setTimeout(() => state.textContent === word && (state.textContent = ''), 2000)
}
makeMenu(
  find('.actions'),
  'Save',
  {
    'Picture (PNG)': async () => {
      const picture = await stage.inside()?.snapshot()
      if (!picture) throw new Error('There is no picture to save yet.')
      download(picture, 'warp.png')
    },
    'Page that opens anywhere (HTML)': async () =>
      download(
        new Blob([await pageAlone(editor.sketch(), files)], { type: 'text/html' }),
        'warp.html',
      ),
    'Copy as a page for the p5 editor': async () => {
      if (!navigator.clipboard)
        throw new Error('This browser lets only pages of https and of localhost copy.')
      await navigator.clipboard.writeText(pageWithTags(editor.sketch()))
      return 'Copied: paste it into index.html'
    },
  },
  { done: say, failed: complain },
)

takeFiles((name, address) => {
  files[name] = address
  say(`“${name}” is there for the sketch to load`)
  changed()
})

/** #sketch=… holds a sketch, #example=… names one of the gallery. */
async function follow() {
  const { hash } = location
  const [, name] = /^#example=([\w-]+)$/.exec(hash) ?? []
  if (name || !holdsSketch(hash)) return choices.begin(name)
  try {
    const { text, host: named, chosen = [], values } = await sketchOf(hash)
    sliders.set(values)
    editor.set({
      text,
      host: named in hosts ? named : 'p5',
      chosen: chosen.filter((each) => each in scripts),
    })
  } catch (error) {
    if (!editor.sketch().text) choices.begin()
    complain(error)
  }
}
addEventListener('hashchange', follow)
follow()
