/**
 * `exactNormals`: a shader that a sketch made by p5's `modify`, from hooks in GLSL or by p5.strands, with normals that are
 * turned as it moves positions. The hook stays as it is and moves the vertex; beside it, the front end reads the same text,
 * and the exact derivative of what it does to the position turns the normal.
 */
import { compileWarp } from '../compile/compile-warp-text.js'
import { WarpError, describe } from '../checks/errors.js'
import { glslOffset } from '../glsl/offset.js'

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

/** Each moves positions of a space of its own, and its normals are turned there. */
const hookNames = ['Vertex getObjectInputs', 'Vertex getWorldInputs', 'Vertex getCameraInputs']

/**
 * The same shader with exact normals, where its hooks move positions. What cannot be, such as a position that reads an
 * attribute of the sketch's own, is told in a sentence on the console, and the shader comes back as it was. Throws a
 * `WarpError` for what is no shader of p5 2 in WEBGL.
 */
export function exactNormals<Shader extends object>(shader: Shader): Shader {
  const given = shader as unknown as ModifiedShader
  const modified = given?.hooks?.modified?.vertex
  if (!modified || !hookNames.every((name) => name in given.hooks.vertex))
    throw new WarpError(
      `exactNormals: a shader was expected that modify() or buildMaterialShader() of p5 2 made in WEBGL, but ${describe(shader)} came.`,
    )
  try {
    const moving = hookNames
      .filter((name) => modified[name])
      .map((name) => turned(given, name))
      .filter((hook) => hook !== undefined)
    if (moving.length === 0) return shader
    return given.modify({
      ...Object.assign({}, ...moving.map(({ hook }) => hook)),
      ...(modified['void afterVertex'] ? {} : unitNormals(given)),
      // p5 puts declarations in the place of those before.
      vertexDeclarations: [
        given.hooks.vertex.declarations ?? '',
        'bool warpjetFlat;',
        ...moving.map(({ above }) => above),
      ].join('\n'),
    }) as unknown as Shader
  } catch (error) {
    if (!(error instanceof WarpError)) throw error
    console.warn(
      `exactNormals: the shader stays as it is. ${error.message.replace(/^glslOffset: /, '')}`,
    )
    return shader
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

/** A hook that calls the sketch's own and turns the normal; nothing where that leaves the position as it is. */
function turned(shader: ModifiedShader, name: string) {
  const word = name.split(' ')[1]!
  const own = `warpjetOwn_${word}`
  const names = {
    position: 'warpjetInputs.position',
    normal: 'warpjetInputs.normal',
    uv: 'warpjetInputs.texCoord',
    color: 'warpjetInputs.color',
  }
  const outputs = {
    offset: `warpjetOffset_${word}`,
    position: `warpjetMoved_${word}`,
    normal: `warpjetTurned_${word}`,
  }
  const hook = `Vertex ${own}${shader.hooks.vertex[name]!}`
  const source = `${aboveHooks(shader)}
${hook}
vec3 warpjetPosition(vec3 position, vec3 normal, vec2 uv, vec4 color) {
  Vertex inputs;
  inputs.position = position;
  inputs.normal = normal;
  inputs.texCoord = uv;
  inputs.color = color;
  return ${own}(inputs).position;
}`
  const offset = glslOffset(source, {
    function: 'warpjetPosition',
    returns: 'position',
    maxIterations: 256,
  })
  const options = { target: 'glsl300', names, outputs, surfaceVariation: false } as const
  const moves = compileWarp(offset, { ...options, normals: false }).stats.operations > 0
  if (!moves) return undefined
  const { code, declarations } = compileWarp(offset, options)
  return {
    above: declarations,
    hook: {
      // Below the helpers that the sketch's hook may call.
      [name]: `(Vertex warpjetInputs);
${hook}
Vertex HOOK_${word}(Vertex warpjetInputs) {
${code}
  Vertex warpjetResult = ${own}(warpjetInputs);
  warpjetResult.normal = ${outputs.normal};
  warpjetFlat = ${outputs.normal} == vec3(0.0);
  return warpjetResult;
}`,
    },
  }
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
