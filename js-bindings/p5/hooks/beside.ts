/**
 * Hooks of ours for a shader that may have hooks of the sketch's. p5's `modify` puts a hook, and all declarations, in the place of
 * those before; here, of a hook that both have, both run.
 */
import type { Modifications, Shader } from '../host.js'

/** When the sketch's hook runs: before ours, after it, or where ours calls it itself, by the name that `given` tells. */
export type Turn = 'first' | 'last' | 'inside'

/** What the sketch's hook is called then. */
export const given = (name: string) => `warpjetGiven_${name.split(' ')[1]}`

/** For p5's `modify`; `turnOf` takes names such as `Vertex getObjectInputs`. */
export function beside(
  { hooks, _renderer }: Shader,
  ours: Modifications,
  turnOf: (name: string) => Turn,
): Modifications {
  const all: Modifications = {}
  for (const [name, text] of Object.entries(ours)) {
    const stage = (['vertex', 'fragment'] as const).find((each) => hooks.modified[each][name])
    const own = stage && hooks[stage][name]!
    if (!own) all[name] = text
    else if (_renderer?.device) {
      const { hook, above } = bothInWgsl(stage, name, own, text as string, turnOf(name))
      all[name] = hook
      all[`${stage}Declarations`] = `${all[`${stage}Declarations`] ?? ''}\n${above}`
    } else all[name] = bothInGlsl(name, own, text as string, turnOf(name))
  }
  for (const stage of ['vertex', 'fragment'] as const) {
    const above = `${stage}Declarations`
    if (above in all) all[above] = `${hooks[stage].declarations ?? ''}\n${all[above] as string}`
  }
  return all
}

const parts = (text: string) => /^\s*\(([^)]*)\)([^]*)$/.exec(text)!.slice(1) as [string, string]

/** What the hook does, of what it is handed. */
function calls(turn: Turn, own: string, our: string, value: string, more = '') {
  const call = (name: string, ...values: string[]) =>
    `${name}(${[...values.filter(Boolean), more].filter(Boolean).join(', ')})`
  const chain = { first: [own, our], last: [our, own], inside: [our] }[turn]
  return value
    ? `return ${chain.reduce((inner, name) => call(name, inner), value)};`
    : chain.map((name) => `${call(name)};`).join(' ')
}

/** p5 writes type and name in front of it, and helpers that the sketch's hook may call above. `exactNormals` names the hook too. */
function bothInGlsl(name: string, own: string, our: string, turn: Turn) {
  const [type, word] = name.split(' ')
  const [parameter] = parts(our)
  const value = parameter.trim().split(' ').pop()!
  const put = `warpjetPut_${word}`
  return `(${parameter});
${type} ${given(name)}${own.replaceAll(`HOOK_${word}`, given(name))}
${type} ${put}${our}
${type} HOOK_${word}(${parameter}) { ${calls(turn, given(name), put, value)} }`
}

/** What p5 hands to hooks beside what they say. */
const extra = {
  vertex: ['instanceID: u32, _p5VertexId: u32', 'instanceID, _p5VertexId'],
  fragment: ['_p5FragPos: vec4<f32>', '_p5FragPos'],
} as const

function bothInWgsl(
  stage: 'vertex' | 'fragment',
  name: string,
  own: string,
  our: string,
  turn: Turn,
) {
  const [type, word] = name.split(' ')
  const [parameters, values] = extra[stage]
  const put = `warpjetPut_${word}`
  const written = (label: string, text: string) => {
    const [parameter, body] = parts(text)
    const list = [parameter.trim(), parameters].filter(Boolean).join(', ')
    return `fn ${label}(${list})${type === 'void' ? '' : ` -> ${type}`}${body}`
  }
  const [parameter] = parts(our)
  const value = parameter.split(':')[0]!.trim()
  return {
    above: `${written(given(name), own)}\n${written(put, our)}`,
    hook: `(${parameter}) { ${calls(turn, given(name), put, value, values)} }`,
  }
}
