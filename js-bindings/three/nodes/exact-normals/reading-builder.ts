/**
 * A node builder of three.js that writes the code of one node without the rest of a shader. The backend makes this builder, so that the
 * builder writes the same code as in the shader. We name the values that the code reads from outside, such as uniforms and attributes of
 * instances, and record the node of each name: the real shader passes that node's value.
 */
import type { Texture } from 'three'
import { WarpError } from '../../../errors/errors.js'
import type { Builder } from '../builder.js'
import { tsl, type AnyNode } from '../tsl.js'

/** A value from outside that the code of a node reads by a name. */
export interface OuterValue {
  type: string
  node: AnyNode
  /** Present for an array. */
  array?: { elementType: string; count: number | undefined; isStorage: boolean }
}

/** The code that three.js writes for a node: statements, the declarations of their variables, and an expression for the result. */
interface Flow {
  code: string
  vars: string
  result: string
}

/** The part of three's NodeBuilder that reading a node needs. */
export interface ReadingBuilder extends Builder {
  codes: { vertex?: { code: string }[] }
  hasGeometryAttribute(name: string): boolean
  varyings: { name: string; type: string }[]
  nodes: Iterable<ReadNode>
  scene: unknown
  camera: unknown
  setShaderStage(stage: string): void
  flowStagesNode(node: AnyNode, type: string): Flow
  getType(type: string): string
  addNode(node: ReadNode): void
  addSequentialNode(node: ReadNode): void
  format(snippet: string, from: string, to: string | null): string
  getPropertyName(node: unknown, stage?: string): string
  getVaryingFromNode(node: unknown, ...others: unknown[]): unknown
  getVarFromNode(node: unknown, ...others: unknown[]): unknown
}

/** The parts of three's nodes that we use. */
export interface ReadNode extends AnyNode {
  isStorageArrayElementNode?: boolean
  isArrayBufferElementNode?: boolean
  isAssignNode?: boolean
  /** The function that a node of mathematics calls. */
  method?: string | null
  isUniformGroup?: boolean
  isBufferNode?: boolean
  isTextureNode?: boolean
  instanced?: boolean
  value?: {
    isInstancedBufferAttribute?: boolean
    data?: { isInstancedInterleavedBuffer?: boolean }
  }
  attribute?: ReadNode['value']
  bufferType?: string
  bufferCount?: number
  indexNode?: AnyNode
  targetNode?: ReadNode
  node?: ReadNode
  updateType?: string
  updateBeforeType?: string
  updateAfterType?: string
  getNodeType(builder: unknown): string
  getPaddedType?(builder: unknown): string
  setup(builder: unknown): unknown
  generate(builder: unknown, output: string | null): string
}

/** The attributes that differentiation knows, with the names of an offset's inputs. */
export const knownAttributes = new Set(['position', 'normal', 'uv'])

/** The start of our names in the code. */
const prefix = 'warpjetOuter'

export class NodeReading {
  readonly values = new Map<string, OuterValue>()
  /** Textures by name. */
  readonly textures = new Map<string, { value: Texture }>()
  readonly builder: ReadingBuilder
  /** Maps nodes → their variables in the source. */
  readonly variables = new Map<unknown, unknown>()
  private readonly names = new Map<unknown, string>()
  private readonly patched: ReadNode[] = []

  constructor(
    private readonly place: string,
    builder: ReadingBuilder,
  ) {
    this.builder = builder
    builder.setShaderStage('vertex')
    Object.assign(builder, this.methods(builder))
  }

  /** Writes the code of the node. */
  read(node: AnyNode): Flow {
    try {
      return this.builder.flowStagesNode(node, 'vec3')
    } finally {
      for (const each of this.patched) {
        delete (each as Partial<ReadNode>).setup
        delete (each as Partial<ReadNode>).generate
      }
    }
  }

  private nameFor(key: unknown, value: () => OuterValue): string {
    let name = this.names.get(key)
    if (!name) {
      name = `${prefix}${this.names.size}`
      this.names.set(key, name)
      this.values.set(name, value())
    }
    return name
  }

  private nameForTexture(node: ReadNode): string {
    let name = this.names.get(node)
    if (!name) {
      name = `${prefix}${this.names.size}`
      this.names.set(node, name)
      this.textures.set(name, node as unknown as { value: Texture })
    }
    return name
  }

