/** The interactive benchmark: a moving picture, a panel, and the cost of the chosen method on the chosen row. */
// Imported first, so that it sees the memory of warpjet's WebAssembly.
import './memory.js'
import './style.css'
import { keepForOffline } from '../offline.js'
import { make } from './dom.js'
import { measureRow } from './measure.js'
import { listMethods } from './method-list.js'
import { notes } from './method-notes.js'
import { methods } from './methods.js'
import { makePanel } from './panel.js'
import { Picture } from './picture.js'
import { makeReadOuts } from './read-outs.js'
import { recordsOf } from './records.js'
import { defaultEye } from './scene.js'
import { makeTable } from './table.js'
import { workloads } from './workloads.js'

/** The canvas size of the paper, in pixels; `?size=` overrides it. */
const SIZE = 1200
/** Milliseconds between two measurements of frame time and normals, and before the first one. */
const MEASURING_INTERVAL = 1000
const FIRST_INTERVAL = 250
/** The max fraction of time spent on measuring. */
const MAX_MEASURING_FRACTION = 0.1

/** The settings of `measureRow`: a row takes some seconds on a GPU, half a minute without one. */
const moderate = { rounds: 5, frames: 8, turn: 300, runs: 10, samples: 400 }

const find = (selector) => document.querySelector(selector)
const status = find('.picture output')
const button = find('.measure')
const showReadOuts = makeReadOuts(find('.read-outs'))

const settings = {
  row: 'airplane twist',
  method: 'warpjet',
  exponent: -1,
  moves: !matchMedia('(prefers-reduced-motion: reduce)').matches,
  speed: 1,
}

listMethods(find('.notes'))

/** The row and method that the picture currently shows; `settings` holds the requested ones. */
const shown = {}
/** The warp's time in milliseconds. */
let millis = 1200
/** Work to do between two frames, if any. */
let pendingWork
let isMeasuring = false
let mustStop = false
let isLost = false

const nextFrame = () => new Promise(requestAnimationFrame)

/** Shows a message over the picture and waits until it is visible. */
async function showStatus(text) {
  status.textContent = text
  await nextFrame()
  await nextFrame()
}

const showError = (error) => (find('[role=alert]').textContent = error?.message ?? '')

const uniforms = () => ({ millis, h: 10 ** settings.exponent })

async function loadRow(picture) {
  showError()
  await showStatus('Making the mesh…')
  shown.row = settings.row
  // Prevents compiling if loading fails.
  shown.method = settings.method
  const workload = workloads.find(({ name }) => name === shown.row)
  picture.load(workload)
  const { positions, indices } = picture.mesh
  showReadOuts({
    vertices: positions.length / 3,
    triangles: indices.length / 3,
    nodes: workload.nodes,
  })
  shown.method = undefined
}

async function compile(picture) {
  showError()
  await showStatus('Compiling…')
  shown.method = settings.method
  find('figcaption').replaceChildren(
    make('b', { textContent: shown.method, style: `--color: ${notes[shown.method].color}` }),
    notes[shown.method].text,
  )
  showReadOuts({
    rate: undefined,
    frame: undefined,
    first: undefined,
    generation: undefined,
    error: undefined,
    median: undefined,
  })
  const method = methods.find(({ name }) => name === shown.method)
  showReadOuts(await picture.use(method, uniforms()))
  status.textContent = ''
}

async function findStep(picture) {
  if (!picture.method.steps) return
  await showStatus('Looking for the best h…')
  settings.exponent = Math.log10(picture.bestStep(millis))
  panel.refresh()
  status.textContent = ''
}

async function measure(picture) {
  isMeasuring = true
  mustStop = false
  button.textContent = 'Stop measuring'
  try {
    await showStatus('Measuring…')
    picture.scene.lookFrom(defaultEye)
    const { mesh, workload } = picture
    const measured = await measureRow(
      picture.scene,
      { ...workload, mesh: () => mesh },
      { ...moderate, millis },
      (text) => {
        if (mustStop) throw new Stopped()
        status.textContent = `Measuring: ${text}…`
      },
    )
    showMeasured(picture, recordsOf(workload, measured), measured)
  } catch (error) {
    if (!(error instanceof Stopped)) throw error
  } finally {
    isMeasuring = false
    button.textContent = 'Measure this row'
    status.textContent = ''
  }
}

class Stopped extends Error {}

function showMeasured({ scene }, records, { clock }) {
  const section = find('.measured')
  section.hidden = false
  section.querySelector('p').textContent =
    `${scene.gl.canvas.width} × ${scene.gl.canvas.height} pixels on ${scene.renderer}, timed by ${clock}.`
  section.querySelector('.wide').replaceChildren(makeTable(records))
  section.scrollIntoView({ block: 'nearest' })
}

/** Draws frame after frame and does the panel's work in between, so that nothing runs concurrently. */
async function run(picture) {
  let [before, start, frames, nextMeasurement] = [performance.now(), 0, 0, 0]
  const startCounting = (duration = FIRST_INTERVAL) => {
    start = before = performance.now()
    frames = 0
    nextMeasurement = start + duration
  }
  while (!isLost) {
    await nextFrame()
    const now = performance.now()
    try {
      if (shown.row !== settings.row) await loadRow(picture)
      else if (shown.method !== settings.method) {
        await compile(picture)
        startCounting()
      } else if (pendingWork && picture.program) {
        const work = pendingWork
        pendingWork = undefined
        await work(picture)
        startCounting()
      } else if (picture.program) {
        if (settings.moves) millis += settings.speed * (now - before)
        before = now
        picture.draw(uniforms())
        frames++
        if (now < nextMeasurement) continue
        // Waits for the frames in the GPU's queue, since they are not visible yet.
        picture.scene.finish()
        showReadOuts({ rate: (1000 * frames) / (performance.now() - start) })
        const frame = await picture.frameTime(uniforms())
        const { largest, median } = picture.error(uniforms())
        showReadOuts({ frame, clock: picture.clock.kind, error: largest, median })
        startCounting(MEASURING_INTERVAL + (performance.now() - now) / MAX_MEASURING_FRACTION)
      }
    } catch (error) {
      status.textContent = ''
      showError(error)
    }
  }
}

let panel
try {
  const size = Number(new URLSearchParams(location.search).get('size')) || SIZE
  const picture = new Picture(find('canvas'), size)
  panel = makePanel(find('.panel'), settings, () => (pendingWork = findStep))
  button.addEventListener('click', () => {
    if (isMeasuring) mustStop = true
    else pendingWork = measure
  })
  find('canvas').addEventListener('webglcontextlost', () => {
    isLost = true
    showError(new Error('The GPU lost this picture: reload the page and choose a smaller row.'))
  })
  void run(picture)
} catch (error) {
  const still = { src: '../posters/airplane-twist.webp', alt: 'The airplane at rest, twisted' }
  find('.hand').replaceWith(make('img', still))
  showError(error)
}

keepForOffline(new URL('../', location.href))
