/** The playground's page: a sketch beside its picture, and what comes of it below. */
import './style.css'
import { make } from '../bench/dom.js'
import { keepForOffline } from '../offline.js'
import { makeChecks } from './checks.js'
import { makeChoices } from './choices.js'
import { takeFiles } from './drop.js'
import { makeEditor } from './editor.js'
import { help } from './help.js'
import { boxNamedIn, hosts, scripts } from './hosts.js'
import { fragmentOf, holdsSketch, sketchOf } from './link.js'
import { makeMenu } from './menu.js'
import { draggableNumbers } from './numbers.js'
import { makeOutput } from './output.js'
import { glbOf } from './mesh.js'
import { fileOf } from './messages.js'
import { isModelFile, whole } from './offset.js'
import { download, pageAlone, pageWithTags, project } from './save.js'
import { makeSliders } from './sliders.js'
import { makeStage } from './stage.js'
import { hasWebGL, showStill } from './still.js'
import { makeTime } from './time.js'
import { makeWarpsInFrame } from './warps-in-frame.js'

/** Milliseconds without a key, after which the sketch is built again. */
const PAUSE = 400
const REPORT_EVERY = 500

const find = (selector) => document.querySelector(selector)
const state = find('.state')
/** What was done is told for a moment, whatever is being done. */
const told = { doing: '', done: '' }
function tell(news) {
  Object.assign(told, news)
  state.textContent = told.done || told.doing
}
const mistakePlace = find('.mistake')

/** What a warp may read at this moment. */
const inputsNow = () => {
  const { innerWidth: width, innerHeight: height } = window
  const { millis } = stage.state()
  return { millis, mouse: [width / 2, height / 2], size: [width, height], pixelDensity: 1 }
}
const stage = makeStage(find('.stage'), listen)
const warpsInFrame = makeWarpsInFrame(stage)
const checks = makeChecks(inputsNow, warpsInFrame)
const output = makeOutput(
  find('.tabs'),
  find('#panel'),
  { checks },
  { pointed: (lines) => editor.light(lines), picked: (line) => editor.goTo(line) },
)
const time = makeTime(find('.time'), stage)
const sliders = makeSliders(find('.sliders'), (values) => stage.tell('setValues', values))
const editor = makeEditor(find('.editor'), {
  changed,
  moved: output.follow,
  extensions: [draggableNumbers, help],
})
const normals = find('#normals')
const network = find('#network')
const choices = makeChoices(editor, complain)
/** By name, those that were dropped. */
const files = new Map()
/** An address that the sketch was not let load from. */
let blocked

/** Follows the editor once nobody has changed anything for a while. */
let timer
let isPending = false
function changed() {
  choices.show()
  find('main').ariaBusy = 'true'
  isPending = true
  clearTimeout(timer)
  timer = setTimeout(run, PAUSE)
}

function run() {
  isPending = false
  const sketch = editor.sketch()
  if (!hasWebGL && sketch.host !== 'p5-webgpu') {
    showStill(find('.stage'), find('#example').value)
    find('main').ariaBusy = 'false'
    return keepInAddress(sketch)
  }
  tell({ doing: 'Building…' })
  output.print()
  blocked = undefined
  void stage.run(whole(sketch), {
    clock: time.start(),
    files,
    view: normals.checked ? 'normals' : 'picture',
    values: sliders.moved(),
    mayLoad: network.checked,
  })
  void keepInAddress(sketch)
}

/** So that a reload, or a copy of the address, has the sketch as it is. */
async function keepInAddress(sketch) {
  history.replaceState(null, '', await fragmentOf({ ...sketch, values: sliders.moved() }))
}

function listen(message) {
  if (message.kind === 'printed') return output.print(message)
  if (message.kind === 'blocked') return explainBlocked(message)
  if (message.kind === 'made') return show()
  if (!isPending) {
    find('main').ariaBusy = 'false'
    tell({ doing: '' })
  }
  if (message.kind === 'error') return complain(message)
  complain()
  // A hand may have moved one while the sketch was on its way.
  stage.tell('setValues', sliders.moved())
  show(message.milliseconds)
}

/** Shows the warps and uniforms of the visible sketch; `first` is the time of its first picture in milliseconds. */
function show(first) {
  const { warps, uniforms } = stage.made()
  sliders.show(uniforms)
  output.show({ warps, first })
}

function explainBlocked({ address }) {
  if (blocked || network.checked) return
  blocked = address
  complain({ message: '' })
}

