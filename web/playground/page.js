/** The playground's page: a sketch beside its picture, and the tabs with its output below. */
import './style.css'
import { make } from '../bench/dom.js'
import { keepForOffline } from '../offline.js'
import { makeChecks } from './checks.js'
import { makeChoices } from './choices.js'
import { takeFiles } from './drop.js'
import { makeEditor } from './editor.js'
import { help } from './help.js'
import { boxNamedIn, hosts, scripts } from './hosts.js'
import { decodeSketch, encodeSketch, hasSketch } from './link.js'
import { makeMenu } from './menu.js'
import { glbOf } from './mesh.js'
import { fileOf } from './messages.js'
import { draggableNumbers } from './numbers.js'
import { completeSketch, isModelFile } from './offset.js'
import { makeOutput } from './output.js'
import { download, writePage, writePageWithTags, writeProject } from './save.js'
import { makeSliders } from './sliders.js'
import { makeStage } from './stage.js'
import { hasWebGL, showStill } from './still.js'
import { makeTime } from './time.js'
import { makeWarpsInFrame } from './warps-in-frame.js'

/** After this many milliseconds without a change, the sketch is built again. */
const PAUSE = 400
const REPORT_EVERY = 500

const find = (selector) => document.querySelector(selector)
const state = find('.state')
/** The status: `done`, shown briefly after an action, takes precedence over `doing`. */
const statusTexts = { doing: '', done: '' }
function setStatus(texts) {
  Object.assign(statusTexts, texts)
  state.textContent = statusTexts.done || statusTexts.doing
}
const mistakePlace = find('.mistake')

/** Returns the current values of the inputs that a warp may read. */
const readInputs = () => {
  const { innerWidth: width, innerHeight: height } = window
  const { millis } = stage.state()
  return { millis, mouse: [width / 2, height / 2], size: [width, height], pixelDensity: 1 }
}
const stage = makeStage(find('.stage'), listen)
const warpsInFrame = makeWarpsInFrame(stage)
const checks = makeChecks(readInputs, warpsInFrame)
const output = makeOutput(
  find('.tabs'),
  find('#panel'),
  { checks },
  { onPoint: (lines) => editor.highlight(lines), onPick: (line) => editor.goTo(line) },
)
const time = makeTime(find('.time'), stage)
const sliders = makeSliders(find('.sliders'), (values) => stage.send('setValues', values))
const editor = makeEditor(find('.editor'), {
  onChange: runSoon,
  onMove: output.follow,
  extensions: [draggableNumbers, help],
})
const normals = find('#normals')
const network = find('#network')
const choices = makeChoices(editor, showMistake)
/** Maps name → dropped file. */
const files = new Map()
/** The first address that the sketch tried to load and the policy blocked. */
let blocked

/** Runs the sketch after a pause without changes. */
let timer
let isPending = false
function runSoon() {
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
  setStatus({ doing: 'Building…' })
  output.print()
  blocked = undefined
  void stage.run(completeSketch(sketch), {
    clock: time.start(),
    files,
    view: normals.checked ? 'normals' : 'picture',
    values: sliders.moved(),
    mayLoad: network.checked,
  })
  void keepInAddress(sketch)
}

/** Writes the sketch into the address, so that a reload or a copied address restores it. */
async function keepInAddress(sketch) {
  history.replaceState(null, '', await encodeSketch({ ...sketch, values: sliders.moved() }))
}

function listen(message) {
  if (message.kind === 'printed') return output.print(message)
  if (message.kind === 'blocked') return explainBlocked(message)
  if (message.kind === 'made') return show()
  if (!isPending) {
    find('main').ariaBusy = 'false'
    setStatus({ doing: '' })
  }
  if (message.kind === 'error') return showMistake(message)
  showMistake()
  // Sliders may have moved while the sketch was being built.
  stage.send('setValues', sliders.moved())
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
  showMistake({ message: '' })
}

/** Shows { message, line }, or clears the message if there is none. */
function showMistake(mistake = blocked && { message: '' }) {
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

/** Shows frames per second from the frame's counter. */
let lastCount = { frames: 0, at: 0 }
setInterval(() => {
  const { frames } = stage.state()
  const at = performance.now()
  const newFrames = frames - lastCount.frames
  if (newFrames > 0 && lastCount.frames) output.showRate((1000 * newFrames) / (at - lastCount.at))
  lastCount = { frames, at }
}, REPORT_EVERY)

normals.addEventListener('change', runSoon)
network.addEventListener('change', runSoon)
find('.sliders').addEventListener('change', () => keepInAddress(editor.sketch()))

const copyLink = find('#copy-link')
copyLink.addEventListener('click', async () => {
  await keepInAddress(editor.sketch())
  // The clipboard exists only in secure contexts; elsewhere the address bar has the link.
  await navigator.clipboard?.writeText(location.href)
  copyLink.textContent = navigator.clipboard ? 'Copied' : 'Copy it from the address bar'
  setTimeout(() => (copyLink.textContent = 'Copy link'), 2000)
})

function showDone(done) {
  setStatus({ done })
  setTimeout(() => statusTexts.done === done && setStatus({ done: '' }), 3000)
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
      setStatus({ doing: 'Filming…' })
      try {
        download(fileOf(await stage.ask('film', 4), 'video/webm'), 'warp.webm')
      } finally {
        setStatus({ doing: '' })
      }
    },
    'Warped shape (GLB)': async () =>
      download(
        new Blob([await glbOf(stage.made(), warpsInFrame, readInputs())], {
          type: 'model/gltf-binary',
        }),
        'warp.glb',
      ),
    'npm project (zip)': async () =>
      download(
        new Blob(await writeProject(completeSketch(editor.sketch()), files), {
          type: 'application/zip',
        }),
        'warp.zip',
      ),
    'Page that opens anywhere (HTML)': async () =>
      download(
        new Blob([await writePage(completeSketch(editor.sketch()), files)], { type: 'text/html' }),
        'warp.html',
      ),
    'Copy a page and open the p5 editor': async () => {
      if (!navigator.clipboard)
        throw new Error('This browser allows copying only on https and localhost pages.')
      await navigator.clipboard.writeText(writePageWithTags(completeSketch(editor.sketch())))
      open('https://editor.p5js.org/', '_blank', 'noopener')
      return 'Copied: paste it into index.html'
    },
  },
  { onDone: showDone, onError: showMistake },
)

takeFiles((file) => {
  const { name } = file
  files.set(name, file)
  if (isModelFile(name)) choices.addModel(name)
  showDone(`The sketch can load “${name}” now`)
  runSoon()
})

/** Opens the sketch in #sketch=… or the gallery's example named by #example=…. */
async function openFragment() {
  const { hash } = location
  // The permission to load from other sites is for one sketch only.
  network.checked = false
  const [, name] = /^#example=([\w-]+)$/.exec(hash) ?? []
  if (name || !hasSketch(hash)) return choices.begin(name)
  try {
    const { text, host: named, chosen = [], model = 'sphere', values } = await decodeSketch(hash)
    sliders.set(values)
    editor.set({
      text,
      host: Object.hasOwn(hosts, named) ? named : 'p5',
      model,
      chosen: chosen.filter((each) => Object.hasOwn(scripts, each)),
    })
  } catch (error) {
    if (!editor.sketch().text) void choices.begin()
    showMistake(error)
  }
}
addEventListener('hashchange', openFragment)
void openFragment()

keepForOffline(new URL('../', location.href))
