// Warps made of pieces, with kinks and jumps between them, with plain functions of numbers. See stress.js.
import { clamp, onSmallMesh, seconds } from './plain.js'

const { sin, log, abs, sign, floor, min, max, hypot } = Math

export const pieces = onSmallMesh({
  'ifElse and comparisons': {
    warp({ glsl, position, millis }) {
      const [x, y, z] = [position.x(), position.y(), position.z()]
      const edge = millis.div(1000).sin().mult(0.3)
      return glsl.vec3(
        x.gt(edge).ifElse(y.mult(3).sin().mult(0.2), x.mult(x).mult(0.4)),
        x.lt(0.35).and(z.ge(-0.25)).ifElse(x.mult(z).mult(0.3), 0.1),
        y
          .le(edge)
          .or(x.ne(x))
          .ifElse(x.mult(0.3), y.mult(0.2))
          .add(z.eq(2).not().ifElse(y.mult(x).mult(0.1), 7)),
      )
    },
    offset([x, y, z], inputs) {
      const edge = 0.3 * sin(seconds(inputs))
      return [
        x > edge ? 0.2 * sin(3 * y) : 0.4 * x * x,
        x < 0.35 && z >= -0.25 ? 0.3 * x * z : 0.1,
        (y <= edge ? 0.3 * x : 0.2 * y) + 0.1 * y * x,
      ]
    },
  },

  'ifElse of vectors': {
    warp: ({ glsl, position }) =>
      position
        .length()
        .gt(1.2)
        .ifElse(position.mult(0.3), glsl.vec3(position.y(), 0, 0.1).mult(0.5)),
    offset: (p) => (hypot(...p) > 1.2 ? p.map((x) => 0.3 * x) : [0.5 * p[1], 0, 0.05]),
  },

  'clamp with varying bounds': {
    warp({ glsl, position, millis }) {
      const [x, y, z] = [position.x(), position.y(), position.z()]
      const low = y.mult(0.3).sub(0.4)
      const high = z.mult(0.2).add(millis.div(1000).sin().mult(0.1)).add(0.4)
      return glsl
        .vec3(x.clamp(low, high).mult(0.5), y.clamp(-0.5, x.add(1)), x.clamp(0.2, 0.2))
        .mult(0.6)
    },
    offset([x, y, z], inputs) {
      const [low, high] = [0.3 * y - 0.4, 0.2 * z + 0.1 * sin(seconds(inputs)) + 0.4]
      return [0.3 * clamp(x, low, high), 0.6 * clamp(y, -0.5, x + 1), 0.12]
    },
  },

  'min and max': {
    warp: ({ glsl, position: p }) =>
      glsl.vec3(p.x().min(p.y(), 0.3), p.y().max(p.z().mult(2), -0.2), p.z().max(0)).mult(0.4),
    offset: ([x, y, z]) => [0.4 * min(x, y, 0.3), 0.4 * max(y, 2 * z, -0.2), 0.4 * max(z, 0)],
  },

  'abs and sign': {
    warp: ({ glsl, position: p }) =>
      glsl.vec3(p.y().abs(), p.x().sub(0.3).sign().mult(p.z()), p.y().mult(p.x()).abs()).mult(0.5),
    offset: ([x, y, z]) => [0.5 * abs(y), 0.5 * sign(x - 0.3) * z, 0.5 * abs(y * x)],
  },

  'floor, fract, mod and step': {
    warp({ glsl, position, millis }) {
      const [x, y, z] = [position.x(), position.y(), position.z()]
      const steps = x.mult(2.8).floor().mult(y).mult(0.1)
      const teeth = y.mult(2).add(0.3).add(millis.div(1000)).fract().mult(0.2)
      return glsl.vec3(
        steps,
        x.mod(0.7).mult(z),
        glsl
          .step(0.2, z)
          .mult(x)
          .add(teeth)
          .add(x.mod(y.add(3))),
      )
    },
    offset([x, y, z], inputs) {
      const mod = (a, b) => a - b * floor(a / b)
      const tooth = 2 * y + 0.3 + seconds(inputs)
      return [
        0.1 * floor(2.8 * x) * y,
        mod(x, 0.7) * z,
        (z < 0.2 ? 0 : x) + 0.2 * (tooth - floor(tooth)) + mod(x, y + 3),
      ]
    },
  },

  smoothstep: {
    warp: ({ glsl, position: p }) =>
      glsl
        .vec3(
          glsl.smoothstep(-0.5, 0.6, p.y()),
          glsl.smoothstep(p.x().mult(0.3), 1.1, p.z()),
          glsl.smoothstep(0.8, -0.3, p.x()),
        )
        .mult(0.4),
    offset([x, y, z]) {
      const smoothstep = (low, high, value) => {
        const t = clamp((value - low) / (high - low), 0, 1)
        return 0.4 * t * t * (3 - 2 * t)
      }
      return [smoothstep(-0.5, 0.6, y), smoothstep(0.3 * x, 1.1, z), smoothstep(0.8, -0.3, x)]
    },
  },

  // The branch that is not taken divides by zero.
  'guarded divisions': {
    warp({ glsl, position }) {
      const [x, y] = [position.x(), position.y()]
      const away = position.xy().length()
      const components = [
        away.gt(0).ifElse(y.div(away), 0),
        x.gt(0.37).ifElse(x.log(), 0),
        x.abs().gt(0.37).ifElse(y.div(x), 0),
      ]
      return glsl.vec3(...components).mult(0.2)
    },
    offset([x, y]) {
      const away = hypot(x, y)
      return [
        away > 0 ? (0.2 * y) / away : 0,
        x > 0.37 ? 0.2 * log(x) : 0,
        abs(x) > 0.37 ? (0.2 * y) / x : 0,
      ]
    },
  },
})
