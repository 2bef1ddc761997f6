/**
 * A warp as nodes of three.js, for WebGPURenderer on both its backends: one function in WGSL or GLSL, called where the
 * material has the vertex. What is said in nodes is only what is called, so that the text is the one of all other hosts.
 *
 * The other way, a node for each operation, was measured with four Gerstner waves, their derivatives by hand, on 200,700 vertices
 * (three 0.187, SwiftShader, two busy cores, medians in turn). A frame: 229 ms with text, 228 ms with nodes on WebGPU, 267 and
 * 256 ms on WebGL 2. The first one: 492 and 640 ms on WebGPU, 601 and 483 ms on WebGL 2. So nothing would be gained for a second
 * compiler of all operations.
 */
import {
  type BatchedMesh,
  type InstancedMesh,
  type Mesh,
  Matrix3,
  Matrix4,
  type Texture,
  Vector2,
  Vector3,
  Vector4,
} from 'three'
import * as TSL from 'three/tsl'
import { shaderNames, variationAttribute, variationNames } from '../compile/hosts.js'
import type { WarpSpace } from './settings.js'
import { fillOf } from './surface.js'
import type { ThreeWarp, Turned } from './three-warp.js'
import { valueNow } from './uniforms.js'

/** A node of three.js, whose own types tell what each may do by what it holds: too much for text that a function returns. */
export interface AnyNode {
  build(builder: unknown, type: string): string
  assign(value: unknown): AnyNode
  mul(value: unknown): AnyNode
  div(value: unknown): AnyNode
  element(i: number): AnyNode
  transpose(): AnyNode
  xyz: AnyNode
}

interface Builder {
  getFrontFacing(): string
  object: Mesh
  geometry: Mesh['geometry']
  material: Mesh['material']
  renderer: { backend: { isWebGPUBackend?: boolean } }
}

type Call = (inputs: Record<string, unknown>) => AnyNode

const tsl = TSL as unknown as Record<
  | 'positionLocal'
  | 'positionGeometry'
  | 'normalLocal'
  | 'normalGeometry'
  | 'tangentLocal'
  | 'tangentGeometry'
  | 'modelWorldMatrix'
  | 'modelWorldMatrixInverse'
  | 'modelNormalMatrix',
  AnyNode
>

const make = TSL as unknown as {
  Fn: (work: (builder: Builder) => unknown) => () => AnyNode
  wgslFn: (code: string, includes?: unknown[]) => Call
  glslFn: (code: string, includes?: unknown[]) => Call
  wgsl: (code: string) => unknown
  glsl: (code: string) => unknown
  uniform: (value: unknown) => {
    onObjectUpdate: (
      work: (frame: { object: Mesh }, self: { value: unknown }) => unknown,
    ) => AnyNode
  }
  texture: (texture: Texture) => AnyNode & { onObjectUpdate?: unknown; value: Texture }
  attribute: (name: string, type: string) => AnyNode
  uv: () => AnyNode
  length: (value: unknown) => AnyNode
  max: (...values: unknown[]) => AnyNode
  vec3: (...values: unknown[]) => AnyNode
  vec4: (...values: unknown[]) => AnyNode
  mat3: (...values: unknown[]) => AnyNode
  instancedMesh: (object: unknown) => AnyNode
  batch: (object: unknown) => AnyNode
}

/** A node for `positionNode`; `before` is what the material had there. */
export function nodeFor(warp: ThreeWarp, before?: unknown): AnyNode {
  const calls = new Map<string, Call>()
  const uniforms = uniformsOf(warp)
  return make.Fn((builder) => {
    const { object, geometry, material, renderer } = builder
    orientFaces(builder, warp, uniforms)
    const turned: Turned = geometry.hasAttribute('tangent')
      ? 'tangent'
      : geometry.hasAttribute('normal')
        ? 'normal'
        : 'position'
    const isWebGPU = renderer.backend.isWebGPUBackend === true
    const key = `${isWebGPU} ${turned}`
    if (!calls.has(key)) calls.set(key, functionFor(warp, turned, isWebGPU))
    if (before) tsl.positionLocal.assign(before)
    const isLocal = warp.settings.space !== 'world'
    const isMany = isLocal && manyOf(object)
    if (isMany) takeBack(turned)
    const there = isLocal ? here : inWorld
    const result = calls.get(key)!({
      ...there.inputs(turned),
      ...inputsFor(warp, { geometry, material }, uniforms, isLocal),
    })
    there.assign(result, turned)
    // Three.js had applied the matrices of instances already, which come after the warp.
    if (isMany) isMany(object)
    return tsl.positionLocal
  })()
}

/** Where the warp mirrors all of space, the outer side of a triangle is the one that the renderer takes for the back. */
function orientFaces(builder: Builder, warp: ThreeWarp, uniforms: Record<string, AnyNode>) {
  if (warp.mirrors === false || Object.hasOwn(builder, 'getFrontFacing')) return
  const getFrontFacing = builder.getFrontFacing.bind(builder)
  builder.getFrontFacing = () => {
    const orientation = uniforms[shaderNames.orientation]!.build(builder, 'float')
    return `( ${getFrontFacing()} == ( ${orientation} > 0.0 ) )`
  }
}

