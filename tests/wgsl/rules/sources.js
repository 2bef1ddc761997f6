// Makes the sources of the rules. Each has a function `offset`.
const offset = 'fn offset(p: vec3f) -> vec3f { return p; }'
export const above = (text) => `${text}\n${offset}`
export const body = (statements, text = '') =>
  `${text}\nfn offset(p: vec3f) -> vec3f { ${statements} return p; }`

/** Makes cases of one kind: calls `make` with each piece of source. */
export const each = (kind, pieces, make) =>
  pieces.map((piece) => [`${kind}: ${piece}`, make(piece)])
