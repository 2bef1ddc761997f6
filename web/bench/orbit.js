/** Dragging on the picture rotates the camera about the center of the mesh. */
import { defaultEye } from './scene.js'

const RADIANS_PER_PIXEL = 0.008
/** In radians, less than π/2: seen from straight above, the up direction is undefined. */
const MAX_LATITUDE = 1.5

/** @returns direction(): the unit vector from the center to the camera */
export function orbit(canvas) {
  let longitude = Math.atan2(defaultEye[0], defaultEye[2])
  let latitude = Math.asin(defaultEye[1] / Math.hypot(...defaultEye))

  canvas.addEventListener('pointerdown', ({ pointerId }) => canvas.setPointerCapture(pointerId))
  canvas.addEventListener('pointermove', ({ pointerId, movementX, movementY }) => {
    if (!canvas.hasPointerCapture(pointerId)) return
    longitude -= RADIANS_PER_PIXEL * movementX
    latitude += RADIANS_PER_PIXEL * movementY
    latitude = Math.max(-MAX_LATITUDE, Math.min(MAX_LATITUDE, latitude))
  })

  return () => [
    Math.cos(latitude) * Math.sin(longitude),
    Math.sin(latitude),
    Math.cos(latitude) * Math.cos(longitude),
  ]
}
