// `BabylonWarp`: a warp as a plugin of a material of Babylon.js, in GLSL.
import type { Material } from '@babylonjs/core/Materials/material.js'
import type { MaterialDefines } from '@babylonjs/core/Materials/materialDefines.js'
import { MaterialPluginBase } from '@babylonjs/core/Materials/materialPluginBase.js'
import { ShaderLanguage } from '@babylonjs/core/Materials/shaderLanguage.js'
import type { UniformBuffer } from '@babylonjs/core/Materials/uniformBuffer.js'
import { WarpError, describe } from '../checks/errors.js'
import { checkCallback, checkOptions } from '../checks/options.js'
import { type KeptWarp, keepWarp, readOptions, writeWarp } from '../compile/warp-text.js'
import {
  type DeclaredUniforms,
  numbersFor,
  readDeclared,
  withUniforms,
} from '../inputs/declared-uniforms.js'
import { drawInputs, variationInputs } from '../inputs/inputs.js'
import { typeOf } from '../expression/shapes.js'
import type { OffsetFunction, UniformOptions, UniformValues } from '../types/types.js'

const method = 'BabylonWarp'

export interface BabylonWarpOptions<Uniforms extends UniformValues = UniformValues> {
  /** What the offset function reads as `uniforms`: numbers, lists of numbers, `Vector3`s, or functions that give them. */
  uniforms?: UniformOptions<Uniforms>
}

const outputs = {
  offset: 'warpjetOffset',
  position: 'warpjetMoved',
  normal: 'warpjetTurned',
  tangent: 'warpjetSwung',
}

const sizes: Record<string, number> = { float: 1, vec2: 2, vec3: 3, vec4: 4, mat3: 12, mat4: 16 }

/**
 * Warps what a material draws: `new BabylonWarp(material, offset, { uniforms })`. Vertices are those of the mesh after morph
 * targets, before instances and bones. GLSL only: not for materials that a WebGPUEngine draws in WGSL.
 * Throws a `WarpError` for an offset that returns no vec3 or misuses an operation, and for wrong options.
 */
export class BabylonWarp<const Uniforms extends UniformValues = {}> extends MaterialPluginBase {
  /** Milliseconds, which the offset may read. */
  millis = 0
  /** By name, values in place of the option's: `warp.values.height = 0.5`. */
  readonly values: { [Name in keyof Uniforms]?: Uniforms[Name] } = {}
  private readonly warp: KeptWarp
  private readonly declared: DeclaredUniforms
  private readonly labels: ReadonlyMap<string, string>
  private readonly reads: ReadonlySet<string>

  constructor(
    material: Material,
    offset: OffsetFunction<NoInfer<Uniforms>>,
    options: BabylonWarpOptions<Uniforms> = {},
  ) {
    if (typeof (material as Partial<Material>)?.getEffect !== 'function')
      throw new WarpError(
        `${method}: a material of Babylon.js was expected, but ${describe(material)} came.`,
      )
    checkCallback(method, offset)
    checkOptions(method, options, ['uniforms'])
    const declared = readDeclared(method, options.uniforms)
    const labels = new Map([...declared.keys()].map((name, i) => [name, `warpjet${i}`]))
    const warp = keepWarp(
      withUniforms(method, offset as OffsetFunction, declared, (name) => labels.get(name)!),
      readOptions(method, offset as OffsetFunction, { outputs, names, tangents: true }),
    )
    const { uniforms, attributes } = writeWarp(warp, 'glsl300').text
    refuse(declared, labels, uniforms)
    super(material, 'Warpjet', 200, { WARPJET: true }, false)
    this.warp = warp
    this.declared = declared
    this.labels = labels
    this.reads = new Set(attributes.map(({ name }) => name))
    // Asked for its code at once, so that all of this must be there.
    ;(this._pluginManager as unknown as { _addPlugin(plugin: object): void })._addPlugin(this)
    this._enable(true)
  }

  override getClassName() {
    return 'BabylonWarp'
  }

  override isCompatible(language: ShaderLanguage) {
    return language === ShaderLanguage.GLSL
  }

