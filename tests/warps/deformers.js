// The formulas of 'warpjet/deformers' in plain numbers, as documented. Each maps constant options to a function from a point to its offset.
// Formulas about an axis are written in the frame of that axis.
import { add, cross, dot, normalize, subtract } from '../support/browser/matrix.js'
import { noise } from '../support/noise.js'

const { abs, cos, exp, hypot, max, min, PI, sin, sqrt } = Math

const times = (v, factor) => v.map((x) => x * factor)
const sum = (...vectors) => vectors.reduce((a, b) => add(a, b))
const mix = (a, b, t) => a + (b - a) * t
const smoothstep = (low, high, x) => {
  const t = max(0, min(1, (x - low) / (high - low)))
  return t * t * (3 - 2 * t)
}
const falloff = (r) => (r < 1 ? (1 - r * r) ** 3 : 0)

/** Normalizes a vector; zero stays zero. */
const unit = (v) => (v.some(Boolean) ? normalize(v) : [0, 0, 0])

const axesByName = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] }
const direction = (axis) => normalize(axesByName[axis] ?? [...axis])

/**
 * Makes a frame at `center` with `axis` as its third direction: `into` maps a point to coordinates [a, b, h], `back` maps coordinates to a
 * point. The first two directions satisfy a × b = h and are otherwise arbitrary.
 */
function frame(center, axis) {
  const c = direction(axis)
  const a = normalize(cross(abs(c[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], c))
  const directions = [a, cross(c, a), c]
  return {
    into: (p) => directions.map((e) => dot(subtract(p, center), e)),
    back: (q) => sum(center, ...q.map((x, i) => times(directions[i], x))),
  }
}

/** Makes an offset from `move`, which maps the coordinates of a point in a frame to moved coordinates. */
const inFrame = (center, axis, move) => (p) => {
  const { into, back } = frame(center, axis)
  return subtract(back(move(into(p))), p)
}

export const deformers = {
  twist: ({ axis = 'y', center = [0, 0, 0], angle = PI / 2, length = 200 }) =>
    inFrame(center, axis, ([x, y, z]) => {
      const turn = (angle * z) / length
      return [x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn), z]
    }),

  taper: ({ axis = 'y', center = [0, 0, 0], amount = 0.5, length = 200 }) =>
    inFrame(center, axis, ([x, y, z]) => {
      const r = max(0, 1 - (amount * z) / length)
      return [r * x, r * y, z]
    }),

  stretch: ({ axis = 'y', center = [0, 0, 0], amount = 0.5, keepVolume = false }) =>
    inFrame(center, axis, ([x, y, z]) => {
      const s = keepVolume ? max(0.01, 1 + amount) : 1 + amount
      const r = keepVolume ? 1 / sqrt(s) : 1
      return [r * x, r * y, s * z]
    }),

  // In Barr's notation, with the radius 1 / k; for k = 0 the identity.
  bend: ({
    axis = 'z',
    along = 'y',
    center = [0, 0, 0],
    angle = PI / 2,
    from = -100,
    to = 100,
  }) => {
    const about = direction(axis)
    const alongDirection = direction(along)
    const line = normalize(subtract(alongDirection, times(about, dot(alongDirection, about))))
    const side = cross(about, line)
    const k = angle / (to - from)
    return (p) => {
      if (k === 0) return [0, 0, 0]
      const d = subtract(p, center)
      const [s, t] = [dot(d, line), dot(d, side)]
      const clamped = max(from, min(to, s))
      const [turn, radius] = [k * clamped, 1 / k]
      const alongLine = (radius - t) * sin(turn) + (s - clamped) * cos(turn)
      const alongSide = radius - (radius - t) * cos(turn) + (s - clamped) * sin(turn)
      return add(times(line, alongLine - s), times(side, alongSide - t))
    }
  },

  bulge: ({ axis, center = [0, 0, 0], amount = 0.5, radius = 100 }) =>
    axis === undefined
      ? (p) => {
          const d = subtract(p, center)
          return times(d, amount * falloff(hypot(...d) / radius))
        }
      : inFrame(center, axis, ([x, y, z]) => {
          const r = 1 + amount * falloff(abs(z) / radius)
          return [r * x, r * y, z]
        }),

  wave:
    ({
      axis = 'x',
      direction: to = 'y',
      center = [0, 0, 0],
      amount = 20,
      wavelength = 100,
      speed = 100,
    }) =>
    (p, { millis }) => {
      const h = dot(subtract(p, center), direction(axis))
      const phase = (2 * PI * (h - (speed * millis) / 1000)) / wavelength
      return times(direction(to), amount * sin(phase))
    },

  ripple:
    ({ axis = 'z', center = [0, 0, 0], amount = 20, wavelength = 50, speed = 50, radius = 200 }) =>
    (p, { millis }) =>
      inFrame(center, axis, ([x, y, z]) => {
        const d = hypot(x, y)
        const r = hypot(d, wavelength / 8)
        const phase = (2 * PI * (r - (speed * millis) / 1000)) / wavelength
        return [x, y, z + amount * falloff(d / radius) * sin(phase)]
      })(p),

  melt: ({
    axis = 'y',
    center = [0, 0, 0],
    amount = 0.5,
    ground = 100,
    spread = 1,
    height = 100,
  }) =>
    inFrame(center, axis, ([x, y, z]) => {
      const u = ground - z
      const r = 1 + spread * amount * exp(-((u / height) ** 2))
      return [r * x, r * y, ground - u * (1 - amount)]
    }),

  inflate:
    ({ amount = 20, direction: to }) =>
    (p, { normal }) =>
      times(to ?? unit(normal), amount),

  genie: ({ center = [0, 200, 0], axis = 'y', amount = 0.5, length = 300, neck = 0, edge }) => {
    const [k, m] = [smoothstep(0, 0.6, amount), smoothstep(0.3, 1, amount)]
    const along = direction(axis)
    return (p) => {
      const d = subtract(p, center)
      const h = dot(d, along)
      const u = -h - min(max(-h, 0), length * m)
      const width = mix(1, mix(neck, 1, smoothstep(0, length, u)), k)
      let across = subtract(d, times(along, h))
      let alongEdge = [0, 0, 0]
      if (edge !== undefined) {
        const e = direction(edge)
        alongEdge = times(e, dot(across, e))
        across = subtract(across, alongEdge)
      }
      return subtract(sum(center, times(along, -u), alongEdge, times(across, width)), p)
    }
  },

  noiseDisplace:
    ({ amount = 20, scale = 50, direction: to, center = [0, 0, 0], speed = 0, seed = 0 }) =>
    (p, { normal, millis }) => {
      const place = times(subtract(p, center), 1 / scale)
      const time = speed === 0 ? [] : [(speed * millis) / 1000]
      return times(to ?? unit(normal), amount * noise([...place, ...time], { seed }))
    },

  spherify:
    ({ center = [0, 0, 0], radius = 100, amount = 1 }) =>
    (p) => {
      const d = subtract(p, center)
      const onSphere = times(unit(d), radius)
      return times(subtract(onSphere, d), amount)
    },

  shear:
    ({ axis = 'y', direction: to = 'x', center = [0, 0, 0], amount = 0.5 }) =>
    (p) =>
      times(direction(to), amount * dot(subtract(p, center), direction(axis))),
}
