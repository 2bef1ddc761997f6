/** Shows records as a table: a group of lines per row of the benchmark, a line per method. */
import { make } from './dom.js'
import { degrees, plain, short, times, whole } from './figures.js'
import { notes } from './method-notes.js'
import { rowsOf } from './series.js'

/** Groups of columns: [heading, ...columns], where a column is [heading, key in the record, formatter]. */
const groups = [
  [
    'frame, ms',
    ['median', 'frameMs', short],
    ['half from', 'frameLowMs', short],
    ['to', 'frameHighMs', short],
  ],
  ['frame, relative to', ['positions', 'toPositions', times], ['warpjet', 'toWarpjet', times]],
  ['frames a second', ['uncapped', 'uncappedFps', short], ['with vsync', 'cappedFps', short]],
  [
    'compile + first draw',
    ['ms', 'firstMs', short],
    ['to positions', 'firstToPositions', times],
    ['to by hand', 'firstToByHand', times],
  ],
  ['characters', ['count', 'characters', whole], ['to by hand', 'charactersToByHand', times]],
  ['generation', ['ms', 'generationMs', plain]],
  [
    'normal error, °',
    ['largest', 'errorDegrees', degrees],
    ['median', 'errorMedianDegrees', degrees],
    ['with h', 'h', plain],
  ],
]

export function makeTable(records) {
  // Leave out columns that were not measured for any record.
  const shown = groups
    .map(([heading, ...columns]) => [
      heading,
      ...columns.filter(([, name]) => records.some((record) => record[name] !== undefined)),
    ])
    .filter(({ length }) => length > 1)
  const columns = shown.flatMap(([, ...columns]) =>
    columns.map(([heading, name, write], i) => ({ heading, name, write, isFirst: i === 0 })),
  )
  const className = ({ isFirst }) => (isFirst ? 'first' : '')

  const head = make(
    'thead',
    {},
    make(
      'tr',
      {},
      make('th', { rowSpan: 2, scope: 'col', textContent: 'method' }),
      ...shown.map(([heading, ...columns]) =>
        make('th', {
          colSpan: columns.length,
          scope: 'colgroup',
          textContent: heading,
          className: 'first',
        }),
      ),
    ),
    make(
      'tr',
      {},
      ...columns.map((column) =>
        make('th', { scope: 'col', textContent: column.heading, className: className(column) }),
      ),
    ),
  )

  const line = (record) =>
    make(
      'tr',
      { className: record.method === 'warpjet' ? 'ours' : '' },
      make('th', {
        scope: 'row',
        textContent: record.method,
        style: `--color: ${notes[record.method]?.color ?? 'transparent'}`,
      }),
      ...columns.map((column) =>
        make('td', {
          textContent: column.write(record[column.name]),
          className: className(column),
        }),
      ),
    )
  const bodies = rowsOf(records).map((row) => {
    const lines = records.filter((record) => record.row === row)
    const title = make(
      'th',
      { colSpan: columns.length + 1, scope: 'rowgroup' },
      make('div', {}, make('b', { textContent: row }), ` ${describeRow(lines[0])}`),
    )
    return make('tbody', {}, make('tr', { className: 'title' }, title), ...lines.map(line))
  })
  return make('table', {}, head, ...bodies)
}

const describeRow = ({ vertices, nodes, jsHeapMb, wasmHeapMb }) =>
  [
    vertices !== undefined && `${whole(vertices)} vertices`,
    nodes !== undefined && `${whole(nodes)} nodes`,
    Number.isFinite(jsHeapMb) && `max ${whole(jsHeapMb)} MB of JavaScript`,
    Number.isFinite(wasmHeapMb) && `max ${whole(wasmHeapMb)} MB of WebAssembly`,
  ]
    .filter(Boolean)
    .join(' · ')
