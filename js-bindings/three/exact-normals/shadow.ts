// Shadows of displaced meshes: the displacement, as a warp, is inserted into the depth and distance materials of three.js.
import type { Material } from 'three'
import { replaceProperties } from '../properties.js'
import { uniformsFor } from '../shader-weaver.js'
import { weave } from '../weave.js'
import type { Displacement } from './displacement.js'
import { messageOf, renameUniforms } from './exact-material.js'
import { withExactFunctions, withExactNames } from './exact-names.js'
import type { MeshDisplacement } from './mesh-displacement.js'
import type { ExactShader } from './shader.js'

/** Variables whose values differ between a light, for which shadows are drawn, and the camera. */
const cameraVariables = [
  'viewMatrix',
  'modelViewMatrix',
  'projectionMatrix',
  'normalMatrix',
  'cameraPosition',
  'isOrthographic',
]

/** Attributes that three.js declares. */
const declared = new Set(['instanceMatrix', 'instanceColor'])

/** Makes three.js compile the shadow's material again when the shader of the mesh has changed. */
function followVersion(material: Material, displacement: MeshDisplacement) {
  let { version } = material
  let state = displacement.exactMaterial?.state
  replaceProperties(material, {
    version: {
      get() {
        const currentState = displacement.exactMaterial?.state
        if (currentState !== state) version++
        state = currentState
        return version
      },
      set: (assigned: number) => void (version = assigned),
    },
  })
}

export function displaceShadow<Kind extends Material>(
  material: Kind,
  displacement: MeshDisplacement,
): Kind {
  followVersion(material, displacement)
  material.customProgramCacheKey = () => `exactNormals ${displacement.readForGpu()?.warp.key}`
  material.onBeforeCompile = (shader) => {
    const found = displacement.readForGpu()
    if (!found) return
    try {
      insertDisplacement(shader as unknown as ExactShader, found, material)
    } catch (error) {
      displacement.exactMaterial?.warn(
        `cannot displace the shadow of the mesh: ${messageOf(error)}`,
      )
    }
  }
  return material
}

function insertDisplacement(
  shader: ExactShader,
  { warp, parameters }: Displacement,
  material: Material,
) {
  const unknown = parameters.find(
    ({ name, isAttribute }) =>
      cameraVariables.includes(name) || !(isAttribute || name === 'modelMatrix'),
  )
  if (unknown)
    throw new Error(
      `it moves vertices by ${unknown.name}, which ${cameraVariables.includes(unknown.name) ? 'belongs to the light while shadows are drawn' : 'has no value yet'}.`,
    )
  const attributes = parameters
    .filter(
      ({ name, isAttribute }) => isAttribute && !declared.has(name) && !name.startsWith('gl_'),
    )
    .map(({ name, type }) => `attribute ${type} ${name};\n`)
  // The warp already includes the displacement map.
  const vertexShader = shader.vertexShader.replace('#include <displacementmap_vertex>', '')
  const woven = weave(`${attributes.join('')}${vertexShader}`, warp, {
    mayHaveTangents: false,
    hasColors: false,
    isShaderMaterial: false,
    isRaw: false,
    isGlsl100: false,
  })
  Object.assign(shader.uniforms, renameUniforms(uniformsFor(warp, material)))
  shader.vertexShader = withExactNames(withExactFunctions(woven))
}
