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
    const sketchText = stage && hooks[stage][name]!
    if (!sketchText) all[name] = text
    else if (_renderer?.device) {
      const { hook, above } = bothInWgsl(stage, name, sketchText, text as string, orderOf(name))
      all[name] = hook
      all[`${stage}Declarations`] = `${all[`${stage}Declarations`] ?? ''}\n${above}`
    } else all[name] = bothInGlsl(name, sketchText, text as string, orderOf(name))
  }
  for (const stage of ['vertex', 'fragment'] as const) {
    const above = `${stage}Declarations`
    if (above in all) all[above] = `${hooks[stage].declarations ?? ''}\n${all[above] as string}`
  }
  return all
}

const splitHook = (text: string) =>
  /^\s*\(([^)]*)\)([^]*)$/.exec(text)!.slice(1) as [string, string]

/**
 * Returns the statements of a hook with the parameter `value`. They call the functions named `sketch` and `our`; each call also passes
 * `moreArguments`.
 */
function callInOrder(
  order: HookOrder,
  sketch: string,
  our: string,
  value: string,
  moreArguments = '',
) {
  const call = (name: string, ...values: string[]) =>
    `${name}(${[...values.filter(Boolean), moreArguments].filter(Boolean).join(', ')})`
  const chain = { first: [sketch, our], last: [our, sketch], inside: [our] }[order]
  return value
    ? `return ${chain.reduce((inner, name) => call(name, inner), value)};`
    : chain.map((name) => `${call(name)};`).join(' ')
}

/**
 * p5 writes the hook's type and name before this source, and above it the helpers that the sketch's hook may call. A hook of
 * `exactNormals` contains its own name, which is replaced too.
 */
function bothInGlsl(name: string, sketchText: string, ourText: string, order: HookOrder) {
  const [type, hookName] = name.split(' ')
  const [parameter] = splitHook(ourText)
  const value = parameter.trim().split(' ').pop()!
  const ourHook = `warpjetHook_${hookName}`
  return `(${parameter});
${type} ${sketchHook(name)}${sketchText.replaceAll(`HOOK_${hookName}`, sketchHook(name))}
${type} ${ourHook}${ourText}
${type} HOOK_${hookName}(${parameter}) { ${callInOrder(order, sketchHook(name), ourHook, value)} }`
}

/** Parameters that p5 appends to those of a hook, and the arguments with which the hook passes them to another function. */
const extraParameters = {
  vertex: ['instanceID: u32, _p5VertexId: u32', 'instanceID, _p5VertexId'],
  fragment: ['_p5FragPos: vec4<f32>', '_p5FragPos'],
} as const

function bothInWgsl(
  stage: 'vertex' | 'fragment',
  name: string,
  sketchText: string,
  ourText: string,
  order: HookOrder,
) {
  const [type, hookName] = name.split(' ')
  const [parameters, values] = extraParameters[stage]
  const ourHook = `warpjetHook_${hookName}`
  const writeFunction = (label: string, text: string) => {
    const [parameter, body] = splitHook(text)
    const list = [parameter.trim(), parameters].filter(Boolean).join(', ')
    return `fn ${label}(${list})${type === 'void' ? '' : ` -> ${type}`}${body}`
  }
  const [parameter] = splitHook(ourText)
  const value = parameter.split(':')[0]!.trim()
  return {
    above: `${writeFunction(sketchHook(name), sketchText)}\n${writeFunction(ourHook, ourText)}`,
    hook: `(${parameter}) { ${callInOrder(order, sketchHook(name), ourHook, value, values)} }`,
  }
}
