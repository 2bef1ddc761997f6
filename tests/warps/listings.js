// The warps of the paper, the article and the documentation of p5.warp and glsl-autodiff, rewritten.
import { add, subtract } from '../support/browser/matrix.js'
import { clamp } from './plain.js'

const { sin, cos, hypot, max, PI } = Math

/** Rotates about the x axis. */
const rotateInSketch = (glsl, point, angle) => {
  const [y, z] = [point.y(), point.z()]
  const [c, s] = [angle.cos(), angle.sin()]
  return glsl.vec3(point.x(), c.mult(y).sub(s.mult(z)), s.mult(y).add(c.mult(z)))
}
const rotate = ([x, y, z], angle) => [
  x,
  y * cos(angle) - z * sin(angle),
  y * sin(angle) + z * cos(angle),
]

/** Each warp as an offset function, and as a plain function of numbers, as in the listing. */
export const warps = {
  'the paper: its example of an offset': {
    size: 1,
    warp: ({ glsl, position, millis }) =>
      glsl.vec3(millis.mult(0.005).add(position.y().mult(2)).sin().mult(0.5), 0, 0),
    offset: ([, y], { millis }) => [0.5 * sin(0.005 * millis + 2 * y), 0, 0],
  },

  'the paper: a twist': {
    size: 100,
    warp({ glsl, position, millis }) {
      const angle = position.x().mult(0.02).mult(millis.div(1000).sin())
      return rotateInSketch(glsl, position, angle).sub(position)
    },
    offset: (p, { millis }) => subtract(rotate(p, 0.02 * p[0] * sin(millis / 1000)), p),
  },

  'the README of p5.warp: three sines': {
    size: 1,
    warp({ glsl, position, millis }) {
      const seconds = millis.div(1000)
      const wave = (speed, frequency, along) =>
        glsl.sin(glsl.sum(seconds.mult(speed), along.mult(frequency))).mult(0.15)
      const [x, y, z] = [position.x(), position.y(), position.z()]
      return glsl.vec3(wave(2, 4, y), wave(0.5, 2, z), wave(1.5, 3, x))
    },
    offset([x, y, z], { millis }) {
      const t = millis / 1000
      return [2 * t + 4 * y, 0.5 * t + 2 * z, 1.5 * t + 3 * x].map((angle) => 0.15 * sin(angle))
    },
  },

  'the examples of p5.warp: a twist that goes on turning': {
    size: 100,
    warp({ glsl, position, millis }) {
      const angle = position.x().mult(0.03).add(millis.div(1000))
      return rotateInSketch(glsl, position, angle).sub(position)
    },
    offset: (p, { millis }) => subtract(rotate(p, 0.03 * p[0] + millis / 1000), p),
  },

  'the examples of p5.warp: the wobble': {
    size: 100,
    warp({ glsl, position, millis }) {
      const fromCenter = position.add(glsl.vec3(0, 0, 500))
      const third = fromCenter.div(3)
      const x = third.x().div(100)
      const beat = millis.mult(0.001).sub(x).sin()
      const jitter = millis.mult(0.0001).sin().add(1).mult(0.5)
      const strength = jitter.sub(1).div(10).clamp(0, 0.5).add(0.5)
      const waves = glsl.vec3(
        x.mult(6).add(millis.mult(0.003)).sin().mult(5),
        x.mult(2).add(millis.add(jitter).mult(0.005), 100).sin().mult(10).mult(strength),
        x.mult(8).add(millis.mult(0.006), 10).sin().mult(0.5),
      )
      const swing = beat.add(millis.mult(0.00025).sin()).mult(0.5)
      const flip = beat.clamp(0, 1).mult(PI).mult(millis.mult(0.001).sin())
      const rotated = rotateInSketch(glsl, third, swing).sub(third)
      const flipped = rotateInSketch(glsl, fromCenter, flip).sub(fromCenter)
      return glsl.vecSum(waves, rotated, flipped)
    },
    offset(p, { millis }) {
      const fromCenter = add(p, [0, 0, 500])
      const third = fromCenter.map((value) => value / 3)
      const x = third[0] / 100
      const beat = sin(0.001 * millis - x)
      const jitter = 0.5 + 0.5 * sin(0.0001 * millis)
      const waves = [
        5 * sin(6 * x + 0.003 * millis),
        10 *
          sin(2 * x + 0.005 * (millis + jitter) + 100) *
          (0.5 + clamp((jitter - 1) / 10, 0, 0.5)),
        0.5 * sin(8 * x + 0.006 * millis + 10),
      ]
      const swing = 0.5 * (beat + sin(0.00025 * millis))
      const flip = clamp(beat, 0, 1) * PI * sin(0.001 * millis)
      const rotated = subtract(rotate(third, swing), third)
      return add(waves, add(rotated, subtract(rotate(fromCenter, flip), fromCenter)))
    },
  },

  'the demos of glsl-autodiff: waves across a plane and rings on it': {
    size: 1,
    warp({ glsl, position, millis }) {
      const [at, time] = [position.xy(), millis.div(1000)]
      const wave = (height, phase, frequency, angle) =>
        at
          .dot(glsl.vec2(cos(angle), sin(angle)))
          .mult(frequency)
          .add(phase)
          .sin()
          .mult(height)
      const phase = at.dist(glsl.vec2(-0.5, -0.5)).mult(4).add(time.mult(1.5), 8)
      const rings = glsl.sum(phase.mult(6).sin(), phase.sin(), -1).max(0).pow(2)
      const waves = glsl.sum(
        wave(time.sin().mult(0.5), time.mult(5), 5, PI / 4),
        wave(time.add(10).sin().add(5).mult(0.15), time.mult(5).add(50), 10, 0.8 * PI),
        rings.mult(time.sin().add(1)).neg(),
      )
      return glsl.vec3(0, 0, waves.mult(0.08))
    },
    offset([x, y], { millis }) {
      const time = millis / 1000
      const wave = (height, phase, frequency, angle) =>
        height * sin(phase + frequency * (x * cos(angle) + y * sin(angle)))
      const phase = 4 * hypot(x + 0.5, y + 0.5) + 1.5 * time + 8
      const rings = max(0, sin(6 * phase) + sin(phase) - 1) ** 2
      const waves =
        wave(0.5 * sin(time), 5 * time, 5, PI / 4) +
        wave(0.15 * (5 + sin(time + 10)), 5 * time + 50, 10, 0.8 * PI) -
        rings * (1 + sin(time))
      return [0, 0, 0.08 * waves]
    },
  },

  'the demos of glsl-autodiff: a cloth of noise made of sines': {
    size: 1,
    warp({ glsl, position, millis }) {
      const time = millis.div(1000)
      let place = position.xy().scale(-0.1).mult(glsl.vec2(4, 4)).add(glsl.vec2(10, 1))
      for (const i of [1, 2, 3])
        place = place.add(place.yx().scale(i).add(glsl.vec2(time, time)).sin().scale(0.4))
      const noise = place.x().mult(place.y()).sin().mult(0.5).add(0.5)
      const t = noise.add(0.5).div(2).clamp(0, 1)
      const smooth = t.mult(t, t.mult(-2).add(3))
      return glsl.vec3(0, 0, smooth.mult(position.x().mult(-2).sub(1)).mult(0.4))
    },
    offset([x, y], { millis }) {
      const time = millis / 1000
      let [u, v] = [10 - 0.4 * x, 1 - 0.4 * y]
      for (const i of [1, 2, 3]) [u, v] = [u + 0.4 * sin(i * v + time), v + 0.4 * sin(i * u + time)]
      const t = clamp((0.5 + 0.5 * sin(u * v) + 0.5) / 2, 0, 1)
      return [0, 0, t * t * (3 - 2 * t) * (-2 * x - 1) * 0.4]
    },
  },
}
