/** What the plots have in common: their colours, their letters, and the ticks of a logarithmic scale. */
import * as Plot from '@observablehq/plot'
import { methodNames, notes } from './method-notes.js'

const FONT = 13
/** From one line of text to the next, in pixels. */
export const LINE = 16

export const common = {
  style: { background: 'none', fontFamily: 'inherit', fontSize: `${FONT}px`, overflow: 'visible' },
  color: {
    type: 'categorical',
    domain: methodNames,
    range: methodNames.map((name) => notes[name].color),
  },
}

/** In pixels, by the page's font. */
export function widthOf(text) {
  const context = document.createElement('canvas').getContext('2d')
  context.font = `${FONT}px ${getComputedStyle(document.body).fontFamily}`
  return context.measureText(text).width
}

export const least = (points, key) => Math.min(...points.map((point) => point[key]))
export const most = (points, key) => Math.max(...points.map((point) => point[key]))

/** 1, 2 and 5 of each power of ten, or the powers alone where there are many. */
export function decimalTicks([low, high]) {
  const steps = high / low > 2000 ? [1] : [1, 2, 5]
  const powers = Array.from({ length: 16 }, (_, i) => 10 ** (i - 8))
  return powers
    .flatMap((power) => steps.map((step) => step * power))
    .filter((tick) => tick >= low && tick <= high)
}

/** An axis with exactly these ticks: on a logarithmic scale, Plot would leave the numbers of some away. */
export const axisX = (ticks, write, label) => Plot.axisX(ticks, { text: write, label, tickSize: 4 })
export const axisY = (ticks, write, label) => [
  Plot.gridY(ticks),
  Plot.axisY(ticks, { text: write, label, tickSize: 0 }),
]
