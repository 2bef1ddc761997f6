/**
 * Warps meshes in the passes of Babylon.js that draw with shaders of their own: depth, outline, highlight, glow, G-buffer, GPU picking.
 * Each pass keeps its effect (Babylon.js' compiled shader) in a draw wrapper of the submesh or of the pass's material, and draws by
 * `_processRendering`. So the effect for a warped submesh is replaced by a variant whose vertex shader has the warp, and the uniforms of
 * the warp are set right before each draw. Shadows are left to the ShadowDepthWrapper of the material.
 *
 * For this, methods of Babylon.js' prototypes are replaced when the first warp is made.
 */
import type { AbstractEngine } from '@babylonjs/core/Engines/abstractEngine.js'
import { DrawWrapper } from '@babylonjs/core/Materials/drawWrapper.js'
import type { Effect } from '@babylonjs/core/Materials/effect.js'
import type { Material } from '@babylonjs/core/Materials/material.js'
import { ShaderLanguage } from '@babylonjs/core/Materials/shaderLanguage.js'
import { ShaderMaterial } from '@babylonjs/core/Materials/shaderMaterial.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import { Mesh } from '@babylonjs/core/Meshes/mesh.js'
import { SubMesh } from '@babylonjs/core/Meshes/subMesh.js'
import { variationDefines } from './names.js'
import { passDefines, warpPass } from './shader.js'
import { sentUniforms, texturesOf, type NumberSetter, type ShaderParts } from './uniforms.js'
import { variationKinds } from './variation.js'

/** The name of the plugin, the same for all warps. */
export const pluginName = 'Warpjet'

/** The define of every effect that has a warp; its value is the number of the warp's code. */
export const codeDefine = 'WARPJET_CODE'

/** The members of a warp that passes use. */
export interface PassWarp {
  isEnabled: boolean
  /** Warps with equal code have equal numbers. */
  codeNumber: number
  parts: ShaderParts
  /** Sets all uniforms of the warp. */
  send(setter: NumberSetter): void
}

/** Maps the warped variant of an effect → the effect. */
const originals = new WeakMap<Effect, Effect>()

let isInstalled = false

export function installPasses() {
  if (isInstalled) return
  isInstalled = true
  installInSubMeshes(SubMesh.prototype)
  installInMaterials(ShaderMaterial.prototype)
  installInMeshes(Mesh.prototype)
}

/** Returns the enabled warp of a mesh's or submesh's own material, which need not be the material that the pass draws with. */
function warpOf(mesh: AbstractMesh, subMesh?: SubMesh): PassWarp | undefined {
  const { material } = mesh as { material: (Material & Partial<WithSubMaterials>) | null }
  const subMaterial = subMesh && material?.getSubMaterial?.(subMesh.materialIndex)
  const plugin = (subMaterial ?? material)?.pluginManager?.getPlugin(
    pluginName,
  ) as unknown as PassWarp
  return plugin?.isEnabled ? plugin : undefined
}

interface WithSubMaterials {
  getSubMaterial(index: number): Material | null
}

/** Replaces effects in the draw wrappers of submeshes: passes call `_getDrawWrapper` before they set the wrapper's effect. */
function installInSubMeshes(prototype: SubMesh) {
  const { _getDrawWrapper } = prototype
  prototype._getDrawWrapper = function (passId, createIfMissing) {
    const wrapper = _getDrawWrapper.call(this, passId, createIfMissing)
    if (!wrapper || !createIfMissing) return wrapper
    const mesh = this.getRenderingMesh()
    const isHooked = Object.hasOwn(wrapper, 'setEffect')
    if (!isHooked && !warpOf(mesh, this)) return wrapper
    if (!isHooked)
      wrapper.setEffect = (effect, ...others) =>
        DrawWrapper.prototype.setEffect.call(
          wrapper,
          effect && effectFor(effect, mesh, warpOf(mesh, this)),
          ...others,
        )
    replaceEffect(wrapper, mesh, warpOf(mesh, this))
    return wrapper
  }
}

/**
 * Replaces effects in the materials of passes. Such a material may keep one effect for all meshes, so `isReady` sets the variant for the
 * mesh.
 */
function installInMaterials(prototype: ShaderMaterial) {
  const { isReady } = prototype
  prototype.isReady = function (mesh, useInstances, subMesh) {
    const isReadyForMesh = () => isReady.call(this, mesh, useInstances, subMesh)
    const hasSharedEffect = !(
      subMesh && (this as unknown as WithStoredEffects)._storeEffectOnSubMeshes
    )
    const wrapper = this._getDrawWrapper()
    if (!hasSharedEffect || !mesh || !wrapper) return isReadyForMesh()
    if (wrapper.effect) replaceEffect(wrapper, mesh, undefined)
    if (!isReadyForMesh()) return false
    const warp = warpOf(mesh)
    const original = wrapper.effect
    if (!warp || !original) return true
    DrawWrapper.prototype.setEffect.call(wrapper, cachedVariant(original, mesh, warp), undefined)
    this.getScene().resetCachedMaterial()
    return wrapper.effect!.isReady()
  }
}

/** Maps a mesh → effects that materials share among meshes → their variants, so that variants are not made anew for each draw. */
const variantsOf = new WeakMap<AbstractMesh, WeakMap<Effect, Effect>>()

