/** Shows the numbers beside the picture. */
import { make } from './dom.js'
import { degrees, short, whole } from './figures.js'

/** Maps a value's name to [label, formatter, unit]. */
const outputs = {
  rate: ['frames a second', short],
  frame: ['GPU-complete frame', short, ' ms'],
  first: ['compile + first draw', short, ' ms'],
  generation: ['generation of the source', short, ' ms'],
  error: ['largest normal error', degrees, '°'],
  median: ['median normal error', degrees, '°'],
  vertices: ['vertices', whole],
  triangles: ['triangles', whole],
  nodes: ['nodes of the warp', whole],
  clock: ['clock of the frame', String],
}

/** @returns show(values): updates the read-outs that `values` names, and leaves the others unchanged */
export function makeReadOuts(list) {
  const cells = {}
  for (const [name, [label]] of Object.entries(outputs)) {
    cells[name] = make('dd', { className: name })
    list.append(make('div', {}, make('dt', { textContent: label }), cells[name]))
  }
  return function show(values) {
    for (const [name, value] of Object.entries(values)) {
      const [, write, unit = ''] = outputs[name]
      const isKnown = value !== undefined && !Number.isNaN(value)
      cells[name].replaceChildren(write(value), make('span', { textContent: isKnown ? unit : '' }))
    }
  }
}
