/** The page for the visitor's own model: loads it, warps it, and exports it. */
import './style.css'
import { bakeWarp, exportGLB, subdivide } from '../../dist/mesh.js'
import { compileWarp } from '../../dist/warpjet.js'
import { make } from '../bench/dom.js'
import { keepForOffline } from '../offline.js'
import { makeCamera } from './camera.js'
import { loadFiles, samples } from './files.js'
import { View } from './view.js'
import { fitWarp, sides, warps } from './warps.js'

/** Milliseconds of one cycle of the time slider. */
const CYCLE = 6000
/** Milliseconds between two counts of folded vertices while time passes. */
const COUNTING_INTERVAL = 400
const MAX_TRIANGLES = 400_000

const find = (selector) => document.querySelector(selector)
const status = find('.picture output')
const [amount, time, tolerance] = ['#amount', '#time', '#tolerance'].map(find)
const findCheckbox = (name) => find(`[name=${name}]`)

/** The visible model, { name, mesh, picture, center, unit, low, high }; `drawnMesh` is its mesh, subdivided or not. */
let model
let drawnMesh
/** { name, compiled } */
let warp
let view, camera
let isPlaying = false
let needsFrame = true

const nextFrame = () => new Promise(requestAnimationFrame)
const alert = find('[role=alert]')
/** Shows an error without the name of the function at the start of its message, since visitors of this page write no code. */
const showError = (error) =>
  (alert.textContent = (error?.message ?? '').replace(/^\w+: (.)/, (_, first) =>
    first.toUpperCase(),
  ))
const redraw = () => (needsFrame = true)
// Formats of numbers.
const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 })
const short = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 })
const rough = new Intl.NumberFormat('en', { maximumSignificantDigits: 2 })
const trianglesOf = ({ indices, positions }) => (indices?.length ?? positions.length / 3) / 3

/** Tasks run one after the other. Each shows a status message. If a task throws, its error is shown, and the next task runs. */
let tasks = Promise.resolve()
let pending = 0
function enqueue(message, task) {
  countTasks(1)
  tasks = tasks.then(async () => {
    showError()
    status.textContent = message
    await nextFrame()
    await nextFrame()
    try {
      await task()
    } catch (error) {
      showError(error)
    }
    status.textContent = ''
    redraw()
    countTasks(-1)
  })
  return tasks
}

function countTasks(change) {
  pending += change
  find('main').ariaBusy = String(pending > 0)
}

/** Returns only the uniforms that the warp reads, since it rejects others. */
function uniforms({ compiled } = warp, { center, unit } = model) {
  const all = { center, unit, amount: Number(amount.value), time: Number(time.value) }
  return Object.fromEntries(compiled.uniforms.map(({ name }) => [name, all[name]]))
}

function boxOf({ positions }) {
  const low = [Infinity, Infinity, Infinity]
  const high = low.map((value) => -value)
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i])
    high[i % 3] = Math.max(high[i % 3], positions[i])
  }
  return { low, high }
}

/** Shows a model; if that fails, the previous one stays. */
function showModel({ name, mesh, picture }) {
  const { low, high } = boxOf(mesh)
  const center = low.map((value, i) => (value + high[i]) / 2)
  const unit = Math.max(...high.map((value, i) => value - low[i])) / 2 || 1
  const next = { name, mesh, picture, center, unit, low, high }
  view.show(mesh, picture)
  model = next
  drawnMesh = mesh
  find('.name').textContent = name
  find('.warnings').replaceChildren(
    ...(mesh.warnings ?? []).map((textContent) => make('li', { textContent })),
  )
  if (!warp) return
  showReadOuts()
  if (findCheckbox('subdivide').checked) refine()
}

/** Updates the drawn mesh: subdivided where the warp needs it, or as it was loaded. */
function refine() {
  let next = model.mesh
  if (findCheckbox('subdivide').checked)
    next = subdivide(model.mesh, {
      warp: warp.compiled,
      uniforms: uniforms(),
      tolerance: 2 * model.unit * 10 ** Number(tolerance.value),
      maxTriangles: Math.max(MAX_TRIANGLES, trianglesOf(model.mesh)),
    })
  if (next === drawnMesh) return
  view.show(next, model.picture)
  drawnMesh = next
  // The subdivision warns if it stopped at the max number of triangles.
  if (next !== model.mesh && next.warnings) showError({ message: next.warnings.join(' ') })
  showReadOuts()
}

const refineAgain = () =>
  findCheckbox('subdivide').checked || drawnMesh !== model?.mesh
    ? enqueue('Subdividing…', () => model && refine())
    : undefined

/** Updates the read-outs beside the picture. */
function showReadOuts() {
  const [original, subdivided] = [model.mesh, drawnMesh].map((mesh) =>
    whole.format(trianglesOf(mesh)),
  )
  find('.triangles').textContent =
    drawnMesh === model.mesh ? original : `${original} → ${subdivided}`
  countFolded()
}

/** The time of the last count of folded vertices, and its duration. */
let lastCount = { at: -Infinity, took: 0 }

function countFolded() {
  try {
    showCounts()
  } catch (error) {
    showError(error)
  }
}

function showCounts() {
  const start = performance.now()
  const { positions, normals, uvs, colors } = drawnMesh
  const { count } = warp.compiled.foldover(
    { positions, normals, uvs, colors },
    { uniforms: uniforms() },
  )
  const folded = find('.folded')
  folded.textContent = `${whole.format(count)} of ${whole.format(positions.length / 3)}`
  folded.classList.toggle('some', count > 0)
  const { min, max } = computeBounds()
  const lengths = max.map((value, i) => value - min[i])
  find('.size').textContent = lengths.every(Number.isFinite)
    ? `${lengths.map((side) => short.format(side)).join(' × ')}`
    : 'without bounds'
  lastCount = { at: performance.now(), took: performance.now() - start }
}

