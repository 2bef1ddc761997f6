// Materials that draw the shadow of a displaced mesh: three's own, with the displacement as a warp.
import type { Material } from 'three'
import { replaceProperties } from '../properties.js'
import { uniformsFor } from '../shader-weaver.js'
import { weave } from '../weave.js'
import { messageOf, renameUniforms } from './exact-material.js'
import { withExactFunctions, withExactNames } from './exact-names.js'
import type { MeshReading } from './mesh-reading.js'
import type { Reading } from './reading.js'
import type { ExactShader } from './shader.js'

/** Variables that are different for a light than for the camera. */
const ofCamera = [
  'viewMatrix',
  'modelViewMatrix',
  'projectionMatrix',
  'normalMatrix',
  'cameraPosition',
  'isOrthographic',
]

/** Attributes that three.js declares. */
const declared = new Set(['instanceMatrix', 'instanceColor'])

/** Lets three.js compile a material again when the shader of the mesh has changed. */
function followVersion(material: Material, reading: MeshReading) {
  let { version } = material
  let state = reading.exact?.state
  replaceProperties(material, {
    version: {
      get() {
        const now = reading.exact?.state
        if (now !== state) version++
        state = now
        return version
      },
      set: (assigned: number) => void (version = assigned),
    },
  })
}

export function putShadow<Kind extends Material>(material: Kind, reading: MeshReading): Kind {
  followVersion(material, reading)
  material.customProgramCacheKey = () => `exactNormals ${reading.onGpu()?.warp.key}`
  material.onBeforeCompile = (shader) => {
    const found = reading.onGpu()
    if (!found) return
    try {
      putDisplacement(shader as unknown as ExactShader, found, material)
    } catch (error) {
      reading.exact?.warn(
        `has the shadow of the mesh without its displacement: ${messageOf(error)}`,
      )
    }
  }
  return material
}

function putDisplacement(shader: ExactShader, { warp, parameters }: Reading, material: Material) {
  const unknown = parameters.find(
    ({ name, isAttribute }) => ofCamera.includes(name) || !(isAttribute || name === 'modelMatrix'),
  )
  if (unknown)
    throw new Error(
      `it moves vertices by ${unknown.name}, which ${ofCamera.includes(unknown.name) ? 'is that of the light there' : 'has no value yet'}.`,
    )
  const attributes = parameters
    .filter(
      ({ name, isAttribute }) => isAttribute && !declared.has(name) && !name.startsWith('gl_'),
    )
    .map(({ name, type }) => `attribute ${type} ${name};\n`)
  // The displacement of a displacement map is among those of the warp.
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
