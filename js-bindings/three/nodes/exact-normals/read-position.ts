// Reads a positionNode as source: as a function of the vertex in the GLSL or WGSL that three.js writes for the node.
import type { Texture } from 'three'
import { WarpError } from '../../../errors/errors.js'
import type { SourceLanguage } from '../../../glsl-source/options.js'
import type { Builder } from '../builder.js'
import { tsl, type AnyNode } from '../tsl.js'
import {
  NodeReading,
  type OuterValue,
  type ReadNode,
  type ReadingBuilder,
} from './reading-builder.js'

/** The vertex from which the position is computed: as three.js has posed it, as it is in the geometry, or both. */
export type Base = 'posed' | 'geometry' | 'both'

export interface PositionSource {
  language: SourceLanguage
  /** Source of a function that returns the new position. */
  text: string
  /**
   * Source of a function that returns a mat4 of the position and the numbers of `effects`; `undefined` if there are no effects, or too
   * many.
   */
  textWithEffects: string | undefined
  /** The functions that both texts contain and call. Three.js writes them in another order when it first builds a node. */
  functions: readonly string[]
  /** Maps names in the source → values that the shader passes. */
  values: ReadonlyMap<string, OuterValue>
  /** Maps names in the source → nodes of textures. */
  textures: ReadonlyMap<string, { value: Texture }>
  base: Base
  /** Nodes whose values three.js updates. */
  updated: readonly ReadNode[]
  /** Varyings and other variables that the code assigns, and that other code of the shader can read later. */
  effects: readonly Effect[]
}

/** A variable that the code of a position assigns. */
export interface Effect {
  node: AnyNode
  /** Its name in the source and the number of its components; `undefined` for a type that is not of floats. */
  variable: { name: string; size: number } | undefined
}

export const functionName = 'warpjetMoved'

/** Makes a builder for the same object and renderer as another. */
export function siblingOf(builder: Builder): ReadingBuilder {
  const original = builder as ReadingBuilder & Record<string, unknown>
  const sibling = original.renderer.backend.createNodeBuilder!(
    original.object,
    original.renderer,
  ) as ReadingBuilder
  const names = [
    'scene',
    'material',
    'camera',
    'lightsNode',
    'environmentNode',
    'fogNode',
    'clippingContext',
  ]
  Object.assign(sibling, Object.fromEntries(names.map((name) => [name, original[name]])))
  sibling.context = { ...original.context }
  return sibling
}

/** Returns the number of components of effects; `undefined` if a function cannot return them. */
export function sizeOfEffects(effects: readonly Effect[]): number | undefined {
  return effects.every(({ variable }) => variable)
    ? effects.reduce((sum, { variable }) => sum + variable!.size, 0)
    : undefined
}

/** Reads a node. `place` begins messages. */
export function readPosition(
  place: string,
  builder: ReadingBuilder,
  node: AnyNode,
): PositionSource {
  const reading = new NodeReading(place, builder)
  const flow = flowOf(place, reading, node)
  const isWebGPU = builder.renderer.backend.isWebGPUBackend === true
  const nodes = [...builder.nodes]
  rejectFragmentNodes(place, nodes)
  const parts: Parts = {
    ...flow,
    returned: 'vec3',
    functions: (builder.codes.vertex ?? []).map(({ code }) => code),
    varyings: builder.varyings,
    type: (type) => builder.getType(type),
    reading,
  }
  const effects = effectsOf(reading, nodes)
  const size = sizeOfEffects(effects) ?? 0
  const write = (changed: Partial<Parts> = {}) =>
    writeSource(isWebGPU ? wgsl : glsl, { ...parts, ...changed })
  const canReturn = size > 0 && size <= maxSize
  return {
    language: isWebGPU ? 'wgsl' : 'glsl',
    text: write(),
    textWithEffects: canReturn ? write(returnMatrix(flow, effects, isWebGPU)) : undefined,
    functions: parts.functions,
    values: reading.values,
    textures: reading.textures,
    base: baseOf(parts),
    updated: nodes.filter(isUpdated),
    effects,
  }
}

function flowOf(place: string, reading: NodeReading, node: AnyNode) {
  try {
    return reading.read(tsl.subBuild(node, 'POSITION', 'vec3'))
  } catch (error) {
    if (error instanceof WarpError) throw error
    throw new WarpError(
      `${place}: three.js cannot write the code of the position: ${(error as Error).message}`,
    )
  }
}

/** Throws for nodes that three.js leaves out in the vertex stage. */
function rejectFragmentNodes(place: string, nodes: readonly ReadNode[]) {
  const found = nodes.find(({ method }) => /^(?:dFd[xy]|fwidth)$/.test(method ?? ''))
  if (found)
    throw new WarpError(
      `${place}: the position depends on ${found.method}(), which exists in the fragment stage only; expected a function of position, normal, uv and uniforms.`,
    )
}

interface Parts {
  code: string
  vars: string
  /** The type of the result. */
  returned: string
  result: string
  functions: string[]
  varyings: { name: string; type: string }[]
  type: (type: string) => string
  reading: NodeReading
}

type Value = NodeReading['values'] extends ReadonlyMap<string, infer One> ? One : never

/** Writers of the declarations in one language: of the function, and of the values that it reads. */
interface Syntax {
  inputs: readonly string[]
  declareValue: (name: string, value: Value, type: Parts['type']) => string
  declareTexture: (name: string) => string
  declareVarying: (name: string, type: string) => string
  head: (returned: string) => string
}

