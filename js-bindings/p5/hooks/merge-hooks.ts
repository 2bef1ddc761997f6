/**
 * Adds our hooks to a shader that may have hooks of the sketch. p5's `modify` replaces earlier hooks and declarations; where the sketch
 * and we have the same hook, this module makes both run.
 */
import type { Modifications, Shader } from '../host.js'

/** When the sketch's hook runs: before ours, after it, or inside, where ours calls it by the name that `sketchHook` returns. */
export type HookOrder = 'first' | 'last' | 'inside'

/** Returns the function name of the sketch's hook when both it and ours run. */
export const sketchHook = (name: string) => `warpjetSketchHook_${name.split(' ')[1]}`

/** Returns the argument of p5's `modify`. `orderOf` takes names such as `Vertex getObjectInputs`. */
export function mergeHooks(
  { hooks, _renderer }: Shader,
  ours: Modifications,
  orderOf: (name: string) => HookOrder,
): Modifications {
  const all: Modifications = {}
  for (const [name, text] of Object.entries(ours)) {
    const stage = (['vertex', 'fragment'] as const).find((each) => hooks.modified[each][name])
    const own = stage && hooks[stage][name]!
    if (!own) all[name] = text
    else if (_renderer?.device) {
      const { hook, above } = bothInWgsl(stage, name, own, text as string, orderOf(name))
      all[name] = hook
      all[`${stage}Declarations`] = `${all[`${stage}Declarations`] ?? ''}\n${above}`
    } else all[name] = bothInGlsl(name, own, text as string, orderOf(name))
  }
  for (const stage of ['vertex', 'fragment'] as const) {
    const above = `${stage}Declarations`
    if (above in all) all[above] = `${hooks[stage].declarations ?? ''}\n${all[above] as string}`
  }
  return all
}

const parts = (text: string) => /^\s*\(([^)]*)\)([^]*)$/.exec(text)!.slice(1) as [string, string]

/** Returns the statements of a hook with the parameter `value` that calls `own` and `our` in order. */
function callInOrder(turn: HookOrder, own: string, our: string, value: string, more = '') {
  const call = (name: string, ...values: string[]) =>
    `${name}(${[...values.filter(Boolean), more].filter(Boolean).join(', ')})`
  const chain = { first: [own, our], last: [our, own], inside: [our] }[turn]
  return value
    ? `return ${chain.reduce((inner, name) => call(name, inner), value)};`
    : chain.map((name) => `${call(name)};`).join(' ')
}

/**
 * p5 writes the hook's type and name before this source, and above it the helpers that the sketch's hook may call. A hook of
 * `exactNormals` contains its own name, which is replaced too.
 */
function bothInGlsl(name: string, own: string, our: string, turn: HookOrder) {
  const [type, word] = name.split(' ')
  const [parameter] = parts(our)
  const value = parameter.trim().split(' ').pop()!
  const ourHook = `warpjetHook_${word}`
  return `(${parameter});
${type} ${sketchHook(name)}${own.replaceAll(`HOOK_${word}`, sketchHook(name))}
${type} ${ourHook}${our}
${type} HOOK_${word}(${parameter}) { ${callInOrder(turn, sketchHook(name), ourHook, value)} }`
}

/** Parameters that p5 appends to those of the hooks, and the arguments that pass them on. */
const extra = {
  vertex: ['instanceID: u32, _p5VertexId: u32', 'instanceID, _p5VertexId'],
  fragment: ['_p5FragPos: vec4<f32>', '_p5FragPos'],
} as const

function bothInWgsl(
  stage: 'vertex' | 'fragment',
  name: string,
  own: string,
  our: string,
  turn: HookOrder,
) {
  const [type, word] = name.split(' ')
  const [parameters, values] = extra[stage]
  const ourHook = `warpjetHook_${word}`
  const writeFunction = (label: string, text: string) => {
    const [parameter, body] = parts(text)
    const list = [parameter.trim(), parameters].filter(Boolean).join(', ')
    return `fn ${label}(${list})${type === 'void' ? '' : ` -> ${type}`}${body}`
  }
  const [parameter] = parts(our)
  const value = parameter.split(':')[0]!.trim()
  return {
    above: `${writeFunction(sketchHook(name), own)}\n${writeFunction(ourHook, our)}`,
    hook: `(${parameter}) { ${callInOrder(turn, sketchHook(name), ourHook, value, values)} }`,
  }
}