function manyOf(object: Mesh) {
  if ((object as InstancedMesh).isInstancedMesh) return make.instancedMesh
  return (object as unknown as BatchedMesh).isBatchedMesh ? make.batch : undefined
}

function takeBack(turned: Turned) {
  tsl.positionLocal.assign(tsl.positionGeometry)
  if (turned !== 'position') tsl.normalLocal.assign(tsl.normalGeometry)
  if (turned === 'tangent') tsl.tangentLocal.assign(tsl.tangentGeometry.xyz)
}

/** In the space where three.js has the vertex. */
const here = {
  inputs: (turned: Turned): Record<string, unknown> => ({
    warpjetRestPosition: tsl.positionLocal,
    ...(turned !== 'position' && { warpjetRestNormal: tsl.normalLocal }),
    ...(turned === 'tangent' && { warpjetRestTangent: tsl.tangentLocal }),
  }),
  assign(result: AnyNode, turned: Turned) {
    if (turned === 'position') return void tsl.positionLocal.assign(result)
    tsl.normalLocal.assign(result.element(1))
    if (turned === 'tangent') tsl.tangentLocal.assign(result.element(2))
    tsl.positionLocal.assign(result.element(0))
  },
}

const linear = () => make.mat3(tsl.modelWorldMatrix)

/** The normal in the world, of length 1, as the other renderer and rays have it; a zero one stays. */
function normalInWorld() {
  const normal = tsl.modelNormalMatrix.mul(tsl.normalLocal)
  return normal.div(make.max(make.length(normal), 1e-30))
}

/** In the world, and back. */
const inWorld = {
  inputs: (turned: Turned): Record<string, unknown> => ({
    warpjetRestPosition: tsl.modelWorldMatrix.mul(make.vec4(tsl.positionLocal, 1)).xyz,
    ...(turned !== 'position' && { warpjetRestNormal: normalInWorld() }),
    ...(turned === 'tangent' && { warpjetRestTangent: linear().mul(tsl.tangentLocal) }),
  }),
  assign(result: AnyNode, turned: Turned) {
    const back = (position: unknown) => tsl.modelWorldMatrixInverse.mul(make.vec4(position, 1)).xyz
    if (turned === 'position') return void tsl.positionLocal.assign(back(result))
    tsl.normalLocal.assign(linear().transpose().mul(result.element(1)))
    if (turned === 'tangent')
      tsl.tangentLocal.assign(make.mat3(tsl.modelWorldMatrixInverse).mul(result.element(2)))
    tsl.positionLocal.assign(back(result.element(0)))
  },
}

const values: Record<string, () => object | number> = {
  float: () => 0,
  vec2: () => new Vector2(),
  vec3: () => new Vector3(),
  vec4: () => new Vector4(),
  mat3: () => new Matrix3(),
  mat4: () => new Matrix4(),
}

/** Nodes that have the values of the moment when they are sent. */
function uniformsOf(warp: ThreeWarp): Record<string, AnyNode> {
  const number = (type: string, read: () => unknown) =>
    make.uniform(values[type]!()).onObjectUpdate((_, self) => {
      const now = read()
      if (typeof now === 'number') return now
      ;(self.value as Vector3).fromArray(now as number[])
      return self.value
    })
  return {
    [shaderNames.millis]: number('float', () => warp.millis.value),
    [shaderNames.orientation]: number('float', () => (warp.isMirroredNow() ? -1 : 1)),
    warpjetColor: make.uniform(new Vector4()).onObjectUpdate(({ object }, self) => {
      ;(self.value as Vector4).fromArray(fillOf(object.material))
      return self.value
    }),
    ...Object.fromEntries(
      Object.keys(warp.frameNow()).map((name) => [
        name,
        number('vec4', () => warp.frameNow()[name]),
      ]),
    ),
    ...Object.fromEntries(
      warp.uniforms.inShader.map((uniform) => {
        const read = () => valueNow(uniform)
        return [
          uniform.label,
          uniform.image ? imageOf(read as () => Texture) : number(uniform.type, read),
        ]
      }),
    ),
  }
}

/** For a parameter of a function: in GLSL an image and its sampler are one, which three.js has by the image's name. */
function imageOf(read: () => Texture): AnyNode {
  const node = make.texture(read()) as unknown as {
    generate: (builder: unknown, output: string) => unknown
    onObjectUpdate: (work: () => Texture) => AnyNode
  }
  const { generate } = node
  node.generate = (builder, output) =>
    generate.call(node, builder, output === 'sampler2D' ? 'texture' : output)
  return node.onObjectUpdate(read)
}

