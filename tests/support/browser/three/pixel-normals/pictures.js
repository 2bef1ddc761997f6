// Pictures for tests of normals at pixels, for both renderers: surfaces that collapse, flat-shaded facets, and maps.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { collapses } from './scenes.js'
import { warps } from './warps.js'

/** Makes a normal map of bumps. */
export function makeBumps() {
  const count = 16
  const bytes = Uint8Array.from({ length: 4 * count * count }, (_, i) => {
    const texel = i >> 2
    const [x, y] = [Math.sin((texel % count) * 0.8), Math.cos(Math.floor(texel / count) * 0.9)]
    return [128 + 60 * x, 128 + 60 * y, 220, 255][i % 4]
  })
  const map = new THREE.DataTexture(bytes, count, count)
  map.needsUpdate = true
  return map
}

/** Makes a normal map of one direction, in floats. */
export function makeNormalMap(direction) {
  const map = new THREE.DataTexture(
    Float32Array.from([...direction.map((x) => 0.5 * x + 0.5), 1]),
    1,
    1,
    THREE.RGBAFormat,
    THREE.FloatType,
  )
  map.needsUpdate = true
  return map
}

/** Returns a scene with the light at the eye, and an object that `offset` warps. */
export function litScene(
  material,
  offset,
  options,
  geometry = new THREE.SphereGeometry(1, 24, 16),
) {
  const scene = new THREE.Scene()
  const light = new THREE.DirectionalLight(0xffffff, 2)
  light.position.set(0, 0, 8)
  const object = new THREE.Mesh(geometry, material)
  object.rotation.set(0.5, -0.4, 0.2)
  scene.add(light, object)
  const warped = warp(object, offset, options)
  return { scene, object, warped }
}

/** Returns the numbers of covered pixels, of those that are not finite (`wrong`), and of dark ones, which include back faces. */
export function summarize(picture) {
  const counts = { covered: 0, wrong: 0, dark: 0 }
  for (let i = 0; i < picture.length; i += 4) {
    if (picture[i + 3] === 0) continue
    counts.covered++
    const colour = picture.slice(i, i + 3)
    if (!colour.every(Number.isFinite)) counts.wrong++
    if (!(colour[0] + colour[1] + colour[2] > 0.02)) counts.dark++
  }
  return counts
}

/** Counts the pixels of two pictures that differ. */
export function countDifferences(a, b, tolerance = 1e-3) {
  let count = 0
  for (let i = 0; i < a.length; i += 4)
    if ([0, 1, 2, 3].some((k) => !(Math.abs(a[i + k] - b[i + k]) <= tolerance))) count++
  return count
}

/**
 * Draws a collapsing surface lit and with its normals as colours, and counts the pixels that differ from pictures of the flat-shaded
 * surface.
 */
export async function collapse({ draw, makers }, name, { normals, side = 'FrontSide' }) {
  const offset = collapses[name]
  const options = { side: THREE[side] }
  const drawWarped = async (material, warpOptions) => {
    const { scene, warped } = litScene(material, offset, warpOptions)
    const picture = await draw(scene)
    warped.dispose()
    return picture
  }
  const lit = await drawWarped(makers.standard(options), { normals })
  const shown = await drawWarped(makers.normal(options), { normals })
  const facets = await drawWarped(makers.normal({ ...options, flatShading: true }), {
    normals: 'vertex',
  })
  const litFacets = await drawWarped(makers.standard({ ...options, flatShading: true }), {
    normals: 'vertex',
  })
  return {
    ...summarize(lit),
    finite: shown.every(Number.isFinite),
    differing: countDifferences(shown, facets),
    differingInLight: countDifferences(lit, litFacets),
  }
}

/**
 * Draws a surface that collapses, and so has no warped tangents, with a normal map of the direction (x, y, z). Returns the number of
 * pixels, and the max distance between their normals and (x, y, 0) + z times the normal of the triangle, normalized: the tangents are then
 * the axes of the view.
 */
export async function collapseWithMap({ draw, decode, makers }, [x, y, z]) {
  const geometry = new THREE.SphereGeometry(1, 24, 16)
  geometry.computeTangents()
  const drawNormals = async (options, normals) => {
    const { scene, warped } = litScene(
      makers.normal(options),
      collapses.floor,
      { normals },
      geometry,
    )
    const picture = decode(await draw(scene))
    warped.dispose()
    return picture
  }
  const mapped = await drawNormals({ normalMap: makeNormalMap([x, y, z]) }, 'pixel')
  const facets = await drawNormals({ flatShading: true }, 'vertex')
  const readNormal = (picture, i) =>
    new THREE.Vector3(...picture.slice(i, i + 3)).multiplyScalar(2).subScalar(1)
  let [covered, worst] = [0, 0]
  for (let i = 0; i < mapped.length; i += 4) {
    if (!mapped[i + 3]) continue
    covered++
    const expected = readNormal(facets, i).normalize().multiplyScalar(z)
    expected.add(new THREE.Vector3(x, y, 0)).normalize()
    worst = Math.max(worst, readNormal(mapped, i).distanceTo(expected))
  }
  return { covered, worst }
}

/**
 * Counts the pixels that differ between normals at vertices and at pixels with flat shading. None may differ: warps do not smooth facets.
 */
export async function countFacetDifferences({ draw, makers }, name) {
  const pictures = []
  for (const normals of ['vertex', 'pixel']) {
    const { scene, warped } = litScene(makers.standard({ flatShading: true }), warps[name], {
      normals,
    })
    pictures.push(await draw(scene))
    warped.dispose()
  }
  return countDifferences(...pictures)
}

const maps = {
  normalMap: () => ({ normalMap: makeBumps() }),
  bumpMap: () => ({ bumpMap: makeBumps(), bumpScale: 4 }),
  'both sides': () => ({ normalMap: makeBumps(), side: THREE.DoubleSide }),
  clearcoat: () => ({ clearcoat: 1, clearcoatNormalMap: makeBumps() }),
  anisotropy: () => ({ anisotropy: 1 }),
  // Nothing is behind the object, so that only the diffuse half of the light is visible.
  transmission: () => ({ transmission: 0.5, thickness: 1 }),
  tangents: () => ({ normalMap: makeBumps() }),
}
export const mapNames = Object.keys(maps)

/** Draws a material with a map, with normals at vertices and at pixels → a summary of the latter, and the number of differing pixels. */
export async function drawWithMap({ draw, makers }, name, offsetName = 'simplex') {
  const pictures = []
  for (const normals of ['vertex', 'pixel']) {
    const geometry = new THREE.SphereGeometry(1, 24, 16)
    if (name === 'tangents') geometry.computeTangents()
    const { scene, warped } = litScene(
      makers.physical(maps[name]()),
      warps[offsetName],
      { normals },
      geometry,
    )
    pictures.push(await draw(scene))
    warped.dispose()
  }
  return { ...summarize(pictures[1]), differing: countDifferences(...pictures) }
}
