/** The page of results.csv: shows one run of the benchmark as plots and as a table. */
import text from './results.csv?raw'
import './style.css'
import { keepForOffline } from '../offline.js'
import { plotAgainstNodes, plotAgainstVertices } from './cost-plots.js'
import { make } from './dom.js'
import { plotErrorAgainstCost } from './error-plot.js'
import { formatShort } from './figures.js'
import { listMethods } from './method-list.js'
import { deviceOf, parseRecords, runsOf } from './records.js'
import { costAgainstNodes, costAgainstVertices, errorAgainstCost, rowsOf } from './series.js'
import { makeTable } from './table.js'

/** The row that the last plot shows first: its methods are far apart. */
const DEFAULT_ROW = '3 chains of 24 nested sines'

const find = (selector) => document.querySelector(selector)

const runs = runsOf(parseRecords(text))
let run = runs[0]
let row

/**
 * The plots: [selector, function that draws, its points]. They are redrawn whenever the width changes, so that letters keep the page's font
 * size.
 */
const plots = [
  ['.nodes', plotAgainstNodes, () => costAgainstNodes(run.records)],
  ['.vertices', plotAgainstVertices, () => costAgainstVertices(run.records)],
  ['.error', plotErrorAgainstCost, () => errorAgainstCost(run.records, row)],
]

function drawPlots() {
  for (const [selector, plot, points] of plots) {
    const place = find(`${selector} .plot`)
    const data = points()
    place.replaceChildren(
      data.length
        ? plot(data, place.clientWidth)
        : make('p', { textContent: 'This run has no figures for this plot.' }),
    )
    // Plot labels its groups but gives them no role.
    for (const group of place.querySelectorAll('g[aria-label]')) group.role = 'group'
  }
}

function showRow(name) {
  row = name
  for (const button of find('.error .bar').children)
    button.ariaPressed = String(button.textContent === name)
  drawPlots()
}

/** @param dateStyle 'long' or 'medium' */
const formatDate = (date, dateStyle) =>
  new Date(date).toLocaleString('en-GB', { dateStyle, timeStyle: 'short', timeZone: 'UTC' })

/** Describes p5's own rows, in which the warp is a part of a whole sketch. */
function describeP5(records) {
  const frameOf = (method) => records.find((record) => record.method === method)?.frameMs
  const versions = records
    .map(({ method }) => /^(p5 .*), warpjet$/.exec(method)?.[1])
    .filter((version) => version && frameOf(`${version}, no warp`) !== undefined)
    .map((version) => {
      const [warped, unwarped] = [frameOf(`${version}, warpjet`), frameOf(`${version}, no warp`)]
      return `${formatShort(warped)} ms a frame with ${version} (${formatShort(unwarped)} ms without the warp)`
    })
  return versions.length ? `A whole p5 sketch takes ${versions.join(', and ')}.` : ''
}

function showRun(date) {
  run = runs.find((run) => run.date === date)
  const { commit, chromium, renderer, sizePx, records } = run
  const clocks = [...new Set(records.map(({ clock }) => clock).filter(Boolean))].join(' and ')
  const device = deviceOf(renderer)
  find('.run p').textContent = [
    `Drawn by ${device} on ${formatDate(date, 'long')} UTC, in Chromium ${chromium}, at commit ${commit}${sizePx ? `, ${sizePx} × ${sizePx} pixels` : ''}; frames timed by ${clocks}.`,
    device === 'SwiftShader' &&
      'SwiftShader draws without a GPU: its milliseconds are long, but the ratios are still meaningful.',
    renderer !== device && `The driver reports ${renderer}.`,
  ]
    .filter(Boolean)
    .join(' ')
  const rows = rowsOf(records)
  find('.error .bar').replaceChildren(
    ...rows.map((name) => {
      const button = make('button', { type: 'button', textContent: name })
      button.addEventListener('click', () => showRow(name))
      return button
    }),
  )
  find('.wide').replaceChildren(makeTable(records))
  find('.p5-share').textContent = describeP5(records)
  showRow(rows.includes(row) ? row : rows.includes(DEFAULT_ROW) ? DEFAULT_ROW : rows[0])
}

if (run) {
  find('.results').hidden = false
  listMethods(find('.notes'))
  const select = find('select')
  select.append(
    ...runs.map(({ date, commit, renderer }) =>
      make('option', {
        value: date,
        textContent: `${formatDate(date, 'medium')} · ${commit} · ${deviceOf(renderer)}`,
      }),
    ),
  )
  select.addEventListener('change', () => showRun(select.value))
  showRun(run.date)
  let width = innerWidth
  addEventListener('resize', () => {
    if (width === innerWidth) return
    width = innerWidth
    drawPlots()
  })
} else find('.nothing').hidden = false

keepForOffline(new URL('../', location.href))
