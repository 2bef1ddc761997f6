// The shader of a material before three.js compiles it.
import { ShaderLib, UniformsUtils, type Material, type Mesh, type ShaderMaterial } from 'three'
import type { ExactShader } from './shader.js'

/** Maps the type of a material → its shader in ShaderLib. */
const libraryNames: Record<string, string> = {
  MeshNormalMaterial: 'normal',
  MeshBasicMaterial: 'basic',
  MeshLambertMaterial: 'lambert',
  MeshPhongMaterial: 'phong',
  MeshToonMaterial: 'toon',
  MeshStandardMaterial: 'physical',
  MeshPhysicalMaterial: 'physical',
  MeshMatcapMaterial: 'matcap',
  ShadowMaterial: 'shadow',
}

/**
 * Makes a shader with the parameters that affect the positions of vertices; returns `undefined` for a material that three.js does not have.
 */
export function createShader(material: Material, object: Mesh): ExactShader | undefined {
  const { isShaderMaterial, vertexShader, fragmentShader, uniforms } =
    material as Partial<ShaderMaterial>
  const { defines } = material as { defines?: Record<string, unknown> }
  const parameters = { ...parametersOf(material, object), ...(defines && { defines }) }
  if (isShaderMaterial)
    return {
      ...parameters,
      vertexShader: vertexShader!,
      fragmentShader: fragmentShader!,
      uniforms: uniforms!,
    }
  const library = (ShaderLib as Record<string, (typeof ShaderLib)['basic'] | undefined>)[
    libraryNames[material.type] ?? ''
  ]
  return (
    library && {
      ...parameters,
      vertexShader: library.vertexShader,
      fragmentShader: library.fragmentShader,
      uniforms: { ...UniformsUtils.clone(library.uniforms), ...liveUniforms(material, library) },
    }
  )
}

/** Makes uniforms that always have the current value of the material's property of that name; three.js would set them before it draws. */
const liveUniforms = (material: Material, { uniforms }: { uniforms: object }) =>
  Object.fromEntries(
    Object.keys(uniforms)
      .filter((name) => name in material)
      .map((name) => [
        name,
        {
          get value() {
            return (material as unknown as Record<string, unknown>)[name]
          },
        },
      ]),
  )

/** Returns the parameters of the program that depend on the object. */
export function parametersOf(material: Material, object: Mesh) {
  const { attributes, morphAttributes } = object.geometry
  const { instanceColor, isInstancedMesh, isSkinnedMesh } = object as Mesh & {
    instanceColor?: unknown
    isInstancedMesh?: boolean
    isSkinnedMesh?: boolean
  }
  const { displacementMap } = material as { displacementMap?: { channel?: number } | null }
  return {
    instancing: isInstancedMesh === true,
    instancingColor: isInstancedMesh === true && instanceColor != null,
    skinning: isSkinnedMesh === true,
    morphTargets: morphAttributes.position !== undefined,
    vertexColors: material.vertexColors,
    vertexAlphas: material.vertexColors && attributes.color?.itemSize === 4,
    vertexUv1s: attributes.uv1 !== undefined,
    vertexUv2s: attributes.uv2 !== undefined,
    vertexUv3s: attributes.uv3 !== undefined,
    ...(displacementMap && {
      displacementMap: true,
      displacementMapUv: displacementMap.channel ? `uv${displacementMap.channel}` : 'uv',
    }),
  }
}
