// In the frame of a sketch with three.js in the place of 'warpjet/three': each warp that the sketch makes is kept, and drawn as the
// page says.
import { MeshNormalMaterial, ShaderLib } from 'three'
import { compileWarp } from 'warpjet/itself'
import * as warpjet from 'warpjet/three/itself'

export * from 'warpjet/three/itself'

const { playground } = window
const isOfNormals = playground.view === 'normals'

export function warp(object, offset, options, ...rest) {
  const moved = playground.withSliders(options, { isCopied: false })
  const putOn = isOfNormals ? showNormals(object) : () => {}
  const warped = warpjet.warp(object, offset, moved, ...rest)
  putOn()
  keep('warp', offset, moved, () => {
    const objects = []
    object.traverse((part) => objects.push(part))
    return objects
  })
  return warped
}

export function warpMaterial(material, offset, options, ...rest) {
  const moved = playground.withSliders(options, { isCopied: false })
  const given = isOfNormals && !options?.share ? normalsOf(material) : material
  const warped = warpjet.warpMaterial(given, offset, moved, ...rest)
  if (given !== material) likeBefore(warped.material, material)
  // Whichever they are put on.
  const objects = new Set()
  const { onBeforeRender } = warped.material
  warped.material.onBeforeRender = function (...how) {
    objects.add(how[4])
    return onBeforeRender.apply(this, how)
  }
  keep('warpMaterial', offset, moved, () => [...objects])
  return warped
}

function keep(maker, offset, { space = 'local', uniforms = {}, surfaceVariation } = {}, objects) {
  playground.keep(
    maker,
    () =>
      playground.withLines(
        compileWarp(offset, {
          uniforms: Object.fromEntries(
            Object.entries(uniforms).map(([name, value]) => [name, () => plain(value)]),
          ),
          surfaceVariation: surfaceVariation ?? true,
          debug: true,
        }),
      ),
    {
      surfaceVariation,
      space,
      radius: 1,
      declared: Object.keys(uniforms),
      shapes: () => shapesOf(objects()),
    },
  )
}

/** As `compileWarp` takes it, which knows nothing of three.js. */
function plain(given) {
  const value = typeof given === 'function' ? given() : given
  if (value?.isTexture) return { width: 1, height: 1 }
  return value?.toArray?.() ?? value
}

/** As arrays, for mesh.js. */
function shapesOf(objects) {
  const meshes = objects.filter(({ isMesh, geometry }) => isMesh && geometry)
  return meshes.map((mesh) => {
    if (
      mesh.isInstancedMesh ||
      mesh.isBatchedMesh ||
      mesh.isSkinnedMesh ||
      mesh.morphTargetInfluences
    )
      throw new Error(
        `The shape cannot be saved: ${mesh.name || `the ${mesh.type}`} is moved by instances, bones or morph targets, too.`,
      )
    mesh.updateWorldMatrix(true, false)
    const { positions, normals, uvs, indices } = warpjet.fromBufferGeometry(mesh.geometry)
    return {
      positions,
      normals,
      uvs,
      indices: indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i),
      matrix: mesh.matrixWorld.elements,
    }
  })
}

const copied = [
  'bumpMap',
  'bumpScale',
  'displacementBias',
  'displacementMap',
  'displacementScale',
  'flatShading',
  'normalMap',
  'normalMapType',
  'side',
  'visible',
  'wireframe',
]

/** A material that shows normals; those whose shader is the sketch's own stay as they are. */
function normalsOf(material) {
  if (!material?.isMaterial || material.isShaderMaterial) return material
  const normals = new MeshNormalMaterial()
  for (const name of copied) if (name in material) normals[name] = material[name]
  if (material.normalScale) normals.normalScale.copy(material.normalScale)
  return normals
}

// Three.js hands the shader whatever a material has, such as a colour that glows.
if (isOfNormals)
  ShaderLib.normal.uniforms = { ...ShaderLib.physical.uniforms, ...ShaderLib.normal.uniforms }

/** The sketch goes on setting what its own material has, such as its colour. */
function likeBefore(normals, material) {
  for (const name of Object.keys(material))
    if (!(name in normals) && !/^_?is[A-Z]|^_?transmission$/.test(name))
      normals[name] = material[name]
}

/** Puts such materials on the meshes of an object → what is left to do once they are warped. */
function showNormals(object) {
  const made = new Map()
  const meshes = []
  const normalsFor = (material) => {
    if (!made.has(material)) made.set(material, normalsOf(material))
    return made.get(material)
  }
  object?.traverse?.((part) => {
    const { isMesh, material } = part
    if (!isMesh || !material) return
    meshes.push([part, material])
    part.material = Array.isArray(material) ? material.map(normalsFor) : normalsFor(material)
  })
  return () => {
    for (const [part, before] of meshes) {
      const after = [part.material].flat()
      for (const [i, material] of [before].flat().entries()) likeBefore(after[i], material)
    }
  }
}