function inputsFor(
  warp: ThreeWarp,
  { geometry, material }: Pick<Builder, 'geometry' | 'material'>,
  uniforms: Record<string, AnyNode>,
  isLocal: boolean,
) {
  const inputs: Record<string, unknown> = { ...uniforms }
  inputs.warpjetUv = geometry.hasAttribute('uv') ? make.uv() : make.vec3(0, 0, 0)
  const { color } = geometry.attributes
  // Otherwise it is the material's, as in WebGL.
  if (color && [material].flat()[0]?.vertexColors) inputs.warpjetColor = colorOf(color.itemSize)
  for (const name of variationNames) {
    const attribute = variationAttribute(name)
    inputs[names[name]!] =
      isLocal && geometry.hasAttribute(attribute)
        ? make.attribute(attribute, 'vec3')
        : make.vec3(0, 0, 0)
  }
  return Object.fromEntries(
    parametersOf(warp, 'tangent', true).flatMap(([name]) =>
      name in inputs ? [[name, inputs[name]]] : [],
    ),
  )
}

const colorOf = (size: number) => {
  const color = make.attribute('color', size === 4 ? 'vec4' : 'vec3')
  return size === 4 ? color : make.vec4(color, 1)
}

const names: Record<string, string> = {
  position: 'warpjetRestPosition',
  normal: 'warpjetRestNormal',
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

/** What the function takes, by name and type. */
function parametersOf(warp: ThreeWarp, turned: Turned, isWebGPU: boolean): [string, string][] {
  const { attributes, frame } = warp.textFor(
    isWebGPU ? 'wgsl' : 'glsl300',
    turned,
    namesIn(isWebGPU),
  )
  const read = new Set(attributes.map(({ name }) => name))
  const optional: [string, string][] = [
    ['uv', 'vec2'],
    ['color', 'vec4'],
    ...variationNames.map((name): [string, string] => [name, 'vec3']),
  ]
  return [
    ['warpjetRestPosition', 'vec3'],
    ...(turned === 'position' ? [] : [['warpjetRestNormal', 'vec3'] as [string, string]]),
    ...(turned === 'tangent' ? [['warpjetRestTangent', 'vec3'] as [string, string]] : []),
    ...optional
      .filter(([name]) => read.has(name))
      .map(([name, type]): [string, string] => [names[name]!, type]),
    [shaderNames.millis, 'float'],
    ...frame.map((name): [string, string] => [name, 'vec4']),
    ...warp.uniforms.inShader.map(({ label, type }): [string, string] => [label, type]),
  ]
}

const namesIn = (isWebGPU: boolean) => ({
  ...names,
  tangent: `${isWebGPU ? 'vec4f' : 'vec4'}(warpjetRestTangent, 1.0)`,
})

/** One function, which gives the position, or the columns position, normal and tangent. */
function functionFor(warp: ThreeWarp, turned: Turned, isWebGPU: boolean): Call {
  const text = warp.textFor(isWebGPU ? 'wgsl' : 'glsl300', turned, namesIn(isWebGPU))
  const parameters = parametersOf(warp, turned, isWebGPU)
  const name = `warpjet_${warp.key}_${turned}`
  const vec3 = isWebGPU ? 'vec3f' : 'vec3'
  const mat3 = isWebGPU ? 'mat3x3f' : 'mat3'
  const type = turned === 'position' ? vec3 : mat3
  // A normal of zero, where the surface collapses, is left to its neighbours.
  const normal = isWebGPU
    ? `select(${shaderNames.normal}, warpjetRestNormal * 1e-6, all(${shaderNames.normal} == vec3f(0.0)))`
    : `(${shaderNames.normal} == vec3(0.0) ? warpjetRestNormal * 1e-6 : ${shaderNames.normal})`
  const tangent = turned === 'tangent' ? `${shaderNames.tangent}.xyz` : `${vec3}(0.0)`
  const result =
    turned === 'position'
      ? shaderNames.position
      : `${mat3}(${shaderNames.position}, ${normal}, ${tangent})`
  const body = `{\n${text.code}\nreturn ${result};\n}`
  if (isWebGPU) {
    const given = parameters.map(([name, type]) => `${name}: ${wgslTypes[type]}`)
    const includes = text.declarations ? [make.wgsl(text.declarations)] : []
    return make.wgslFn(`fn ${name}(${given.join(', ')}) -> ${type} ${body}`, includes)
  }
  const given = parameters.map(([name, type]) => `${type} ${name}`)
  const includes = text.declarations ? [make.glsl(text.declarations)] : []
  return make.glslFn(`${type} ${name}(${given.join(', ')}) ${body}`, includes)
}

/** What this renderer cannot do, for a sentence; nothing where it can. */
export function obstacle(space: WarpSpace, object: Mesh): string | undefined {
  const { morphAttributes } = object.geometry
  const isSkinned = 'isSkinnedMesh' in object
  const isMorphed = Object.keys(morphAttributes ?? {}).length > 0
  if (space === 'rest' && (isSkinned || isMorphed))
    return "WebGPURenderer warps after morph targets and bones; use the space 'local' or 'world'"
  const isMany = 'isInstancedMesh' in object || 'isBatchedMesh' in object
  const isDisplaced = [object.material]
    .flat()
    .some((each) => (each as { displacementMap?: unknown }).displacementMap)
  if (space !== 'world' && isMany && (isSkinned || isMorphed || isDisplaced))
    return "WebGPURenderer cannot warp instances that have morph targets or a displacementMap before their matrices; use the space 'world'"
  return undefined
}
