// Replaces 'warpjet/three' in the iframe of a three.js sketch: records each warp that the sketch makes, and draws normals as colours if
// the page asks for that.
import { MeshNormalMaterial, ShaderLib } from 'three'
import { compileWarp } from 'warpjet/itself'
import * as warpjet from 'warpjet/three/itself'

export * from 'warpjet/three/itself'

const { playground } = window
const drawsNormals = playground.view === 'normals'

export function warp(object, offset, options, ...rest) {
  const withSliders = playground.withSliders(options, { readsOnce: false })
  const finish = drawsNormals ? showNormals(object) : () => {}
  const warped = warpjet.warp(object, offset, withSliders, ...rest)
  finish()
  record('warp', offset, withSliders, () => {
    const objects = []
    object.traverse((part) => objects.push(part))
    return objects
  })
  return warped
}

export function warpMaterial(material, offset, options, ...rest) {
  const withSliders = playground.withSliders(options, { readsOnce: false })
  const drawnMaterial = drawsNormals && !options?.share ? normalsOf(material) : material
  const warped = warpjet.warpMaterial(drawnMaterial, offset, withSliders, ...rest)
  if (drawnMaterial !== material) copyOwnProperties(warped.material, material)
  // Collect the objects that use the material.
  const objects = new Set()
  const { onBeforeRender } = warped.material
  warped.material.onBeforeRender = function (...args) {
    // The fifth argument is the object.
    objects.add(args[4])
    return onBeforeRender.apply(this, args)
  }
  record('warpMaterial', offset, withSliders, () => [...objects])
  return warped
}

function record(
  method,
  offset,
  { space = 'local', uniforms = {}, surfaceVariation } = {},
  objects,
) {
  playground.record(
    method,
    () =>
      playground.withLines(
        compileWarp(offset, {
          uniforms: Object.fromEntries(
            Object.entries(uniforms).map(([name, value]) => [name, () => toPlainValue(value)]),
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

/** Converts a value of three.js to one that `compileWarp` accepts. */
function toPlainValue(valueOrFunction) {
  const value = typeof valueOrFunction === 'function' ? valueOrFunction() : valueOrFunction
  // Only the shader code is used, so the size of the image does not matter.
  if (value?.isTexture) return { width: 1, height: 1 }
  return value?.toArray?.() ?? value
}

/** Returns the shapes as arrays for mesh.js. */
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
        `The shape cannot be saved: ${mesh.name || `the ${mesh.type}`} has instances, bones or morph targets, which cannot be saved.`,
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

const copiedProperties = [
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

/** Returns a material that shows normals; a material with the sketch's own shader is returned unchanged. */
function normalsOf(material) {
  if (!material?.isMaterial || material.isShaderMaterial) return material
  const normals = new MeshNormalMaterial()
  for (const name of copiedProperties) if (name in material) normals[name] = material[name]
  if (material.normalScale) normals.normalScale.copy(material.normalScale)
  return normals
}

// copyOwnProperties gives a MeshNormalMaterial properties such as `emissive`. three.js then sets their uniforms, so its shader must have
// them.
if (drawsNormals)
  ShaderLib.normal.uniforms = { ...ShaderLib.physical.uniforms, ...ShaderLib.normal.uniforms }

/** Copies the properties of the sketch's material that the sketch may continue to set, such as its colour. */
function copyOwnProperties(normals, material) {
  for (const name of Object.keys(material))
    if (!(name in normals) && !/^_?is[A-Z]|^_?transmission$/.test(name))
      normals[name] = material[name]
}

/** Makes the meshes of an object show normals. Returns a function that must be called after the warp is applied. */
function showNormals(object) {
  const normalMaterials = new Map()
  const meshes = []
  const normalsFor = (material) => {
    if (!normalMaterials.has(material)) normalMaterials.set(material, normalsOf(material))
    return normalMaterials.get(material)
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
      for (const [i, material] of [before].flat().entries()) copyOwnProperties(after[i], material)
    }
  }
}
