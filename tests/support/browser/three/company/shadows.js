// Rows of the company tests for shadows, including cascaded ones.
import * as THREE from 'three'
import { CSM } from 'three/addons/csm/CSM.js'
import { camera, floor, litScene, makeRow, mesh, standard } from './lib.js'

/**
 * Makes a row with cascades, which are set up for the materials of the object and the floor 'before' the warp, 'after' it, or 'after a
 * frame'. If `isShared`, the floor has the material of the object.
 */
const makeCascadeRow =
  (when, { isShared = false } = {}) =>
  ({ put, renderer }) => {
    renderer.shadowMap.enabled = true
    const scene = litScene()
    scene.children[0].castShadow = false
    const view = camera()
    const csm = new CSM({
      maxFar: 20,
      cascades: 2,
      mode: 'practical',
      parent: scene,
      shadowMapSize: 512,
      lightDirection: new THREE.Vector3(-1, -2, -1).normalize(),
      camera: view,
    })
    const object = mesh()
    const ground = floor()
    object.castShadow = object.receiveShadow = true
    scene.add(object, ground)
    if (isShared) ground.material = object.material
    else csm.setupMaterial(ground.material)
    if (when === 'before') csm.setupMaterial(object.material)
    put(object)
    if (when === 'after a frame') renderer.render(scene, view)
    if (when !== 'before') {
      csm.setupMaterial(object.material)
      object.material.needsUpdate = true
    }
    csm.update()
    renderer.render(scene, view)
    view.fov = 40
    view.updateProjectionMatrix()
    csm.updateFrustums()
    csm.update()
    renderer.render(scene, view)
    csm.remove()
    csm.dispose()
  }

const makePointLightRow = () =>
  makeRow(() => mesh(), {
    shadow: true,
    after({ scene }) {
      scene.children[0].castShadow = false
      const light = new THREE.PointLight(0xffffff, 20)
      light.position.set(1, 2, 2)
      light.castShadow = true
      light.shadow.bias = -0.01
      scene.add(light)
    },
  })

export const rows = {
  'a directional light casts shadows': makeRow(() => mesh(), { shadow: true }),
  'a point light casts shadows': makePointLightRow(),
  'alphaTest cuts holes': makeRow(() => mesh(standard({ alphaTest: 0.5, opacity: 1 })), {
    shadow: true,
  }),
  'cascades are set up before the warp': makeCascadeRow('before'),
  'cascades are set up after the warp': makeCascadeRow('after'),
  'cascades are set up after a frame': makeCascadeRow('after a frame'),
  'cascades are set up on a material that an unwarped mesh shares': makeCascadeRow('after', {
    isShared: true,
  }),
}
