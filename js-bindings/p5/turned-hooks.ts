/** In the place of a sketch's hook that moves positions: one that calls it, and turns the normal by its exact derivative. */
import { asOwn } from '../checks/operators.js'
import { compileWarp } from '../compile/compile-warp-text.js'
import { glslOffset } from '../glsl/offset.js'
import { drawInputs } from '../inputs/inputs.js'
import type { Target } from '../module/kept-module.js'
import type { OffsetFunction } from '../types/types.js'
import { aboveStrands, glslOf } from './strands-wgsl.js'

/** A shader that p5's `modify` made. */
export interface ModifiedShader {
  readonly hooks: {
    readonly vertex: Readonly<Record<string, string>>
    readonly helpers: Readonly<Record<string, string>>
    readonly uniforms: Readonly<Record<string, unknown>>
    readonly declarations?: string
    readonly varyingVariables?: readonly string[]
    readonly modified: { readonly vertex: Readonly<Record<string, boolean>> }
  }
  /** As p5 has it, with the places of hooks. */
  readonly _vertSrc: string
  modify(hooks: Record<string, string>): ModifiedShader
}

export type Hooks = Record<string, string>

/** Inputs of an offset that a hook has not: uniforms of the sketch may have their names. */
const unread = Object.fromEntries(
  Object.keys(drawInputs).map((name) => [name, `warpjetNo_${name}`]),
)

/** Whether the shader is of a WEBGPU canvas. */
export const isWgsl = ({ _vertSrc }: ModifiedShader) => /\bfn main\b/.test(_vertSrc)

export interface Weaving {
  /** What the inputs of an offset are called in the new hook. */
  names: Record<'position' | 'normal' | 'uv' | 'color', string>
  /** Statements that give where `position` moves to by the sketch's own hook. */
  moved: (own: string) => string
  /** The new hook: `text` is the sketch's, as the function `own`; `code` computes `turned`, the normal. */
  hook: (parts: { code: string; own: string; text: string; turned: string }) => Hooks
}

/** New hooks that call the sketch's own and turn the normal; nothing where no position moves. */
export function movingHooks(
  shader: ModifiedShader,
  names: readonly string[],
  weavingOf: (name: string) => Weaving,
): { hooks: Hooks; declarations: string[]; texts: string[] } | undefined {
  const moving = names
    .filter((name) => shader.hooks.modified.vertex[name])
    .map((name) => turned(shader, name, weavingOf))
    .filter((hook) => hook !== undefined)
  if (moving.length === 0) return undefined
  return {
    hooks: Object.assign({}, ...moving.map(({ hook }) => hook)) as Hooks,
    declarations: moving.map(({ declarations }) => declarations),
    texts: moving.map(({ text }) => text),
  }
}

function turned(shader: ModifiedShader, name: string, weavingOf: (name: string) => Weaving) {
  const [type, word] = name.split(' ')
  const own = `warpjetOwn_${word}`
  const outputs = {
    offset: `warpjetOffset_${word}`,
    position: `warpjetMoved_${word}`,
    normal: `warpjetTurned_${word}`,
  }
  const hook = shader.hooks.vertex[name]!
  const text = `${isWgsl(shader) ? 'fn' : type} ${own}${hook}`
  const weaving = weavingOf(name)
  const source = `${readable(shader, `${type} ${own}`, hook)}
vec3 warpjetPosition(vec3 position, vec3 normal, vec2 uv, vec4 color) {
  ${weaving.moved(own)}
}`
  const options = {
    target: targetOf(shader, type!),
    names: { ...unread, ...weaving.names },
    outputs,
    surfaceVariation: false,
  } as const
  const read = glslOffset(source, {
    function: 'warpjetPosition',
    returns: 'position',
    maxIterations: 256,
  })
  // Without those either: what is called millis, size or instance is the sketch's.
  const offset: OffsetFunction = asOwn(({ glsl, position, normal, uv, color, uniforms }) =>
    read({ glsl, position, normal, uv, color, uniforms } as never),
  )
  if (compileWarp(offset, { ...options, normals: false }).stats.operations === 0) return undefined
  const { code, declarations } = compileWarp(offset, options)
  return { declarations, text, hook: weaving.hook({ code, own, text, turned: outputs.normal }) }
}

function targetOf(shader: ModifiedShader, type: string): Target {
  if (isWgsl(shader)) return 'wgsl'
  // p5 1.11 may have to do with WebGL 1.
  return type === 'Vertex' || shader._vertSrc.includes('300 es') ? 'glsl300' : 'glsl100'
}

/** The hook as a function, and what stands above it, in GLSL. */
function readable(shader: ModifiedShader, head: string, hook: string): string {
  if (!isWgsl(shader)) return `${aboveHooks(shader)}\n${head}${hook}`
  const { uniforms, varyingVariables = [], vertex, declarations } = shader.hooks
  const above = [
    ...Object.keys(uniforms).map((uniform) => `uniform var ${uniform};`),
    ...varyingVariables.map((varying) => `var ${varying};`),
    // p5 puts its noise() and random() above all hooks, whichever calls them.
    vertex.declarations?.replace(/^fn (\w+)[^]*?^\}/gm, (text, called) =>
      hook.includes(`${called}(`) ? text : '',
    ),
    declarations,
  ].join('\n')
  return `${aboveStrands}\n${glslOf(above)}\n${head}${glslOf(hook)}`
}

/** What p5 writes above a shader's hooks, as far as they can read it. */
function aboveHooks({ hooks, _vertSrc }: ModifiedShader): string {
  const inner = _vertSrc.match(
    /^[ \t]*(?:(?:IN|OUT|uniform|in|out)\s[^;()]+;|struct Vertex\s*\{[^}]*\};)/gm,
  )
  return [
    '#define IN in\n#define OUT out',
    ...(inner ?? []),
    ...Object.keys(hooks.uniforms).map((uniform) => `uniform ${uniform};`),
    ...(hooks.varyingVariables ?? []).map((varying) => `out ${varying};`),
    hooks.declarations ?? '',
    hooks.vertex.declarations ?? '',
    ...Object.entries(hooks.helpers).map(([head, body]) => head + body),
  ].join('\n')
}
