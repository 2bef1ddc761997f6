/** Finds the cameras of lights that cast shadows: a mesh outside of the picture may cast a shadow into it. */
import {
  PerspectiveCamera,
  Vector3,
  type Camera,
  type DirectionalLight,
  type Light,
  type PointLight,
  type SpotLight,
} from 'three'
import type { Render } from './render.js'

/** A camera, and the size of its picture in pixels. */
export interface SizedCamera {
  readonly camera: Camera
  readonly width: number
  readonly height: number
}

const camerasByRender = new WeakMap<Render, SizedCamera[]>()

/** Returns the cameras of all shadows of a render call, with the sizes of their maps. */
export function shadowCamerasOf(render: Render): SizedCamera[] {
  let cameras = camerasByRender.get(render)
  if (cameras) return cameras
  cameras = []
  render.scene.traverseVisible((object) => {
    const light = object as Light & Partial<DirectionalLight & PointLight & SpotLight>
    if (light.isLight && light.castShadow && light.shadow) cameras!.push(...camerasOf(light as Lit))
  })
  camerasByRender.set(render, cameras)
  return cameras
}

type Lit = DirectionalLight | SpotLight | PointLight

function camerasOf(light: Lit): SizedCamera[] {
  const { x: width, y: height } = light.shadow.mapSize
  if ((light as PointLight).isPointLight)
    return cubeCamerasOf(light as PointLight).map((camera) => ({ camera, width, height }))
  const { shadow } = light as SpotLight
  shadow.updateMatrices(light as SpotLight)
  return [{ camera: shadow.camera, width, height }]
}

const aroundLights = new WeakMap<PointLight, PerspectiveCamera[]>()

/** Returns cameras that look from the light at the six sides of a cube. */
function cubeCamerasOf(light: PointLight): PerspectiveCamera[] {
  let cameras = aroundLights.get(light)
  if (!cameras)
    aroundLights.set(light, (cameras = sides.map(() => new PerspectiveCamera(90, 1, 0.1, 1))))
  const { near, far } = light.shadow.camera as PerspectiveCamera
  cameras.forEach((camera, i) => {
    Object.assign(camera, { near, far })
    camera.up.copy(sides[i]!.up)
    camera.position.setFromMatrixPosition(light.matrixWorld)
    camera.lookAt(place.copy(camera.position).add(sides[i]!.ahead))
    camera.updateProjectionMatrix()
    camera.updateMatrixWorld()
  })
  return cameras
}

const place = new Vector3()

const sides = [0, 1, 2].flatMap((axis) =>
  [1, -1].map((sign) => ({
    ahead: new Vector3().setComponent(axis, sign),
    up: new Vector3().setComponent((axis + 1) % 3, 1),
  })),
)
