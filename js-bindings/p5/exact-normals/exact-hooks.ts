/** Wraps a sketch's hook that moves positions in a new hook, which also transforms the normal by the exact derivative of the movement. */
import { compileWarp } from '#text-compiler'
import { drawInputs, type OffsetFunction, type Target } from '../../compile/hosts.js'
import { WarpError } from '../../errors/errors.js'
import { markLibraryFunction } from '../../errors/operators.js'
import { withoutLocation } from '../../glsl-source/generated.js'
import { readOffset } from '../../glsl-source/offset.js'
import { readsVariation, variationVariables } from '../variation/variation-text.js'
import { isWgsl, type ModifiedShader } from './modified-shader.js'
import { place } from './place.js'
import { randomCallsOf } from './random-calls.js'
import { storageReadsOf } from './storage-reads.js'
import { wgslOfHook } from './strands-wgsl.js'
import {
  isGeneratedByStrands,
  randomError,
  rejectRandom,
  storageError,
  strandsMessage,
  vertexId,
  withoutRandom,
} from './unreadable-hooks.js'

type CompiledText = ReturnType<typeof compileWarp>

export type Hooks = Record<string, string>

/** Renames inputs of an offset that a hook lacks: uniforms of the sketch may have the same names. */
const missingInputs = Object.fromEntries(
  Object.keys(drawInputs).map((name) => [name, `warpjetMissing_${name}`]),
)

export interface HookTemplate {
  /** Maps inputs of an offset to expressions in the new hook. */
  names: Record<'position' | 'normal' | 'uv' | 'color', string>
  /** Returns statements that compute the new `position` by calling the sketch's hook. */
  moveCode: (original: string) => string
  /**
   * Returns the new hook. `text` is the sketch's hook as source of a function named `original`. `code` is the code of `warp`, which stores
   * the transformed normal in the variable whose name is `normal`.
   */
  hook: (parts: {
    code: string
    original: string
    text: string
    normal: string
    warp: CompiledText
  }) => Hooks
}

export interface ExactHooks {
  hooks: Hooks
  declarations: string[]
  /** Source of the sketch's hooks as functions named `warpjetOriginal_…`. */
  texts: string[]
  /** Hooks whose normals depend on the gradients of normal and uv. */
  varying: { name: string; warp: CompiledText }[]
}

/** Returns new hooks that call the sketch's hooks and transform the normal; `undefined` if no hook moves a position. */
export function makeExactHooks(
  shader: ModifiedShader,
  names: readonly string[],
  maxIterations: number,
  templateOf: (name: string) => HookTemplate,
): ExactHooks | undefined {
  const made: NonNullable<ReturnType<typeof makeExactHook>>[] = []
  for (const name of names.filter((each) => shader.hooks.modified.vertex[each])) {
    const hook = makeExactHook(shader, name, maxIterations, templateOf, made.length === 0)
    if (hook) made.push(hook)
  }
  if (made.length === 0) return undefined
  return {
    hooks: Object.assign({}, ...made.map(({ hook }) => hook)) as Hooks,
    declarations: made.map(({ declarations }) => declarations),
    texts: made.map(({ text }) => text),
    varying: made.filter(({ warp }) => readsVariation(warp)),
  }
}

