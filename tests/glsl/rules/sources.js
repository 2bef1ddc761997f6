// Makes the sources of the rules. Each has a function `vec3 offset(vec3 p)`, and no #version: `withTop` puts text above the function,
// `withLines` puts lines there, and `withBody` puts statements into the function.
const offset = 'vec3 offset(vec3 p) { return p; }'
export const withTop = (text) => `${text}\n${offset}`
export const withBody = (statements, text = '') =>
  `${text}\nvec3 offset(vec3 p) { ${statements} return p; }`
export const withLines = (...lines) => withTop(lines.join('\n'))

/** Makes [title, source] of cases of one kind; `make` returns the source that contains a piece. */
export const makeCases = (kind, pieces, make) =>
  pieces.map((piece) => [`${kind}: ${[piece].flat().join(' | ')}`, make(piece)])
