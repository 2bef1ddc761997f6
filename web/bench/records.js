/**
 * Measurements as records, one per method of a row. Keys are the column names of results.csv in camel case (frame_ms is
 * `frameMs`). A figure that does not exist is undefined.
 */

/** The columns that contain text. The others contain numbers. */
const textColumns = ['date', 'commit', 'chromium', 'renderer', 'clock', 'row', 'method']

/** Parses CSV (RFC 4180) into arrays of fields. */
function parseFields(text) {
  const lines = [[]]
  // Match a field, quoted or not, and its terminator.
  for (const [, quoted, plain, end] of text.matchAll(
    /(?:"((?:[^"]|"")*)"|([^",\r\n]*))(,|\r?\n|$)/g,
  )) {
    lines.at(-1).push(quoted === undefined ? plain : quoted.replaceAll('""', '"'))
    if (end === '') break
    if (end !== ',') lines.push([])
  }
  return lines.filter((fields) => fields.length > 1)
}

/** Converts a column name to a record's key: frame_ms → frameMs. */
export const camelCase = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase())

const valueOf = (name, field) => {
  if (field === undefined || field === '') return undefined
  return textColumns.includes(name) ? field : Number(field)
}

/** @param csv the content of results.csv, with its header line */
export function parseRecords(csv) {
  const [header = [], ...lines] = parseFields(csv)
  const names = header.map(camelCase)
  return lines.map((fields) =>
    Object.fromEntries(names.map((name, i) => [name, valueOf(name, fields[i])])),
  )
}

/** Groups records by run, newest first → [{ date, commit, chromium, renderer, sizePx, records }]. */
export function runsOf(records) {
  const runs = new Map()
  for (const record of records) {
    const { date, commit, chromium, renderer, sizePx } = record
    if (!runs.has(date)) runs.set(date, { date, commit, chromium, renderer, sizePx, records: [] })
    runs.get(date).records.push(record)
  }
  return [...runs.values()].sort((a, b) => (a.date < b.date ? 1 : -1))
}

const MEGABYTE = 2 ** 20

/** Converts the result of `measureRow` into records. */
export const recordsOf = ({ name, nodes }, { clock, vertices, memory, results }) =>
  results.map(({ method, frame, first, generation, error, ...others }) => ({
    clock,
    row: name,
    vertices,
    nodes,
    method,
    h: error.h,
    frameMs: frame.median,
    frameLowMs: frame.low,
    frameHighMs: frame.high,
    toPositions: others.toPositions,
    toWarpjet: others.toWarpjet,
    firstMs: first.median,
    firstToPositions: others.firstToPositions,
    firstToByHand: others.firstToByHand,
    characters: others.characters,
    charactersToByHand: others.charactersToByHand,
    generationMs: generation ?? undefined,
    errorDegrees: error.largest,
    errorMedianDegrees: error.median,
    jsHeapMb: memory.heap / MEGABYTE,
    wasmHeapMb: memory.wasm / MEGABYTE,
  }))

/** Extracts the name of the graphics card, or of its software replacement, from the driver's renderer string. */
export function deviceOf(renderer = '') {
  if (/swiftshader/i.test(renderer)) return 'SwiftShader'
  const [, device = renderer] = /^ANGLE \([^,]*, (.*), [^,]*\)$/.exec(renderer) ?? []
  const [, name = device] = /^Vulkan [\d.]+ \((.*)\)$/.exec(device) ?? []
  return name.replace(/ \(0x\w+\)| Direct3D.*| OpenGL.*|ANGLE Metal Renderer: /g, '').trim()
}
