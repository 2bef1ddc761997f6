// Makes the sources of the rules. Each has a function `offset`: `withTop` puts text above it, `withBody` puts statements into it.
const offset = 'fn offset(p: vec3f) -> vec3f { return p; }'
export const withTop = (text) => `${text}\n${offset}`
export const withBody = (statements, text = '') =>
  `${text}\nfn offset(p: vec3f) -> vec3f { ${statements} return p; }`

/** Makes [title, source] of cases of one kind; `make` returns the source that contains a piece. */
export const makeCases = (kind, pieces, make) =>
  pieces.map((piece) => [`${kind}: ${piece}`, make(piece)])
