// Warps that read inputs other than position and time, with plain functions of numbers. See stress.js.
import { onSmallMesh, seconds } from './plain.js'

const { sin, cos, exp, hypot } = Math

export const inputs = onSmallMesh({
  'inflation along the normal': {
    warp({ position, normal, millis }) {
      const wave = position.x().mult(4).add(millis.div(1000)).sin()
      return normal.scale(wave.mult(0.15).add(0.2))
    },
    offset([x], inputs) {
      return inputs.normal.map((n) => n * (0.2 + 0.15 * sin(4 * x + seconds(inputs))))
    },
  },

  'uv and color': {
    warp: ({ glsl, position, uv, color }) =>
      glsl
        .vec3(uv.x().mult(position.y()), uv.y().mult(5).sin(), color.rgb().dot(position))
        .mult(color.a()),
    offset([x, y, z], { uv, color }) {
      const [r, g, b, alpha] = color
      return [uv[0] * y, sin(5 * uv[1]), r * x + g * y + b * z].map((value) => value * alpha)
    },
  },

  'a mirror, with a wave along it': {
    warp: ({ glsl, position }) =>
      glsl.vec3(position.x().mult(-2), position.x().mult(3).sin().mult(0.2), 0),
    offset: ([x]) => [-2 * x, 0.2 * sin(3 * x), 0],
    mirrors: () => true,
  },

  'a mirror that a parameter controls': {
    warp({ glsl, position }) {
      const flip = glsl.param('flip')
      const wave = position.x().mult(3).sin().mult(0.2).mult(flip)
      return glsl.vec3(position.x().mult(flip.sub(1)), wave, 0)
    },
    offset: ([x], { flip }) => [(flip - 1) * x, 0.2 * flip * sin(3 * x), 0],
    params: { flip: -0.7 },
    mirrors: ({ flip }) => flip < 0,
  },

  'a twisted mirror that the mouse controls': {
    warp({ glsl, position, mouse }) {
      const factor = mouse.x().div(-100)
      const [x, y, z] = [position.x().mult(factor), position.y(), position.z()]
      return glsl
        .rotateY(y)
        .mult(glsl.vec3(x, y, z))
        .sub(position)
    },
    offset([x, y, z], { mouse }) {
      const scaled = (x * mouse[0]) / -100
      return [scaled * cos(y) + z * sin(y) - x, 0, z * cos(y) - scaled * sin(y) - z]
    },
    mirrors: ({ mouse }) => mouse[0] > 0,
  },

  'mouse, size and pixelDensity': {
    warp({ glsl, position, mouse, size, mouseY, width, pixelDensity }) {
      const at = mouse.div(size).mult(2).sub(1)
      const near = position.xy().sub(at).length().mult(pixelDensity).neg().exp()
      return glsl.vec3(position.y().mult(mouseY).div(width), 0, near)
    },
    offset([x, y], { mouse, size, pixelDensity }) {
      const [u, v] = [(2 * mouse[0]) / size[0] - 1, (2 * mouse[1]) / size[1] - 1]
      return [(y * mouse[1]) / size[0], 0, exp(-pixelDensity * hypot(x - u, y - v))]
    },
  },
})
