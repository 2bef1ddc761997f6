/** Shows the numbers beside the picture. */
import { make } from './dom.js'
import { formatDegrees, formatInteger, formatShort } from './figures.js'

/** Maps a value's name to [label, formatter, unit]. */
const outputs = {
  rate: ['frames a second', formatShort],
  frame: ['GPU-complete frame', formatShort, ' ms'],
  first: ['compile + first draw', formatShort, ' ms'],
  generation: ['generation of the source', formatShort, ' ms'],
  error: ['largest normal error', formatDegrees, '°'],
  median: ['median normal error', formatDegrees, '°'],
  vertices: ['vertices', formatInteger],
  triangles: ['triangles', formatInteger],
  nodes: ['nodes of the warp', formatInteger],
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
