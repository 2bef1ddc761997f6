/**
 * Completes the vertex shader of a material, so that it can be read by itself: as a GLSL function that returns the position to which the
 * shader moves a vertex, in the space of the geometry.
 */
import { splitAtMain } from '../shader-source.js'
import { definesFor } from './defines.js'
import { inputPrefix, isInputName } from './exact-names.js'
import { movedBody, type MovedBody } from './moved-body.js'
import { numberedIncludes } from './numbered-includes.js'
import { withoutComments } from './plain-source.js'
import type { ExactShader } from './shader.js'

/** Maps a variable that three.js declares → type. */
export const uniforms: Record<string, string> = {
  modelMatrix: 'mat4',
  modelViewMatrix: 'mat4',
  projectionMatrix: 'mat4',
  viewMatrix: 'mat4',
  normalMatrix: 'mat3',
  cameraPosition: 'vec3',
  isOrthographic: 'bool',
}

export interface VertexSource {
  /** GLSL with the function. */
  text: string
  /** Attributes that are not inputs of an offset function. `text` declares them as uniforms. */
  attributes: ReadonlySet<string>
  /** The message about statements of the shader that are ignored, if there are any. */
  note?: string
}

export function vertexSource(shader: ExactShader): VertexSource {
  const resolved = withoutComments(numberedIncludes(shader.vertexShader))
  const { top, main } = splitAtMain(resolved)!
  const { body, result, hidden, note }: MovedBody = movedBody(
    main,
    withoutThreeDeclarations(top),
    shader.instancing === true,
  )
  const attributes = new Set<string>()
  const declarations = withoutThreeDeclarations(top).replace(
    /\b(?:attribute|in)\s+((?:(?:high|medium|low)p\s+)?\w+\s+(\w+)\s*(?:\[[^\]]*\]\s*)?;)/g,
    (_, rest: string, name: string) => {
      attributes.add(name)
      return `uniform ${rest}`
    },
  )
  const optional = optionalAttributes(shader)
  for (const [name] of optional) attributes.add(name)
  const declared = [...declarations.matchAll(/\buniform\s[^;{]*?\b(\w+)\s*(?:\[[^\]]*\]\s*)?;/g)]
  const renamed = [...declared.map(([, name]) => name!), ...attributes].filter(isInputName)
  const text = `${definesFor(shader)}
${Object.entries(uniforms)
  .filter(([name]) => !hidden.includes(name))
  .map(([name, type]) => `uniform ${type} ${name};`)
  .join('\n')}
attribute vec3 position;
attribute vec3 normal;
attribute vec2 uv;
${[...new Set(renamed)].map((name) => `#define ${name} ${inputPrefix}${name}`).join('\n')}
${optional.map(([name, type]) => `uniform ${type} ${name};`).join('\n')}
vec4 warpjetClip;
#define gl_Position warpjetClip
${hidden.map((name) => `#define ${name} mat4( 1.0 )`).join('\n')}
#line 1
${declarations}${body}
return ${result};
}
`
  return { text, attributes, ...(note && { note }) }
}

/** Returns name and type of those attributes of the shader that three.js declares only if a geometry or an object has them. */
function optionalAttributes(shader: ExactShader) {
  const all: (readonly [name: string, type: string, isPresent: boolean | undefined])[] = [
    ['instanceMatrix', 'mat4', shader.instancing],
    ['instanceColor', 'vec3', shader.instancingColor],
    ['color', shader.vertexAlphas ? 'vec4' : 'vec3', shader.vertexColors],
    ['tangent', 'vec4', shader.vertexTangents],
    ['uv1', 'vec2', shader.vertexUv1s],
    ['uv2', 'vec2', shader.vertexUv2s],
    ['uv3', 'vec2', shader.vertexUv3s],
  ]
  return all.filter(([, , isPresent]) => isPresent)
}

/**
 * Removes declarations of variables that `vertexSource` declares. A RawShaderMaterial contains them; for other materials, three.js adds
 * them.
 */
const withoutThreeDeclarations = (top: string) =>
  top.replace(
    new RegExp(
      `\\b(?:uniform|attribute|in)\\s+(?:(?:high|medium|low)p\\s+)?\\w+\\s+(?:${[...Object.keys(uniforms), 'position', 'normal', 'uv', 'instanceMatrix'].join('|')})\\s*;`,
      'g',
    ),
    '',
  )