/** `isFirst` means that no earlier hook has moved the surface. Returns `undefined` if the hook moves no position. */
function makeExactHook(
  shader: ModifiedShader,
  name: string,
  maxIterations: number,
  templateOf: (name: string) => HookTemplate,
  isFirst: boolean,
) {
  const [type, hookName] = name.split(' ')
  const original = `warpjetOriginal_${hookName}`
  const outputs = {
    offset: `warpjetOffset_${hookName}`,
    position: `warpjetPosition_${hookName}`,
    normal: `warpjetNormal_${hookName}`,
  }
  const hook = shader.hooks.vertex[name]!
  const text = `${isWgsl(shader) ? 'fn' : type} ${original}${hook}`
  if (!isWgsl(shader)) rejectRandom(shader, hookName!, hook)
  const reads = storageReadsOf(shader)
  const randoms = randomCallsOf(hook, Object.values(shader.hooks.helpers))
  const template = templateOf(name)
  const isLocal = /Object|Local/.test(hookName!)
  const moved = 'warpjetMovedPosition'
  const source = isWgsl(shader)
    ? wgslOfHook(shader, original, hook, moved, [randoms, reads])
    : `${declarationsAboveHooks(shader, isLocal)}
${type} ${original}${hook}
vec3 ${moved}(vec3 position, vec3 normal, vec2 uv, vec4 color) {
  ${attributesFor(isLocal)
    .map((each) => `${each.name} = ${each.value};\n  `)
    .join('')}
  ${template.moveCode(original)}
}`
  const options = {
    target: targetOf(shader, type!),
    names: { ...missingInputs, ...variationVariables, ...template.names },
    outputs,
    surfaceVariation: true,
  } as const
  /** Runs `work`; rewrites the messages of its errors if p5.strands generated the hook. */
  const withStrandsMessages = <Result>(work: () => Result): Result => {
    try {
      return work()
    } catch (error) {
      if (!(error instanceof WarpError && isGeneratedByStrands(hook))) throw error
      const storage = isWgsl(shader) ? reads.findUnreplaced(reads.replace(hook)) : undefined
      throw storage && /index/.test(error.message)
        ? storageError(storage, hookName!)
        : new WarpError(strandsMessage(error.message, hookName!))
    }
  }
  const read = withStrandsMessages(() =>
    readOffset(place, isWgsl(shader) ? 'wgsl' : 'glsl', source, {
      function: moved,
      returns: 'position',
      maxIterations,
    }),
  )
  // Passes only these inputs: in a hook, millis, size and instance may be variables of the sketch.
  const offset: OffsetFunction = markLibraryFunction(
    ({ glsl, position, normal, uv, color, uniforms }) =>
      read.offset({ glsl, position, normal, uv, color, uniforms } as never),
  )
  const withoutNormals = withStrandsMessages(() =>
    compileWarp(offset, { ...options, normals: false }),
  )
  if (withoutNormals.stats.operations === 0) return undefined
  if (read.cutOff) warnCutOff(hookName!, hook, read.cutOff)
  if (withoutNormals.uniforms.some((each) => each.name === vertexId)) throw randomError(hookName!)
  const exact = withStrandsMessages(() => compileWarp(offset, options))
  const isExact = isFirst || !readsVariation(exact)
  if (!isExact) warnSecondHook(hookName!)
  const warp = isExact ? exact : compileWarp(offset, { ...options, surfaceVariation: false })
  const code = randoms.statementsFor(warp.code) + reads.restore(warp.code)
  const parts = { code, original, text, normal: outputs.normal, warp }
  return { name, declarations: warp.declarations, text, warp, hook: template.hook(parts) }
}

const warnSecondHook = (hookName: string) =>
  console.warn(
    `exactNormals: ${hookName} moves vertices by normal or texCoord after another hook has moved them, so its normals are only approximate; move the vertices in one hook.`,
  )

/** Lines of p5.strands have numbers that no user knows. */
function warnCutOff(hookName: string, hook: string, message: string) {
  const located = isGeneratedByStrands(hook) ? withoutLocation(message) : message
  console.warn(`exactNormals: ${hookName} has normals as if a loop ended early: ${located}`)
}

function targetOf(shader: ModifiedShader, type: string): Target {
  if (isWgsl(shader)) return 'wgsl'
  // p5 1.11 may run on WebGL 1.
  return type === 'Vertex' || shader._vertSrc.includes('300 es') ? 'glsl300' : 'glsl100'
}

/**
 * Attributes that a hook may read directly. We declare them as globals that start with the values of the offset's inputs. An attribute
 * that `dependsOnSpace` is in the shape's own space, so only hooks of that space (`isLocal`) may read it.
 */
const attributes = [
  { name: 'aPosition', type: 'vec3', value: 'position', dependsOnSpace: true },
  { name: 'aNormal', type: 'vec3', value: 'normal', dependsOnSpace: true },
  { name: 'aTexCoord', type: 'vec2', value: 'uv', dependsOnSpace: false },
]

const attributesFor = (isLocal: boolean) =>
  attributes.filter(({ dependsOnSpace }) => isLocal || !dependsOnSpace)

/** Mirrors the function that p5 puts above its shaders. */
const getTexture = `vec4 getTexture(sampler2D content, vec2 coord) {
  vec4 color = texture(content, coord);
  if (color.a > 0.0) color.rgb /= color.a;
  return color;
}`

/** Returns the declarations that p5 writes above a shader's hooks and that the hooks can read. */
function declarationsAboveHooks({ hooks, _vertSrc }: ModifiedShader, isLocal: boolean): string {
  const declared = _vertSrc.match(
    /^[ \t]*(?:(?:IN|OUT|uniform|in|out)\s[^;()]+;|struct Vertex\s*\{[^}]*\};)/gm,
  )
  const readable = attributesFor(isLocal)
  const declaresAttribute = (line: string) =>
    readable.some(({ name }) => new RegExp(`\\b${name}\\b`).test(line))
  return [
    '#define IN in\n#define OUT out',
    // These are declared as globals instead, below.
    ...(declared ?? []).filter((line) => !declaresAttribute(line)),
    ...readable.map(({ type, name }) => `${type} ${name};`),
    getTexture,
    ...Object.keys(hooks.uniforms).map((uniform) => `uniform ${uniform};`),
    ...(hooks.varyingVariables ?? []).map((varying) => `out ${varying};`),
    hooks.declarations ?? '',
    withoutRandom(hooks.vertex.declarations ?? ''),
    ...Object.entries(hooks.helpers).map(([head, body]) => head + body),
  ].join('\n')
}
