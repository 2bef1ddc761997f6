/** The plot of normal error against cost: takes points of series.js and a width in pixels, and returns an SVG element. */
import * as Plot from '@observablehq/plot'
import { MIN_ERROR, formatDegrees, formatExact, formatRatio } from './figures.js'
import { placeBeside } from './labels.js'
import { LINE, axisY, common, decimalTicks, maxOf, minOf, widthOf } from './plot-parts.js'

const HEIGHT = 460
/** One scale for all rows, so that rows can be compared. */
const errors = { type: 'log', domain: [MIN_ERROR / 2, 360] }
const ticks = decimalTicks([MIN_ERROR, 180])

const write = (value) =>
  `${value > MIN_ERROR ? '' : '≤ '}${value.toLocaleString('en', { maximumFractionDigits: 5 })}°`

/** Adds `labelX`, `labelY` and `isFar` to the points: the positions of their names, in units of the scales. */
function placeLabels(points, x, y) {
  const [scaleX, scaleY] = [Plot.scale({ x }), Plot.scale({ y })]
  const places = placeBeside(
    points.map((point) => ({
      x: scaleX.apply(point.x),
      y: scaleY.apply(point.y),
      width: widthOf(point.method) + 8,
      height: LINE,
    })),
    { left: x.range[0] + 4, right: x.range[1], top: y.range[1], bottom: y.range[0] - 2 },
  )
  return points.map((point, i) => ({
    ...point,
    isFar: places[i].isFar,
    labelX: scaleX.invert(places[i].x),
    labelY: scaleY.invert(places[i].y),
  }))
}

/** @param points of `errorAgainstCost` */
export function plotErrorAgainstCost(points, width) {
  const [left, right, top, bottom] = [90, 16, 34, HEIGHT - 46]
  const [low, high] = [Math.min(0.95, minOf(points, 'x')), Math.max(1.25, maxOf(points, 'x'))]
  const margin = 0.08 * (high - low)
  const x = {
    type: 'linear',
    domain: [low - margin, high + 2 * margin],
    range: [left, width - right],
  }
  const y = { ...errors, range: [bottom, top] }
  // warpjet goes first, so that its name is right beside its dot.
  const isOurs = ({ method }) => method === 'warpjet'
  const labels = placeLabels(
    [...points].sort((a, b) => isOurs(b) - isOurs(a)),
    x,
    y,
  )
  const [x1, y1, x2, y2] = ['x', 'y', 'labelX', 'labelY']
  return Plot.plot({
    ...common,
    width,
    height: HEIGHT,
    marginLeft: left,
    marginRight: right,
    marginTop: top,
    marginBottom: HEIGHT - bottom,
    x: {
      ...x,
      label: 'frame, relative to positions only →',
      tickSize: 4,
      ticks: Math.min(8, width / 80),
      tickFormat: formatExact,
    },
    y,
    r: { type: 'identity' },
    marks: [
      ...axisY(ticks, write, '↑ largest error of a normal'),
      Plot.ruleX([1], { stroke: 'var(--line)' }),
      Plot.link(
        labels.filter(({ isFar }) => isFar),
        { x1, y1, x2, y2, stroke: 'method', strokeOpacity: 0.4 },
      ),
      // Our dot is drawn first and larger: if another dot coincides with it, a rim stays visible.
      Plot.dot(labels, {
        x: 'x',
        y: 'y',
        fill: 'method',
        stroke: 'var(--back)',
        r: (point) => (isOurs(point) ? 8 : 5.5),
      }),
      Plot.text(labels, {
        x: 'labelX',
        y: 'labelY',
        text: 'method',
        fill: 'method',
        stroke: 'var(--back)',
        strokeWidth: 4,
      }),
      Plot.tip(
        labels,
        Plot.pointer({
          x: 'x',
          y: 'y',
          title: ({ method, x, error }) =>
            `${method}\n${formatRatio(x)} × positions only\n${formatDegrees(error)}°`,
        }),
      ),
    ],
  })
}
