/**
 * `exactNormals`: a shader that a sketch made by p5's `modify`, from hooks in GLSL or by p5.strands, with normals that are
 * turned as it moves positions. The hook stays as it is and moves the vertex; beside it, the front end reads the same text,
 * and the exact derivative of what it does to the position turns the normal.
 */
import { compileWarp } from '../compile/compile-warp-text.js'
import { WarpError, describe } from '../checks/errors.js'
import { glslOffset } from '../glsl/offset.js'
import { drawInputs } from '../inputs/inputs.js'
import type { OffsetFunction } from '../types/types.js'

interface ModifiedShader {
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

/** Inputs of an offset that a hook has not: uniforms of the sketch may have their names. */
const unread = Object.fromEntries(
  Object.keys(drawInputs).map((name) => [name, `warpjetNo_${name}`]),
)

/** Each moves positions of a space of its own, and its normals are turned there. */
const structHooks = ['Vertex getObjectInputs', 'Vertex getWorldInputs', 'Vertex getCameraInputs']
/** Those of p5 1.11, of which it calls the second one "world", though it is in view space. */
const valueHooks = ['vec3 getLocalPosition', 'vec3 getWorldPosition']
const normalHooks = ['vec3 getLocalNormal', 'vec3 getWorldNormal']

/**
 * The same shader with exact normals, where its hooks move positions. What cannot be, such as a position that reads an
 * attribute of the sketch's own, is told in a sentence on the console, and the shader comes back as it was. Throws a
 * `WarpError` for what is no shader of p5 in WEBGL.
 */
export function exactNormals<Shader extends object>(shader: Shader): Shader {
  const given = shader as unknown as ModifiedShader
  const hooks = given?.hooks?.modified?.vertex && given.hooks.vertex
  const has = (names: readonly string[]) => names.every((name) => name in (hooks ?? {}))
  const weave = has(structHooks) ? inStructs : has(valueHooks) ? inValues : undefined
  if (!weave)
    throw new WarpError(
      `exactNormals: a shader was expected that modify() or buildMaterialShader() of p5 made in WEBGL, but ${describe(shader)} came.`,
    )
  try {
    if (/\bfn main\b/.test(given._vertSrc))
      throw new WarpError(
        'On a WEBGPU canvas its hooks are WGSL, which is not read; draw it on a WEBGL canvas, or write the motion for createWarp.',
      )
    const woven = weave(given)
    return woven ? (given.modify(woven) as unknown as Shader) : shader
  } catch (error) {
    if (!(error instanceof WarpError)) throw error
    console.warn(
      `exactNormals: the shader stays as it is. ${error.message.replace(/^glslOffset: /, '')}`,
    )
    return shader
  }
}

type Hooks = Record<string, string>

/** p5 2: a hook has all that a vertex is, and gives it back. */
function inStructs(shader: ModifiedShader): Hooks | undefined {
  const moving = movingHooks(shader, structHooks, (name) => ({
    names: {
      position: 'warpjetInputs.position',
      normal: 'warpjetInputs.normal',
      uv: 'warpjetInputs.texCoord',
      color: 'warpjetInputs.color',
    },
    moved: (own) => `Vertex inputs;
  inputs.position = position;
  inputs.normal = normal;
  inputs.texCoord = uv;
  inputs.color = color;
  return ${own}(inputs).position;`,
    // The sketch's own stands below the helpers that it may call.
    hook: ({ code, own, text, turned }) => ({
      [name]: `(Vertex warpjetInputs);
${text}
Vertex HOOK_${name.split(' ')[1]}(Vertex warpjetInputs) {
${code}
  Vertex warpjetResult = ${own}(warpjetInputs);
  warpjetResult.normal = ${turned};
  warpjetFlat = ${turned} == vec3(0.0);
  return warpjetResult;
}`,
    }),
  }))
  if (!moving) return undefined
  const isFree = !shader.hooks.modified.vertex['void afterVertex']
  return {
    ...(isFree && unitNormals(shader)),
    ...moving.hooks,
    // p5 puts declarations in the place of those before.
    vertexDeclarations: [
      shader.hooks.vertex.declarations ?? '',
      'bool warpjetFlat;',
      ...moving.declarations,
    ].join('\n'),
  }
}

/**
 * p5 1.11: a hook has the position alone. The normal is carried over, in view space, to the last hook for normals, since p5
 * calls those for positions first.
 */
function inValues(shader: ModifiedShader): Hooks | undefined {
  const { modified } = shader.hooks
  let isKnown = false
  const moving = movingHooks(shader, valueHooks, (name) => {
    const isLocal = name === valueHooks[0]
    return {
      names: {
        position: 'warpjetGiven',
        normal: isLocal ? 'aNormal' : 'warpjetNormal',
        uv: 'aTexCoord',
        color: '(uUseVertexColor ? aVertexColor : uMaterialColor)',
      },
      moved: (own) => `return ${own}(position);`,
      hook({ code, own, turned }) {
        const start = isLocal || isKnown ? '' : '  warpjetNormal = uNormalMatrix * aNormal;\n'
        isKnown = true
        return {
          [name]: `(vec3 warpjetGiven) {
${start}${code}
  warpjetNormal = ${isLocal ? `uNormalMatrix * ${turned}` : turned};
  return ${own}(warpjetGiven);
}`,
        }
      },
    }
  })
  if (!moving) return undefined
  const own = normalHooks.find((name) => modified.vertex[name])
  if (own)
    throw new WarpError(
      `The sketch has a hook ${own.split(' ')[1]} of its own, which on p5 1.11 says the normal by itself; leave it out.`,
    )
  return {
    ...moving.hooks,
    'vec3 getWorldNormal':
      '(vec3 normal) { return warpjetNormal == vec3(0.0) ? warpjetNormal : normalize(warpjetNormal); }',
    // p5 gives its normal shader medium precision, too little for what is computed here.
    vertexDeclarations: [
      'precision highp float;',
      shader.hooks.vertex.declarations ?? '',
      'vec3 warpjetNormal;',
      ...moving.declarations,
      ...moving.texts,
    ].join('\n'),
  }
}

/**
 * The last word on normals, as a warp of createWarp has it: of length 1 before they are interpolated, but where the surface
 * is collapsed.
 */
function unitNormals({ _vertSrc }: ModifiedShader): Record<string, string> {
  const name = ['vNormal', 'vVertexNormal'].find((each) =>
    new RegExp(`\\b(?:OUT|out) vec3 ${each};`).test(_vertSrc),
  )
  if (!name) return {}
  const unit = `${name} = warpjetFlat ? vec3(0.0) : normalize(${name});`
  return { 'void afterVertex': `() { ${unit} }` }
}

interface Weaving {
  /** What the inputs of an offset are called in the new hook. */
  names: Record<'position' | 'normal' | 'uv' | 'color', string>
  /** Statements that give where `position` moves to by the sketch's own hook. */
  moved: (own: string) => string
  /** The new hook: `text` is the sketch's, as the function `own`; `code` computes `turned`, the normal. */
  hook: (parts: { code: string; own: string; text: string; turned: string }) => Hooks
}

/** New hooks that call the sketch's own and turn the normal; nothing where no position moves. */
function movingHooks(
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
  const text = `${type} ${own}${shader.hooks.vertex[name]!}`
  const weaving = weavingOf(name)
  const source = `${aboveHooks(shader)}
${text}
vec3 warpjetPosition(vec3 position, vec3 normal, vec2 uv, vec4 color) {
  ${weaving.moved(own)}
}`
  // p5 1.11 may have to do with WebGL 1.
  const target = type === 'Vertex' || shader._vertSrc.includes('300 es') ? 'glsl300' : 'glsl100'
  const options = {
    target,
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
  const offset: OffsetFunction = ({ glsl, position, normal, uv, color, uniforms }) =>
    read({ glsl, position, normal, uv, color, uniforms } as never)
  if (compileWarp(offset, { ...options, normals: false }).stats.operations === 0) return undefined
  const { code, declarations } = compileWarp(offset, options)
  return { declarations, text, hook: weaving.hook({ code, own, text, turned: outputs.normal }) }
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
