/**
 * Shares the uniforms that a material's `onBeforeCompile` adds. That function adds new uniform objects for each program, and user code
 * that stores the shader (`material.userData.shader = shader`) sets only those of the program that was compiled last. A material and its
 * variants are separate programs, so we give all of these programs the newest objects.
 */
import type { IUniform, Material, WebGLRenderer } from 'three'

type Uniforms = Record<string, IUniform>

const addedUniforms = new WeakMap<Material, AddedUniforms>()

export function addedUniformsOf(material: Material): AddedUniforms {
  let added = addedUniforms.get(material)
  if (!added) addedUniforms.set(material, (added = new AddedUniforms()))
  return added
}

export class AddedUniforms {
  private readonly names = new Set<string>()
  private newest: Uniforms | undefined
  private originalUniforms: Uniforms | undefined

  /** Records the uniforms with which a variant of `original` was just compiled. */
  record(names: string[], uniforms: Uniforms, original: Material, renderer: WebGLRenderer) {
    for (const name of names) this.names.add(name)
    this.newest = uniforms
    this.originalUniforms = uniformsOf(original, renderer)
  }

  /** Gives the material and its variant the newest uniforms. */
  share(original: Material, variant: Material, renderer: WebGLRenderer) {
    const [originalUniforms, variantUniforms] = [original, variant].map((each) =>
      uniformsOf(each, renderer),
    )
    // The material itself was compiled after the variant, for another mesh.
    if (originalUniforms && originalUniforms !== this.originalUniforms)
      this.newest = originalUniforms
    this.originalUniforms = originalUniforms
    for (const uniforms of [originalUniforms, variantUniforms]) {
      if (!uniforms || !this.newest || uniforms === this.newest) continue
      for (const name of this.names) if (this.newest[name]) uniforms[name] = this.newest[name]
    }
  }
}

const uniformsOf = (material: Material, renderer: WebGLRenderer): Uniforms | undefined =>
  (renderer.properties.get(material) as { uniforms?: Uniforms }).uniforms
