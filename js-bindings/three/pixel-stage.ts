// Decides whether a shader of WebGLRenderer computes normals at each pixel if the warp's option asks for that.
import type { Material, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import { warnOfVertices } from './notes.js'
import { PixelNormals, type Matrices } from './pixel-normals.js'
import type { ThreeWarp } from './three-warp.js'
import { readsNormal } from './weave-attributes.js'
import { hasNormalLine, readsVaryingNormal } from './weave-fragment.js'
import { obstacleInVertex } from './weave.js'

type Shader = WebGLProgramParametersWithUniforms & {
  instancing?: boolean
  batching?: boolean
  skinning?: boolean
  morphNormals?: boolean
  flatShading?: boolean
  vertexTangents?: boolean
  envMap?: boolean
  shaderID?: string
  defines?: object
}

/**
 * Returns the code by which a shader computes normals at each pixel; `undefined` if it computes them at vertices. `name` is for the
 * message.
 */
export function pixelNormalsFor(
  shader: Shader,
  material: Material,
  { capabilities }: WebGLRenderer,
  warp: ThreeWarp,
  name: string,
  obstacleInVertices = obstacleInVertex,
): PixelNormals | undefined {
  // Flat shading stays flat.
  if (warp.normals === 'vertex' || shader.flatShading) return undefined
  const pixel = new PixelNormals(warp, {
    matrices: matricesFor(shader, warp),
    mayHaveTangents: shader.vertexTangents !== false,
  })
  const left = capabilities.maxVaryings - varyingsOfThree(shader)
  const obstacle =
    obstacleIn(shader, material, warp) ??
    obstacleInVertices(shader.vertexShader) ??
    (pixel.varyingCount > left
      ? `it passes ${pixel.varyingCount} vectors to pixels, of which this browser has ${left} left`
      : undefined)
  if (!obstacle) return pixel
  if (warp.settings.normals === 'pixel' && isLit(shader, material))
    warnOfVertices(warp, name, obstacle)
  return undefined
}

function obstacleIn(shader: Shader, material: Material, warp: ThreeWarp): string | undefined {
  const { fragmentShader, morphNormals } = shader
  if (isRaw(material)) return 'a RawShaderMaterial has no declarations of three.js'
  if (!hasNormalLine(fragmentShader))
    return "its fragment shader has no line 'vec3 normal = normalize( vNormal );', as the chunk normal_fragment_begin of three.js does"
  if (warp.settings.space === 'rest' && morphNormals)
    return "morph targets change normals after a warp in the space 'rest'"
  return undefined
}

const isRaw = (material: Material) =>
  (material as { isRawShaderMaterial?: boolean }).isRawShaderMaterial === true

interface Flags {
  isShaderMaterial?: boolean
}

/** Tests whether a shader shows normals at all. */
function isLit(
  { fragmentShader, vertexShader, shaderID, envMap }: Shader,
  material: Material & Flags,
) {
  if (material.isShaderMaterial) return readsNormal(vertexShader)
  return readsVaryingNormal(fragmentShader) && (shaderID !== 'basic' || envMap === true)
}

function matricesFor(
  { instancing, batching, skinning, defines }: Shader,
  warp: ThreeWarp,
): Matrices {
  const { space } = warp.settings
  if (space === 'world') return 'uniform'
  if (space === 'rest' && skinning) return 'smooth'
  // InstancedMesh2 of @three.ez/instanced-mesh defines this macro.
  const isIndirect = defines !== undefined && 'USE_INSTANCING_INDIRECT' in defines
  return instancing || batching || isIndirect ? 'flat' : 'uniform'
}

/** Returns the maximum number of vectors that three's own shader passes to pixels. */
function varyingsOfThree(shader: Shader): number {
  const parameters = Object.entries(shader)
  const uvs = parameters.filter(([name, value]) => name.endsWith('Uv') && value)
  const shadows = parameters.filter(([name]) =>
    /^num(?:Sun|Dir|Point)LightShadows$|^numSpotLight(?:Shadows|Maps)$/.test(name),
  )
  // Normal, tangents, colour, fog, depth, clipping, and positions in view space and in the world.
  const others = 9
  const ofShadows = shadows.reduce((sum, [, count]) => sum + (count as number), 0)
  // Two uvs, of two components each, share a vector.
  return others + Math.ceil(uvs.length / 2) + ofShadows
}
