// `warpMaterial`: a material whose vertices a warp moves, and those that draw its shadows.
import {
  type Material,
  MeshDepthMaterial,
  MeshDistanceMaterial,
  RGBADepthPacking,
  type WebGLProgramParametersWithUniforms,
  type WebGLRenderer,
} from 'three'
import { WarpError, describe } from '../errors/errors.js'
import { millisUniform, orientationName } from '../compile/host-names.js'
import { describeOfThree, spriteError } from './describe.js'
import { orientFaces } from './faces.js'
import { type ThreeWarp, keep } from './kept.js'
import { type ThreeOffset, type WarpOptions, readOptions } from './settings.js'
import type { ThreeUniforms, UniformHandles, ValuesOf } from './uniforms.js'
import { checkChunks, weave } from './weave.js'
import { fillOf } from './surface.js'

/** What a warped material and a warped object have. */
export interface Warped<Uniforms = {}> {
  /** As in three.js: `warped.uniforms.amount.value = 2`. */
  readonly uniforms: UniformHandles<Uniforms>
  /** Sets `millis`, which the offset may read: `renderer.setAnimationLoop((time) => warped.update(time))`. */
  update(millis?: number): void
  /** Frees what was made, and leaves everything as it was before. */
  dispose(): void
}

export interface WarpedMaterial<
  Kind extends Material = Material,
  Uniforms = {},
> extends Warped<Uniforms> {
  /** A clone of the material, warped; with `share: true` the material itself. */
  readonly material: Kind
  /** For the mesh's property of that name: shadows of directional and spot lights. */
  readonly customDepthMaterial: Material
  /** Likewise, of point lights. */
  readonly customDistanceMaterial: Material
}

/**
 * A material whose vertices a warp moves and whose normals it turns, for who places it by hand:
 * what it gives as `material`, `customDepthMaterial` and `customDistanceMaterial` goes to the mesh's properties of these names,
 * so that shadows follow too; that nothing visible is culled and that rays meet what is seen is done by `warp`. Takes every material of three.js that makes vertices from geometry, also one with an
 * `onBeforeCompile` of its own, which is called first. Throws a `WarpError` for any other.
 */
