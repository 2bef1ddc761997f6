// `warpMaterial`: warps a material, and makes the materials that draw its shadows.
import { MeshDepthMaterial, MeshDistanceMaterial, RGBADepthPacking, type Material } from 'three'
import { WarpError, describe } from '../errors/errors.js'
import { describeOfThree, nameOfMaterial } from './describe.js'
import { readOptions, type ThreeOffset, type WarpOptions, type WarpSpace } from './settings.js'
import { ShaderWeaver, type WovenSurface } from './shader-weaver.js'
import { isWarpedMaterial, markWarped, unsupportedMaterial } from './supported.js'
import { ThreeWarp } from './three-warp.js'
import type { ThreeUniforms, UniformHandles, ValuesOf } from './uniforms.js'
import { Variant } from './variant.js'

/** The common part of a warped material and a warped object. */
export interface Warped<Uniforms = {}> {
  /** The uniforms, to be set as in three.js: `warped.uniforms.amount.value = 2`. */
  readonly uniforms: UniformHandles<Uniforms>
  /** The stage that computes normals: the option `normals`, with `'auto'` resolved. */
  readonly normals: 'vertex' | 'pixel'
  /** Sets `millis`, which the offset may read: `renderer.setAnimationLoop((time) => warped.update(time))`. */
  update(millis?: number): void
  /** Frees everything that was created for the warp, and restores everything that it changed. */
  dispose(): void
}

export interface WarpedMaterial<
  Kind extends Material = Material,
  Uniforms = {},
> extends Warped<Uniforms> {
  /** A warped live view of the material, with the same properties; with `share: true`, the material itself. */
  readonly material: Kind
  /** For the mesh's property of the same name: draws shadows of directional and spot lights. */
  readonly customDepthMaterial: Material
  /** For the mesh's property of the same name: draws shadows of point lights. */
  readonly customDistanceMaterial: Material
}

/**
 * Warps a material, for WebGLRenderer. The results `material`, `customDepthMaterial` and `customDistanceMaterial` are for the
 * mesh's properties with these names. `warp` does more: culling, rays, and passes that replace the material. Any material of three.js
 * that draws the vertices of a geometry can be warped, also one with an `onBeforeCompile`, which is called first.
 *
 * Throws a `WarpError` for any other material.
 */
export function warpMaterial<Kind extends Material, const Uniforms extends ThreeUniforms = {}>(
  material: Kind,
  offset: ThreeOffset<ValuesOf<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpedMaterial<Kind, ValuesOf<Uniforms>> {
  const method = 'warpMaterial'
  const settings = readOptions(method, options)
  checkMaterial(method, material, settings.space)
  const warp = new ThreeWarp(offset as never, settings)
  const surface = {
    material,
    hasColors: material.vertexColors && warp.reads('color'),
    name: nameOfMaterial(material),
  }
  const depth = new MeshDepthMaterial({ depthPacking: RGBADepthPacking })
  const releases = settings.isShared ? [weaveInto(material, warp, surface)] : []
  const makeView = (original: Material) => {
    const variant = new Variant(original, warp, surface)
    const view = variant as unknown as Material
    markWarped(view, true)
    releases.push(() => variant.dispose())
    return view
  }
  return {
    material: (settings.isShared ? material : makeView(material)) as Kind,
    customDepthMaterial: makeView(depth),
    customDistanceMaterial: makeView(new MeshDistanceMaterial()),
    uniforms: warp.handles as never,
    normals: warp.normals,
    update: updateOf(warp),
    dispose() {
      for (const release of releases.splice(0)) release()
    },
  }
}

/** Adds the warp to the material itself; the returned function removes the warp. */
function weaveInto(material: Material, warp: ThreeWarp, surface: WovenSurface): () => void {
  const weaver = new ShaderWeaver(warp, surface)
  const before = ['onBeforeCompile', 'customProgramCacheKey'].map(
    (name) => [name, Object.getOwnPropertyDescriptor(material, name)] as const,
  )
  const { onBeforeCompile, customProgramCacheKey } = material
  material.onBeforeCompile = function (shader, renderer) {
    onBeforeCompile.call(this, shader, renderer)
    weaver.weave(shader, material, renderer)
  }
  material.customProgramCacheKey = function () {
    return `${weaver.key} ${customProgramCacheKey.call(this)}`
  }
  material.needsUpdate = true
  markWarped(material, true)
  return () => {
    for (const [name, property] of before)
      if (property) Object.defineProperty(material, name, property)
      else Reflect.deleteProperty(material, name)
    material.needsUpdate = true
    markWarped(material, false)
  }
}

export const updateOf =
  ({ settings, millis }: ThreeWarp) =>
  (time: number = performance.now()) => {
    if (!Number.isFinite(time))
      throw new WarpError(
        `${settings.method}: expected milliseconds for update, such as the time that setAnimationLoop passes, got ${describe(time)}.`,
      )
    millis.value = time
  }

/** Throws for anything that WebGLRenderer cannot draw warped. */
export function checkMaterial(
  method: string,
  material: unknown,
  space?: WarpSpace,
): asserts material is Material {
  if (!(material as Partial<Material> | undefined)?.isMaterial)
    throw new WarpError(
      `${method}: expected a material of three.js, got ${describeOfThree(material)}.`,
    )
  const problem = unsupportedMaterial(material as Material, space)
  if (problem)
    throw new WarpError(
      `${method}: ${nameOfMaterial(material as Material)} cannot be warped: ${problem}.`,
    )
}

/** Throws for a material that `warpMaterial` has warped: a shader with two warps would not compile. */
export function checkUnwarped(method: string, material: Material) {
  if (isWarpedMaterial(material)) checkMaterial(method, material)
}

export { markWarped as mark } from './supported.js'
