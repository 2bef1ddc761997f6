/** The numbers beside the picture. */
import { make } from './dom.js'
import { degrees, short, whole } from './figures.js'

/** What is shown → [its label, how a value is written, its unit]. */
const outputs = {
  rate: ['frames a second', short],
  frame: ['GPU-complete frame', short, ' ms'],
  first: ['compile + first draw', short, ' ms'],
  generation: ['generation of the text', short, ' ms'],
  error: ['largest normal error', degrees, '°'],
  median: ['median normal error', degrees, '°'],
  vertices: ['vertices', whole],
  triangles: ['triangles', whole],
  nodes: ['nodes of the warp', whole],
  clock: ['clock of the frame', String],
}

/** @returns show(values): writes those that are given, by the names above, and leaves the others */
export function makeReadOuts(list) {
  const cells = {}
  for (const [name, [label]] of Object.entries(outputs)) {
    cells[name] = make('dd', { className: name })
    list.append(make('div', {}, make('dt', { textContent: label }), cells[name]))
  }
  return function show(values) {
    for (const [name, value] of Object.entries(values)) {
      const [, write, unit = ''] = outputs[name]
      const isThere = value !== undefined && !Number.isNaN(value)
      cells[name].replaceChildren(write(value), make('span', { textContent: isThere ? unit : '' }))
    }
  }
}
