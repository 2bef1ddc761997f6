/**
 * Uniforms that a material's `onBeforeCompile` adds are other objects for each program, and whoever keeps the shader
 * (`material.userData.shader = shader`) has those of the program that was compiled last. Since a material and its variants compile
 * one by one, they are given the same objects, the last ones.
 */
import type { IUniform, Material, WebGLRenderer } from 'three'

type Uniforms = Record<string, IUniform>

const known = new WeakMap<Material, AddedUniforms>()

export function addedUniformsOf(material: Material): AddedUniforms {
  let added = known.get(material)
  if (!added) known.set(material, (added = new AddedUniforms()))
  return added
}

export class AddedUniforms {
  private readonly names = new Set<string>()
  private newest: Uniforms | undefined
  private ofOriginal: Uniforms | undefined

  /** Notes what a variant of `original` has just compiled with. */
  note(names: string[], uniforms: Uniforms, original: Material, renderer: WebGLRenderer) {
    for (const name of names) this.names.add(name)
    this.newest = uniforms
    this.ofOriginal = uniformsOf(original, renderer)
  }

  /** Gives the material and its variant the newest uniforms. */
  tie(original: Material, variant: Material, renderer: WebGLRenderer) {
    const [ofOriginal, ofVariant] = [original, variant].map((each) => uniformsOf(each, renderer))
    // The material itself has compiled since, on another mesh.
    if (ofOriginal && ofOriginal !== this.ofOriginal) this.newest = ofOriginal
    this.ofOriginal = ofOriginal
    for (const uniforms of [ofOriginal, ofVariant]) {
      if (!uniforms || !this.newest || uniforms === this.newest) continue
      for (const name of this.names) if (this.newest[name]) uniforms[name] = this.newest[name]
    }
  }
}

const uniformsOf = (material: Material, renderer: WebGLRenderer): Uniforms | undefined =>
  (renderer.properties.get(material) as { uniforms?: Uniforms }).uniforms