function cachedVariant(original: Effect, mesh: AbstractMesh, warp: PassWarp): Effect {
  let variants = variantsOf.get(mesh)
  if (!variants) variantsOf.set(mesh, (variants = new WeakMap()))
  const cached = variants.get(original)
  const isValid = cached && !cached.isDisposed && hasCodeOf(cached, warp)
  const effect = isValid ? cached : effectFor(original, mesh, warp)
  variants.set(original, effect)
  return effect
}

const hasCodeOf = ({ defines }: Effect, { codeNumber }: PassWarp) =>
  defines.includes(`${codeDefine} ${codeNumber}\n`)

interface WithStoredEffects {
  _storeEffectOnSubMeshes: boolean
}

/** Sets the uniforms of the warp before each draw of a variant. */
function installInMeshes(prototype: Mesh) {
  const { _processRendering } = prototype
  prototype._processRendering = function (mesh, subMesh, effect, ...others) {
    if (originals.has(effect)) {
      const warp = warpOf(subMesh.getRenderingMesh(), subMesh)
      if (warp) sendTo(effect, warp)
    }
    return _processRendering.call(this, mesh, subMesh, effect, ...others)
  }
}

function sendTo(effect: Effect, warp: PassWarp) {
  warp.send({
    updateFloat: (name, x) => effect.setFloat(name, x),
    updateFloat2: (name, x, y) => effect.setFloat2(name, x, y),
    updateFloat3: (name, x, y, z) => effect.setFloat3(name, x, y, z),
    updateFloat4: (name, x, y, z, w) => effect.setFloat4(name, x, y, z, w),
    updateMatrices: (name, numbers) => effect.setMatrices(name, numbers),
  })
  for (const [name, texture] of texturesOf(warp.parts)) effect.setTexture(name, texture)
}

function replaceEffect(wrapper: DrawWrapper, mesh: AbstractMesh, warp: PassWarp | undefined) {
  const { effect } = wrapper
  if (!effect) return
  const newEffect = effectFor(effect, mesh, warp)
  if (newEffect !== effect) DrawWrapper.prototype.setEffect.call(wrapper, newEffect, undefined)
}

/** Returns the variant of an effect that has the warp, or without a warp the original effect. */
function effectFor(effect: Effect, mesh: AbstractMesh, warp: PassWarp | undefined): Effect {
  const original = originals.get(effect) ?? effect
  if (!warp || !isPassEffect(original)) return original
  if (original !== effect && hasCodeOf(effect, warp)) return effect
  return makeVariant(original, mesh, warp)
}

/**
 * Returns whether an effect belongs to a pass, and neither to the warped material itself nor to shadows, which the ShadowDepthWrapper
 * warps.
 */
const isPassEffect = ({ defines, name }: Effect) =>
  !defines.includes(codeDefine) && !JSON.stringify(name).includes('shadow')

function makeVariant(effect: Effect, mesh: AbstractMesh, warp: PassWarp): Effect {
  const { parts } = warp
  const privateOptions = effect as unknown as PrivateOptions
  const engine = effect.getEngine() as AbstractEngine
  const attributes = effect.getAttributesNames()
  const isWGSL = effect.shaderLanguage === ShaderLanguage.WGSL
  const has = (kind: string) =>
    mesh.isVerticesDataPresent(kind) && (kind !== 'color' || mesh.useVertexColors)
  const read = attributeKinds.filter((kind) => parts.warp.reads(kind) && has(kind))
  const added = read.filter((kind) => !attributes.includes(kind))
  const variation = variationKinds.filter(has)
  const defines = [
    `${codeDefine} ${warp.codeNumber}`,
    ...read.map((kind) => passDefines[kind].has),
    ...added.map((kind) => passDefines[kind].adds),
    ...(variation.length >= 3 ? [variationDefines.normal] : []),
    ...(variation.length >= 5 ? [variationDefines.uv] : []),
  ]
  const variant = engine.createEffect(
    effect.name,
    {
      attributes: [...attributes, ...added, ...variation],
      uniformsNames: [...effect.getUniformNames(), ...sentUniforms(parts).map(({ name }) => name)],
      uniformBuffersNames: effect.getUniformBuffersNames(),
      samplers: [...effect.getSamplers(), ...texturesOf(parts).map(([name]) => name)],
      defines: [effect.defines, ...defines.map((define) => `#define ${define}`), ''].join('\n'),
      fallbacks: null,
      onCompiled: null,
      onError: null,
      indexParameters: effect.getIndexParameters(),
      shaderLanguage: effect.shaderLanguage,
      multiTarget: privateOptions._multiTarget,
      processFinalCode: privateOptions._processFinalCode,
      processCodeAfterIncludes: (stage, code, ...others) => {
        const processed = privateOptions._processCodeAfterIncludes?.(stage, code, ...others) ?? code
        return stage === 'vertex' ? warpPass(parts, isWGSL, processed) : processed
      },
      // Waits until the original effect is compiled: then Babylon.js has loaded the source code.
      extraInitializationsAsync: () =>
        new Promise((resolve) => effect.executeWhenCompiled(() => resolve())),
    },
    engine,
  )
  originals.set(variant, effect)
  return variant
}

const attributeKinds = ['normal', 'uv', 'color'] as const

type ProcessCode = (stage: string, code: string, ...others: unknown[]) => string

/** Private members of an effect with options of `createEffect` that have no getters. */
interface PrivateOptions {
  _multiTarget: boolean
  _processFinalCode: ProcessCode | null
  _processCodeAfterIncludes: ProcessCode | undefined
}