/** { message, line }, or nothing. */
function complain(mistake = blocked && { message: '' }) {
  editor.mark(mistake)
  mistakePlace.replaceChildren()
  if (!mistake) return
  if (mistake.line) {
    const button = make('button', { type: 'button', textContent: `Line ${mistake.line}` })
    button.addEventListener('click', () => editor.goTo(mistake.line))
    mistakePlace.append(button, ' ')
  }
  mistakePlace.append(mistake.message)
  const box = boxNamedIn(mistake.message, editor.sketch().host)
  if (box) mistakePlace.append(` Here, tick “${box}” above.`)
  if (blocked)
    mistakePlace.append(
      ` The sketch would load ${blocked}: if you trust it, tick “Load from other sites” below the picture.`,
    )
}

/** Frames a second, as the frame counts them. */
let counted = { frames: 0, at: 0 }
setInterval(() => {
  const { frames } = stage.state()
  const at = performance.now()
  const passed = frames - counted.frames
  if (passed > 0 && counted.frames) output.rate((1000 * passed) / (at - counted.at))
  counted = { frames, at }
}, REPORT_EVERY)

normals.addEventListener('change', changed)
network.addEventListener('change', changed)
find('.sliders').addEventListener('change', () => keepInAddress(editor.sketch()))

const copyLink = find('#copy-link')
copyLink.addEventListener('click', async () => {
  await keepInAddress(editor.sketch())
  // Only safe origins have a clipboard; elsewhere the address bar has the link.
  await navigator.clipboard?.writeText(location.href)
  copyLink.textContent = navigator.clipboard ? 'Copied' : 'It is in the address bar'
  setTimeout(() => (copyLink.textContent = 'Copy link'), 2000)
})

function say(done) {
  tell({ done })
  setTimeout(() => told.done === done && tell({ done: '' }), 3000)
}
makeMenu(
  find('.actions'),
  'Save',
  {
    'Picture (PNG)': async () => {
      const picture = !stage.isEmpty() && fileOf(await stage.ask('snapshot'), 'image/png')
      if (!picture) throw new Error('There is no picture to save yet.')
      download(picture, 'warp.png')
    },
    'Film of four seconds (WebM)': async () => {
      if (stage.isEmpty()) throw new Error('There is no picture to film yet.')
      tell({ doing: 'Filming…' })
      try {
        download(fileOf(await stage.ask('film', 4), 'video/webm'), 'warp.webm')
      } finally {
        tell({ doing: '' })
      }
    },
    'Warped shape (GLB)': async () =>
      download(
        new Blob([await glbOf(stage.made(), warpsInFrame, inputsNow())], {
          type: 'model/gltf-binary',
        }),
        'warp.glb',
      ),
    'npm project (zip)': async () =>
      download(
        new Blob(await project(whole(editor.sketch()), files), { type: 'application/zip' }),
        'warp.zip',
      ),
    'Page that opens anywhere (HTML)': async () =>
      download(
        new Blob([await pageAlone(whole(editor.sketch()), files)], { type: 'text/html' }),
        'warp.html',
      ),
    'Copy a page and open the p5 editor': async () => {
      if (!navigator.clipboard)
        throw new Error('This browser lets only pages of https and of localhost copy.')
      await navigator.clipboard.writeText(pageWithTags(whole(editor.sketch())))
      open('https://editor.p5js.org/', '_blank', 'noopener')
      return 'Copied: paste it into index.html'
    },
  },
  { done: say, failed: complain },
)

takeFiles((file) => {
  const { name } = file
  files.set(name, file)
  if (isModelFile(name)) choices.addModel(name)
  say(`“${name}” is there for the sketch to load`)
  changed()
})

/** #sketch=… holds a sketch, #example=… names one of the gallery. */
async function follow() {
  const { hash } = location
  // The permission is for one sketch: the next link starts without it.
  network.checked = false
  const [, name] = /^#example=([\w-]+)$/.exec(hash) ?? []
  if (name || !holdsSketch(hash)) return choices.begin(name)
  try {
    const { text, host: named, chosen = [], model = 'sphere', values } = await sketchOf(hash)
    sliders.set(values)
    editor.set({
      text,
      host: Object.hasOwn(hosts, named) ? named : 'p5',
      model,
      chosen: chosen.filter((each) => Object.hasOwn(scripts, each)),
    })
  } catch (error) {
    if (!editor.sketch().text) void choices.begin()
    complain(error)
  }
}
addEventListener('hashchange', follow)
void follow()

keepForOffline(new URL('../', location.href))