  override prepareDefinesBeforeAttributes(defines: MaterialDefines) {
    if (this.reads.has('uv')) (defines as { _needUVs?: boolean })._needUVs = true
    if (this.reads.has('normal')) (defines as { _needNormals?: boolean })._needNormals = true
  }

  private inShader() {
    return [
      { name: millisName, type: 'float' },
      ...[...this.declared].map(([name, { shape }]) => ({
        name: this.labels.get(name)!,
        type: typeOf(shape) as string,
      })),
    ]
  }

  override getUniforms() {
    const uniforms = this.inShader()
    return {
      ubo: uniforms.map(({ name, type }) => ({ name, type, size: sizes[type]! })),
      vertex: uniforms.map(({ name, type }) => `uniform ${type} ${name};\n`).join(''),
    }
  }

  override bindForSubMesh(buffer: UniformBuffer) {
    buffer.updateFloat(millisName, this.millis)
    for (const [name, { shape, numbers }] of this.declared) {
      const given = (this.values as Record<string, unknown>)[name]
      const place = `The warp's uniform "${name}"`
      const [x, y, z, w, ...more] =
        given === undefined ? numbers(method) : numbersFor(place, shape, given)
      const label = this.labels.get(name)!
      const all = [x!, y!, z!, w!, ...more]
      if (all.length === 16) buffer.updateMatrices(label, Float32Array.from(all))
      else if (all.length === 9) buffer.updateMatrix3x3(label, Float32Array.from(all))
      else if (w !== undefined) buffer.updateFloat4(label, x!, y!, z!, w)
      else if (z !== undefined) buffer.updateFloat3(label, x!, y!, z)
      else if (y !== undefined) buffer.updateFloat2(label, x!, y)
      else buffer.updateFloat(label, x!)
    }
  }

  override getCustomCode(type: string) {
    if (type !== 'vertex') return null
    const texts = [
      { normals: true, tangents: true },
      { normals: true, tangents: false },
      { normals: false, tangents: false },
    ].map((turned) => {
      const settings = { ...this.warp.settings, ...turned }
      return writeWarp({ ...this.warp, settings }, 'glsl300').text
    })
    return {
      CUSTOM_VERTEX_DEFINITIONS: chosen(texts.map(({ declarations }) => declarations)),
      CUSTOM_VERTEX_UPDATE_NORMAL: [
        '{',
        this.reads.has('color') ? colorOfVertex : '',
        chosen(texts.map(({ code }, i) => `${code}\n${results[i]}`)),
        '}',
      ].join('\n'),
    }
  }
}

const colorOfVertex = `#ifdef VERTEXCOLOR
vec4 warpjetColor = colorUpdated;
#else
vec4 warpjetColor = vec4(1.0);
#endif`

const millisName = 'warpjetMillis'

const names = {
  position: 'positionUpdated',
  normal: 'normalUpdated',
  uv: 'uvUpdated',
  color: 'warpjetColor',
  tangent: 'tangentUpdated',
  millis: millisName,
}

const moved = `positionUpdated = ${outputs.position};`
const turned = `normalUpdated = ${outputs.normal};`
const results = [
  `${moved} ${turned} tangentUpdated = ${outputs.tangent};`,
  `${moved} ${turned}`,
  moved,
]

/** By what the mesh has. */
const chosen = ([tangent, normal, position]: string[]) =>
  `#ifdef NORMAL\n#ifdef TANGENT\n${tangent}\n#else\n${normal}\n#endif\n#else\n${position}\n#endif`

function refuse(
  declared: DeclaredUniforms,
  labels: ReadonlyMap<string, string>,
  read: readonly { name: string }[],
) {
  for (const [name, { image }] of declared)
    if (image)
      throw new WarpError(
        `${method}: the uniform "${name}" is an image, which a warp in Babylon.js cannot read; give numbers.`,
      )
  const known = new Set(labels.values())
  for (const { name } of read)
    if (name !== 'millis' && !known.has(name))
      throw new WarpError(
        name in drawInputs || name in variationInputs
          ? `${method}: the offset reads ${name}, which Babylon.js does not have; declare a uniform for it.`
          : `${method}: the offset reads "${name}" by glsl.param, which nothing declares; read it as uniforms.${name}, with the option { uniforms: { ${name}: … } }.`,
      )
}
