/**
 * A right hand, fingers pointing up in p5 (-y), palm towards the viewer, 200 units tall. It is one
 * smooth field: palm and wrist are round cones blended together, the fingers are bowed tubes that
 * blend into the palm but hardly into each other. Lengths are about those of an adult's hand in
 * millimetres.
 */

import { polygonize, roundCone, smoothMin } from './implicit.js'
import { clamp, distance, fit, toScreen } from './mesh.js'

// Blending distances in units: two parts closer than this flow into each other.
const BLEND_FINGERS = 5
const BLEND_PALM = 9
const BLEND_BONES = 16
const BLEND_THUMB = 18
const BLEND_CUT = 6

/**
 * Makes the field of a finger: a tube around the parabola from `from` to `to` that bows out by `bow`
 * half way. Its radius goes from `base` to `tip`, slightly thicker at the joints, which are fractions
 * of the length. The bow shears space instead of bending it: for such slight bows the result looks the
 * same, and the field stays smooth and costs two square roots.
 */
function finger({ from, to, bow, base, tip, joints }) {
  const length = distance(from, to)
  const [dx, dy, dz] = to.map((x, k) => (x - from[k]) / length)
  return (x, y, z) => {
    const px = x - from[0]
    const py = y - from[1]
    const pz = z - from[2]
    const s = (px * dx + py * dy + pz * dz) / length
    // The parabola continues past the ends: stopping it there would crease the finger tip.
    const u = clamp(s, -0.2, 1.2)
    const bulge = 4 * u * (1 - u)
    const along = clamp(s, 0, 1)
    const qx = px - bulge * bow[0] - along * length * dx
    const qy = py - bulge * bow[1] - along * length * dy
    const qz = pz - bulge * bow[2] - along * length * dz
    const far = Math.sqrt(qx * qx + qy * qy + qz * qz) - 1.1 * base
    // This far out the exact value no longer affects the surface; it only has to be large.
    if (far > 2 * BLEND_PALM) return far
    let radius = tip + (base - tip) * (1 - along * along) ** 2
    for (const joint of joints) radius += 0.045 * base * Math.exp(-(((along - joint) / 0.075) ** 2))
    return far + 1.1 * base - radius
  }
}

const JOINTS = [0.48, 0.77]
const KNUCKLES = [
  [29, 2, -1],
  [9.5, 7, -2],
  [-10, 4, -2],
  [-28, -6, -1],
]

const FINGERS = [
  { to: [46, 87, 10], bow: [1.5, 0, -5], base: 10.4, tip: 7.4 },
  { to: [13, 101, 9], bow: [0, 0, -5], base: 10.6, tip: 7.7 },
  { to: [-22, 91, 12], bow: [-0.5, 0, -5.5], base: 10.2, tip: 7.4 },
  { to: [-51, 58, 15], bow: [-1.5, 0, -5.5], base: 9.2, tip: 6.6 },
].map((shape, i) => finger({ ...shape, from: KNUCKLES[i], joints: JOINTS }))

const THUMB = finger({
  from: [14, -62, 5],
  to: [76, 22, 15],
  bow: [3, -4, 5],
  base: 16,
  tip: 8.2,
  joints: [0.75],
})

/** Returns the union of fields, blended where they are within `k` of each other. */
function blendFields(parts, k) {
  return (x, y, z) => {
    let d = parts[0](x, y, z)
    for (let i = 1; i < parts.length; i++) d = smoothMin(d, parts[i](x, y, z), k)
    return d
  }
}

/** Metacarpals, the cushions of the palm, the web of the thumb, and a short wrist. */
const PALM = blendFields(
  [
    ...KNUCKLES.map(([x, y, z]) => roundCone([x * 0.45, -68, -1], [x, y + 4, z], 12, 9)),
    roundCone([-15, -62, 3], [-28, -14, 2], 11, 9),
    roundCone([-25, -8, 2.5], [26, -2, 2.5], 7, 7),
    roundCone([42, -30, 8], [26, -12, 1], 8, 7),
    roundCone([9, -50, 0], [7.5, -130, -1], 13, 16.5),
    roundCone([-9, -50, 0], [-7.5, -130, -1], 13, 16.5),
  ],
  BLEND_BONES,
)

const ALL_FINGERS = blendFields(FINGERS, BLEND_FINGERS)

function field(x, y, z) {
  const palm = smoothMin(PALM(x, y, z), THUMB(x, y, z), BLEND_THUMB)
  const whole = smoothMin(palm, ALL_FINGERS(x, y, z), BLEND_PALM)
  // The wrist ends in a flat cut with a soft edge.
  return -smoothMin(-whole, y + 112, BLEND_CUT)
}

/** Makes a hand of about 15,500 vertices. */
export function hand() {
  return toScreen(fit(polygonize(field, { low: [-75, -118, -26], high: [92, 118, 50], cell: 2 })))
}
