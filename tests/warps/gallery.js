// The warps of the gallery as plain functions of numbers, by their names in sketches.js, which has the offset functions. See
// stress.js.
import { fbm } from '../support/noise.js'
import { deformerSketches } from './deformer-sketches.js'
import { clamp } from './plain.js'

const { sin, cos, exp, sqrt, hypot, fround } = Math

const minus = (a, b) => a.map((value, i) => value - b[i])

/** Rotates about the y axis. */
const rotateAboutY = ([x, y, z], angle) => [
  x * cos(angle) - z * sin(angle),
  y,
  x * sin(angle) + z * cos(angle),
]

const sinesByAxis =
  (frequency, speed, amplitude, phases = [0, 0, 0]) =>
  ([x, y, z], { millis }) =>
    [y, z, x].map((value, i) => amplitude * sin(frequency * value + millis / speed + phases[i]))

/** Both warps of the sketch "along-the-normal": they differ only in whether they use the gradients of the normal. */
const bumpsAlongTheNormal = {
  size: 100,
  offset: ([x, y, z], { normal, millis }) => {
    const wave = (value) => sin(0.1 * value + millis / 900)
    const height = 4.5 * (wave(x) + wave(y) + wave(z))
    return normal.map((n) => (n * height) / (hypot(...normal) || 1))
  },
}
const add = (p, shift) => p.map((x, i) => x + shift[i])

/**
 * The relief of domain-warping-3d. Its slope changes so fast that finite differences need small steps. At the third level, the shifted
 * points are between 8 and 16, where the spacing of float32 is 1e-6: rounding them already rotates the normal by up to 0.02°.
 */
const relief = (level) => ({
  deep: level > 0,
  size: 1,
  step: 1e-5,
  degrees: level < 2 ? 0.02 : 0.05,
  every: 5,
  offset(point, { millis }) {
    const f = (p, ...shift) => 0.5 + fbm(add(p, shift), { octaves: 3 }) / 2
    const p = point.map((x) => 0.5 * x + millis / 30000)
    const movedBy = (vector) => p.map((x, i) => x + 4 * vector[i])
    let at = p
    if (level > 0) at = movedBy([f(p, 0, 0, 0), f(p, 5.2, 1.3, 2.8), f(p, 1.7, 9.2, 4.1)])
    if (level > 1) at = movedBy([f(at, 1.7, 9.2, 0), f(at, 8.3, 2.8, 5.1), f(at, 3.9, 6.4, 2.2)])
    return point.map((x) => 0.9 * x * (f(at, 0, 0, 0) - 0.5))
  },
})

/** A warp for a box of size 1, like p5's own. */
const swaying = {
  size: 0.5,
  offset([, y], { millis }) {
    const angle = 5 * y + millis / 700
    return [0.4 * sin(angle), 0, 0.4 * cos(angle)]
  },
}

