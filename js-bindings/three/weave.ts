/**
 * Splices a warp into the vertex shaders of WebGLRenderer. These finish the normal before there is a position; so all that
 * makes either is taken out of `main` and put together, in the order in which it depends on each other, in front of
 * what uses it.
 */
import { type HostText, shaderNames, variationAttribute, variationNames } from '../compile/hosts.js'
import { WarpError } from '../errors/errors.js'
import { declareOrientation } from './faces.js'
import type { WarpSpace } from './settings.js'
import type { ThreeWarp, Turned } from './three-warp.js'

/** The chunks of three.js that make the position and the normal, in our order; those of a later version may be missing. */
const atRest = ['beginnormal_vertex', 'begin_vertex']
const posed = [
  'morphnormal_vertex',
  'morphtarget_vertex',
  'skinbase_vertex',
  'skinnormal_vertex',
  'skinning_vertex',
  'displacementmap_vertex',
]

const include = (name: string) => `#include <${name}>`

/** What `#include <…>` of a chunk looks like in the shaders of three.js and of those who write like it. */
const including = (name: string) => new RegExp(`^[ \\t]*#include +<${name}>`, 'm')

/** Throws for a shader, which is called `what`, that is not made of the chunks that a warp goes between. */
export function checkChunks(method: string, what: string, vertexShader: string) {
  const hasChunks = ['begin_vertex', 'project_vertex'].every((name) =>
    including(name).test(vertexShader),
  )
  if (!hasChunks || !/void\s+main\s*\(\s*\)\s*\{/.test(vertexShader))
    throw new WarpError(
      `${method}: ${what} has no "${include('begin_vertex')}" and "${include('project_vertex')}", between which a warp goes; write it of three's chunks.`,
    )
}

/** The vertex shader, warped; `mayHaveTangents` if some of what it draws has tangents that its material reads. */
export function weave(vertexShader: string, warp: ThreeWarp, mayHaveTangents: boolean): string {
  checkChunks(warp.settings.method, "the material's vertex shader", vertexShader)
  const isLit = including('defaultnormal_vertex').test(vertexShader)
  const lines = vertexShader.split('\n')
  const start = lines.findIndex((line) => /void\s+main\s*\(/.test(line))
  const first = outsideOfConditions(lines, firstOf(lines, start))
  const before = lines.slice(0, first).join('\n')
  // Chunks that shaders have at several places, and that others of ours need.
  const early = ['morphinstance_vertex', 'batching_vertex', 'uv_vertex'].filter(
    (name) => including(name).test(vertexShader) && !including(name).test(before),
  )
  const moved = [...early, ...atRest, ...posed]
  const rest = moved.reduce(
    (text, name) => text.replace(new RegExp(including(name), 'gm'), ''),
    lines.slice(first).join('\n'),
  )
  const poses = posed.filter((name) => isDeclared(name, vertexShader)).map(include)
  const { space } = warp.settings
  const texts = textsFor(warp, isLit, mayHaveTangents)
  const block = statements(warp, isLit, texts)
  const body = [
    ...[...early, ...atRest].map(include),
    ...(space === 'rest' ? [block, ...poses] : [...poses, block]),
  ].join('\n')
  const [head, tail] = before.split(/(?=void\s+main\s*\(\s*\)\s*\{)/)
  const end = bitangentsOf(warp, neverNaN(rest))
  return `${head}\n${declarationsFor(warp, texts)}\n${tail}\n${body}\n${end}`
}

/** The first line of `main` that includes one of the chunks that we move. */
const firstOf = (lines: string[], start: number) =>
  lines.findIndex(
    (line, i) => i > start && [...atRest, ...posed].some((name) => including(name).test(line)),
  )

/** The line of the outermost `#if` around a line, or the line. */
function outsideOfConditions(lines: string[], line: number) {
  const open: number[] = []
  for (let i = 0; i < line; i++) {
    if (/^\s*#\s*if/.test(lines[i]!)) open.push(i)
    if (/^\s*#\s*endif/.test(lines[i]!)) open.pop()
  }
  return open[0] ?? line
}

/** Points and lines are neither skinned nor displaced, and lack what these chunks read. */
const isDeclared = (name: string, vertexShader: string) => {
  const [kind] = /^(morph|skin|displacement)/.exec(name)!
  const declaring = { morph: 'morphtarget', skin: 'skinning', displacement: 'displacementmap' }
  return including(`${declaring[kind as 'morph']}_pars_vertex`).test(vertexShader)
}

function declarationsFor(warp: ThreeWarp, texts: Written[]) {
  const [fullest] = texts
  const variation = fullest!.text.attributes.filter(({ name }) =>
    (variationNames as string[]).includes(name),
  )
  return [
    `uniform highp float ${shaderNames.millis};`,
    'uniform highp vec4 warpjetFill;',
    ...warp.uniforms.inShader.map(({ label, type }) => `uniform highp ${type} ${label};`),
    ...[...new Set(texts.flatMap(({ text }) => text.frame))].map(
      (name) => `uniform highp vec4 ${name};`,
    ),
    ...declareOrientation(warp),
    ...variation.map(({ name }) => `attribute vec3 ${variationAttribute(name)};`),
    byTangent(texts, ({ declarations }) => declarations),
  ].join('\n')
}

interface Written {
  turned: Turned
  text: HostText
}

/** With tangents and without, or without normals. */
const textsFor = (warp: ThreeWarp, isLit: boolean, mayHaveTangents: boolean): Written[] =>
  turnedBy(isLit, mayHaveTangents).map((turned) => ({
    turned,
    text: warp.textFor('glsl300', turned, namesIn(warp.settings.space)),
  }))

function turnedBy(isLit: boolean, mayHaveTangents: boolean): Turned[] {
  if (!isLit) return ['position']
  return mayHaveTangents ? ['tangent', 'normal'] : ['normal']
}

const byTangent = (texts: Written[], part: (text: HostText) => string) =>
  texts.length === 1
    ? part(texts[0]!.text)
    : `#ifdef USE_TANGENT\n${part(texts[0]!.text)}\n#else\n${part(texts[1]!.text)}\n#endif`

const isWorld = (space: WarpSpace) => space === 'world'

function namesIn(space: WarpSpace): Record<string, string> {
  const own = isWorld(space)
    ? {
        position: 'warpjetRestPosition',
        normal: 'warpjetRestNormal',
        tangent: 'warpjetRestTangent',
      }
    : {
        position: 'transformed',
        normal: 'objectNormal',
        tangent: 'vec4( objectTangent, tangent.w )',
      }
  const variation = variationNames.map((name) => [
    name,
    isWorld(space) ? `warpjet_${name}` : variationAttribute(name),
  ])
  return { ...own, uv: 'uv', color: 'warpjetColor', ...Object.fromEntries(variation) }
}

function statements(warp: ThreeWarp, isLit: boolean, texts: Written[]) {
  const code = byTangent(texts, ({ code }) => code)
  const color =
    warp.reads('color') || texts[0]!.text.attributes.some(({ name }) => name === 'color')
  return `{
${color ? colorOfVertex : ''}${isWorld(warp.settings.space) ? inWorld(code, isLit, texts) : inGeometry(code, isLit)}
}`
}

const colorOfVertex = `#if defined( USE_COLOR_ALPHA )
vec4 warpjetColor = color;
#elif defined( USE_COLOR )
vec4 warpjetColor = vec4( color, 1.0 );
#else
vec4 warpjetColor = warpjetFill;
#endif
`

const inGeometry = (code: string, isLit: boolean) => `${code}
transformed = ${shaderNames.position};${
  isLit
    ? `
objectNormal = ${shaderNames.normal};
#ifdef USE_TANGENT
objectTangent = ${shaderNames.tangent}.xyz;
#endif`
    : ''
}`

/**
 * There and back again, so that the rest of the shader stays what it is. An instance that is scaled to nothing has no way
 * back, and needs none. Normals arrive with length 1; how they vary follows from that.
 */
function inWorld(code: string, isLit: boolean, texts: Written[]) {
  const reads = (name: string) =>
    texts.some(({ text }) => text.attributes.some((attribute) => attribute.name === name))
  const variation = variationNames.filter(reads)
  const gradients = variation.some((name) => name.startsWith('normal'))
  return `mat4 warpjetToWorld = modelMatrix;
#ifdef USE_BATCHING
warpjetToWorld = warpjetToWorld * batchingMatrix;
#endif
#ifdef USE_INSTANCING
warpjetToWorld = warpjetToWorld * instanceMatrix;
#endif
mat3 warpjetLinear = mat3( warpjetToWorld );
if ( determinant( warpjetLinear ) != 0.0 ) {
mat3 warpjetInverse = inverse( warpjetLinear );
mat3 warpjetCovariant = transpose( warpjetInverse );
vec3 warpjetRestPosition = ( warpjetToWorld * vec4( transformed, 1.0 ) ).xyz;
vec3 warpjetRestNormal = warpjetCovariant * objectNormal;
float warpjetLength = length( warpjetRestNormal );
if ( warpjetLength > 0.0 ) warpjetRestNormal /= warpjetLength;
${gradients ? gradientsInWorld : ''}${variation
    .filter((name) => !name.startsWith('normal'))
    .map((name) => `vec3 warpjet_${name} = warpjetCovariant * ${variationAttribute(name)};\n`)
    .join('')}#ifdef USE_TANGENT
vec4 warpjetRestTangent = vec4( warpjetLinear * objectTangent, tangent.w );
#endif
${code}
transformed = ( inverse( warpjetToWorld ) * vec4( ${shaderNames.position}, 1.0 ) ).xyz;${
    isLit
      ? `
objectNormal = ${shaderNames.normal} * warpjetLinear;
#ifdef USE_TANGENT
objectTangent = warpjetInverse * ${shaderNames.tangent}.xyz;
#endif`
      : ''
  }
}`
}

const [nx, ny, nz] = variationNames.map(variationAttribute)

/** The rows of the derivative of the normal: turned, and without what would change its length. */
const gradientsInWorld = `mat3 warpjetGradients = warpjetCovariant * mat3( ${nx}, ${ny}, ${nz} ) * warpjetInverse;
if ( warpjetLength > 0.0 ) warpjetGradients = ( warpjetGradients - outerProduct( warpjetGradients * warpjetRestNormal, warpjetRestNormal ) ) / warpjetLength;
vec3 warpjet_${variationNames[0]} = warpjetGradients[ 0 ];
vec3 warpjet_${variationNames[1]} = warpjetGradients[ 1 ];
vec3 warpjet_${variationNames[2]} = warpjetGradients[ 2 ];
`

/** Three.js takes their side from the attribute. */
const bitangentsOf = ({ mirrors }: ThreeWarp, text: string) =>
  mirrors === false
    ? text
    : text.replace(
        including('normal_vertex'),
        `${include('normal_vertex')}
#if defined( USE_TANGENT ) && ! defined( FLAT_SHADED )
vBitangent *= ${shaderNames.orientation};
#endif`,
      )

/**
 * Where a warp collapses the surface, its normal is zero, which three.js would make NaN of. Such a vertex is lit as if it
 * faced the eye, with so little weight that its neighbours decide wherever they have a normal. Arithmetic, since branches
 * that differ from vertex to vertex make the whole frame 3% slower on SwiftShader.
 */
const neverNaN = (text: string) =>
  text
    .replace(
      including('defaultnormal_vertex'),
      `${include('defaultnormal_vertex')}
float warpjetFlat = float( transformedNormal == vec3( 0.0 ) );
transformedNormal.z += warpjetFlat;
#ifdef USE_TANGENT
transformedTangent.x += float( transformedTangent == vec3( 0.0 ) );
#endif`,
    )
    .replace(
      including('normal_vertex'),
      `${include('normal_vertex')}
#ifndef FLAT_SHADED
vNormal *= mix( 1.0, 1e-6, warpjetFlat );
#endif`,
    )
