/**
 * Passes of Babylon.js that draw a mesh with a shader of their own: depth, outline, highlight, glow, G-buffer, GPU picking. Each
 * keeps its effect in a draw wrapper of the submesh, or in its material, and each draws by `_processRendering`. So an effect
 * that comes to a warped submesh is replaced there by a variant whose vertex shader has the warp, and the uniforms of the warp
 * are set right before each draw. Shadows are left to the ShadowDepthWrapper of the material.
 *
 * The methods are replaced on the prototypes, when the first warp is made.
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

/** The name of our plugin. */
export const pluginName = 'Warpjet'

/** The define of every effect that has a warp. Its number stands for the code of the warp. */
export const codeDefine = 'WARPJET_CODE'

/** The part of a plugin that passes use. */
export interface PassWarp {
  isEnabled: boolean
  /** Warps with equal code have equal numbers. */
  codeNumber: number
  parts: ShaderParts
  /** Sets all uniforms of the warp. */
  send(setter: NumberSetter): void
}

/** Maps our variant of an effect → the effect. */
const plainOf = new WeakMap<Effect, Effect>()

let isInstalled = false

export function installPasses() {
  if (isInstalled) return
  isInstalled = true
  installInSubMeshes(SubMesh.prototype)
  installInMaterials(ShaderMaterial.prototype)
  installInMeshes(Mesh.prototype)
}

/** The warp of a mesh, whose own material counts, not that of the pass. */
function warpOf(mesh: AbstractMesh, subMesh?: SubMesh): PassWarp | undefined {
  const { material } = mesh as { material: (Material & Partial<SubMaterials>) | null }
  const own = subMesh && material?.getSubMaterial?.(subMesh.materialIndex)
  const plugin = (own ?? material)?.pluginManager?.getPlugin(pluginName) as unknown as PassWarp
  return plugin?.isEnabled ? plugin : undefined
}

interface SubMaterials {
  getSubMaterial(index: number): Material | null
}

/** Passes call `_getDrawWrapper` before they put an effect into a submesh. */
function installInSubMeshes(prototype: SubMesh) {
  const { _getDrawWrapper } = prototype
  prototype._getDrawWrapper = function (passId, isCreated) {
    const wrapper = _getDrawWrapper.call(this, passId, isCreated)
    if (!wrapper || !isCreated) return wrapper
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

/** A material of a pass may keep one effect for all meshes: it gets the one that the mesh needs. */
function installInMaterials(prototype: ShaderMaterial) {
  const { isReady } = prototype
  prototype.isReady = function (mesh, useInstances, subMesh) {
    const isReadyFor = () => isReady.call(this, mesh, useInstances, subMesh)
    const isKeptHere = !(subMesh && (this as unknown as Stored)._storeEffectOnSubMeshes)
    const wrapper = this._getDrawWrapper()
    if (!isKeptHere || !mesh || !wrapper) return isReadyFor()
    if (wrapper.effect) replaceEffect(wrapper, mesh, undefined)
    if (!isReadyFor()) return false
    const warp = warpOf(mesh)
    const plain = wrapper.effect
    if (!warp || !plain) return true
    DrawWrapper.prototype.setEffect.call(wrapper, variantFor(plain, mesh, warp), undefined)
    this.getScene().resetCachedMaterial()
    return wrapper.effect!.isReady()
  }
}

/** Maps a mesh → effects that materials share among meshes → their variants. Made anew for each draw, they would be counted. */
const variantsOf = new WeakMap<AbstractMesh, WeakMap<Effect, Effect>>()

function variantFor(plain: Effect, mesh: AbstractMesh, warp: PassWarp): Effect {
  let variants = variantsOf.get(mesh)
  if (!variants) variantsOf.set(mesh, (variants = new WeakMap()))
  const known = variants.get(plain)
  const variant = known && !known.isDisposed && hasCodeOf(warp, known) ? known : undefined
  const effect = variant ?? effectFor(plain, mesh, warp)
  variants.set(plain, effect)
  return effect
}

const hasCodeOf = ({ codeNumber }: PassWarp, { defines }: Effect) =>
  defines.includes(`${codeDefine} ${codeNumber}\n`)

interface Stored {
  _storeEffectOnSubMeshes: boolean
}

function installInMeshes(prototype: Mesh) {
  const { _processRendering } = prototype
  prototype._processRendering = function (mesh, subMesh, effect, ...others) {
    if (plainOf.has(effect)) {
      const warp = warpOf(subMesh.getRenderingMesh(), subMesh)
      if (warp) send(warp, effect)
    }
    return _processRendering.call(this, mesh, subMesh, effect, ...others)
  }
}

function send(warp: PassWarp, effect: Effect) {
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
  const wanted = effectFor(effect, mesh, warp)
  if (wanted !== effect) DrawWrapper.prototype.setEffect.call(wrapper, wanted, undefined)
}

/** The effect without a warp, or its variant with this one. */
function effectFor(effect: Effect, mesh: AbstractMesh, warp: PassWarp | undefined): Effect {
  const plain = plainOf.get(effect) ?? effect
  if (!warp || !isOfPass(plain)) return plain
  if (plain !== effect && hasCodeOf(warp, effect)) return effect
  return variantOf(plain, mesh, warp)
}

/** Shaders of the material itself are warped already, those of shadows elsewhere. */
const isOfPass = ({ defines, name }: Effect) =>
  !defines.includes(codeDefine) && !JSON.stringify(name).includes('shadow')

function variantOf(effect: Effect, mesh: AbstractMesh, warp: PassWarp): Effect {
  const { parts } = warp
  const own = effect as unknown as PrivateOptions
  const engine = effect.getEngine() as AbstractEngine
  const attributes = effect.getAttributesNames()
  const isWGSL = effect.shaderLanguage === ShaderLanguage.WGSL
  const has = (kind: string) =>
    mesh.isVerticesDataPresent(kind) && (kind !== 'color' || mesh.useVertexColors)
  const read = kinds.filter((kind) => parts.warp.reads(kind) && has(kind))
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
      multiTarget: own._multiTarget,
      processFinalCode: own._processFinalCode,
      processCodeAfterIncludes: (stage, code, ...others) => {
        const processed = own._processCodeAfterIncludes?.(stage, code, ...others) ?? code
        return stage === 'vertex' ? warpPass(parts, isWGSL, processed) : processed
      },
      // Babylon.js has loaded the source once the effect itself is compiled.
      extraInitializationsAsync: () =>
        new Promise((resolve) => effect.executeWhenCompiled(() => resolve())),
    },
    engine,
  )
  plainOf.set(variant, effect)
  return variant
}

const kinds = ['normal', 'uv', 'color'] as const

type Process = (stage: string, code: string, ...others: unknown[]) => string

/** Options of an effect that it has no getters for. */
interface PrivateOptions {
  _multiTarget: boolean
  _processFinalCode: Process | null
  _processCodeAfterIncludes: Process | undefined
}
