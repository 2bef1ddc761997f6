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

// Negative, so that no other material has them.
let lastId = 0

export class Variant extends ForwardingMaterial {
  readonly isWarpVariant = true
  readonly id = --lastId
  readonly uuid = MathUtils.generateUUID()
  /** The listeners of `EventDispatcher`. */
  _listeners: object | undefined = undefined
  /** The uniforms that the material's `onBeforeCompile` adds, which all variants of the material have in common. */
  added: AddedUniforms | undefined = undefined
  /** The number of programs that it has been compiled for. */
  compilations = 0
  private readonly weaver: ShaderWeaver
  private readonly onOriginalDispose: () => void

  constructor(original: Material, warp: ThreeWarp, surface: WovenSurface) {
    super(original)
    this.weaver = new ShaderWeaver(warp, surface)
    // The material may outlive the warp, and must not keep it.
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
      // These are the user's own uniforms: this way they stay live, and ours are not added to them.
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

  /** Frees its programs. It can be drawn again. */
  freePrograms() {
    ;(this as unknown as Material).dispatchEvent({ type: 'dispose' })
  }

  dispose() {
    this.original.removeEventListener('dispose', this.onOriginalDispose)
    this.freePrograms()
  }
}

// Assigned properties would be forwarded.
for (const name of [
  'addEventListener',
  'removeEventListener',
  'hasEventListener',
  'dispatchEvent',
] as const)
  Object.defineProperty(Variant.prototype, name, { value: Material.prototype[name] })