const computeBounds = () =>
  warp.compiled.bounds({ min: model.low, max: model.high }, { uniforms: uniforms() })

const chosenValue = (name) => find(`[name=${name}]:checked`).value

function chooseWarp() {
  return enqueue('Compiling…', () => {
    const chosen = warps.find(({ name }) => name === chosenValue('warp'))
    const compiled = compileWarp(fitWarp(chosen, chosenValue('side')), { target: 'glsl300' })
    view.use(compiled)
    warp = { name: chosen.name, compiled }
    if (!model) return
    if (findCheckbox('subdivide').checked) refine()
    else showReadOuts()
  })
}

const chooseFiles = (files) =>
  files.length &&
  enqueue('Reading the model…', async () => {
    const loaded = await loadFiles([...files])
    showModel(loaded)
  })

const chooseSample = (name) =>
  enqueue('Making the model…', () => showModel({ name, mesh: samples[name]() }))

const download = () =>
  enqueue('Writing the file…', () => {
    const bytes = exportGLB(bakeWarp(drawnMesh, warp.compiled, { uniforms: uniforms() }))
    const href = URL.createObjectURL(new Blob([bytes], { type: 'model/gltf-binary' }))
    make('a', { href, download: `${model.name}-${warp.name.toLowerCase()}.glb` }).click()
    setTimeout(() => URL.revokeObjectURL(href), 60_000)
  })

function draw() {
  const box = findCheckbox('box').checked && computeBounds()
  const isFinite = box && [...box.min, ...box.max].every(Number.isFinite)
  view.draw(uniforms(), camera.view(model, view.canvas.clientWidth / view.canvas.clientHeight), {
    normals: findCheckbox('normals').checked,
    wires: findCheckbox('wires').checked,
    box: isFinite && box,
  })
}

async function run() {
  for (let before = performance.now(); ;) {
    const now = await nextFrame()
    if (isPlaying) {
      time.value = (Number(time.value) + (2 * Math.PI * (now - before)) / CYCLE) % (2 * Math.PI)
      redraw()
    }
    before = now
    if (!needsFrame || !model || !warp) continue
    needsFrame = false
    try {
      draw()
      // Counting takes at most 10% of the time, so a large model is counted less often.
      if (now - lastCount.at > Math.max(COUNTING_INTERVAL, 10 * lastCount.took)) countFolded()
    } catch (error) {
      showError(error)
    }
  }
}

function setPlaying(value) {
  isPlaying = value
  const button = find('.play')
  button.ariaPressed = String(value)
  button.textContent = value ? 'Pause' : 'Play'
  if (!value && warp && model) countFolded()
}

function showTolerance() {
  find('.finer output').textContent = `${rough.format(100 * 10 ** Number(tolerance.value))}%`
}

function addChoices(place, name, values, first) {
  for (const value of values) {
    const input = make('input', { type: 'radio', name, value, checked: value === first })
    input.addEventListener('change', chooseWarp)
    find(place).append(make('label', {}, input, value))
  }
}

function listen() {
  const names = warps.map(({ name }) => name)
  addChoices('.warps', 'warp', names, 'Twist')
  addChoices('.axes', 'side', sides, 'y')
  for (const name of Object.keys(samples)) {
    const button = make('button', { type: 'button', className: 'button', textContent: name })
    button.addEventListener('click', () => chooseSample(name))
    find('.samples').append(button)
  }
  find('.choose input').addEventListener('change', ({ target }) => {
    chooseFiles([...target.files])
    // Reset, so that choosing the same file again fires another change event.
    target.value = ''
  })
  find('form').addEventListener('submit', (event) => event.preventDefault())
  find('.play').addEventListener('click', () => setPlaying(!isPlaying))
  find('.download').addEventListener('click', download)

  for (const input of [amount, time]) {
    input.addEventListener('input', () => {
      if (input === time) setPlaying(false)
      redraw()
    })
    input.addEventListener('change', () => {
      if (model && warp) countFolded()
      void refineAgain()
    })
  }
  for (const name of ['normals', 'wires', 'box'])
    findCheckbox(name).addEventListener('change', redraw)
  findCheckbox('subdivide').addEventListener('change', refineAgain)
  tolerance.addEventListener('input', showTolerance)
  tolerance.addEventListener('change', refineAgain)
  showTolerance()

  // The number of elements that the dragged files have entered and not left: the events also occur for elements of the page.
  let depth = 0
  const drag = (change) => (event) => {
    if (!event.dataTransfer?.types.includes('Files')) return
    event.preventDefault()
    depth = change === 0 ? 0 : depth + change
    document.body.classList.toggle('dragging', depth > 0)
  }
  addEventListener('dragenter', drag(1))
  addEventListener('dragleave', drag(-1))
  addEventListener('dragover', (event) => event.preventDefault())
  addEventListener('drop', (event) => {
    drag(0)(event)
    event.preventDefault()
    chooseFiles([...(event.dataTransfer?.files ?? [])])
  })
  addEventListener('resize', redraw)
}

try {
  view = new View(find('canvas'))
  camera = makeCamera(view.canvas, redraw)
  listen()
  find('canvas').addEventListener('webglcontextlost', () =>
    showError(new Error('The GPU lost this picture: reload the page.')),
  )
  void chooseWarp()
  void chooseSample('bunny').then(() =>
    setPlaying(!matchMedia('(prefers-reduced-motion: reduce)').matches),
  )
  void run()
} catch (error) {
  const still = { src: '../posters/bunny.webp', alt: 'A bunny at rest, twisted and flattened' }
  find('.hand').replaceWith(make('img', still))
  showError(error)
}

keepForOffline(new URL('../', location.href))
