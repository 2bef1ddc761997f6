// Warps that read inputs other than position and time, beside plain functions of numbers. See stress.js.
import { onSmallMesh, seconds } from './plain.js'

const { sin, exp, hypot } = Math

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
