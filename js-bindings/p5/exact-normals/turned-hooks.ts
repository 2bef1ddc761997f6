/** In the place of a sketch's hook that moves positions: one that calls it, and turns the normal by its exact derivative. */
import { compileWarp } from '#text-compiler'
import { type OffsetFunction, type Target, drawInputs } from '../../compile/hosts.js'
import { WarpError } from '../../errors/errors.js'
import { asOwn } from '../../errors/operators.js'
import { glslOffset } from '../../glsl-source/offset.js'
import { aboveStrands, glslOf } from './strands-wgsl.js'
import { type ModifiedShader, isWgsl } from './modified-shader.js'
import { checkReadable, inStrandsWords, isOfStrands, withoutRandom } from './unreadable-hooks.js'
import { readsVariation, variationVariables } from '../variation/variation-text.js'

type CompiledText = ReturnType<typeof compileWarp>

export type Hooks = Record<string, string>

/** Inputs of an offset that a hook has not: uniforms of the sketch may have their names. */
const unread = Object.fromEntries(
  Object.keys(drawInputs).map((name) => [name, `warpjetNo_${name}`]),
)

export interface Weaving {
  /** What the inputs of an offset are called in the new hook. */
  names: Record<'position' | 'normal' | 'uv' | 'color', string>
  /** Statements that give where `position` moves to by the sketch's own hook. */
  moved: (own: string) => string
  /**
   * The new hook: `text` is the sketch's, as the function `own`; `code` computes `turned`, the normal, and is what was written as
   * `warp`.
   */
  hook: (parts: {
    code: string
    own: string
    text: string
    turned: string
    warp: CompiledText
  }) => Hooks
}

export interface MovingHooks {
  hooks: Hooks
  declarations: string[]
  texts: string[]
  /** Hooks whose normals depend on how normal and uv vary over the surface. */
  varying: { name: string; warp: CompiledText }[]
}

/** New hooks that call the sketch's own and turn the normal; nothing where no position moves. */
export function movingHooks(
  shader: ModifiedShader,
  names: readonly string[],
  weavingOf: (name: string) => Weaving,
): MovingHooks | undefined {
  const moving: NonNullable<ReturnType<typeof turned>>[] = []
  for (const name of names.filter((each) => shader.hooks.modified.vertex[each])) {
    const hook = turned(shader, name, weavingOf, moving.length === 0)
    if (hook) moving.push(hook)
  }
  if (moving.length === 0) return undefined
  return {
    hooks: Object.assign({}, ...moving.map(({ hook }) => hook)) as Hooks,
    declarations: moving.map(({ declarations }) => declarations),
    texts: moving.map(({ text }) => text),
    varying: moving.filter(({ warp }) => readsVariation(warp)),
  }
}

/** `isFirst`: no hook has moved the surface before. */
function turned(
  shader: ModifiedShader,
  name: string,
  weavingOf: (name: string) => Weaving,
  isFirst: boolean,
) {
  const [type, word] = name.split(' ')
  const own = `warpjetOwn_${word}`
  const outputs = {
    offset: `warpjetOffset_${word}`,
    position: `warpjetPosition_${word}`,
    normal: `warpjetNormal_${word}`,
  }
  const hook = shader.hooks.vertex[name]!
  const text = `${isWgsl(shader) ? 'fn' : type} ${own}${hook}`
  checkReadable(shader, name, hook)
  const weaving = weavingOf(name)
  const isOfShape = /Object|Local/.test(word!)
  const source = `${readable(shader, `${type} ${own}`, hook, isOfShape)}
vec3 warpjetRestPosition(vec3 position, vec3 normal, vec2 uv, vec4 color) {
  ${isWgsl(shader) ? '' : attributes.map((each) => each.isSet(isOfShape)).join('')}
  ${weaving.moved(own)}
}`
  const options = {
    target: targetOf(shader, type!),
    names: { ...unread, ...variationVariables, ...weaving.names },
    outputs,
    surfaceVariation: true,
  } as const
  const read = glslOffset(source, {
    function: 'warpjetRestPosition',
    returns: 'position',
    maxIterations: 256,
  })
  // Without those either: what is called millis, size or instance is the sketch's.
  const offset: OffsetFunction = asOwn(({ glsl, position, normal, uv, color, uniforms }) =>
    read({ glsl, position, normal, uv, color, uniforms } as never),
  )
  try {
    if (compileWarp(offset, { ...options, normals: false }).stats.operations === 0) return undefined
    const exact = compileWarp(offset, options)
    const isKnown = isFirst || !readsVariation(exact)
    if (!isKnown) noteSecond(word!)
    const warp = isKnown ? exact : compileWarp(offset, { ...options, surfaceVariation: false })
    const { code, declarations } = warp
    const parts = { code, own, text, turned: outputs.normal, warp }
    return { name, declarations, text, warp, hook: weaving.hook(parts) }
  } catch (error) {
    if (!(error instanceof WarpError && isOfStrands(hook))) throw error
    throw new WarpError(inStrandsWords(error.message, word!))
  }
}