export const gallery = {
  ...deformerSketches,
  'along-the-normal-rough': bumpsAlongTheNormal,
  'along-the-normal-exact': bumpsAlongTheNormal,

  'airplane-twist': {
    size: 100,
    offset(p, { millis }) {
      const [x, y, z] = p
      const angle = 0.015 * x * sin(millis / 1200)
      const turned = [x, y * cos(angle) - z * sin(angle), y * sin(angle) + z * cos(angle)]
      return minus(turned, p)
    },
  },

  'bunny-twist': {
    size: 100,
    offset: (p, { millis }) => minus(rotateAboutY(p, 0.015 * p[1] * sin(millis / 900)), p),
  },

  'bunny-flatten': {
    size: 100,
    offset: ([x], { millis }) => [-x * clamp(0.5 + 1.5 * sin(millis / 900), 0, 0.97), 0, 0],
  },

  carousel: {
    size: 85,
    params: { phase: 1.7 },
    offset([x, y], { millis, phase }) {
      const down = y / 170 + 0.5
      const swing = sin(0.05 * x + 0.03 * y - millis / 300 + phase)
      return [-50 * down ** 2, -10 * down ** 2, 14 * swing * down]
    },
  },

  'coarse-and-fine': {
    size: 90,
    offset: (p, { millis }) => minus(rotateAboutY(p, 0.014 * p[1] * sin(millis / 1000)), p),
  },

  'displaced-plane': {
    size: 0.5,
    offset([x, y, z], { millis }) {
      const [time, distance] = [millis / 1000, sqrt(x * x + y * y + 0.002)]
      const ripples = (0.06 * sin(26 * distance - 3 * time)) / (8 * distance + 1)
      return [0, 0, ripples + 0.05 * sin(5 * x + time) * cos(4 * y) - z]
    },
  },

  'domain-warping-3d-plain': relief(0),
  'domain-warping-3d-warped': relief(1),
  'domain-warping-3d-twice': relief(2),

  // Constants in shaders are float32, which matters after a week.
  'glsl-terrain': {
    size: 0.5,
    step: 1e-5,
    offset([x, y], { millis }) {
      let [u, v] = [4 * x, 4 * y + millis / 4000]
      let [sum, size, slope] = [0, 1, 0]
      for (let i = 0; i < 6; i++) {
        const h = sin(u + slope) * cos(v - slope)
        sum += size * h
        slope += fround(0.35) * size * h
        const [a, b] = [fround(1.6), fround(1.2)]
        ;[u, v] = [a * u - b * v, b * u + a * v]
        size *= fround(0.45)
      }
      return [0, 0, 0.11 * sum]
    },
  },

  'glsl-waves': {
    size: 0.5,
    params: { choppiness: 0.9 },
    offset([x, y], { millis }) {
      const waves = [
        [1, 0.3, 0.28, 4],
        [0.7, -0.8, 0.22, 2.3],
        [0.2, 1, 0.2, 1.4],
        [-0.6, 0.9, 0.15, 0.8],
      ].map((wave) => wave.map(fround))
      const moved = [0, 0, 0]
      for (const [dx, dy, steepness, length] of waves) {
        const [k, size] = [(2 * fround(3.14159265)) / length, hypot(dx, dy)]
        const along = (10 * (dx * x + dy * y)) / size
        const phase = k * (along - (sqrt(fround(9.8) / k) * millis) / 1500)
        const a = (steepness * 0.9) / k / 10
        moved[0] += (a * dx * cos(phase)) / size
        moved[1] += (a * dy * cos(phase)) / size
        moved[2] += a * sin(phase)
      }
      return moved
    },
  },

  fingers: {
    size: 180,
    offset([x, y], { millis }) {
      const up = clamp(-y / 200, 0, 1)
      return [0, 0, 70 * up ** 2 * sin(0.03 * x + millis / 250)]
    },
  },

  genie: {
    size: 100,
    offset(p, { millis }) {
      const [spout, above] = [
        [100, 186, 0],
        [150, 0, 0],
      ]
      const progress = 0.5 + 0.75 * sin(millis / 1300)
      const start = hypot(...minus(p, spout)) / 480
      const s = clamp((progress - start) / 0.5, 0, 1)
      const t = s * s * (3 - 2 * s)
      const weights = [(1 - t) ** 2, 2 * t * (1 - t), t ** 2]
      return p.map((x, i) => weights[0] * x + weights[1] * above[i] + weights[2] * spout[i] - x)
    },
  },

  lotus: {
    size: 1,
    params: { bend: 0.8 },
    offset(p, { bend }) {
      const [x, y, z] = [0.34 * p[0], p[1], p[2]]
      const angle = bend * (0.5 - 0.5 * y)
      const front = 0.04 * z - 1.6 * x * x
      const out = (1.5 * (1 - cos(angle))) / bend + front * cos(angle)
      const up = (1.5 * sin(angle)) / bend - front * sin(angle)
      return minus([x, -up, out], p)
    },
  },

  'shadow-map-fartower': swaying,

  'one-edge-per-side': {
    size: 0.5,
    offset: (p, { millis }) => minus(rotateAboutY(p, 0.6 * sin(6 * p[1] + millis / 1500)), p),
  },

  'sine-cube': { size: 100, offset: sinesByAxis(0.035, 800, 22) },
  'sine-sphere': { size: 1, offset: sinesByAxis(7, 700, 0.13, [0, 2, 4]) },
  'tangent-plane': { size: 75, offset: sinesByAxis(0.04, 800, 16) },

  spoon: {
    size: 100,
    offset(p, { millis }) {
      const [x, y, z] = p
      const radius = 1 / (0.0185 + 0.018 * sin(millis / 1500))
      const along = clamp(x + 10, 0, 50)
      const beyond = x + 10 - along
      const angle = along / radius
      const bent = [
        (radius - y) * sin(angle) + beyond * cos(angle) - 10,
        radius - (radius - y) * cos(angle) + beyond * sin(angle),
        z,
      ]
      return minus(bent, p)
    },
  },

  'text-bulge': {
    size: 250,
    offset([x, y], { mouse, size, millis }) {
      const away = [x - mouse[0] + size[0] / 2, y - mouse[1] + size[1] / 2]
      const near = exp((away[0] ** 2 + away[1] ** 2) / -16000)
      return [
        0.6 * near * away[0],
        0.6 * near * away[1],
        90 * near + 14 * sin(0.01 * x + millis / 600),
      ]
    },
  },
}
