/** Shared by the plots: colours, fonts, and the ticks of a logarithmic scale. */
import * as Plot from '@observablehq/plot'
import { methodNames, notes } from './method-notes.js'

const FONT = 13
/** The line height in pixels. */
export const LINE = 16

export const common = {
  style: { background: 'none', fontFamily: 'inherit', fontSize: `${FONT}px`, overflow: 'visible' },
  color: {
    type: 'categorical',
    domain: methodNames,
    range: methodNames.map((name) => notes[name].color),
  },
}

/** Measures the width of a text in pixels, in the page's font. */
export function widthOf(text) {
  const context = document.createElement('canvas').getContext('2d')
  context.font = `${FONT}px ${getComputedStyle(document.body).fontFamily}`
  return context.measureText(text).width
}

export const minOf = (points, key) => Math.min(...points.map((point) => point[key]))
export const maxOf = (points, key) => Math.max(...points.map((point) => point[key]))

/** Returns 1, 2 and 5 times each power of ten in the range, or only the powers if there are many. */
export function decimalTicks([low, high]) {
  const steps = high / low > 2000 ? [1] : [1, 2, 5]
  const powers = Array.from({ length: 16 }, (_, i) => 10 ** (i - 8))
  return powers
    .flatMap((power) => steps.map((step) => step * power))
    .filter((tick) => tick >= low && tick <= high)
}

/** An axis with exactly these ticks: on a logarithmic scale, Plot would omit the numbers of some. */
export const axisX = (ticks, write, label) => Plot.axisX(ticks, { text: write, label, tickSize: 4 })
export const axisY = (ticks, write, label) => [
  Plot.gridY(ticks),
  Plot.axisY(ticks, { text: write, label, tickSize: 0 }),
]
