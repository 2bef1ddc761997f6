// Makes the sources of the rules. Each has a function `vec3 offset(vec3 p)`, and no #version.
const offset = 'vec3 offset(vec3 p) { return p; }'
export const above = (text) => `${text}\n${offset}`
export const body = (statements, text = '') =>
  `${text}\nvec3 offset(vec3 p) { ${statements} return p; }`
export const lines = (...all) => above(all.join('\n'))

/** Makes cases of one kind: calls `make` with each piece of source. */
export const each = (kind, pieces, make) =>
  pieces.map((piece) => [`${kind}: ${[piece].flat().join(' | ')}`, make(piece)])
