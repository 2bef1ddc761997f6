// Warps that use each smooth operation, with plain functions of numbers. See stress.js.
import { clamp, mix, onSmallMesh, seconds } from './plain.js'

const { sin, cos, tan, asin, acos, atan, atan2, exp, log, sqrt, abs, hypot } = Math

export const operations = onSmallMesh({
  mix: {
    warp({ glsl, position, millis }) {
      const amount = position.x().mult(2).add(millis.div(1000)).sin().mult(0.5).add(0.5)
      return position
        .zxy()
        .mult(0.4)
        .mix(glsl.vec3(0.2, position.y().mult(-0.3), 0), amount)
    },
    offset([x, y, z], inputs) {
      const amount = 0.5 + 0.5 * sin(2 * x + seconds(inputs))
      return [mix(0.4 * z, 0.2, amount), mix(0.4 * x, -0.3 * y, amount), mix(0.4 * y, 0, amount)]
    },
  },

  'length and dist': {
    warp({ glsl, position, millis }) {
      const away = position.dist(glsl.vec3(0.3, -0.2, 1.5)).sub(millis.div(1000))
      return glsl.vec3(
        position.length().mult(0.3),
        away.mult(5).sin().mult(0.1),
        position.xy().length(),
      )
    },
    offset([x, y, z], inputs) {
      const away = hypot(x - 0.3, y + 0.2, z - 1.5) - seconds(inputs)
      return [0.3 * hypot(x, y, z), 0.1 * sin(5 * away), hypot(x, y)]
    },
  },

  'normalize, cross and dot': {
    warp({ glsl, position, millis }) {
      const axis = glsl.vec3(0.3, 0.9, millis.div(1000).cos().mult(0.3))
      const other = position
        .yzx()
        .add(glsl.vec3(2, 0, 0))
        .normalize()
      return position
        .cross(axis)
        .mult(0.3)
        .add(other.mult(position.dot(axis).mult(0.4)))
    },
    offset([x, y, z], inputs) {
      const [a, b, c] = [0.3, 0.9, 0.3 * cos(seconds(inputs))]
      const along = (0.4 * (a * x + b * y + c * z)) / hypot(y + 2, z, x)
      return [
        0.3 * (y * c - z * b) + along * (y + 2),
        0.3 * (z * a - x * c) + along * z,
        0.3 * (x * b - y * a) + along * x,
      ]
    },
  },

  'pow with whole exponents': {
    warp: ({ glsl, position: p }) =>
      glsl
        .vec3(p.y().pow(2), p.x().pow(3), p.z().add(3).pow(-2).mult(9).add(p.x().pow(5)))
        .mult(0.3),
    offset: ([x, y, z]) => [0.3 * y ** 2, 0.3 * x ** 3, 2.7 * (z + 3) ** -2 + 0.3 * x ** 5],
  },

  'pow with other exponents': {
    warp({ glsl, position, millis }) {
      const base = position.x().add(1.5)
      const exponent = position.y().add(millis.div(1000).sin())
      return glsl.vec3(position.z().abs().pow(1.5), base.pow(0.3), base.pow(exponent).mult(0.2))
    },
    offset([x, y, z], inputs) {
      return [abs(z) ** 1.5, (x + 1.5) ** 0.3, 0.2 * (x + 1.5) ** (y + sin(seconds(inputs)))]
    },
  },

  'atan of one and two arguments': {
    warp({ glsl, position: p, millis }) {
      const around = p.y().atan(p.x()).mult(3).add(millis.div(1000)).sin()
      return glsl
        .vec3(p.y().mult(2).atan(), around.mult(0.1), glsl.atan(p.x(), p.z().add(3)))
        .mult(0.5)
    },
    offset([x, y, z], inputs) {
      const around = sin(3 * atan2(y, x) + seconds(inputs))
      return [0.5 * atan(2 * y), 0.05 * around, 0.5 * atan2(x, z + 3)]
    },
  },

  'exp, log, sqrt and inversesqrt': {
    warp: ({ glsl, position: p }) =>
      glsl
        .vec3(
          p.y().mult(1.5).exp().mult(0.1),
          p.x().add(2.5).log(),
          p.y().add(1.5).sqrt().add(p.z().add(2).inversesqrt()),
        )
        .mult(0.5),
    offset: ([x, y, z]) => [
      0.05 * exp(1.5 * y),
      0.5 * log(x + 2.5),
      0.5 * (sqrt(y + 1.5) + 1 / sqrt(z + 2)),
    ],
  },

  'tan, asin and acos': {
    warp: ({ glsl, position: p }) =>
      glsl.vec3(p.y().tan(), p.z().mult(0.8).asin(), p.x().mult(0.7).acos()).mult(0.4),
    offset: ([x, y, z]) => [0.4 * tan(y), 0.4 * asin(0.8 * z), 0.4 * acos(0.7 * x)],
  },

  // At the poles neither angle has a derivative.
  'spherical coordinates': {
    warp({ glsl, position, millis }) {
      const [x, y] = [position.x(), position.y()]
      const polar = position.normalize().z().clamp(-1, 1).acos()
      const azimuth = y.atan(x).add(millis.div(1000))
      const swell = polar.mult(2).sin().mult(0.2).mult(azimuth.mult(3).cos())
      return position.mult(swell).add(glsl.vec3(0, 0, polar.mult(0.1)))
    },
    offset([x, y, z], inputs) {
      const polar = acos(clamp(z / (hypot(x, y, z) || 1), -1, 1))
      const swell = 0.2 * sin(2 * polar) * cos(3 * (atan2(y, x) + seconds(inputs)))
      return [x * swell, y * swell, z * swell + 0.1 * polar]
    },
  },

  'nested sines': {
    warp({ position, millis }) {
      let p = position.mult(1.5).add(millis.div(1000))
      for (let i = 0; i < 5; i++) p = p.yzx().mult(1.2).sin().add(p.mult(0.3))
      return p.mult(0.3)
    },
    offset(position, inputs) {
      let p = position.map((x) => 1.5 * x + seconds(inputs))
      for (let i = 0; i < 5; i++) {
        const [x, y, z] = p
        p = [sin(1.2 * y) + 0.3 * x, sin(1.2 * z) + 0.3 * y, sin(1.2 * x) + 0.3 * z]
      }
      return p.map((x) => 0.3 * x)
    },
  },

  'radians, degrees and swizzles': {
    warp: ({ glsl, position: p }) =>
      glsl
        .vec3(p.zx().dot(p.yy()), p.x().mult(90).radians().cos(), p.z().degrees().mult(0.005))
        .mult(0.3),
    offset: ([x, y, z]) => [
      0.3 * (z * y + x * y),
      0.3 * cos((x * Math.PI) / 2),
      (0.0015 * 180 * z) / Math.PI,
    ],
  },
})
