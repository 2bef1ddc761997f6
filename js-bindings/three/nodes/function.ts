/**
 * A warp as one function in WGSL or GLSL that nodes of three.js call. Only the call is a node, so that the shader code is that
 * of all other hosts.
 *
 * We measured one node per operation as an alternative, with four Gerstner waves and derivatives written by hand, on 200,700 vertices
 * (three 0.187, SwiftShader, two busy cores, medians of alternating runs). Per frame: on WebGPU 229 ms with shader code and 228 ms with
 * nodes, on WebGL 2 267 and 256 ms. First frame: on WebGPU 492 and 640 ms, on WebGL 2 601 and 483 ms. A second compiler of all operations
 * would gain nothing.
 */
import { shaderNames, variationNames } from '../../compile/hosts.js'
import { wgslType } from '../../glsl-source/options.js'
import type { Stage, ThreeWarp } from '../three-warp.js'
import { tsl, type Call } from './tsl.js'

/** Maps an input of the warp → the name of its parameter. */
export const parameterNames: Record<string, string> = {
  position: 'warpjetRestPosition',
  normal: 'warpjetRestNormal',
  tangent: 'warpjetRestTangent',
  uv: 'warpjetUv',
  color: 'warpjetColor',
  millis: shaderNames.millis,
  ...Object.fromEntries(variationNames.map((name) => [name, `warpjet_${name}`])),
}

const parameterType = (type: string) => (type === 'sampler2D' ? 'texture_2d<f32>' : wgslType(type))

const isOfPixel = (stage: Stage) => stage.endsWith('of pixel')
const hasTangents = (stage: Stage) => stage.startsWith('tangent')

const textOf = (warp: ThreeWarp, stage: Stage, isWebGPU: boolean) =>
  warp.textFor(isWebGPU ? 'wgsl' : 'glsl300', stage, {
    ...parameterNames,
    tangent: `${isWebGPU ? 'vec4f' : 'vec4'}(${parameterNames.tangent}, 1.0)`,
  })

const vertexTypes: Record<string, string> = {
  position: 'vec3',
  normal: 'vec3',
  tangent: 'vec3',
  uv: 'vec2',
  color: 'vec4',
  ...Object.fromEntries(variationNames.map((name) => [name, 'vec3'])),
}

/** Returns the inputs of a vertex for which the function has parameters; in the vertex stage, these include some that it does not read. */
export function inputsOfStage(
  warp: ThreeWarp,
  stage: Stage,
  isWebGPU: boolean,
): [input: string, type: string][] {
  const inputs = new Set(textOf(warp, stage, isWebGPU).attributes.map(({ name }) => name))
  if (!isOfPixel(stage)) {
    inputs.add('position')
    if (stage !== 'position') inputs.add('normal')
    if (stage === 'tangent') inputs.add('tangent')
    if (stage === 'position') inputs.delete('normal')
  }
  return Object.entries(vertexTypes).filter(([input]) => inputs.has(input))
}

/** Returns the names and types of the function's parameters. */
export function parametersOf(
  warp: ThreeWarp,
  stage: Stage,
  isWebGPU: boolean,
): [name: string, type: string][] {
  const { frame, parameters } = textOf(warp, stage, isWebGPU)
  return [
    ...inputsOfStage(warp, stage, isWebGPU).map(([input, type]): [string, string] => [
      parameterNames[input]!,
      type,
    ]),
    [shaderNames.millis, 'float'],
    ...frame.map((name): [string, string] => [name, 'vec4']),
    ...warp.uniforms.inShader.map(({ label, type }): [string, string] => [label, type]),
    ...parameters.flatMap(({ name }): [string, string][] => {
      const type = warp.outerTypes?.get(name)
      return type ? [[name, type]] : []
    }),
  ]
}

/**
 * Returns the function. In the vertex stage the function returns the position, or a matrix with the columns position, normal and tangent;
 * for pixels the normal, or a matrix with the columns normal and tangent. For a warp with other results (`otherNames`), it returns a mat4
 * in the vertex stage, with these results in the places that `otherPlaces` lists.
 */
export function functionFor(warp: ThreeWarp, stage: Stage, isWebGPU: boolean): Call {
  const { code, declarations } = textOf(warp, stage, isWebGPU)
  const parameters = parametersOf(warp, stage, isWebGPU)
  const name = `warpjet_${warp.key}_${stage.replaceAll(' ', '_')}`
  const columns = columnsOf(stage, isWebGPU)
  const others = isOfPixel(stage) ? [] : warp.otherNames
  const { type, result } = others.length
    ? matrixWithOthers(columns, others, isWebGPU)
    : matrixOf(columns, isWebGPU)
  const body = `{\n${code}\nreturn ${result};\n}`
  if (isWebGPU) {
    const list = parameters.map(([name, type]) => `${name}: ${parameterType(type)}`)
    const includes = declarations ? [tsl.wgsl(declarations)] : []
    return tsl.wgslFn(`fn ${name}(${list.join(', ')}) -> ${type} ${body}`, includes)
  }
  const list = parameters.map(([name, type]) => `${type} ${name}`)
  const includes = declarations ? [tsl.glsl(declarations)] : []
  return tsl.glslFn(`${type} ${name}(${list.join(', ')}) ${body}`, includes)
}

function matrixOf(columns: string[], isWebGPU: boolean) {
  const vec3 = isWebGPU ? 'vec3f' : 'vec3'
  if (columns.length === 1) return { type: vec3, result: columns[0] }
  const type = isWebGPU ? 'mat3x3f' : 'mat3'
  const zeros = Array<string>(3 - columns.length).fill(`${vec3}(0.0)`)
  return { type, result: `${type}(${[...columns, ...zeros].join(', ')})` }
}

/** Returns the places in a mat4 that `count` vec3 columns leave free: first the last row of these columns, then the other columns. */
export const otherPlaces = (count: number): (readonly [column: number, row: number])[] =>
  [0, 1, 2, 3].flatMap((column) =>
    (column < count ? [3] : [0, 1, 2, 3]).map((row) => [column, row] as const),
  )

function matrixWithOthers(columns: string[], others: readonly string[], isWebGPU: boolean) {
  const [type, vec4] = isWebGPU ? ['mat4x4f', 'vec4f'] : ['mat4', 'vec4']
  const places = otherPlaces(columns.length)
  const numberAt = (column: number, row: number) =>
    others[places.findIndex(([c, r]) => c === column && r === row)] ?? '0.0'
  const all = [0, 1, 2, 3].map((column) =>
    column < columns.length
      ? `${vec4}(${columns[column]}, ${numberAt(column, 3)})`
      : `${vec4}(${[0, 1, 2, 3].map((row) => numberAt(column, row)).join(', ')})`,
  )
  return { type, result: `${type}(${all.join(', ')})` }
}

function columnsOf(stage: Stage, isWebGPU: boolean): string[] {
  const tangents = hasTangents(stage) ? [`${shaderNames.tangent}.xyz`] : []
  if (isOfPixel(stage)) return [shaderNames.normal, ...tangents]
  if (stage === 'position') return [shaderNames.position]
  // The normal is zero if the surface collapses. Then we return the normal before the warp, made very short: it does not become NaN when
  // it is normalized, and the normals of neighbours outweigh it.
  const normal = isWebGPU
    ? `select(${shaderNames.normal}, warpjetRestNormal * 1e-6, all(${shaderNames.normal} == vec3f(0.0)))`
    : `(${shaderNames.normal} == vec3(0.0) ? warpjetRestNormal * 1e-6 : ${shaderNames.normal})`
  return [shaderNames.position, normal, ...tangents]
}
