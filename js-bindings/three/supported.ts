// Tests whether WebGLRenderer can draw a material warped, and names an alternative if it cannot.
import { GLSL3, type Material, type RawShaderMaterial } from 'three'
import type { WarpSpace } from './settings.js'
import { canWeave } from './weave.js'

type Flags = Material &
  Partial<Record<'isNodeMaterial' | 'isSpriteMaterial' | 'isLineMaterial', boolean>> &
  Partial<RawShaderMaterial>

/** Materials that `warpMaterial` has warped. */
const warpedMaterials = new WeakSet<Material>()
export const markWarped = (material: Material, isWarped: boolean) =>
  void (isWarped ? warpedMaterials.add(material) : warpedMaterials.delete(material))
export const isWarpedMaterial = (material: Material) => warpedMaterials.has(material)

/** Returns why a material cannot be warped and what to write instead, for a message; `undefined` if it can. */
export function unsupportedMaterial(material: Material, space?: WarpSpace): string | undefined {
  const {
    isNodeMaterial,
    isSpriteMaterial,
    isLineMaterial,
    isShaderMaterial,
    vertexShader,
    isRawShaderMaterial,
    glslVersion,
  } = material as Flags
  if (isWarpedMaterial(material))
    return 'a call of warpMaterial has warped it already; give the object a material without a warp'
  if (isNodeMaterial) return "only WebGPURenderer draws it; import 'warpjet/three/webgpu'"
  if (isSpriteMaterial)
    return 'a sprite always faces the camera and has no surface; use a Mesh with a PlaneGeometry'
  if (isLineMaterial)
    return 'its shader builds each segment of the line from its two ends, so that there is no surface to warp; use a Line with a LineBasicMaterial, or a Mesh with a TubeGeometry'
  if (isShaderMaterial && !canWeave(String(vertexShader)))
    return 'its vertex shader neither reads the attribute "position" nor declares the variable "transformed"; read "position" in the vertex shader'
  if (space === 'world' && isRawShaderMaterial && glslVersion !== GLSL3)
    return "the space 'world' needs the inverse of a matrix, which GLSL ES 1.00 cannot compute; write the shader in GLSL ES 3.00 with glslVersion: THREE.GLSL3"
  return undefined
}
