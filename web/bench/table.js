/** Shows records as a table: a group of lines per row of the benchmark, a line per method. */
import { make } from './dom.js'
import { formatDegrees, formatExact, formatInteger, formatRatio, formatShort } from './figures.js'
import { notes } from './method-notes.js'
import { rowsOf } from './series.js'

/** Groups of columns: [heading, ...columns], where a column is [heading, key in the record, formatter]. */
const groups = [
  [
    'frame, ms',
    ['median', 'frameMs', formatShort],
    ['half from', 'frameLowMs', formatShort],
    ['to', 'frameHighMs', formatShort],
  ],
  [
    'frame, relative to',
    ['positions', 'toPositions', formatRatio],
    ['warpjet', 'toWarpjet', formatRatio],
  ],
  [
    'frames a second',
    ['uncapped', 'uncappedFps', formatShort],
    ['with vsync', 'cappedFps', formatShort],
  ],
  [
    'compile + first draw',
    ['ms', 'firstMs', formatShort],
    ['to positions', 'firstToPositions', formatRatio],
    ['to by hand', 'firstToByHand', formatRatio],
  ],
  [
    'characters',
    ['count', 'characters', formatInteger],
    ['to by hand', 'charactersToByHand', formatRatio],
  ],
  ['generation', ['ms', 'generationMs', formatExact]],
  [
    'normal error, °',
    ['largest', 'errorDegrees', formatDegrees],
    ['median', 'errorMedianDegrees', formatDegrees],
    ['with h', 'h', formatExact],
  ],
]

export function makeTable(records) {
  // Leave out columns that were not measured for any record.
  const measuredGroups = groups
    .map(([heading, ...columns]) => [
      heading,
      ...columns.filter(([, name]) => records.some((record) => record[name] !== undefined)),
    ])
    .filter(({ length }) => length > 1)
  const columns = measuredGroups.flatMap(([, ...columns]) =>
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
      ...measuredGroups.map(([heading, ...columns]) =>
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
    vertices !== undefined && `${formatInteger(vertices)} vertices`,
    nodes !== undefined && `${formatInteger(nodes)} nodes`,
    Number.isFinite(jsHeapMb) && `max ${formatInteger(jsHeapMb)} MB of JavaScript`,
    Number.isFinite(wasmHeapMb) && `max ${formatInteger(wasmHeapMb)} MB of WebAssembly`,
  ]
    .filter(Boolean)
    .join(' · ')