  /** Returns replacements for the methods of the builder by which nodes read values from outside. */
  private methods(builder: ReadingBuilder) {
    const { addNode, getPropertyName, getVaryingFromNode, getVarFromNode } = builder
    const record =
      (method: (node: unknown, ...others: unknown[]) => unknown) =>
      (node: unknown, ...others: unknown[]) => {
        const variable = method.call(builder, node, ...others)
        this.variables.set(node, variable)
        return variable
      }
    const isWebGPU = builder.renderer.backend.isWebGPUBackend === true
    const sample = (name: string, uv: string) =>
      isWebGPU
        ? `textureSampleLevel( ${name}, ${name}_sampler, ${uv}, 0.0 )`
        : `texture( ${name}, ${uv} )`
    return {
      getVaryingFromNode: record(getVaryingFromNode),
      getVarFromNode: record(getVarFromNode),
      getAttribute: (name: string, type: string) => ({
        name: knownAttributes.has(name) ? name : this.attribute(name, type),
        type,
      }),
      getBufferAttributeFromNode: (node: ReadNode, type: string) => ({
        name: this.bufferAttribute(node, type),
        type,
      }),
      getUniformFromNode: (node: ReadNode, type: string) => ({
        isNodeUniform: true,
        node,
        type,
        name: node.isTextureNode ? this.nameForTexture(node) : this.uniform(node, type),
      }),
      getPropertyName(node: {
        isNodeUniform?: boolean
        isNodeVarying?: boolean
        name: string
        type: string
      }) {
        if (node.isNodeVarying) return node.name
        if (!node.isNodeUniform) return getPropertyName.call(builder, node)
        return isWebGPU && /buffer/i.test(node.type) ? `${node.name}.value` : node.name
      },
      getInstanceIndex: () =>
        this.nameFor('instanceIndex', () => ({ type: 'uint', node: tsl.instanceIndex })),
      getVertexIndex: () => {
        throw this.perVertexError('vertexIndex')
      },
      getDrawIndex: () => this.nameFor('drawIndex', () => ({ type: 'uint', node: tsl.drawIndex })),
      generateTexture: (_: Texture, name: string, uv: string, depth?: string, offset?: string) =>
        this.checkTextureRead('0', depth, offset) && sample(name, uv),
      generateTextureLevel: (
        _: Texture,
        name: string,
        uv: string,
        level: string,
        depth?: string,
        offset?: string,
      ) => this.checkTextureRead(level, depth, offset) && sample(name, uv),
      addNode: (node: ReadNode) => {
        if (node.isStorageArrayElementNode || node.isArrayBufferElementNode) this.patchElement(node)
        addNode.call(builder, node)
      },
    }
  }

  /** Throws if a texture is read in a way that `sample` does not support. */
  private checkTextureRead(
    level: string,
    depth: string | undefined,
    offset: string | undefined,
  ): true {
    const isZero = /^(?:\w+\(\s*)?0(?:\.0*)?[uif]?\s*\)?$/.test(level.trim())
    const found = !isZero ? 'a mip level' : depth ? 'a layer' : offset ? 'an offset' : undefined
    if (found)
      throw new WarpError(
        `${this.place}: the position reads ${found} of a texture; expected texture( map, uv ) at level 0.`,
      )
    return true
  }

  /** Returns the error about a value that differs by vertex and therefore has no derivative with respect to the position. */
  private perVertexError(what: string): WarpError {
    return new WarpError(
      `${this.place}: the position depends on ${what}, which differs from vertex to vertex in a way that has no derivative; expected a function of position, normal, uv, uniforms and what is constant in an instance.`,
    )
  }

  private attribute(name: string, type: string): string {
    const { geometry } = this.builder
    const attribute = geometry.getAttribute(name) as ReadNode['value']
    if (!isInstanced(attribute)) throw this.perVertexError(`the attribute "${name}"`)
    return this.nameFor(`attribute ${name}`, () => ({ type, node: tsl.attribute(name, type) }))
  }

  private bufferAttribute(node: ReadNode, type: string): string {
    if (!node.instanced && !isInstanced(node.value) && !isInstanced(node.attribute))
      throw this.perVertexError('an attribute made by a node')
    return this.nameFor(node, () => ({ type, node }))
  }

  private uniform(node: ReadNode, type: string): string {
    return this.nameFor(node, () => {
      if (!node.isBufferNode) return { type: type === 'color' ? 'vec3' : type, node }
      const elementType = node.getPaddedType?.(this.builder) ?? node.bufferType!
      const isStorage = /storage/i.test(type)
      return { type, node, array: { elementType, count: node.bufferCount, isStorage } }
    })
  }

  /**
   * Makes the code read an element of a buffer as one value from outside if its index comes from outside, too. If a loop counts the
   * index, the element stays an element of the array. `read` restores the methods of the node.
   */
  private patchElement(node: ReadNode) {
    if (this.patched.includes(node)) return
    this.patched.push(node)
    const plain = Object.getPrototypeOf(Object.getPrototypeOf(node)) as ReadNode
    const { generate } = node
    node.setup = (builder) => plain.setup.call(node, builder)
    node.generate = (builder, output) => {
      const index = node.indexNode!.build(builder, 'uint')
      if (!this.isOuter(index)) return generate.call(node, builder, output)
      const type = node.getNodeType(builder)
      const name = this.nameFor(node, () => ({ type, node }))
      return this.builder.format(name, type, output)
    }
  }

  /** Tests whether an expression reads only values from outside. */
  private isOuter(expression: string): boolean {
    const words = expression.match(/\b[a-z_]\w*/gi) ?? []
    return words.every(
      (word) => this.values.has(word) || /^(?:[uif]32|u?int|float|fn\d+)$/.test(word),
    )
  }
}

const isInstanced = (attribute: ReadNode['value']) =>
  attribute?.isInstancedBufferAttribute === true ||
  attribute?.data?.isInstancedInterleavedBuffer === true
