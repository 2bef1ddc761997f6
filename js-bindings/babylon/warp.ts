// `BabylonWarp`: a warp as a plugin of a material of Babylon.js, in GLSL and in WGSL.
import type { AbstractEngine } from '@babylonjs/core/Engines/abstractEngine.js'
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import type { Material } from '@babylonjs/core/Materials/material.js'
import type { MaterialDefines } from '@babylonjs/core/Materials/materialDefines.js'
import { MaterialPluginBase } from '@babylonjs/core/Materials/materialPluginBase.js'
import { ShaderLanguage } from '@babylonjs/core/Materials/shaderLanguage.js'
import { ShadowDepthWrapper } from '@babylonjs/core/Materials/shadowDepthWrapper.js'
import type { UniformBuffer } from '@babylonjs/core/Materials/uniformBuffer.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { SubMesh } from '@babylonjs/core/Meshes/subMesh.js'
import type { Scene } from '@babylonjs/core/scene.js'
import {
  HostWarp,
  shaderNames,
  type NormalStage,
  type OffsetFunction,
  type UniformValues,
} from '../compile/hosts.js'
import { describe } from '../errors/errors.js'
import { noteApproximation } from '../errors/notes.js'
import { codeOf, type WarpCode } from './code.js'
import { registerCopies, remember } from './copies.js'
import { refreshMesh } from './mesh.js'
import { meshDefines, names, variationDefines } from './names.js'
import { NormalStages } from './normal-stages.js'
import { optionsKind, place, rejectUnwarpable, type BabylonWarpOptions } from './options.js'
import { codeDefine, installPasses, pluginName, type PassWarp } from './passes.js'
import { settableValues, type SettableValues } from './settable-values.js'
import { declarationsOf } from './shader.js'
import { sendUniforms, texturesOf, type NumberSetter, type ShaderParts } from './uniforms.js'
import { babylon } from './values.js'
import { variationOf } from './variation.js'

/**
 * Warps all that a material draws: `new BabylonWarp(material, offset, { uniforms })`. The warp is applied to the vertices of a mesh after
 * morph targets and before instances and bones. Works with an Engine and with a WebGPUEngine, and in passes that Babylon.js draws
 * with shaders of its own: depth, outline, highlight, glow, G-buffer, GPU picking. The material gets a `ShadowDepthWrapper` for
 * its shadows unless it has one. Rays and culling use the warped mesh after `refresh(mesh)`.
 *
 * @throws {WarpError} for an offset that returns no vec3 or misuses an operation, and for wrong options.
 */
