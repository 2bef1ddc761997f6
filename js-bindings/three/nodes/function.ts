/**
 * A warp as one function in WGSL or GLSL that nodes of three.js call. Only the call is a node, so that the shader code is that
 * of all other hosts.
 *
 * A node per operation was measured instead, with four Gerstner waves, their derivatives by hand, on 200,700 vertices (three
 * 0.187, SwiftShader, two busy cores, medians in turn). A frame: 229 ms with shader code, 228 ms with nodes on WebGPU, 267 and
 * 256 ms on WebGL 2. The first frame: 492 and 640 ms on WebGPU, 601 and 483 ms on WebGL 2. A second compiler of all operations
 * would gain nothing.
 */
import { shaderNames, variationNames } from '../../compile/hosts.js'
import type { ThreeWarp, Turned } from '../three-warp.js'
import { type Call, tsl } from './tsl.js'

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

const wgslTypes: Record<string, string> = {
  float: 'f32',
  vec2: 'vec2f',
  vec3: 'vec3f',
  vec4: 'vec4f',
  mat3: 'mat3x3f',
  mat4: 'mat4x4f',
  sampler2D: 'texture_2d<f32>',
}

const textOf = (warp: ThreeWarp, turned: Turned, isWebGPU: boolean) =>
  warp.textFor(isWebGPU ? 'wgsl' : 'glsl300', turned, {
    ...parameterNames,
    tangent: `${isWebGPU ? 'vec4f' : 'vec4'}(${parameterNames.tangent}, 1.0)`,
  })

/** The names and types of the parameters. */
export function parametersOf(
  warp: ThreeWarp,
  turned: Turned,
  isWebGPU: boolean,
): [name: string, type: string][] {
  const { attributes, frame } = textOf(warp, turned, isWebGPU)
  const read = new Set(attributes.map(({ name }) => name))
  const optional = [
    ['uv', 'vec2'],
    ['color', 'vec4'],
    ...variationNames.map((name) => [name, 'vec3']),
  ]
  const vertex = [
    ['position', 'vec3'],
    ...(turned === 'position' ? [] : [['normal', 'vec3']]),
    ...(turned === 'tangent' ? [['tangent', 'vec3']] : []),
    ...optional.filter(([name]) => read.has(name!)),
  ]
  return [
    ...vertex.map(([name, type]): [string, string] => [parameterNames[name!]!, type!]),
    [shaderNames.millis, 'float'],
    ...frame.map((name): [string, string] => [name, 'vec4']),
    ...warp.uniforms.inShader.map(({ label, type }): [string, string] => [label, type]),
  ]
}

/** The function. It returns the position, or a matrix with the columns position, normal and tangent. */
export function functionFor(warp: ThreeWarp, turned: Turned, isWebGPU: boolean): Call {
  const { code, declarations } = textOf(warp, turned, isWebGPU)
  const parameters = parametersOf(warp, turned, isWebGPU)
  const name = `warpjet_${warp.key}_${turned}`
  const vec3 = isWebGPU ? 'vec3f' : 'vec3'
  const mat3 = isWebGPU ? 'mat3x3f' : 'mat3'
  const type = turned === 'position' ? vec3 : mat3
  // The normal is zero if the surface collapses. A short one in its place is never NaN, and its neighbours outweigh it.
  const normal = isWebGPU
    ? `select(${shaderNames.normal}, warpjetRestNormal * 1e-6, all(${shaderNames.normal} == vec3f(0.0)))`
    : `(${shaderNames.normal} == vec3(0.0) ? warpjetRestNormal * 1e-6 : ${shaderNames.normal})`
  const tangent = turned === 'tangent' ? `${shaderNames.tangent}.xyz` : `${vec3}(0.0)`
  const result =
    turned === 'position'
      ? shaderNames.position
      : `${mat3}(${shaderNames.position}, ${normal}, ${tangent})`
  const body = `{\n${code}\nreturn ${result};\n}`
  if (isWebGPU) {
    const list = parameters.map(([name, type]) => `${name}: ${wgslTypes[type]}`)
    const includes = declarations ? [tsl.wgsl(declarations)] : []
    return tsl.wgslFn(`fn ${name}(${list.join(', ')}) -> ${type} ${body}`, includes)
  }
  const list = parameters.map(([name, type]) => `${type} ${name}`)
  const includes = declarations ? [tsl.glsl(declarations)] : []
  return tsl.glslFn(`${type} ${name}(${list.join(', ')}) ${body}`, includes)
}
