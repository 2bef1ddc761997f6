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
import { inShader } from './uniforms.js'
import { weavePixelNormals, weaveVertexNormals } from './weave-fragment.js'
import { weave } from './weave.js'

type Shader = WebGLProgramParametersWithUniforms

export interface WovenSurface {
  /** The material of the object, which another one may replace for its shadow. */
  surface: Material
  /** `true` if vertices have colors that the warp may read. */
  hasColors: boolean
  /** Material and object, for a message. */
  name: string
}

/** Maps vertex shaders to the same with the warp, for each warp. */
const woven = new WeakMap<ThreeWarp, Map<string, string>>()

export class ShaderWeaver {
  /** Goes into the program's key: what is equal has equal keys. */
  readonly key: string
  private readonly uniforms: Shader['uniforms']

  constructor(
    private readonly warp: ThreeWarp,
    private readonly of: WovenSurface,
  ) {
    this.key = `warpjet ${warp.key} ${warp.normals} ${of.hasColors}`
    this.uniforms = uniformsFor(warp, of.surface)
  }

  /** If the warp does not fit into the shader, the shader stays as it is: an error here would leave `render()`. */
  weave(shader: Shader, material: Material, renderer: WebGLRenderer) {
    const { warp } = this
    Object.assign(shader.uniforms, this.uniforms)
    try {
      const pixel = pixelNormalsFor(shader, material, renderer, warp, this.of.name)
      shader.vertexShader = this.weaveVertex(shader, material, pixel)
      const fragmentShader = pixel
        ? weavePixelNormals(shader.fragmentShader, pixel, shader.precision)
        : weaveVertexNormals(shader.fragmentShader)
      shader.fragmentShader = orientFaces(fragmentShader, warp)
    } catch (error) {
      console.error(
        `${this.warp.settings.method}: ${this.of.name} is drawn without the warp: ${(error as Error).message}`,
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
      hasColors: this.of.hasColors,
      isShaderMaterial: isShaderMaterial === true,
      isRaw: isRawShaderMaterial === true,
      isGlsl100: isRawShaderMaterial === true && glslVersion !== '300 es',
    }
    const before = `${Object.values(options).join()} ${pixel?.options.matrices} ${vertexShader}`
    if (!woven.has(this.warp)) woven.set(this.warp, new Map())
    const known = woven.get(this.warp)!
    if (!known.has(before)) known.set(before, weave(vertexShader, this.warp, options, pixel))
    return known.get(before)!
  }
}

/** Returns the uniforms of a warp for a shader of three.js. */
export function uniformsFor(warp: ThreeWarp, surface: Material): Shader['uniforms'] {
  const live = (read: () => unknown) => ({
    get value() {
      return read()
    },
  })
  return {
    [shaderNames.millis]: warp.millis,
    ...(warp.reads('color') && { warpjetFill: live(() => fillOf(surface)) }),
    ...(warp.mirrors === undefined && {
      [shaderNames.orientation]: live(() => (warp.isMirroredNow() ? -1 : 1)),
    }),
    ...Object.fromEntries(warp.uniforms.inShader.map((each) => [each.label, inShader(each)])),
    ...Object.fromEntries(
      Object.keys(warp.frameNow()).map((name) => [name, live(() => warp.frameNow()[name])]),
    ),
  } as Shader['uniforms']
}
