/** Dragging on the picture turns the eye about the middle of the mesh. */
import { usualEye } from './scene.js'

const RADIANS_A_PIXEL = 0.008
/** From straight above, nothing says which way is up. */
const STEEPEST = 1.5

/** @returns direction(): from the middle to the eye, of length 1 */
export function orbit(canvas) {
  let longitude = Math.atan2(usualEye[0], usualEye[2])
  let latitude = Math.asin(usualEye[1] / Math.hypot(...usualEye))

  canvas.addEventListener('pointerdown', ({ pointerId }) => canvas.setPointerCapture(pointerId))
  canvas.addEventListener('pointermove', ({ pointerId, movementX, movementY }) => {
    if (!canvas.hasPointerCapture(pointerId)) return
    longitude -= RADIANS_A_PIXEL * movementX
    latitude += RADIANS_A_PIXEL * movementY
    latitude = Math.max(-STEEPEST, Math.min(STEEPEST, latitude))
  })

  return () => [
    Math.cos(latitude) * Math.sin(longitude),
    Math.sin(latitude),
    Math.cos(latitude) * Math.cos(longitude),
  ]
}