const glsl: Syntax = {
  inputs: ['in vec3 position;', 'in vec3 normal;', 'in vec2 uv;'],
  declareValue: (name, { array, type: valueType }, type) =>
    array
      ? `uniform ${type(array.elementType)} ${name}[${array.count}];`
      : `uniform ${type(valueType)} ${name};`,
  declareTexture: (name) => `uniform sampler2D ${name};`,
  declareVarying: (name, type) => `${type} ${name};`,
  head: (returned) => `${returned} ${functionName}()`,
}

const wgsl: Syntax = {
  inputs: [],
  declareValue(name, { array, type: valueType }, type) {
    if (!array) return `var<uniform> ${name} : ${type(valueType)};`
    const { elementType, count, isStorage } = array
    const list = `array<${type(elementType)}${isStorage ? '' : `, ${count}`}>`
    const space = isStorage ? 'storage, read' : 'uniform'
    return `struct ${name}Struct { value : ${list} }\nvar<${space}> ${name} : ${name}Struct;`
  },
  declareTexture: (name) => `var ${name} : texture_2d<f32>;\nvar ${name}_sampler : sampler;`,
  declareVarying: (name, type) => `var<private> ${name} : ${type};`,
  head: (returned) =>
    `fn ${functionName}( position : vec3<f32>, normal : vec3<f32>, uv : vec2<f32> ) -> ${returned}`,
}

function writeSource(
  syntax: Syntax,
  { code, vars, returned, result, functions, varyings, type, reading }: Parts,
): string {
  return [
    ...syntax.inputs,
    ...[...reading.values].map(([name, value]) => syntax.declareValue(name, value, type)),
    ...[...reading.textures.keys()].map(syntax.declareTexture),
    ...varyings.map((each) => syntax.declareVarying(each.name, type(each.type))),
    ...functions,
    `${syntax.head(type(returned))} {\n${vars}\n${code}\nreturn ${result};\n}`,
  ].join('\n')
}

/** Matches the statements by which three.js copies the vertex from the geometry. */
const copyFromGeometry = /\b(?:position|normal)(?:Local|Previous) = (?:position|normal);/g

function baseOf({ code, result, functions }: Parts): Base {
  const text = [
    code.replace(copyFromGeometry, ''),
    result,
    ...functions.map((each) => each.replace(copyFromGeometry, '')),
  ].join('\n')
  const readsPosed = /(?<!\.)\b(?:position|normal)Local\b/.test(text)
  const readsGeometry = /(?<!\.)\b(?:position|normal)\b/.test(text)
  if (readsGeometry) return readsPosed ? 'both' : 'geometry'
  return 'posed'
}

const isUpdated = ({ isUniformGroup, updateType, updateBeforeType, updateAfterType }: ReadNode) =>
  !isUniformGroup &&
  [updateType, updateBeforeType, updateAfterType].some((each) => each && each !== 'none')

/** Tests for the variable of three.js that we assign ourselves. */
const isAssignedByUs = ({ name }: Target) => name === 'positionLocal'

type Target = ReadNode & {
  isVaryingNode?: boolean
  isPropertyNode?: boolean
  isParameterNode?: boolean
  varying?: boolean
  name?: string | null
}

/**
 * Returns the variable that a node assigns and that others can read later; `undefined` if it assigns none, or a local one: a variable made
 * by `toVar()`, or a parameter of a function. Three.js writes the code of a function once for each renderer, so its body has nodes only in
 * the first source that calls it.
 */
function assignedBy(node: ReadNode): Target | undefined {
  if (!node.isAssignNode) return undefined
  const target = node.targetNode!.getScope() as Target
  if (isAssignedByUs(target)) return undefined
  if (target.isVaryingNode) return target
  const isOuter = target.isPropertyNode && !target.isParameterNode
  return isOuter && (target.varying || target.name) ? target : undefined
}

const sizes: Record<string, number> = { float: 1, vec2: 2, vec3: 3, color: 3, vec4: 4 }

function effectsOf({ builder, variables }: NodeReading, nodes: readonly ReadNode[]): Effect[] {
  const assigned = new Set(nodes.map(assignedBy).filter((each) => each !== undefined))
  return Array.from(assigned, (node) => {
    const variable = variables.get(node)
    const size = sizes[node.getNodeType(builder)]
    const name = variable ? builder.getPropertyName(variable) : undefined
    return { node, variable: name && size ? { name, size } : undefined }
  })
}

/** The number of components of a mat4 that the position leaves free. */
const maxSize = 13

/** Returns code whose result is a mat4 of the position and the components of effects. */
function returnMatrix(
  { code, result }: Pick<Parts, 'code' | 'result'>,
  effects: readonly Effect[],
  isWebGPU: boolean,
): Partial<Parts> {
  const moved = 'warpjetResult'
  const values = [{ name: moved, size: 3 }, ...effects.map(({ variable }) => variable!)]
  const numbers = values.flatMap(({ name, size }) =>
    size === 1 ? [name] : Array.from('xyzw'.slice(0, size), (each) => `${name}.${each}`),
  )
  const zeros = Array<string>(16 - numbers.length).fill('0.0')
  return {
    code: `${code}\n${isWebGPU ? 'let' : 'vec3'} ${moved} = ${result};`,
    returned: 'mat4',
    result: `${isWebGPU ? 'mat4x4<f32>' : 'mat4'}( ${[...numbers, ...zeros].join(', ')} )`,
  }
}
