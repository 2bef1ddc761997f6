// OBJ and STL files in many forms, each with the triangles that its shape must have.
import { trianglesOf } from './shapes.js'

const encode = (text) => new TextEncoder().encode(text)
/** Returns lines, each of which consists of a word and the next `width` numbers. */
const toLines = (numbers, width, word) =>
  Array.from({ length: numbers.length / width }, (_, i) =>
    [word, ...numbers.slice(width * i, width * (i + 1))].join(' '),
  )

/** Returns the lines of an OBJ; `corner(i)` returns the text of a corner of a face. */
function objLines(
  { positions, normals, uvs, indices },
  corner = (i) => `${i + 1}/${i + 1}/${i + 1}`,
) {
  const faces = Array.from({ length: indices.length / 3 }, (_, i) =>
    ['f', ...[...indices.slice(3 * i, 3 * i + 3)].map((index) => corner(index))].join(' '),
  )
  return [
    ...toLines(positions, 3, 'v'),
    ...toLines(uvs, 2, 'vt'),
    ...toLines(normals, 3, 'vn'),
    ...faces,
  ]
}

/** Returns a function that makes an OBJ of a shape; `write` encodes its lines, and `files` are further files. */
const makeObj =
  (write = (lines) => encode(lines.join('\n')), files) =>
  (shape) => ({ file: write(objLines(shape), shape), files, triangles: trianglesOf(shape) })

function encodeUtf16(isBigEndian, hasMark) {
  return (lines) => {
    const bytes = Buffer.from((hasMark ? '\uFEFF' : '') + lines.join('\r\n'), 'utf16le')
    return new Uint8Array(isBigEndian ? bytes.swap16() : bytes)
  }
}

/**
 * Encodes lines with a byte order mark. Adds an unused vertex at the end: a reader to which the mark hides the first line still finds
 * enough vertices, but returns wrong corners.
 */
const encodeWithMark = (lines) => encode('\uFEFF' + [...lines, 'v 9 9 9'].join('\n'))

const makeRelative = (shape) => {
  const count = shape.positions.length / 3
  const lines = objLines(shape, (i) =>
    Array(3)
      .fill(i - count)
      .join('/'),
  )
  return { file: encode(lines.join('\n')), triangles: trianglesOf(shape) }
}

const withLines = (...more) => makeObj((lines) => encode([...more, ...lines].join('\n')))

const facets = (triangles, normal) =>
  triangles.flatMap((corners) => [
    `facet normal ${normal}`,
    'outer loop',
    ...corners.map((corner) => `vertex ${corner.join(' ')}`),
    'endloop',
    'endfacet',
  ])

const makeTextStl =
  (normal = '0 0 0', end = '\n') =>
  (shape) => {
    const triangles = trianglesOf(shape)
    const lines = ['solid shape', ...facets(triangles, normal), 'endsolid shape']
    return { file: encode(lines.join(end)), triangles }
  }

const makeBinaryStl =
  (header, normal = [0, 0, 0]) =>
  (shape) => {
    const triangles = trianglesOf(shape)
    const file = new Uint8Array(84 + 50 * triangles.length)
    file.set(encode(header))
    const view = new DataView(file.buffer)
    view.setUint32(80, triangles.length, true)
    triangles.forEach((corners, i) =>
      [...normal, ...corners.flat()].forEach((x, k) =>
        view.setFloat32(84 + 50 * i + 4 * k, x, true),
      ),
    )
    return { file, triangles }
  }

export const textVariants = {
  'an OBJ': makeObj(),
  'an OBJ with CR LF': makeObj((lines) => encode(lines.join('\r\n'))),
  'an OBJ with CR': makeObj((lines) => encode(lines.join('\r'))),
  'an OBJ with a byte order mark': makeObj(encodeWithMark),
  'an OBJ in UTF-16, little endian': makeObj(encodeUtf16(false, true)),
  'an OBJ in UTF-16, big endian': makeObj(encodeUtf16(true, true)),
  'an OBJ in UTF-16 without a mark': makeObj(encodeUtf16(false, false)),
  'an OBJ with relative indices': makeRelative,
  'an OBJ with invalid numbers': makeObj((lines) =>
    encode([...lines, 'v nan 0 -nan(ind)', 'vn inf 0 1.#QNAN', 'vt nan nan'].join('\n')),
  ),
  'an OBJ with materials': makeObj(
    (lines) => encode(['mtllib a.mtl', 'usemtl red', ...lines].join('\n')),
    { 'a.mtl': encode('newmtl red\nKd 1 0 0\n') },
  ),
  'an OBJ whose materials are missing': withLines('mtllib a.mtl', 'usemtl red'),
  'a text STL': makeTextStl(),
  'a text STL with CR LF': makeTextStl('0 1 0', '\r\n'),
  'a text STL with invalid normals': makeTextStl('nan nan nan'),
  'a binary STL': makeBinaryStl('by a test'),
  'a binary STL that begins with "solid"': makeBinaryStl('solid by a test', [0, 1, 0]),
  'a binary STL with invalid normals': makeBinaryStl('', [NaN, 0, 0]),
}
