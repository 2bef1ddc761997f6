/**
 * Completes the vertex shader of a material, so that it can be read by itself: as a GLSL function that returns where the shader moves a
 * vertex, in the units of the geometry.
 */
import { chunkSource, splitAtMain } from '../shader-source.js'
import { anchor } from '../weave.js'
import { definesFor } from './defines.js'
import type { ExactShader } from './shader.js'
import { numberedIncludes } from './numbered-includes.js'

/** The function that is read. */
export const movedFunction = 'warpjetMoved'

/** Replaces the attribute of colors, since an offset's input of that name always has four components. */
export const colorName = 'warpjetColorAttribute'

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
  /** Attributes that an offset function does not have. They are uniforms of `text`. */
  attributes: ReadonlySet<string>
}

export function vertexSource(shader: ExactShader): VertexSource {
  const resolved = withoutComments(numberedIncludes(shader.vertexShader))
  const { top, main } = splitAtMain(resolved)!
  const { body, result, hidden } = movedBody(main, withoutKnown(top))
  const attributes = new Set<string>()
  const own = withoutKnown(top).replace(
    /\b(?:attribute|in)\s+((?:(?:high|medium|low)p\s+)?\w+\s+(\w+)\s*(?:\[[^\]]*\]\s*)?;)/g,
    (_, rest: string, name: string) => {
      attributes.add(name)
      return `uniform ${rest}`
    },
  )
  const text = `${definesFor(shader)}
${Object.entries(uniforms)
  .filter(([name]) => !hidden.includes(name))
  .map(([name, type]) => `uniform ${type} ${name};`)
  .join('\n')}
attribute vec3 position;
attribute vec3 normal;
attribute vec2 uv;
${givenAttributes(shader, attributes)}
vec4 warpjetClip;
#define gl_Position warpjetClip
${hidden.map((name) => `#define ${name} mat4( 1.0 )`).join('\n')}
#line 1
${own}${body}
return ${result};
}
`
  return { text, attributes }
}

/** Attributes that three.js declares only if a geometry or an object has them. */
function givenAttributes(shader: ExactShader, attributes: Set<string>) {
  const given: (readonly [name: string, type: string, isThere: unknown])[] = [
    ['instanceMatrix', 'mat4', shader.instancing],
    ['instanceColor', 'vec3', shader.instancingColor],
    [colorName, shader.vertexAlphas ? 'vec4' : 'vec3', shader.vertexColors],
    ['uv1', 'vec2', shader.vertexUv1s],
    ['uv2', 'vec2', shader.vertexUv2s],
    ['uv3', 'vec2', shader.vertexUv3s],
  ]
  const present = given.filter(([, , isThere]) => isThere)
  for (const [name] of present) attributes.add(name)
  return [
    ...present.map(([name, type]) => `uniform ${type} ${name};`),
    ...(shader.vertexColors ? [`#define color ${colorName}`] : []),
  ].join('\n')
}

/** A RawShaderMaterial declares by itself what three.js declares for others. */
const withoutKnown = (top: string) =>
  top.replace(
    new RegExp(
      `\\b(?:uniform|attribute|in)\\s+(?:(?:high|medium|low)p\\s+)?\\w+\\s+(?:${[...Object.keys(uniforms), 'position', 'normal', 'uv', 'instanceMatrix'].join('|')})\\s*;`,
      'g',
    ),
    '',
  )

/** The statements of a shader that compute where a vertex is, and the expression for that in the units of the geometry. */
interface MovedBody {
  body: string
  result: string
  /** Matrices that are replaced by 1, since the result is led back before they count. */
  hidden: readonly string[]
}

function movedBody(main: string, top: string): MovedBody {
  const end = anchor.exec(main)?.index
  const user = withoutProjection(main)
  const open = (text: string) =>
    text.replace(/\bvoid\s+main\s*\([^)]*\)/, `vec3 ${movedFunction}()`)
  if (end !== undefined && !assigns(user, 'gl_Position') && !assigns(user, 'mvPosition'))
    return { body: open(main.slice(0, end)), result: 'vec3( transformed )', hidden: [] }
  const body = open(main).replace(/\}\s*$/, '')
  const chain = chainOf(user, top)
  return { body, ...chain }
}

