// The six warps of p5.warp's stress test, rewritten. Each has its formula twice: as an offset function, and as a plain function
// of numbers, the oracle, which is independent of the compiler.
import { seededRandom } from './random.js'

const { sin, cos, min, max } = Math

const sinesInWorldSpace = {
  name: 'sines in world space',
  size: 100,
  warp({ glsl, position, millis }) {
    const t = millis.div(1000)
    const wave = (speed, frequency, coordinate) =>
      t.mult(speed).add(coordinate.mult(frequency)).sin().mult(15)
    return glsl.vec3(
      wave(2, 0.04, position.y()),
      wave(0.5, 0.02, position.z()),
      wave(1.5, 0.03, position.x()),
    )
  },
  offset([x, y, z], { millis }) {
    const t = millis / 1000
    return [15 * sin(2 * t + 0.04 * y), 15 * sin(0.5 * t + 0.02 * z), 15 * sin(1.5 * t + 0.03 * x)]
  },
}

const sinesInLocalSpace = {
  name: 'sines in local space',
  size: 1,
  warp({ glsl, position, millis }) {
    const t = millis.mult(0.001)
    const phases = glsl.vec3(t.mult(2), t.mult(0.5), t.mult(1.5))
    return position
      .yzx()
      .mult(glsl.vec3(20, 10, 15))
      .add(phases)
      .sin()
      .mult(0.05)
  },
  offset([x, y, z], { millis }) {
    const t = millis / 1000
    return [0.05 * sin(2 * t + 20 * y), 0.05 * sin(0.5 * t + 10 * z), 0.05 * sin(1.5 * t + 15 * x)]
  },
}

/** Rotates about the axis through (0, 0, -500) along x. */
const rotate = ([x, y, z], angle) => [
  x,
  y * cos(angle) - (z + 500) * sin(angle),
  y * sin(angle) + (z + 500) * cos(angle) - 500,
]

function rotateInSketch(glsl, point, angle) {
  const [c, s] = [angle.cos(), angle.sin()]
  const [y, z] = [point.y(), point.z().add(500)]
  return glsl.vec3(point.x(), y.mult(c).sub(z.mult(s)), y.mult(s).add(z.mult(c)).sub(500))
}

const twist = {
  name: 'twist',
  size: 100,
  reach: 600,
  warp({ glsl, position, millis }) {
    const angle = position.x().mult(0.02).add(millis.div(1000))
    return rotateInSketch(glsl, position, angle).sub(position)
  },
  offset(p, { millis }) {
    const moved = rotate(p, 0.02 * p[0] + millis / 1000)
    return moved.map((value, i) => value - p[i])
  },
}

const wobble = {
  name: 'wobble',
  size: 100,
  reach: 600,
  warp({ glsl, position, millis }) {
    const t = millis.div(1000)
    const [x, y, z] = [position.x(), position.y(), position.z()]
    const waves = glsl.vec3(
      t.mult(2).add(y.mult(0.03)).sin().mult(8),
      t
        .mult(1.3)
        .add(z.mult(0.025))
        .sin()
        .mult(8)
        .add(t.sub(x.mult(0.04)).sin().mult(4)),
      t.mult(1.7).add(x.mult(0.02)).sin().mult(8),
    )
    const strength = glsl.mix(0.004, 0.008, t.sin().mult(0.5).add(0.5))
    const wavy = position.add(waves)
    const once = rotateInSketch(glsl, wavy, wavy.x().mult(strength).clamp(-0.5, 0.6))
    const secondAngle = y.mult(0.001).add(t.mult(0.7).sin().mult(0.3)).clamp(-0.3, 0.35)
    return rotateInSketch(glsl, once, secondAngle).sub(position)
  },
  offset(p, { millis }) {
    const t = millis / 1000
    const [x, y, z] = p
    const wavy = [
      x + 8 * sin(2 * t + 0.03 * y),
      y + 8 * sin(1.3 * t + 0.025 * z) + 4 * sin(t - 0.04 * x),
      z + 8 * sin(1.7 * t + 0.02 * x),
    ]
    const strength = 0.004 + 0.004 * (0.5 + 0.5 * sin(t))
    const once = rotate(wavy, max(-0.5, min(0.6, strength * wavy[0])))
    const twice = rotate(once, max(-0.3, min(0.35, 0.001 * y + 0.3 * sin(0.7 * t))))
    return twice.map((value, i) => value - p[i])
  },
}

/** Moves points to the corner (120, 150, 0); parts that have arrived there collapse to a line or a point. */
const genie = {
  name: 'genie into a corner',
  size: 100,
  collapses: true,
  warp({ glsl, position, millis }) {
    const progress = millis.div(2000).sin().mult(0.5).add(0.5)
    const across = progress.mult(1.6).sub(position.y().mult(0.004)).sub(0.5).clamp(0, 1).pow(3)
    const up = progress.mult(1.4).add(position.x().mult(0.003)).sub(0.4).clamp(0, 1).pow(3)
    const moved = glsl.vec3(
      position.x().mix(120, across),
      position.y().mix(150, up),
      position.z().mix(0, across),
    )
    return moved.sub(position)
  },
  offset([x, y, z], { millis }) {
    const progress = 0.5 + 0.5 * sin(millis / 2000)
    const across = max(0, min(1, 1.6 * progress - 0.004 * y - 0.5)) ** 3
    const up = max(0, min(1, 1.4 * progress + 0.003 * x - 0.4)) ** 3
    return [(120 - x) * across, (150 - y) * up, -z * across]
  },
}

/** Projects onto the plane x = 0, which collapses surfaces perpendicular to this plane. */
const flatten = {
  name: 'flatten',
  size: 100,
  collapses: true,
  warp: ({ glsl, position }) => glsl.vec3(position.x().neg(), 0, 0),
  offset: ([x]) => [-x, 0, 0],
}

/** Makes a warp of `count` sines, each of a random coordinate with random constants, in a random component. `waves` are the constants. */
export function stackedSines(count) {
  const random = seededRandom(count)
  const waves = Array.from({ length: count }, () => ({
    component: Math.floor(3 * random()),
    coordinate: Math.floor(3 * random()),
    frequency: 0.0001 + 0.0009 * random(),
    speed: 0.0001 + 0.0099 * random(),
    amplitude: 1 + 499 * random(),
  }))
  return {
    name: `${count} stacked sines`,
    size: 100,
    waves,
    warp({ glsl, position, millis }) {
      const coordinates = [position.x(), position.y(), position.z()]
      const sums = [glsl.val(0), glsl.val(0), glsl.val(0)]
      for (const { component, coordinate, frequency, speed, amplitude } of waves) {
        const angle = coordinates[coordinate].mult(frequency).add(millis.mult(speed))
        sums[component] = sums[component].add(angle.sin().mult(amplitude))
      }
      return glsl.vec3(...sums).div(count)
    },
    offset(p, { millis }) {
      const sums = [0, 0, 0]
      for (const { component, coordinate, frequency, speed, amplitude } of waves)
        sums[component] += (amplitude / count) * sin(frequency * p[coordinate] + speed * millis)
      return sums
    },
  }
}

const golden = [sinesInWorldSpace, sinesInLocalSpace, twist, wobble, genie, flatten]

export const stress = [
  ...golden.map((warp) => ({ ...warp, isGolden: true })),
  stackedSines(30),
  stackedSines(300),
]
