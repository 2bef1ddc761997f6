/**
 * Validates messages from a sketch's frame, which a hostile sketch may have sent. Each reader returns the message in its expected
 * shape, or undefined.
 */
const MAX_TEXT = 20_000
const MAX_CODE = 5_000_000
const MAX_ITEMS = 200

const isText = (value, max = MAX_TEXT) => typeof value === 'string' && value.length <= max
const isAmount = (value) => Number.isFinite(value) && value >= 0
const isList = (value, isItem) =>
  Array.isArray(value) && value.length <= MAX_ITEMS && value.every(isItem)
const isName = (value) => isText(value, 200)
const isNumber = (value) => Number.isFinite(value)

/** Returns a line or column in the sketch, counted from 1, or undefined. */
const toPosition = (value) => (Number.isSafeInteger(value) && value > 0 ? value : undefined)

/** Returns whether the page can show a value: a number, two to four numbers, or a colour such as '#ff8040'. */
export const isValue = (value) =>
  isNumber(value) ||
  (typeof value === 'string' && /^#[\da-f]{6}$/.test(value)) ||
  (Array.isArray(value) && value.length > 1 && value.length < 5 && value.every(isNumber))

const isCode = (text) =>
  isText(text?.code, MAX_CODE) &&
  (text.declarations === undefined || isText(text.declarations, MAX_CODE))

const isWarp = (warp) =>
  isName(warp?.maker) &&
  isCode(warp.own) &&
  ['glsl300', 'glsl100', 'wgsl'].every((language) => isCode(warp.texts?.[language])) &&
  isList(warp.reads, isName) &&
  (warp.declared === undefined || isList(warp.declared, isName)) &&
  (warp.radius === undefined || isAmount(warp.radius)) &&
  (warp.stats === undefined ||
    ['nodes', 'operations', 'temporaries'].every((name) => isAmount(warp.stats?.[name])))

const levels = ['log', 'info', 'warn', 'error']

/** Maps kind → reader. */
const readers = {
  error: ({ message, line, column }) => ({
    message: String(message).slice(0, MAX_TEXT),
    line: toPosition(line),
    column: toPosition(column),
  }),
  printed: ({ level, text }) =>
    levels.includes(level) && { level, text: String(text).slice(0, MAX_TEXT) },
  blocked: ({ address }) => isText(address) && { address },
  wanted: ({ id, address }) => isAmount(id) && isText(address) && { id, address },
  state: ({ frames, millis }) => isAmount(frames) && isAmount(millis) && { frames, millis },
  made: ({ warps, uniforms }) =>
    isList(warps, isWarp) &&
    isList(uniforms, (each) => isName(each?.name) && isValue(each.value)) && { warps, uniforms },
  drawn: ({ milliseconds }) => isAmount(milliseconds) && { milliseconds },
  answer: ({ id, value, error }) =>
    isAmount(id) && (error === undefined ? { id, value } : { id, error: String(error) }),
}

export function readMessage(data) {
  const { kind } = data ?? {}
  if (!Object.hasOwn(readers, kind)) return undefined
  const read = readers[kind](data)
  return read ? { kind, ...read } : undefined
}

const makeError = () => new Error('The sketch sent an unexpected answer: run it again.')

/** Checks that an answer is a file, and returns it with this type; undefined if there is no file. */
export function fileOf(value, type) {
  if (value === undefined || value === null) return undefined
  if (!(value instanceof Blob)) throw makeError()
  return value.slice(0, value.size, type)
}

const isFloats = (value) => value instanceof Float32Array
const isFloatsOf = (length) => (value) => isFloats(value) && value.length === length

/** Checks that an answer is an evaluated mesh with as many positions and normals as `mesh`. */
export function evaluatedOf(value, mesh) {
  const hasSameLength = isFloatsOf(mesh.positions.length)
  if (!hasSameLength(value?.positions) || (mesh.normals && !hasSameLength(value.normals)))
    throw makeError()
  return value
}

/** Checks that an answer has a mask of `count` vertices, nonzero for folded ones, and returns the mask. */
export function maskOf(value, count) {
  if (!ArrayBuffer.isView(value?.mask) || value.mask.length !== count) throw makeError()
  return value.mask
}

/** Checks that an answer is a list of shapes: [{ positions, normals, uvs, indices, matrix, isUpsideDown }]. */
export function shapesOf(value) {
  const isShape = ({ positions, normals, uvs, indices, matrix } = {}) => {
    if (!isFloats(positions) || positions.length % 3) return false
    const count = positions.length / 3
    return (
      (normals === undefined || isFloatsOf(3 * count)(normals)) &&
      (uvs === undefined || isFloatsOf(2 * count)(uvs)) &&
      ArrayBuffer.isView(indices) &&
      indices.every((index) => index < count) &&
      matrix?.length === 16 &&
      matrix.every(isNumber)
    )
  }
  if (!isList(value, isShape)) throw makeError()
  return value
}
