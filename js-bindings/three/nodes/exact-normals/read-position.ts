// Reads a positionNode as source: a function of the vertex in GLSL or WGSL, whatever three.js writes for the node.
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

/** The vertex that the position is a function of: as three.js has posed it, or as the geometry has it. */
export type Base = 'posed' | 'geometry' | 'both'

export interface PositionSource {
  language: SourceLanguage
  /** A function `name` that returns the new position. */
  text: string
  /** Maps names in the source → values that the shader passes. */
  values: ReadonlyMap<string, OuterValue>
  /** Maps names in the source → nodes of textures. */
  textures: ReadonlyMap<string, { value: Texture }>
  base: Base
  /** Nodes whose values three.js updates. */
  updated: readonly ReadNode[]
  /** `true` if the code assigns varyings or other variables that outlive it. */
  hasEffects: boolean
}

export const functionName = 'warpjetMoved'

/** The max number of iterations of a loop whose end depends on a uniform, as in p5's `exactNormals`. */
export const maxIterations = 256

/** Makes a builder for the same object and renderer as another. */
export function siblingOf(builder: Builder): ReadingBuilder {
  const given = builder as ReadingBuilder & Record<string, unknown>
  const made = given.renderer.backend.createNodeBuilder!(
    given.object,
    given.renderer,
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
  Object.assign(made, Object.fromEntries(names.map((name) => [name, given[name]])))
  made.context = { ...given.context }
  return made
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
    functions: (builder.codes.vertex ?? []).map(({ code }) => code),
    varyings: builder.varyings,
    type: (type) => builder.getType(type),
    reading,
  }
  return {
    language: isWebGPU ? 'wgsl' : 'glsl',
    text: isWebGPU ? wgslOf(parts) : glslOf(parts),
    values: reading.values,
    textures: reading.textures,
    base: baseOf(parts),
    updated: nodes.filter(isUpdated),
    hasEffects: nodes.some(isEffect),
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
  result: string
  functions: string[]
  varyings: { name: string; type: string }[]
  type: (type: string) => string
  reading: NodeReading
}

function glslOf({ code, vars, result, functions, varyings, type, reading }: Parts): string {
  return [
    'in vec3 position;\nin vec3 normal;\nin vec2 uv;',
    ...[...reading.values].map(([name, value]) =>
      value.array
        ? `uniform ${type(value.array.elementType)} ${name}[${value.array.count}];`
        : `uniform ${type(value.type)} ${name};`,
    ),
    ...[...reading.textures.keys()].map((name) => `uniform sampler2D ${name};`),
    ...varyings.map((each) => `${type(each.type)} ${each.name};`),
    ...functions,
    `vec3 ${functionName}() {\n${vars}\n${code}\nreturn ${result};\n}`,
  ].join('\n')
}

function wgslOf({ code, vars, result, functions, varyings, type, reading }: Parts): string {
  return [
    ...[...reading.values].map(([name, value]) => {
      if (!value.array) return `var<uniform> ${name} : ${type(value.type)};`
      const { elementType, count, isStorage } = value.array
      const list = `array<${type(elementType)}${isStorage ? '' : `, ${count}`}>`
      const space = isStorage ? 'storage, read' : 'uniform'
      return `struct ${name}Struct { value : ${list} }\nvar<${space}> ${name} : ${name}Struct;`
    }),
    ...[...reading.textures.keys()].map(
      (name) => `var ${name} : texture_2d<f32>;\nvar ${name}_sampler : sampler;`,
    ),
    ...varyings.map((each) => `var<private> ${each.name} : ${type(each.type)};`),
    ...functions,
    `fn ${functionName}( position : vec3<f32>, normal : vec3<f32>, uv : vec2<f32> ) -> vec3<f32> {`,
    `${vars}\n${code}\nreturn ${result};\n}`,
  ].join('\n')
}

/** The statements by which three.js takes the vertex over from the geometry. */
const takeOver = /\b(?:position|normal)(?:Local|Previous) = (?:position|normal);/g

function baseOf({ code, result, functions }: Parts): Base {
  const text = [
    code.replace(takeOver, ''),
    result,
    ...functions.map((each) => each.replace(takeOver, '')),
  ].join('\n')
  const readsPosed = /(?<!\.)\b(?:position|normal)Local\b/.test(text)
  const readsGeometry = /(?<!\.)\b(?:position|normal)\b/.test(text)
  if (readsGeometry) return readsPosed ? 'both' : 'geometry'
  return 'posed'
}

const isUpdated = ({ isUniformGroup, updateType, updateBeforeType, updateAfterType }: ReadNode) =>
  !isUniformGroup &&
  [updateType, updateBeforeType, updateAfterType].some((each) => each && each !== 'none')

/** The variable of three.js that we assign ourselves. */
const isOwn = ({ name }: Target) => name === 'positionLocal'

type Target = ReadNode & {
  isVaryingNode?: boolean
  isPropertyNode?: boolean
  varying?: boolean
  name?: string | null
}

/** Tests whether a node assigns a variable that others can read later. */
function isEffect(node: ReadNode): boolean {
  if (!node.isAssignNode) return false
  let target = node.targetNode as Target | undefined
  while (target && !target.isVaryingNode && !target.isPropertyNode) target = target.node as Target
  if (!target || isOwn(target)) return false
  return target.isVaryingNode === true || target.varying === true || !!target.name
}
