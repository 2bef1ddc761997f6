/** The tab that compares a warp's normals with finite differences and shows where the surface is inside out. */
import { make } from '../bench/dom.js'
import { columns, normalErrors, rows, spherePoints } from './sphere.js'

const radii = {
  1: 'radius 1, like p5’s sphere() in its own space',
  100: 'radius 100, like the gallery’s models',
  150: 'radius 150, in pixels',
}
const whole = new Intl.NumberFormat('en')
const degrees = new Intl.NumberFormat('en', { maximumSignificantDigits: 2 })
/** The error, in degrees, from which the map has its reddest color. */
const MAX_ERROR = 1

/**
 * @param uniforms returns the current values of all inputs that a warp may read, by name
 * @param frame the frame with the sketch, which evaluates the sketch's warps
 * @returns { title, fill(place, sketch) } for output.js
 */
export function makeChecks(uniforms, frame) {
  let radius
  const fill = async (place, { warps }) => {
    const checked = warps
      .map((warp, index) => ({ ...warp, index }))
      .filter(({ canEvaluate }) => canEvaluate)
    if (!checked.length)
      return place.replaceChildren(
        make('p', {
          className: 'none',
          textContent: 'The sketch has made no warp that can be checked.',
        }),
      )
    const select = make(
      'select',
      {},
      ...Object.entries(radii).map(([value, textContent]) =>
        make('option', { value, textContent }),
      ),
    )
    select.value = radius ?? checked[0].radius ?? 1
    select.addEventListener('change', () => {
      radius = select.value
      void fill(place, { warps })
    })
    const label = make('label', { className: 'chooser' }, 'On a sphere of ', select)
    const points = spherePoints(Number(select.value))
    place.ariaBusy = 'true'
    const results = []
    for (const warp of checked) results.push(await check(warp, points, uniforms(), frame))
    place.replaceChildren(label, ...results)
    place.ariaBusy = 'false'
  }
  return { title: 'Checks', fill }
}

async function check({ index, maker, reads, surfaceVariation, declared = [] }, points, all, frame) {
  const title = make('h2', { textContent: maker })
  try {
    // Uniforms of the option `uniforms` have their values in the frame.
    const inputNames = reads.filter((name) => !declared.includes(name))
    const unknown = inputNames.find((name) => !(name in all))
    if (unknown)
      throw new Error(
        `The sketch sets “${unknown}” only when it draws, so its value is unknown here: pass it to createWarp, as in { uniforms: { ${unknown}: 1 } }.`,
      )
    const uniforms = Object.fromEntries(inputNames.map((name) => [name, all[name]]))
    const { positions, normals, uvs, colors } = points
    // Without surface variation the shader treats normal and uv as constant, so the check does, too.
    const mesh = surfaceVariation === false ? { positions, normals, uvs, colors } : points
    const errors = normalErrors(await frame.evaluate(index, mesh, { uniforms }))
    const mask = await frame.foldedOf(index, mesh, { uniforms })
    const folded = errors.map((_, i) => mask[5 * i])
    return make('div', { className: 'check' }, title, ...showErrors(errors, folded))
  } catch (error) {
    return make(
      'div',
      { className: 'check' },
      title,
      make('p', { className: 'none', textContent: error.message }),
    )
  }
}

function showErrors(errors, folded) {
  const sorted = [...errors].filter((error) => !Number.isNaN(error)).sort((a, b) => a - b)
  const quantile = (fraction) =>
    `${degrees.format((180 / Math.PI) * (sorted[Math.floor(fraction * (sorted.length - 1))] ?? 0))}°`
  const count = folded.reduce((sum, each) => sum + each, 0)
  const figures = {
    'Max error of a normal': quantile(1),
    '90th percentile': quantile(0.9),
    'Turned inside out': `${whole.format(count)} of ${whole.format(errors.length)} points`,
  }
  const list = make(
    'dl',
    { className: 'read-outs' },
    ...Object.entries(figures).map(([term, textContent]) =>
      make('div', {}, make('dt', { textContent: term }), make('dd', { textContent })),
    ),
  )
  return [
    list,
    drawMap(errors, folded),
    make('p', {
      className: 'none',
      textContent: `The sphere unrolled. Red shows the angle between a normal and that of finite differences, ${MAX_ERROR}° or more at the reddest; violet is inside out.`,
    }),
  ]
}

const mix = (a, b, amount) => a.map((value, i) => value + (b[i] - value) * amount)

function drawMap(errors, folded) {
  const canvas = make('canvas', { className: 'map', width: columns, height: rows })
  canvas.role = 'img'
  canvas.ariaLabel = 'Map of the errors and of the points inside out'
  const context = canvas.getContext('2d')
  const image = context.createImageData(columns, rows)
  for (const [i, error] of errors.entries()) {
    const amount = Math.min(1, ((180 / Math.PI) * error) / MAX_ERROR || 0)
    const color = folded[i] ? [169, 156, 255] : mix([45, 51, 71], [255, 90, 60], amount)
    image.data.set([...color, 255], 4 * i)
  }
  context.putImageData(image, 0, 0)
  return canvas
}
