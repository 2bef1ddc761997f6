// Puts a warp into the shaders of a material, at the end of its `onBeforeCompile`.
import type {
  Material,
  RawShaderMaterial,
  WebGLProgramParametersWithUniforms,
  WebGLRenderer,
} from 'three'
import { shaderNames } from '../compile/hosts.js'
import { orientFaces } from './faces.js'
import type { PixelNormals } from './pixel-normals.js'
import { pixelNormalsFor } from './pixel-stage.js'
import { fillOf } from './surface.js'
import type { ThreeWarp } from './three-warp.js'
import { liveUniform } from './uniforms.js'
import { weavePixelNormals, weaveVertexNormals } from './weave-fragment.js'
import { weave } from './weave.js'

type Shader = WebGLProgramParametersWithUniforms

export interface WovenSurface {
  /** The material of the object, even if another material draws its shadow. */
  material: Material
  /** `true` if vertices have colors that the warp may read. */
  hasColors: boolean
  /** Material and object, for a message. */
  name: string
}

/** Maps a warp → a map from the options and the source of a vertex shader to this shader with the warp. */
const woven = new WeakMap<ThreeWarp, Map<string, string>>()

export class ShaderWeaver {
  /** A part of the program's key: equal for warps whose shaders are equal. */
  readonly key: string
  private readonly uniforms: Shader['uniforms']

  constructor(
    private readonly warp: ThreeWarp,
    private readonly surface: WovenSurface,
  ) {
    this.key = `warpjet ${warp.key} ${warp.normals} ${surface.hasColors}`
    this.uniforms = uniformsFor(warp, surface.material)
  }

  /** Adds the warp to a shader. If the warp does not fit, prints an error: a thrown error would leave `render()`. */
  weave(shader: Shader, material: Material, renderer: WebGLRenderer) {
    const { warp } = this
    Object.assign(shader.uniforms, this.uniforms)
    try {
      const pixel = pixelNormalsFor(shader, material, renderer, warp, this.surface.name)
      shader.vertexShader = this.weaveVertex(shader, material, pixel)
      const fragmentShader = pixel
        ? weavePixelNormals(shader.fragmentShader, pixel, shader.precision)
        : weaveVertexNormals(shader.fragmentShader)
      shader.fragmentShader = orientFaces(fragmentShader, warp)
    } catch (error) {
      console.error(
        `${this.warp.settings.method}: ${this.surface.name} is drawn without the warp: ${(error as Error).message}`,
      )
    }
  }

  private weaveVertex(
    { vertexShader, vertexTangents = true }: Shader,
    material: Material,
    pixel: PixelNormals | undefined,
  ) {
    const { isRawShaderMaterial, isShaderMaterial, glslVersion } =
      material as Partial<RawShaderMaterial>
    const options = {
      mayHaveTangents: vertexTangents,
      hasColors: this.surface.hasColors,
      isShaderMaterial: isShaderMaterial === true,
      isRaw: isRawShaderMaterial === true,
      isGlsl100: isRawShaderMaterial === true && glslVersion !== '300 es',
    }
    const key = `${Object.values(options).join()} ${pixel?.options.matrices} ${vertexShader}`
    if (!woven.has(this.warp)) woven.set(this.warp, new Map())
    const shaders = woven.get(this.warp)!
    if (!shaders.has(key)) shaders.set(key, weave(vertexShader, this.warp, options, pixel))
    return shaders.get(key)!
  }
}

/** Returns the uniforms of a warp for a shader of three.js. */
export function uniformsFor(warp: ThreeWarp, material: Material): Shader['uniforms'] {
  const live = (read: () => unknown) => ({
    get value() {
      return read()
    },
  })
  return {
    [shaderNames.millis]: warp.millis,
    ...(warp.reads('color') && { warpjetFill: live(() => fillOf(material)) }),
    ...(warp.mirrors === undefined && {
      [shaderNames.orientation]: live(() => (warp.isMirroredNow() ? -1 : 1)),
    }),
    ...Object.fromEntries(warp.uniforms.inShader.map((each) => [each.label, liveUniform(each)])),
    ...Object.fromEntries(
      Object.keys(warp.frameNow()).map((name) => [name, live(() => warp.frameNow()[name])]),
    ),
  } as Shader['uniforms']
}
