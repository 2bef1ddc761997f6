/** The camera: dragging, pinching, the wheel and keys orbit it about the model's center and zoom. */
import { mat4, vec3 } from 'gl-matrix'

const RADIANS_PER_PIXEL = 0.008
const RADIANS_PER_KEY = 0.12
/** In radians, less than π/2: seen from straight above, the up direction is undefined. */
const MAX_LATITUDE = 1.5
/** The vertical field of view in radians. */
const FIELD_OF_VIEW = 0.6
const defaultView = { longitude: 0.55, latitude: 0.22, distance: 4.6 }

const clamp = (value, low, high) => Math.max(low, Math.min(high, value))

/** @returns { view({ center, unit }, aspect), reset() } */
export function makeCamera(canvas, onChange) {
  const orbit = { ...defaultView }
  const pointers = new Map()

  function rotate(dx, dy) {
    orbit.longitude -= dx
    orbit.latitude = clamp(orbit.latitude + dy, -MAX_LATITUDE, MAX_LATITUDE)
    onChange()
  }

  function zoom(factor) {
    orbit.distance = clamp(orbit.distance * factor, 1.5, 20)
    onChange()
  }

  function reset() {
    Object.assign(orbit, defaultView)
    onChange()
  }

  const pointerDistance = () => {
    const [a, b] = pointers.values()
    return Math.hypot(a.x - b.x, a.y - b.y)
  }

  canvas.addEventListener('pointerdown', ({ pointerId, clientX: x, clientY: y }) => {
    canvas.setPointerCapture(pointerId)
    pointers.set(pointerId, { x, y })
  })
  canvas.addEventListener('pointermove', ({ pointerId, clientX: x, clientY: y }) => {
    const before = pointers.get(pointerId)
    if (!before) return
    const distanceBefore = pointers.size === 2 && pointerDistance()
    pointers.set(pointerId, { x, y })
    if (distanceBefore) zoom(distanceBefore / Math.max(pointerDistance(), 1))
    else if (pointers.size === 1)
      rotate(RADIANS_PER_PIXEL * (x - before.x), RADIANS_PER_PIXEL * (y - before.y))
  })
  for (const end of ['pointerup', 'pointercancel'])
    canvas.addEventListener(end, ({ pointerId }) => pointers.delete(pointerId))
  canvas.addEventListener('dblclick', reset)

  // The wheel zooms only if the canvas has the focus or Ctrl is pressed, so that a visitor can scroll past the canvas.
  canvas.addEventListener(
    'wheel',
    (event) => {
      if (!event.ctrlKey && document.activeElement !== canvas) return
      event.preventDefault()
      zoom(Math.exp(clamp(event.deltaY, -100, 100) * 0.002))
    },
    { passive: false },
  )

  const keys = {
    ArrowLeft: () => rotate(-RADIANS_PER_KEY, 0),
    ArrowRight: () => rotate(RADIANS_PER_KEY, 0),
    ArrowUp: () => rotate(0, RADIANS_PER_KEY),
    ArrowDown: () => rotate(0, -RADIANS_PER_KEY),
    '+': () => zoom(0.9),
    '=': () => zoom(0.9),
    '-': () => zoom(1.1),
    0: reset,
  }
  canvas.addEventListener('keydown', (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return
    event.preventDefault()
    keys[event.key]()
  })

  return {
    reset,
    /** @returns the matrix from the model to the screen, and the eye and lights in the model's own space */
    view({ center, unit }, aspect) {
      const { longitude, latitude, distance } = orbit
      const direction = [
        Math.cos(latitude) * Math.sin(longitude),
        Math.sin(latitude),
        Math.cos(latitude) * Math.cos(longitude),
      ]
      // In a tall picture FIELD_OF_VIEW is the horizontal angle, so that the model still fits.
      const field = 2 * Math.atan(Math.tan(FIELD_OF_VIEW / 2) / Math.min(aspect, 1))
      const eye = vec3.scale([], direction, distance)
      const look = mat4.lookAt(mat4.create(), eye, [0, 0, 0], [0, 1, 0])
      const matrix = mat4.perspective(mat4.create(), field, aspect, distance / 20, distance + 20)
      mat4.multiply(matrix, matrix, look)
      mat4.scale(matrix, matrix, [1 / unit, 1 / unit, 1 / unit])
      mat4.translate(matrix, matrix, vec3.negate([], center))
      // The lights follow the camera, so that every side is lit.
      const back = mat4.invert(mat4.create(), look)
      const light = (x, y, z) => {
        const [a, b, c] = vec3.normalize([], [x, y, z])
        return [0, 1, 2].map((i) => back[i] * a + back[4 + i] * b + back[8 + i] * c)
      }
      return {
        matrix,
        eye: vec3.scaleAndAdd([], center, eye, unit),
        key: light(-0.5, 0.8, 0.9),
        rim: light(0.9, -0.2, -0.1),
      }
    },
  }
}
