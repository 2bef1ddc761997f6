// Scenes with the option `detail`, and how their pictures differ. `draw(scene, camera)` returns RGBA bytes, and `triangles()` the number of triangles that it drew.
import * as THREE from 'three'
import { warp } from 'warpjet/three'
import { countHoles as countOpen } from '../../holes.js'
import { beyondPixel } from '../../pixels.js'

export const size = 256

const swirl = (glsl, { x, y, z }, angle) => {
  const [c, s] = [angle.cos(), angle.sin()]
  return glsl.vec3(x.mult(c).sub(z.mult(s)), y, x.mult(s).add(z.mult(c)))
}

const partsOf = (position) => ({ x: position.x(), y: position.y(), z: position.z() })

export const offsets = {
  twist: ({ glsl, position, uniforms }) =>
    swirl(glsl, partsOf(position), position.y().mult(uniforms.amount)).sub(position),
  bend({ glsl, position, uniforms }) {
    const { x, y, z } = partsOf(position)
    const angle = y.mult(uniforms.amount)
    const radius = glsl.val(1).div(uniforms.amount).sub(x)
    const along = angle.sin().mult(radius)
    const bent = glsl.val(1).div(uniforms.amount).sub(angle.cos().mult(radius))
    return glsl.vec3(bent, along, z).sub(position)
  },
  noise: ({ glsl, position, millis, uniforms }) =>
    glsl
      .normalize(position)
      .mult(
        glsl.simplex(position.mult(2).add(glsl.vec3(0, 0, millis.div(1000)))).mult(uniforms.amount),
      ),
}

const amounts = { twist: 1.1, bend: 0.8, noise: 0.25 }

export const uniformsOf = (name) => ({ amount: amounts[name] })

const geometries = {
  box: () => new THREE.BoxGeometry(1.4, 1.8, 1.4),
  fine: () => new THREE.BoxGeometry(1.4, 1.8, 1.4, 64, 64, 64),
  sphere: () => new THREE.IcosahedronGeometry(1, 2),
  ball: () => new THREE.SphereGeometry(1.3, 16, 12),
  fineBall: () => new THREE.SphereGeometry(1.3, 160, 120),
}

export function camera() {
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50)
  camera.position.set(2.2, 2, 4)
  camera.lookAt(0, 0, 0)
  return camera
}

const lights = {
  sun() {
    const sun = new THREE.DirectionalLight(0xffffff, 3)
    sun.position.set(3, 5, 2)
    sun.shadow.mapSize.setScalar(2048)
    Object.assign(sun.shadow.camera, { left: -2.5, right: 2.5, bottom: -2.5, top: 2.5 })
    return sun
  },
  bulb() {
    const bulb = new THREE.PointLight(0xffffff, 60)
    bulb.position.set(1.5, 2.5, 1)
    bulb.shadow.mapSize.setScalar(1024)
    return bulb
  },
}

/** Returns { scene, mesh }: a scene with one object, which casts a shadow on a floor if `hasShadow`. */
export function sceneOf(geometry, { hasShadow = false, light = 'sun', material } = {}) {
  const scene = new THREE.Scene()
  const mesh = new THREE.Mesh(
    typeof geometry === 'string' ? geometries[geometry]() : geometry,
    material ?? (hasShadow ? new THREE.MeshLambertMaterial() : new THREE.MeshNormalMaterial()),
  )
  scene.add(mesh)
  if (!hasShadow) return { scene, mesh }
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(12, 12), new THREE.MeshLambertMaterial())
  floor.rotation.x = -Math.PI / 2
  floor.position.y = -1.2
  floor.receiveShadow = mesh.castShadow = true
  const lamp = lights[light]()
  lamp.castShadow = true
  scene.add(floor, lamp, new THREE.AmbientLight(0xffffff, 0.6))
  return { scene, mesh }
}

export const warpBy = (mesh, name, detail, moreOptions) =>
  warp(mesh, offsets[name], { uniforms: uniformsOf(name), detail, ...moreOptions })

const imageOf = (data) => ({ width: size, height: size, data })

/** Counts the pixels of both pictures whose color the other one has nowhere within one pixel. */
export const countBeyond = (a, b, tolerance = 24) => beyondPixel(imageOf(a), imageOf(b), tolerance)

/** Counts the pixels that objects cover. */
export const covered = (picture) => {
  let count = 0
  for (let i = 3; i < picture.length; i += 4) if (picture[i] > 0) count++
  return count
}

/** Counts the pixels of the background that are surrounded by objects. */
export const countHoles = (picture) => countOpen(size, (i) => picture[4 * i + 3] === 0)