const assigns = (text: string, name: string) =>
  new RegExp(`(?<![.\\w])${name}\\s*(?:\\.\\w+\\s*)?[-+*/]?=(?!=)`).test(text)

/** Chunks of three.js that read matrices, or make `gl_Position` of `transformed`. */
const projecting = [
  'project_vertex',
  'logdepthbuf_vertex',
  'defaultnormal_vertex',
  'worldpos_vertex',
  'shadowmap_vertex',
  'envmap_vertex',
].map((name) => plainLines(withoutComments(chunkSource(name))))

const withoutProjection = (main: string) =>
  projecting.reduce((text, chunk) => (chunk ? text.replaceAll(chunk, '') : text), plainLines(main))

/** A text without marks of lines and without spaces at the ends of lines, to be compared. */
function plainLines(text: string): string {
  const lines = text.replace(/^#line \d+\n/gm, '').split('\n')
  return lines
    .map((line) => line.trim())
    .filter(Boolean)
    .join('\n')
}

/**
 * Finds the last matrix that is known to be applied to a finished position, and leads the result back before it. Matrices before that
 * are computed with, since the shader may move vertices between them.
 */
function chainOf(user: string, top: string): Omit<MovedBody, 'body'> {
  const text = `${top}\n${user}`
  const isLast = (matrix: string, others: readonly string[]) =>
    count(text, matrix) === 1 &&
    count(text, 'projectionMatrix') === 1 &&
    others.every((name) => count(text, name) === 0) &&
    isAppliedAtEnd(user, matrix)
  const instanced = count(user, 'instanceMatrix') > 0
  if (isLast('modelViewMatrix', ['viewMatrix'])) {
    const hidesInstance =
      count(text, 'instanceMatrix') === 1 &&
      /\bmodelViewMatrix\s*\*\s*instanceMatrix\s*\*\s*vec4\s*\(/.test(user)
    return hidesInstance
      ? {
          result: 'warpjetClip.xyz',
          hidden: ['projectionMatrix', 'modelViewMatrix', 'instanceMatrix'],
        }
      : {
          result: instanced ? '( inverse( instanceMatrix ) * warpjetClip ).xyz' : 'warpjetClip.xyz',
          hidden: ['projectionMatrix', 'modelViewMatrix'],
        }
  }
  const toObject = (matrix: string) =>
    `( inverse( ${matrix}${instanced ? ' * instanceMatrix' : ''} ) * warpjetClip ).xyz`
  if (isLast('viewMatrix', ['modelViewMatrix']))
    return { result: toObject('modelMatrix'), hidden: ['projectionMatrix', 'viewMatrix'] }
  return { result: toObject('( viewMatrix * modelMatrix )'), hidden: ['projectionMatrix'] }
}

const count = (text: string, name: string) =>
  text.match(new RegExp(`(?<![.\\w])${name}\\b`, 'g'))?.length ?? 0

/** Tests whether nothing changes the product of a matrix and a position before it reaches `gl_Position`. */
function isAppliedAtEnd(user: string, matrix: string): boolean {
  if (user.match(/(?<![.\w])gl_Position\b/g)?.length !== 1) return false
  if (
    new RegExp(`gl_Position\\s*=\\s*projectionMatrix\\s*\\*\\s*\\(?\\s*${matrix}\\s*\\*`).test(user)
  )
    return true
  const [, name] = new RegExp(`\\bvec4\\s+(\\w+)\\s*=\\s*\\(?\\s*${matrix}\\s*\\*`).exec(user) ?? []
  if (!name) return false
  const assignments = user.match(
    new RegExp(`(?<![.\\w])${name}\\s*(?:\\.\\w+\\s*)?[-+*/]?=(?!=)`, 'g'),
  )
  return (
    assignments?.length === 1 &&
    new RegExp(`gl_Position\\s*=\\s*projectionMatrix\\s*\\*\\s*${name}\\s*;`).test(user)
  )
}

/** Replaces comments by spaces, so that lines and columns stay. */
export function withoutComments(text: string): string {
  return text.replace(/\/\/[^\n]*|\/\*[^]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ' '))
}
