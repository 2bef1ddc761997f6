// A sphere displaced by the heights in an image: by a warp, and vertex by vertex on the CPU, which samples in double precision at coordinates
// that three's texture matrix transforms.
import * as THREE from 'three'
import { glslOffset } from 'warpjet/glsl'
import { warp } from 'warpjet/three'
import { randomImage, sample } from '../../../operations/textures.js'

const image = randomImage(7, 5, 3)
/** The factor of texture coordinates, which makes them exceed 1, so that the wrap mode matters. */
const uvScale = 2.3

export function makeTexture({ wrapS, wrapT, magFilter, ...transform }) {
  const texture = new THREE.DataTexture(new Uint8Array(image.data), image.width, image.height)
  texture.wrapS = THREE[wrapS]
  texture.wrapT = THREE[wrapT]
  texture.magFilter = THREE[magFilter]
  const { offset = [0, 0], repeat = [1, 1], rotation = 0, center = [0, 0] } = transform
  for (const [name, vector] of Object.entries({ offset, repeat, center }))
    texture[name].set(...vector)
  texture.rotation = rotation
  texture.needsUpdate = true
  return texture
}

/** Maps a way to write the offset → the offset. */
export const heights = {
  builder: ({ glsl, position, uv, uniforms }) =>
    position.mult(glsl.texture(uniforms.map, uv.mult(uvScale)).r().mult(0.4)),
  glsl: glslOffset(`#version 300 es
    uniform sampler2D map;
    vec3 offset(vec3 position, vec2 uv) { return position * texture(map, uv * ${uvScale}).r * 0.4; }`),
}

const wrapModes = {
  ClampToEdgeWrapping: 'clamp',
  RepeatWrapping: 'repeat',
  MirroredRepeatWrapping: 'mirror',
}

export const makeSphere = () => new THREE.SphereGeometry(1, 40, 24)

function heightAt(texture, { wrapS, wrapT, magFilter }, place, isTransformed) {
  if (isTransformed) {
    texture.updateMatrix()
    place.applyMatrix3(texture.matrix)
  }
  const filter = magFilter === 'NearestFilter' ? 'nearest' : 'bilinear'
  return sample(image, place.x, place.y, { filter, wrap: [wrapModes[wrapS], wrapModes[wrapT]] })[0]
}

/** Displaces the vertices of a sphere on the CPU. */
export function bakeGeometry(settings, isTransformed) {
  const texture = makeTexture(settings)
  const sphere = makeSphere()
  const { position, uv } = sphere.attributes
  for (let i = 0; i < position.count; i++) {
    const place = new THREE.Vector2(uv.getX(i), uv.getY(i)).multiplyScalar(uvScale)
    const scale = 1 + 0.4 * heightAt(texture, settings, place, isTransformed)
    position.setXYZ(i, ...[0, 1, 2].map((k) => scale * position.getComponent(i, k)))
  }
  return sphere
}

/** Maps a title → the settings of a texture. */
export const samplings = {
  'repeat across, mirror down': {
    wrapS: 'RepeatWrapping',
    wrapT: 'MirroredRepeatWrapping',
    magFilter: 'LinearFilter',
  },
  'clamp across, repeat down': {
    wrapS: 'ClampToEdgeWrapping',
    wrapT: 'RepeatWrapping',
    magFilter: 'LinearFilter',
  },
  'the nearest texel': {
    wrapS: 'RepeatWrapping',
    wrapT: 'RepeatWrapping',
    magFilter: 'NearestFilter',
  },
  'offset, repeat and rotation': {
    wrapS: 'MirroredRepeatWrapping',
    wrapT: 'RepeatWrapping',
    magFilter: 'LinearFilter',
    offset: [0.13, -0.4],
    repeat: [1.7, 0.8],
    rotation: 0.6,
    center: [0.5, 0.2],
  },
}

/** Makes three scenes: warped, moved vertex by vertex, and unmoved. `kind` is a key of `heights`. */
export function scenesOf(name, kind) {
  const settings = samplings[name]
  const makeScene = (geometry) => {
    const scene = new THREE.Scene()
    const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color: 'white' }))
    scene.add(mesh)
    return { scene, mesh }
  }
  const [warped, expected, still] = [
    makeSphere(),
    bakeGeometry(settings, kind === 'builder'),
    makeSphere(),
  ].map(makeScene)
  warp(warped.mesh, heights[kind], {
    uniforms: { map: makeTexture(settings) },
    surfaceVariation: false,
  })
  return { warped: warped.scene, expected: expected.scene, still: still.scene }
}
