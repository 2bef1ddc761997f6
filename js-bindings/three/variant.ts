/**
 * The material that WebGLRenderer draws a warped object with, in place of whatever material was chosen for it: a live view of that
 * material, with the warp in its shader.
 *
 * It has an id, listeners, and programs of its own. An inherited id would make three.js leave out the upload of uniforms between
 * two warps of one material (1,174 wrong pixels of 25,600); inherited listeners would make `dispose` call itself.
 */
import {
  Material,
  MathUtils,
  type WebGLProgramParametersWithUniforms,
  type WebGLRenderer,
} from 'three'
import { addedUniformsOf, type AddedUniforms } from './added-uniforms.js'
import { withNormalsAtVertices } from './exact-normals/at-vertices.js'
import { ForwardingMaterial } from './forwarding-material.js'
import { ShaderWeaver, type WovenSurface } from './shader-weaver.js'
import type { ThreeWarp } from './three-warp.js'

type Shader = WebGLProgramParametersWithUniforms

// Ids are negative, so that no other material has the same.
let lastId = 0

export class Variant extends ForwardingMaterial {
  readonly isWarpVariant = true
  readonly id = --lastId
  readonly uuid = MathUtils.generateUUID()
  /** The listeners of `EventDispatcher`. */
  _listeners: object | undefined = undefined
  /** The uniforms that the material's `onBeforeCompile` adds, which all variants of the material share. */
  added: AddedUniforms | undefined = undefined
  /** The number of times that the material was compiled. */
  compilations = 0
  private readonly weaver: ShaderWeaver
  private readonly onOriginalDispose: () => void

  constructor(original: Material, warp: ThreeWarp, surface: WovenSurface) {
    super(original)
    this.weaver = new ShaderWeaver(warp, surface)
    // The material may outlive the warp, and must not keep it in memory.
    const self = new WeakRef(this)
    this.onOriginalDispose = () => self.deref()?.freePrograms()
    original.addEventListener('dispose', this.onOriginalDispose)
  }

  onBeforeCompile(shader: Shader, renderer: WebGLRenderer) {
    const { original } = this
    this.compilations++
    const before = new Set(Object.keys(shader.uniforms))
    withNormalsAtVertices(() => original.onBeforeCompile(shader, renderer))
    if (original.isShaderMaterial) {
      // The uniforms are the user's own object. As a prototype it stays live, and we add nothing to it.
      shader.uniforms = Object.create(shader.uniforms) as Shader['uniforms']
    } else {
      const added = Object.keys(shader.uniforms).filter((name) => !before.has(name))
      if (added.length) this.added = addedUniformsOf(original)
      this.added?.record(added, shader.uniforms, original, renderer)
    }
    this.weaver.weave(shader, original, renderer)
  }

  customProgramCacheKey() {
    return `${this.weaver.key} ${withNormalsAtVertices(() => this.original.customProgramCacheKey())}`
  }

  /** Copies the original material. */
  clone() {
    return this.original.clone()
  }

  /** Frees the programs. The variant can be drawn again, with new ones. */
  freePrograms() {
    ;(this as unknown as Material).dispatchEvent({ type: 'dispose' })
  }

  dispose() {
    this.original.removeEventListener('dispose', this.onOriginalDispose)
    this.freePrograms()
  }
}

// These are defined, since assigned properties would be forwarded to the original material.
for (const name of [
  'addEventListener',
  'removeEventListener',
  'hasEventListener',
  'dispatchEvent',
] as const)
  Object.defineProperty(Variant.prototype, name, { value: Material.prototype[name] })
