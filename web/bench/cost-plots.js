/** The plots of frame cost. Each takes points of series.js and a width in pixels, and returns an element. */
import * as Plot from '@observablehq/plot'
import { make } from './dom.js'
import { formatExact, formatInteger, formatShort } from './figures.js'
import { spread } from './labels.js'
import { methodNames, notes } from './method-notes.js'
import { LINE, axisX, axisY, common, decimalTicks, maxOf, minOf, widthOf } from './plot-parts.js'

const HEIGHT = 380
/** The distance in pixels from the end of a line to its name. */
const LEADER = 24
/** The width in pixels below which names beside the lines would leave too little space for the lines. */
const NARROW = 480

const endsOf = (points) =>
  methodNames.map((name) => points.filter(({ method }) => method === name).at(-1)).filter(Boolean)

/** Puts each name beside the end of its line with a thin leader, and moves names apart if they would overlap. */
function labelEnds(points, x, y, [top, bottom]) {
  const ends = endsOf(points)
  const [scaleX, scaleY] = [Plot.scale({ x }), Plot.scale({ y })]
  const places = spread(
    ends.map((end) => scaleY.apply(end.y)),
    LINE,
    [top, bottom],
  )
  const labels = ends.map((end, i) => ({
    ...end,
    labelX: scaleX.invert(x.range[1] + LEADER),
    labelY: scaleY.invert(places[i]),
  }))
  const [x1, y1, x2, y2] = ['x', 'y', 'labelX', 'labelY']
  return [
    Plot.link(labels, { x1, y1, x2, y2, stroke: 'method', strokeOpacity: 0.5 }),
    Plot.text(labels, {
      x: 'labelX',
      y: 'labelY',
      dx: 5,
      text: 'method',
      fill: 'method',
      textAnchor: 'start',
    }),
  ]
}

/** Lists the names below the plot, ordered by the ends of their lines from top to bottom. */
const makeLegend = (points) =>
  make(
    'ul',
    { className: 'legend' },
    ...endsOf(points)
      .sort((a, b) => b.y - a.y)
      .map(({ method }) =>
        make('li', { textContent: method, style: `--color: ${notes[method].color}` }),
      ),
  )

/**
 * @param x `{ type, label, write }`: type and label of the scale, and a formatter of its numbers
 * @param y `{ type, domain, ticks, write }`
 * @param about formats a point's x for its tooltip
 */
function makeCostPlot(points, { width, x, y, about }) {
  const isNarrow = width < NARROW
  const widest = Math.max(...points.map(({ method }) => widthOf(method)))
  const labelSpace = isNarrow ? 20 : LEADER + 12 + widest
  const [left, right, top, bottom] = [46, labelSpace, 30, HEIGHT - 42]
  const [low, high] = [minOf(points, 'x'), maxOf(points, 'x')]
  const scaleX = {
    type: x.type,
    // A single x is drawn at the right, at the end of the range.
    domain: [low < high ? low : high / 2, high],
    range: [left + 12, width - right],
  }
  const scaleY = { type: y.type, domain: y.domain, range: [bottom, top] }
  // Draw warpjet last, on top of the others.
  const drawn = [...points].sort((a, b) => (a.method === 'warpjet') - (b.method === 'warpjet'))
  const bars = drawn.filter(({ low, high }) => Number.isFinite(low) && Number.isFinite(high))
  const place = { x: 'x', y: 'y' }
  const plot = Plot.plot({
    ...common,
    width,
    height: HEIGHT,
    marginLeft: left,
    marginRight: right - 14,
    marginTop: top,
    marginBottom: HEIGHT - bottom,
    x: scaleX,
    y: scaleY,
    marks: [
      axisX([...new Set(points.map((point) => point.x))], x.write, x.label),
      ...axisY(y.ticks, y.write, '↑ milliseconds a frame'),
      Plot.ruleX(bars, {
        x: 'x',
        y1: 'low',
        y2: 'high',
        stroke: 'method',
        strokeOpacity: 0.35,
        strokeWidth: 5,
      }),
      Plot.line(drawn, {
        ...place,
        stroke: 'method',
        strokeWidth: ({ method }) => (method === 'warpjet' ? 3 : 1.75),
      }),
      Plot.dot(drawn, {
        ...place,
        fill: 'method',
        stroke: 'var(--back)',
        r: 4.5,
        strokeWidth: 1,
      }),
      ...(isNarrow ? [] : labelEnds(points, scaleX, scaleY, [top, bottom])),
      Plot.tip(
        points,
        Plot.pointer({
          ...place,
          title: (point) => `${point.method}\n${about(point)}: ${formatShort(point.y)} ms`,
        }),
      ),
    ],
  })
  return isNarrow ? make('div', {}, plot, makeLegend(points)) : plot
}

/** Returns multiples of 1, 2 or 5 times a power of ten: four to nine ticks up to `high`. */
function linearTicks(high) {
  const power = 10 ** Math.floor(Math.log10(high))
  const step = [0.2, 0.5, 1].map((part) => part * power).find((step) => high / step <= 9) ?? power
  return Array.from({ length: Math.floor(high / step) + 1 }, (_, i) => i * step)
}

/** @param points of `costAgainstNodes` */
export function plotAgainstNodes(points, width) {
  const high = 1.05 * maxOf(points, 'y')
  return makeCostPlot(points, {
    width,
    x: { type: 'linear', label: 'nodes of the warp →', write: formatInteger },
    y: { type: 'linear', domain: [0, high], ticks: linearTicks(high), write: formatExact },
    about: ({ x }) => `${formatInteger(x)} nodes`,
  })
}

const formatThousands = (value) =>
  value < 1e6 ? `${Math.round(value / 1000)}k` : `${+(value / 1e6).toFixed(1)}M`

/** @param points of `costAgainstVertices` */
export function plotAgainstVertices(points, width) {
  const domain = [minOf(points, 'y') / 1.3, maxOf(points, 'y') * 1.3]
  return makeCostPlot(points, {
    width,
    x: { type: 'log', label: 'vertices, logarithmic →', write: formatThousands },
    y: { type: 'log', domain, ticks: decimalTicks(domain), write: formatExact },
    about: ({ x }) => `${formatInteger(x)} vertices`,
  })
}
