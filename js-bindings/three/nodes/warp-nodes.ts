// The functions and uniforms of a warp as nodes, made once.
import type { Stage, ThreeWarp } from '../three-warp.js'
import { functionFor } from './function.js'
import type { Call } from './tsl.js'
import { previousUniformsOf, uniformsOf, type NodesByName } from './uniforms.js'

/** The nodes of a warp, shared by all shaders that it is in. */
export class WarpNodes {
  readonly uniforms: NodesByName
  private readonly functions = new Map<string, Call>()
  private previous: NodesByName | undefined

  constructor(private readonly warp: ThreeWarp) {
    this.uniforms = uniformsOf(warp)
  }

  get previousUniforms(): NodesByName {
    return (this.previous ??= { ...this.uniforms, ...previousUniformsOf(this.warp) })
  }

  call(stage: Stage, isWebGPU: boolean): Call {
    const key = `${isWebGPU} ${stage}`
    if (!this.functions.has(key)) this.functions.set(key, functionFor(this.warp, stage, isWebGPU))
    return this.functions.get(key)!
  }
}

const nodesByWarp = new WeakMap<ThreeWarp, WarpNodes>()

export function nodesOf(warp: ThreeWarp): WarpNodes {
  let nodes = nodesByWarp.get(warp)
  if (!nodes) nodesByWarp.set(warp, (nodes = new WarpNodes(warp)))
  return nodes
}