export function warpMaterial<Kind extends Material, const Uniforms extends ThreeUniforms = {}>(
  material: Kind,
  offset: ThreeOffset<ValuesOf<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpedMaterial<Kind, ValuesOf<Uniforms>> {
  const method = 'warpMaterial'
  const settings = readOptions(method, options)
  checkMaterial(method, material)
  const warp = keep(offset as never, settings)
  const woven = weaveInto(material, warp)
  const shadows = shadowMaterials(warp, () => material)
  return {
    material: woven.material as Kind,
    ...shadows,
    uniforms: warp.handles as never,
    update: updateOf(warp),
    dispose() {
      woven.restore()
      shadows.customDepthMaterial.dispose()
      shadows.customDistanceMaterial.dispose()
    },
  }
}

export const updateOf =
  ({ settings, millis }: ThreeWarp) =>
  (time: number = performance.now()) => {
    if (!Number.isFinite(time))
      throw new WarpError(
        `${settings.method}: update takes milliseconds, such as the time that setAnimationLoop gives, but ${describe(time)} came.`,
      )
    millis.value = time
  }

export function checkMaterial(method: string, material: unknown): asserts material is Material {
  const { isMaterial, type, ...is } = (material ?? {}) as Material & Record<string, unknown>
  if (!isMaterial)
    throw new WarpError(
      `${method}: a material of three.js was expected, but ${describeOfThree(material)} came.`,
    )
  checkUnwarped(method, material as Material)
  if (is.isNodeMaterial)
    throw new WarpError(
      `${method}: ${type} is a material of WebGPURenderer; import ${method} from 'warpjet/three/webgpu'.`,
    )
  if (is.isSpriteMaterial) throw spriteError(method, 'a sprite')
  if (is.isShaderMaterial)
    checkChunks(method, `the vertex shader of this ${type}`, String(is.vertexShader))
}

/** Two warps in one shader would not compile. */
export function checkUnwarped(method: string, material: Material) {
  if (!carriers.has(material)) return
  const name = material.name ? `the ${material.type} "${material.name}"` : `the ${material.type}`
  throw new WarpError(
    `${method}: ${name} is warped already, by another call; give the object a material of its own, as with material.clone(), or warp the group of all that have this one.`,
  )
}

/** Materials that have a warp in them: those of ours, and those that are shared. */
const carriers = new WeakSet<Material>()

/** That a material is to be warped from now on, or no longer. */
export const mark = (material: Material, isWarped: boolean) =>
  void (isWarped ? carriers.add(material) : carriers.delete(material))

/** A warped material, and how it becomes what it was. */
export interface Woven {
  material: Material
  restore: () => void
}

/** Of a mesh that casts shadows in a way of its own. */
export interface ShadowMaterials {
  customDepthMaterial?: Material | undefined
  customDistanceMaterial?: Material | undefined
}

/** Properties that materials have with WebGPURenderer. */
interface OfNodes {
  isNodeMaterial?: boolean
  positionNode?: { id: number }
}

/** Weaves the warp into a clone of the material, or into itself where it is shared. */
export function weaveInto(
  material: Material,
  warp: ThreeWarp,
  fill: () => Material = () => material,
): Woven {
  const { isShared } = warp.settings
  const made: Material = isShared ? material : material.clone()
  const { onBeforeCompile, customProgramCacheKey } = material
  const earlierKey = customProgramCacheKey.call(material)
  const isOwn = Object.hasOwn(material, 'onBeforeCompile')
  const isOwnKey = Object.hasOwn(material, 'customProgramCacheKey')
  const uniforms = inShader(warp, fill)
  const woven = new Map<string, string>()
  made.onBeforeCompile = function (
    this: Material,
    shader: WebGLProgramParametersWithUniforms,
    renderer: WebGLRenderer,
  ) {
    onBeforeCompile.call(this, shader, renderer)
    Object.assign(shader.uniforms, uniforms)
    const { vertexShader, vertexTangents = true } = shader
    const source = `${vertexTangents} ${vertexShader}`
    if (!woven.has(source)) woven.set(source, weave(vertexShader, warp, vertexTangents))
    shader.vertexShader = woven.get(source)!
    shader.fragmentShader = orientFaces(shader.fragmentShader, warp)
  }
  const key = `warpjet ${warp.key()} ${earlierKey}`
  made.customProgramCacheKey = function (this: Material & OfNodes) {
    // WebGPURenderer copies this into a material of nodes, which knows better.
    const { customProgramCacheKey } = Object.getPrototypeOf(this) as Material
    if (this.isNodeMaterial) return customProgramCacheKey.call(this)
    // Its cache holds the uniforms beside the code, so that another warp with the same code needs another key.
    return this.positionNode ? `${key} ${this.positionNode.id}` : key
  }
  made.needsUpdate = true
  mark(made, true)
  return {
    material: made,
    restore() {
      if (!isShared) return made.dispose()
      mark(made, false)
      if (isOwn) made.onBeforeCompile = onBeforeCompile
      else delete (made as Partial<Material>).onBeforeCompile
      if (isOwnKey) made.customProgramCacheKey = customProgramCacheKey
      else delete (made as Partial<Material>).customProgramCacheKey
      made.needsUpdate = true
    },
  }
}

function inShader(warp: ThreeWarp, fill: () => Material) {
  return {
    [millisUniform]: warp.millis,
    ...(warp.reads.has('color') && {
      warpjetFill: {
        get value() {
          return fillOf(fill())
        },
      },
    }),
    ...(warp.mirrors === undefined && {
      [orientationName]: {
        get value() {
          return warp.isMirrored() ? -1 : 1
        },
      },
    }),
    ...Object.fromEntries(warp.uniforms.map(({ label, inShader }) => [label, inShader])),
    ...Object.fromEntries(
      Object.keys(warp.frame()).map((name) => [
        name,
        {
          get value() {
            return warp.frame()[name]
          },
        },
      ]),
    ),
  }
}

/** Of the materials that draw shadows, those of the user's own warped too; `surface` is what casts the shadow. */
export function shadowMaterials(
  warp: ThreeWarp,
  surface: () => Material,
  own: ShadowMaterials = {},
) {
  const depth =
    own.customDepthMaterial?.clone() ?? new MeshDepthMaterial({ depthPacking: RGBADepthPacking })
  const distance = own.customDistanceMaterial?.clone() ?? new MeshDistanceMaterial()
  const wovenIn = (made: Material, from: Material | undefined) => {
    made.vertexColors = surface().vertexColors && warp.reads.has('color')
    const source = from ?? made
    const kept = { ...warp, settings: { ...warp.settings, isShared: true } }
    if (from) {
      made.onBeforeCompile = from.onBeforeCompile
      const { customProgramCacheKey } = from
      made.customProgramCacheKey = () => customProgramCacheKey.call(source)
    }
    return weaveInto(made, kept, surface).material
  }
  return {
    customDepthMaterial: wovenIn(depth, own.customDepthMaterial),
    customDistanceMaterial: wovenIn(distance, own.customDistanceMaterial),
  }
}