const noteSecond = (word: string) =>
  console.warn(
    `exactNormals: ${word} moves vertices by normal or texCoord where another hook has moved them before, so that its light is only nearly right; move them in one hook.`,
  )

function targetOf(shader: ModifiedShader, type: string): Target {
  if (isWgsl(shader)) return 'wgsl'
  // p5 1.11 may have to do with WebGL 1.
  return type === 'Vertex' || shader._vertSrc.includes('300 es') ? 'glsl300' : 'glsl100'
}

/** Attributes that a hook may read by themselves, as globals that begin as the inputs of the offset: those of the shape's own space only there. */
const attributes = [
  { name: 'aPosition', type: 'vec3', value: 'position', isFree: false },
  { name: 'aNormal', type: 'vec3', value: 'normal', isFree: false },
  { name: 'aTexCoord', type: 'vec2', value: 'uv', isFree: true },
].map((attribute) => ({
  ...attribute,
  isKnown: (isOfShape: boolean) => isOfShape || attribute.isFree,
  isSet: (isOfShape: boolean) =>
    isOfShape || attribute.isFree ? `${attribute.name} = ${attribute.value};\n  ` : '',
}))

/** The hook as a function, and what stands above it, in GLSL. */
function readable(shader: ModifiedShader, head: string, hook: string, isOfShape: boolean): string {
  if (!isWgsl(shader)) return `${aboveHooks(shader, isOfShape)}\n${head}${hook}`
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

/** Mirrors the function that p5 puts above its shaders. */
const getTexture = `vec4 getTexture(sampler2D content, vec2 coord) {
  vec4 color = texture(content, coord);
  if (color.a > 0.0) color.rgb /= color.a;
  return color;
}`

/** What p5 writes above a shader's hooks, as far as they can read it. */
function aboveHooks({ hooks, _vertSrc }: ModifiedShader, isOfShape: boolean): string {
  const inner = _vertSrc.match(
    /^[ \t]*(?:(?:IN|OUT|uniform|in|out)\s[^;()]+;|struct Vertex\s*\{[^}]*\};)/gm,
  )
  const known = attributes.filter(({ isKnown }) => isKnown(isOfShape))
  const isKnown = (line: string) => known.some(({ name }) => new RegExp(`\\b${name}\\b`).test(line))
  return [
    '#define IN in\n#define OUT out',
    ...(inner ?? []).filter((line) => !isKnown(line)),
    ...known.map(({ type, name }) => `${type} ${name};`),
    getTexture,
    ...Object.keys(hooks.uniforms).map((uniform) => `uniform ${uniform};`),
    ...(hooks.varyingVariables ?? []).map((varying) => `out ${varying};`),
    hooks.declarations ?? '',
    withoutRandom(hooks.vertex.declarations ?? ''),
    ...Object.entries(hooks.helpers).map(([head, body]) => head + body),
  ].join('\n')
}
