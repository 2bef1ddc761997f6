// `BabylonWarp`: a warp as a plugin of a material of Babylon.js, in GLSL and in WGSL, with its shadows and what rays meet.
import type { Material } from '@babylonjs/core/Materials/material.js'
import type { MaterialDefines } from '@babylonjs/core/Materials/materialDefines.js'
import { MaterialPluginBase } from '@babylonjs/core/Materials/materialPluginBase.js'
import { ShaderLanguage } from '@babylonjs/core/Materials/shaderLanguage.js'
import { ShadowDepthWrapper } from '@babylonjs/core/Materials/shadowDepthWrapper.js'
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import type { UniformBuffer } from '@babylonjs/core/Materials/uniformBuffer.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import {
  HostWarp,
  type OffsetFunction,
  type UniformOptions,
  type UniformValues,
  shaderNames,
} from '../compile/hosts.js'
import { WarpError, describe } from '../errors/errors.js'
import { anything } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object } from '../options/schema.js'
import { refreshMesh } from './mesh.js'
import {
  type ShaderParts,
  declarationsOf,
  fragmentCode,
  names,
  send,
  vertexCode,
} from './shader.js'
import { settableValues } from './settable-values.js'
import { babylon } from './values.js'

const method = 'BabylonWarp'
const place = new Place(method)
const schema = object({ uniforms: anything<object>() })
const pluginName = 'Warpjet'

export interface BabylonWarpOptions<Uniforms extends UniformValues = UniformValues> {
  /** What the offset function reads as `uniforms`: numbers, lists of numbers, `Vector3`s, textures, or functions that give
   * them. */
  uniforms?: UniformOptions<Uniforms>
}

/**
 * Warps what a material draws: `new BabylonWarp(material, offset, { uniforms })`. Vertices are those of the mesh after morph
 * targets, before instances and bones. Works with an Engine and with a WebGPUEngine. Shadows follow by a
 * `ShadowDepthWrapper`, which the material gets unless it has one; rays and culling follow where `refresh(mesh)` is called.
 * Throws a `WarpError` for an offset that returns no vec3 or misuses an operation, and for wrong options.
 */
export class BabylonWarp<const Uniforms extends UniformValues = {}> extends MaterialPluginBase {
  /** By name the values that the option gave, which may be set: `warp.values.height = 0.5`. Throws a `WarpError` for another
   * name and for what cannot be such a value. */
  readonly values: { [Name in keyof Uniforms]: Uniforms[Name] | (() => Uniforms[Name]) }
  private time = 0
  private isOn = true
  private readonly warp: HostWarp
  private readonly parts: ShaderParts
  private readonly shadows: ShadowDepthWrapper | undefined

  constructor(
    material: Material,
    offset: OffsetFunction<NoInfer<Uniforms>>,
    options: BabylonWarpOptions<Uniforms> = {},
  ) {
    if (typeof (material as Partial<Material>)?.getEffect !== 'function')
      throw new WarpError(
        `${method}: a material of Babylon.js was expected, but ${describe(material)} came.`,
      )
    if (material.pluginManager?.getPlugin(pluginName))
      throw new WarpError(
        `${method}: the material "${material.name}" is warped already; set isEnabled of that warp to false and warp a clone of the material, or make one offset of both, as with chain of warpjet/deformers.`,
      )
    const { uniforms } = schema.read(options, place)
    const warp = new HostWarp(place, offset as OffsetFunction, {
      host: babylon,
      uniforms,
      names,
      tangents: true,
    })
    super(material, pluginName, 200, { WARPJET: true }, false)
    this.warp = warp
    this.values = settableValues(warp.uniforms) as never
    this.parts = { warp, frame: Object.keys(warp.frame(this.given)) }
    // Asked for its code at once, so that all of this must be there.
    ;(this._pluginManager as unknown as { _addPlugin(plugin: object): void })._addPlugin(this)
    this._enable(true)
    if (!material.shadowDepthWrapper)
      material.shadowDepthWrapper = this.shadows = new ShadowDepthWrapper(
        material,
        material.getScene(),
      )
  }

  /** Milliseconds, which the offset may read. Throws a `WarpError` for what is no finite number. */
  get millis() {
    return this.time
  }

  set millis(time: number) {
    if (!Number.isFinite(time))
      throw new WarpError(
        `${method}: millis must be a number of milliseconds, such as performance.now(), but is ${describe(time)}.`,
      )
    this.time = time
  }

  /** `false` draws the material as it is without the warp. A plugin stays with its material as long as that lives. */
  get isEnabled() {
    return this.isOn
  }

  set isEnabled(isEnabled: boolean) {
    this.isOn = isEnabled
    this.markAllDefinesAsDirty()
  }

  override prepareDefines(defines: MaterialDefines) {
    Object.assign(defines, { WARPJET: this.isOn })
  }

  /**
   * Rays meet a mesh with this material, and it is culled, where the warp has it at this moment: call it before a pick, and
   * each frame for a warp that moves it out of where it was. Vertices are moved on the CPU. Normals of a pick stay those of
   * the mesh. Throws a `WarpError` for a warp that reads an image or calls a `glsl.fn`.
   */
  refresh(mesh: AbstractMesh) {
    refreshMesh(this.warp, mesh, this.given)
  }

  override getClassName() {
    return 'BabylonWarp'
  }

  override isCompatible(language: ShaderLanguage) {
    return language === ShaderLanguage.GLSL || language === ShaderLanguage.WGSL
  }

  override prepareDefinesBeforeAttributes(defines: MaterialDefines) {
    if (this.warp.reads('uv')) Object.assign(defines, { _needUVs: true })
    // A warp reads the normal that it turns.
    Object.assign(defines, { _needNormals: true })
  }

  override isReadyForSubMesh() {
    return this.images().every(([, texture]) => texture.isReadyOrNotBlocking())
  }

  override getUniforms(language?: ShaderLanguage) {
    return declarationsOf(this.parts, language === ShaderLanguage.WGSL)
  }

  override getSamplers(samplers: string[]) {
    samplers.push(...this.images().map(([label]) => label))
  }

  override getActiveTextures(textures: BaseTexture[]) {
    textures.push(...this.images().map(([, texture]) => texture))
  }

  override hasTexture(texture: BaseTexture) {
    return this.images().some(([, each]) => each === texture)
  }

  private get given() {
    return { millis: this.millis }
  }

  private images() {
    return this.warp.uniforms.inShader.flatMap(({ label, image }): [string, BaseTexture][] =>
      image ? [[label, image() as BaseTexture]] : [],
    )
  }

  override bindForSubMesh(buffer: UniformBuffer) {
    const { warp, given } = this
    buffer.updateFloat(shaderNames.millis, given.millis)
    if (warp.mirrors !== false)
      buffer.updateFloat(shaderNames.orientation, this.isOn && warp.isMirrored(given) ? -1 : 1)
    for (const { label, numbers, image } of warp.uniforms.inShader) {
      if (image) buffer.setTexture(label, image() as BaseTexture)
      else send(buffer, label, numbers())
    }
    for (const [label, numbers] of Object.entries(warp.frame(given))) send(buffer, label, numbers)
  }

  override getCustomCode(type: string, language?: ShaderLanguage) {
    const isWGSL = language === ShaderLanguage.WGSL
    if (type === 'vertex') return vertexCode(this.parts, isWGSL)
    return type === 'fragment' && this.warp.mirrors !== false ? fragmentCode(isWGSL) : null
  }

  override dispose() {
    if (this.shadows && this._material.shadowDepthWrapper === this.shadows)
      this._material.shadowDepthWrapper = null
    this.shadows?.dispose()
  }
}
