// Counts evaluations of a height in shader code of three.js: loops with octaves, one for each evaluation. Functions that `main` calls
// count as often as they are called.

const names = { glsl: /\bvoid main\s*\(/, wgsl: /@(?:vertex|fragment)\s+fn\s+main\s*\(/ }

/** Returns the position behind the bracket that closes the first one after `start`. */
function endOf(code, start) {
  let depth = 0
  for (let i = code.indexOf('{', start); i < code.length; i++) {
    if (code[i] === '{') depth++
    if (code[i] === '}' && --depth === 0) return i + 1
  }
  return code.length
}

/** Maps the functions of a shader → their bodies; overloads are joined. */
function bodiesIn(code) {
  const found = code.matchAll(
    /^\s*(?:fn\s+(\w+)\s*\([^{;]*\)\s*->[^{;]*|(?:void|float|u?int|bool|[iub]?vec[234]|mat[234])\s+(\w+)\s*\([^{};]*\)\s*)(?=\{)/gm,
  )
  const bodies = new Map()
  for (const { 1: wgsl, 2: glsl, index } of found) {
    const name = wgsl ?? glsl
    bodies.set(
      name,
      (bodies.get(name) ?? '') + code.slice(code.indexOf('{', index), endOf(code, index)),
    )
  }
  return bodies
}

/** Returns the number of evaluations in one run of a shader. */
export function heightsIn(shader) {
  const code = shader.replace(/\/\/.*|\/\*[^]*?\*\//g, '')
  const bodies = bodiesIn(code)
  const start = code.search(names.wgsl.test(code) ? names.wgsl : names.glsl)
  const count = (body) =>
    (body.match(/\bfor \(/g) ?? []).length +
    [...body.matchAll(/(?<![.\w])(\w+)\s*\(/g)].reduce(
      (sum, [, name]) => sum + (name !== 'main' && bodies.has(name) ? count(bodies.get(name)) : 0),
      0,
    )
  return count(code.slice(code.indexOf('{', start), endOf(code, start)))
}
