/** Completes the WGSL of a hook on a WEBGPU canvas, so that it can be read by itself. */
import type { ModifiedShader } from './modified-shader.js'
import type { RandomCalls } from './random-calls.js'
import type { StorageReads } from './storage-reads.js'

/** Mirrors p5's struct of a vertex; the parameters that p5 adds to every hook are uniforms here. */
const aboveHooks = `struct Vertex { position: vec3f, normal: vec3f, texCoord: vec2f, color: vec4f }
var<uniform> instanceID: u32;
var<uniform> _p5VertexId: u32;`

/**
 * Returns source with the hook as a function named `original`, the declarations that it needs, and a function named `moved`, which
 * returns the position that the hook computes.
 */
export function wgslOfHook(
  { hooks }: ModifiedShader,
  original: string,
  hook: string,
  moved: string,
  replacements: readonly (StorageReads | RandomCalls)[],
): string {
  const fields = Object.keys(hooks.uniforms).filter((uniform) => !uniform.endsWith('sampler2D'))
  const helpers = Object.entries(hooks.helpers).map(([head, text]) => {
    const [type, name] = head.split(' ') as [string, string]
    return `fn ${name}${type === 'void' ? text : text.replace(/\)\s*\{/, `) -> ${type} {`)}`
  })
  const [body, ...helperFunctions] = [hook, ...helpers].map((source) =>
    replacements.reduce((replaced, each) => each.replace(replaced), source),
  )
  return [
    aboveHooks,
    ...replacements.map((each) => each.declarations()),
    ...(fields.length
      ? [`struct HookUniforms { ${fields.join(', ')} }`, 'var<uniform> hooks: HookUniforms;']
      : []),
    ...(hooks.varyingVariables ?? []).map((varying) => `var<private> ${varying};`),
    hooks.vertex.declarations ?? '',
    hooks.declarations ?? '',
    ...helperFunctions,
    `fn ${original}${body!.replace(/\)\s*\{/, ') -> Vertex {')}`,
    `fn ${moved}(position: vec3f, normal: vec3f, uv: vec2f, color: vec4f) -> vec3f {
  return ${original}(Vertex(position, normal, uv, color)).position;
}`,
  ].join('\n')
}
