// Pictures of the tests of normals at pixels, for both renderers: surfaces that collapse, facets, maps, and normals that someone changes.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { collapses } from './scenes.js'
import { warps } from './warps.js'

/** A map of bumps. */
export function bumps() {
  const count = 16
  const bytes = Uint8Array.from({ length: 4 * count * count }, (_, i) => {
    const at = i >> 2
    const [x, y] = [Math.sin((at % count) * 0.8), Math.cos(Math.floor(at / count) * 0.9)]
    return [128 + 60 * x, 128 + 60 * y, 220, 255][i % 4]
  })
  const map = new THREE.DataTexture(bytes, count, count)
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

/** Returns how many pixels a picture covers, how many are not finite, dark, or face away from the eye, and the picture. */
export function summarize(picture) {
  const found = { covered: 0, wrong: 0, dark: 0 }
  for (let i = 0; i < picture.length; i += 4) {
    if (picture[i + 3] === 0) continue
    found.covered++
    const colour = picture.slice(i, i + 3)
    if (!colour.every(Number.isFinite)) found.wrong++
    if (!(colour[0] + colour[1] + colour[2] > 0.02)) found.dark++
  }
  return found
}

/** Counts the pixels of two pictures that differ. */
export function countDifferences(a, b, tolerance = 1e-3) {
  let count = 0
  for (let i = 0; i < a.length; i += 4)
    if ([0, 1, 2, 3].some((k) => !(Math.abs(a[i + k] - b[i + k]) <= tolerance))) count++
  return count
}

/** A surface that collapses, lit, and its normals beside those of facets. */
export async function collapse({ draw, makers }, name, { normals, side = 'FrontSide' }) {
  const offset = collapses[name]
  const options = { side: THREE[side] }
  const pictureOf = async (material, given) => {
    const { scene, warped } = litScene(material, offset, given)
    const picture = await draw(scene)
    warped.dispose()
    return picture
  }
  const lit = await pictureOf(makers.standard(options), { normals })
  const shown = await pictureOf(makers.normal(options), { normals })
  const facets = await pictureOf(makers.normal({ ...options, flatShading: true }), {
    normals: 'vertex',
  })
  const litFacets = await pictureOf(makers.standard({ ...options, flatShading: true }), {
    normals: 'vertex',
  })
  return {
    ...summarize(lit),
    finite: shown.every(Number.isFinite),
    differing: countDifferences(shown, facets),
    differingInLight: countDifferences(lit, litFacets),
  }
}

/** Flat-shaded facets, whose normals a warp does not smooth. */
export async function facets({ draw, makers }, name) {
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
  normalMap: () => ({ normalMap: bumps() }),
  bumpMap: () => ({ bumpMap: bumps(), bumpScale: 4 }),
  'both sides': () => ({ normalMap: bumps(), side: THREE.DoubleSide }),
  clearcoat: () => ({ clearcoat: 1, clearcoatNormalMap: bumps() }),
  anisotropy: () => ({ anisotropy: 1 }),
  // Behind it is nothing to refract: half of the light is diffuse.
  transmission: () => ({ transmission: 0.5, thickness: 1 }),
  tangents: () => ({ normalMap: bumps() }),
}
export const mapNames = Object.keys(maps)

/** A material with a map, with normals of both kinds → finite pixels, and how many differ. */
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
