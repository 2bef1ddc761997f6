/**
 * Calls of p5's `random()` in the hooks of a sketch on WEBGPU. The result of `random()` is a hash of the vertex's number and of the number
 * of earlier calls, so it does not change with the vertex's position. Each call becomes a uniform in the source that is differentiated, and
 * a variable in the hook, which calls `random()` with the same count as the sketch's code does later.
 */
export interface RandomCalls {
  /** Returns source in which the calls are uniforms. */
  replace(source: string): string
  /** Returns the declarations of the uniforms, once all source is replaced. */
  declarations(): string
  /** Returns statements to insert before `code`, which compute the variables that `code` reads. */
  statementsFor(code: string): string
}

/** A call as p5.strands writes it in the vertex stage: the seed is a uniform or a number. */
const call = /(?<![.\w])random\((?:hooks\.\w+|f32\([\d.]+\)|[\d.]+), f32\(_p5VertexId\)\)/g

/** Tests whether each call of random() in a hook runs exactly once, so that its position in the sequence of calls is known. */
function runOnceEach(hook: string): boolean {
  let depth = 0
  let count = 0
  for (const [word] of hook.matchAll(/[{}]|(?<![.\w])random\(/g)) {
    if (word === '{') depth++
    else if (word === '}') depth--
    else if (depth === 1) count++
    else return false
  }
  return count === (hook.match(call) ?? []).length
}

/** `hook` consists of the hook's parameters and body; `helpers` are functions that it may call. */
export function randomCallsOf(hook: string, helpers: readonly string[]): RandomCalls {
  const isCalledByHelper = helpers.some((each) => /(?<![.\w])random\(/.test(each))
  const calls = runOnceEach(hook) && !isCalledByHelper ? (hook.match(call) ?? []) : []
  const nameOf = (i: number) => `warpjetRandom${i}`
  return {
    replace(source) {
      if (source !== hook || calls.length === 0) return source
      let i = 0
      return source.replace(call, () => nameOf(i++))
    },
    declarations: () => calls.map((_, i) => `var<uniform> ${nameOf(i)}: f32;`).join('\n'),
    statementsFor(code) {
      if (!calls.some((_, i) => new RegExp(`\\b${nameOf(i)}\\b`).test(code))) return ''
      return [
        '  let warpjetRandomCalls = _p5_randomCallIndex;',
        ...calls.map((each, i) => `  let ${nameOf(i)} = ${each};`),
        '  _p5_randomCallIndex = warpjetRandomCalls;\n',
      ].join('\n')
    },
  }
}
