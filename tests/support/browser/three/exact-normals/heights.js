// Counts how often shader code of three.js evaluates the height of a showcase: each evaluation contains one loop over octaves. A loop in a
// function counts once per call.

/** Patterns for the start of `main`. */
const mains = { glsl: /\bvoid main\s*\(/, wgsl: /@(?:vertex|fragment)\s+fn\s+main\s*\(/ }

/** Returns the index after the brace that closes the first block after `start`. */
function endOf(code, start) {
  let depth = 0
  for (let i = code.indexOf('{', start); i < code.length; i++) {
    if (code[i] === '{') depth++
    if (code[i] === '}' && --depth === 0) return i + 1
  }
  return code.length
}

/** Maps the names of a shader's functions → their bodies; those of overloads are concatenated. */
function findBodies(code) {
  const matches = code.matchAll(
    /^\s*(?:fn\s+(\w+)\s*\([^{;]*\)\s*->[^{;]*|(?:void|float|u?int|bool|[iub]?vec[234]|mat[234])\s+(\w+)\s*\([^{};]*\)\s*)(?=\{)/gm,
  )
  const bodies = new Map()
  for (const { 1: wgsl, 2: glsl, index } of matches) {
    const name = wgsl ?? glsl
    bodies.set(
      name,
      (bodies.get(name) ?? '') + code.slice(code.indexOf('{', index), endOf(code, index)),
    )
  }
  return bodies
}

/** Returns the number of evaluations of the height in a shader. */
export function countHeights(shader) {
  const code = shader.replace(/\/\/.*|\/\*[^]*?\*\//g, '')
  const bodies = findBodies(code)
  const start = code.search(mains.wgsl.test(code) ? mains.wgsl : mains.glsl)
  const countLoops = (body) =>
    (body.match(/\bfor \(/g) ?? []).length +
    [...body.matchAll(/(?<![.\w])(\w+)\s*\(/g)].reduce(
      (sum, [, name]) =>
        sum + (name !== 'main' && bodies.has(name) ? countLoops(bodies.get(name)) : 0),
      0,
    )
  return countLoops(code.slice(code.indexOf('{', start), endOf(code, start)))
}