export class BabylonWarp<const Uniforms extends UniformValues = {}>
  extends MaterialPluginBase
  implements PassWarp
{
  /**
   * Maps the names of uniforms → their values, which can be set: `warp.values.height = 0.5`. Setting throws a `WarpError` for a name that
   * the option `uniforms` lacks and for a value of another type.
   */
  readonly values: SettableValues<Uniforms>
  /** @internal */
  readonly parts: ShaderParts
  private time = 0
  private isOn = true
  private readonly warp: HostWarp
  private readonly code: WarpCode
  private readonly stages: NormalStages
  private readonly shadows: ShadowDepthWrapper | undefined
  private readonly registration: { id: string; forget: () => void }

  constructor(
    material: Material,
    private readonly offset: OffsetFunction<NoInfer<Uniforms>>,
    private readonly options: BabylonWarpOptions<Uniforms> = {},
  ) {
    rejectUnwarpable(material)
    const { uniforms, surfaceVariation, normals, fadeNoise } = optionsKind.read(options, place)
    const warp = new HostWarp(place, offset as OffsetFunction, {
      host: babylon,
      uniforms,
      names,
      fadeNoise,
      tangents: true,
      surfaceVariation: surfaceVariation ?? true,
    })
    const parts: ShaderParts = { warp, frame: Object.keys(warp.frame({ millis: 0 })) }
    const hasPixels = warp.stageOfNormals(normals) === 'pixel'
    const code = codeOf(parts, hasPixels, material.shaderLanguage === ShaderLanguage.WGSL)
    // Babylon.js caches compiled shaders by their defines, so these must contain the number of the code.
    super(
      material,
      pluginName,
      200,
      { WARPJET: true, [codeDefine]: code.number, ...meshDefines },
      false,
    )
    this.warp = warp
    this.parts = parts
    this.code = code
    this.stages = new NormalStages(normals, code.pixels)
    this.values = settableValues(warp.uniforms) as never
    this.registration = remember(this)
    installPasses()
    // This call reads the code by getCustomCode, so everything above must be set before.
    ;(this._pluginManager as unknown as { _addPlugin(plugin: object): void })._addPlugin(this)
    this._enable(true)
    if (!material.shadowDepthWrapper)
      material.shadowDepthWrapper = this.shadows = new ShadowDepthWrapper(
        material,
        material.getScene(),
      )
  }

  /**
   * The stage that computes normals. It changes to `'vertex'` if the shader of a mesh cannot compute normals at pixels; the normals of
   * other meshes with the material are still computed at pixels.
   */
  get normals(): NormalStage {
    return this.stages.stage
  }

  /** @internal */
  get codeNumber() {
    return this.code.number
  }

  /** The input `millis` of the offset function, in milliseconds. Setting throws a `WarpError` for anything but a finite number. */
  get millis() {
    return this.time
  }

  set millis(time: number) {
    if (!Number.isFinite(time))
      throw place
        .part('millis')
        .expected('a number of milliseconds', describe(time), 'performance.now() gives one')
    this.time = time
  }

  /** `false` draws the material without the warp, which cannot be removed from its material. */
  get isEnabled() {
    return this.isOn
  }

  set isEnabled(isEnabled: boolean) {
    this.isOn = isEnabled
    this.markAllDefinesAsDirty()
  }

  /**
   * Makes rays and culling use the warped positions that a mesh with this material has at this moment: call it before a pick, and each
   * frame for a warp that moves the mesh out of its bounding box. Vertices are warped on the CPU. A pick still returns the normals of the
   * unwarped mesh.
   *
   * @throws {WarpError} for a warp that reads an image or calls a `glsl.fn`.
   */
  refresh(mesh: AbstractMesh) {
    refreshMesh(this.warp, mesh, this.inputs)
  }

  override getClassName() {
    return 'BabylonWarp'
  }

  override isCompatible(language: ShaderLanguage) {
    return language === ShaderLanguage.GLSL || language === ShaderLanguage.WGSL
  }

  override prepareDefinesBeforeAttributes(defines: MaterialDefines) {
    if (this.warp.reads('uv')) Object.assign(defines, { _needUVs: true })
    // The normal is always needed, since the warp transforms it.
    Object.assign(defines, { _needNormals: true })
  }

  override prepareDefines(defines: MaterialDefines, scene: Scene, mesh: AbstractMesh) {
    const count = variationOf(this.warp, mesh).length
    const needsVariation = this.warp.varies && this.options.surfaceVariation !== false
    if (this.isOn && needsVariation && !count)
      noteApproximation(place.method, 'await addSurfaceVariation(mesh)')
    Object.assign(defines, {
      WARPJET: this.isOn,
      [variationDefines.normal]: count >= 3,
      [variationDefines.uv]: count >= 5,
    })
    this.stages.prepare(defines, scene.getEngine().getCaps().maxVaryingVectors)
  }

  override getAttributes(attributes: string[], _scene: Scene, mesh: AbstractMesh) {
    attributes.push(...variationOf(this.warp, mesh))
  }

  override isReadyForSubMesh() {
    return texturesOf(this.parts).every(([, texture]) => texture.isReadyOrNotBlocking())
  }

  override getUniforms(language?: ShaderLanguage) {
    return declarationsOf(this.parts, !!this.code.pixels, language === ShaderLanguage.WGSL)
  }

  override getSamplers(samplers: string[]) {
    samplers.push(...texturesOf(this.parts).map(([label]) => label))
  }

  override getActiveTextures(textures: BaseTexture[]) {
    textures.push(...texturesOf(this.parts).map(([, texture]) => texture))
  }

  override hasTexture(texture: BaseTexture) {
    return texturesOf(this.parts).some(([, each]) => each === texture)
  }

  override bindForSubMesh(
    buffer: UniformBuffer,
    _scene: Scene,
    _engine: AbstractEngine,
    subMesh: SubMesh,
  ) {
    this.stages.check(subMesh.effect)
    this.send(buffer)
    if (this.warp.mirrors !== false)
      buffer.updateFloat(
        shaderNames.orientation,
        this.isOn && this.warp.isMirrored(this.inputs) ? -1 : 1,
      )
    for (const [label, texture] of texturesOf(this.parts)) buffer.setTexture(label, texture)
  }

  /** @internal */
  send(setter: NumberSetter) {
    sendUniforms(this.parts, this.inputs, setter)
  }

  override getCustomCode(type: string) {
    if (type === 'vertex') return this.code.vertex
    return type === 'fragment' ? this.code.fragment : null
  }

  override serialize(): unknown {
    return { ...(super.serialize() as object), warpjet: this.registration.id }
  }

  /** Warps another material in the same way. @internal */
  copyOnto(material: Material) {
    const copy = new BabylonWarp<Uniforms>(material, this.offset, {
      ...this.options,
      uniforms: { ...this.values } as never,
    })
    copy.millis = this.millis
    copy.isEnabled = this.isEnabled
    return copy
  }

  override dispose() {
    this.registration.forget()
    if (this.shadows && this._material.shadowDepthWrapper === this.shadows)
      this._material.shadowDepthWrapper = null
    this.shadows?.dispose()
  }

  private get inputs() {
    return { millis: this.millis }
  }
}

registerCopies('BabylonWarp')
