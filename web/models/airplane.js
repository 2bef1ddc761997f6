/**
 * A chubby twin-engined propeller airliner, nose along +x, 200 units long, upright in p5. Every
 * part is a closed loft. Parts intersect without being welded; a warp moves equal positions
 * equally, so no cracks open.
 */

import { loft } from './loft.js'
import { catmullRom, clamp, fit, merge, mix, smoothstep, toScreen } from './mesh.js'

const SPACING = 2.12
const TURN = 2 * Math.PI

/**
 * Returns half the thickness of a NACA four-digit section at x in [0, 1]. The last coefficient is the one that closes the trailing edge.
 */
const naca = (x) =>
  5 * (0.2969 * Math.sqrt(x) + x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))))

/**
 * Returns a point of an airfoil with a chord of 1: [distance behind the leading edge, height]. From t = 0
 * at the trailing edge it follows the upper side to the leading edge at t = 0.5, then the lower side.
 */
function airfoil(t, thickness, camber) {
  const x = (1 + Math.cos(TURN * t)) / 2
  const side = t < 0.5 ? 1 : -1
  return [x, side * thickness * naca(x) + 4 * camber * x * (1 - x)]
}

/** Returns the radius of a body that ends roundly at u = 1: a superellipse. */
const superellipse = (u, p, q) => (1 - u ** p) ** (1 / q)

const RADIUS = 15.5
const NOSE_FROM = 52
const TAIL_FROM = 18

/** Returns half the height, half the width and the height of the centre line at x. */
function fuselageAt(x) {
  const nose = clamp((x - NOSE_FROM) / (100 - NOSE_FROM), 0, 1)
  const tail = clamp((TAIL_FROM - x) / (TAIL_FROM + 100), 0, 1)
  const r = RADIUS * superellipse(nose, 2.3, 1.9) * superellipse(tail, 1.9, 1.35)
  return {
    halfHeight: r,
    halfWidth: r * (1 - 0.12 * tail),
    // The belly sweeps up to the tail, the nose droops a little.
    centre: 8.5 * tail * tail - 3 * nose * nose,
  }
}

/** Returns a point at the distance `out` from the hull. The angle 0 points up, a quarter turn along +z. */
function fuselagePoint(x, angle, out = 0) {
  const { halfHeight, halfWidth, centre } = fuselageAt(x)
  // The dent of the windscreen, between the nose and the roof.
  const up = Math.max(Math.cos(angle), 0) ** 2
  const dent = 1 - 0.13 * up * Math.exp(-(((x - 82) / 9) ** 2))
  return [
    x,
    centre + Math.cos(angle) * (halfHeight * dent + out),
    Math.sin(angle) * (halfWidth * dent + out),
  ]
}

const fuselage = () =>
  loft((s, t) => fuselagePoint(-100 * Math.cos(Math.PI * s), TURN * t), { spacing: SPACING })

/**
 * Lofts a pillow on the fuselage, used as a window pane: center (x, angle), half sizes along x and around,
 * and corners rounded by the exponent `p`. Its outer half bulges by `height`, its inner half is hidden.
 */
function pane({ x, angle, length, width, height = 0.75, p = 3, slant = 0 }) {
  const section = (s, t) => {
    const [c, d] = [Math.cos(TURN * t), Math.sin(TURN * t)]
    const rim = 1 / (Math.abs(c) ** p + Math.abs(d) ** p) ** (1 / p)
    const reach = Math.sin(Math.PI * s) ** 0.7 * rim
    const out = -height * Math.cos(Math.PI * s)
    const px = x + length * reach * c + slant * width * reach * d
    const { halfWidth } = fuselageAt(px)
    return fuselagePoint(px, angle + (width * reach * d) / halfWidth, out)
  }
  return loft(section, { spacing: 1.45 })
}

function windows() {
  const result = []
  for (const side of [1, -1]) {
    for (let i = 0; i < 7; i++) {
      result.push(
        pane({ x: 50 - 12.5 * i, angle: side * 1.2, length: 2.6, width: 3.1, height: 0.8 }),
      )
    }
    // The windscreen and the side window of the cockpit.
    result.push(
      pane({ x: 81.5, angle: side * 0.42, length: 5, width: 4.4, height: 1.2, slant: -0.4 * side }),
    )
    result.push(
      pane({
        x: 76.5,
        angle: side * 1.12,
        length: 4.4,
        width: 3.3,
        height: 1.2,
        slant: -0.4 * side,
      }),
    )
  }
  return result
}

/**
 * Lofts a pair of wings, from tip to tip in one piece through the fuselage. `tip` is the fraction of the
 * half span that is rounded off, `fairing` thickens the root where it leaves the fuselage.
 */
function wings({ x, y, halfSpan, root, end, sweep, dihedral, thickness, camber, tip, fairing }) {
  const section = (s, t) => {
    // The sine puts the rings closer together at the tips, which are rounded off.
    const z = halfSpan * Math.sin(Math.PI * (s - 0.5))
    const out = Math.abs(z) / halfSpan
    const u = clamp((out - 1 + tip) / tip, 0, 1)
    const round = Math.sqrt(Math.max(1 - u * u, 0))
    const swell = Math.exp(-(((Math.abs(z) - fairing.at) / fairing.reach) ** 2))
    const inner = Math.abs(z) < fairing.at ? 1 : swell
    const chord = mix(root, end, out) * round * (1 + 0.16 * inner)
    const [behind, height] = airfoil(t, thickness * (1 + 0.75 * inner), camber)
    // The rounding shrinks the chord about the middle line of the wing.
    const front = x - sweep * out - mix(root, end, out) * 0.5 + chord * 0.5
    return [front - chord * behind, y + dihedral * out + chord * height, z]
  }
  return loft(section, { spacing: SPACING, sharp: true })
}

/** Lofts the fin, from inside the fuselage upwards; its foot curves forward. */
function fin() {
  const [bottom, top] = [6, 48]
  const section = (s, t) => {
    const y = mix(bottom, top, (1 - Math.cos(Math.PI * s)) / 2)
    const out = (y - bottom) / (top - bottom)
    const [head, foot] = [clamp((out - 0.72) / 0.28, 0, 1), clamp((0.06 - out) / 0.06, 0, 1)]
    const round = Math.sqrt((1 - head * head) * (1 - foot * foot))
    const back = -97 - 4 * out
    const straight = mix(32, 17, out) + 16 * Math.exp(-out / 0.13)
    const chord = straight * round
    const [behind, side] = airfoil(t, 0.115 * mix(0.75, 1, smoothstep(0, 0.4, out)), 0)
    return [back + straight / 2 + chord / 2 - chord * behind, y, chord * side]
  }
  return loft(section, { spacing: SPACING, sharp: true })
}

/** Returns a function of s in [0, 1] that follows a smooth profile [x, r] through knots. */
const profile = (knots) => (s) => {
  const place = clamp(s, 0, 1) * (knots.length - 1)
  const i = Math.min(Math.floor(place), knots.length - 2)
  return catmullRom(knots, i, place - i)
}

/** The engine's profile, from the back wall of the intake, around its lip, along the cowl to the pointed end. */
const COWL = profile([
  [9, 0],
  [9, 3.5],
  [10.5, 6.1],
  [14.5, 6.7],
  [16, 7.6],
  [14.5, 8.7],
  [8, 9.4],
  [-2, 9.0],
  [-14, 7.0],
  [-26, 3.6],
  [-34, 0],
])

/** Lofts a body of revolution about the line through (x, y, z) along x. */
const revolve = (curve, [x, y, z], spacing = SPACING) =>
  loft(
    (s, t) => {
      const [along, r] = curve(s)
      return [x + along, y + r * Math.cos(TURN * t), z + r * Math.sin(TURN * t)]
    },
    { spacing },
  )

/** Returns a point of the profile of the propeller's hub: half an ellipsoid with a round back. */
const spinner = (s) => {
  const angle = Math.PI * s
  return [-Math.cos(angle) * (angle < Math.PI / 2 ? 5 : 7), 2.9 * Math.sin(angle)]
}

/** Lofts a blade from the hub outwards at `angle`: a flat ellipse whose pitch decreases towards the tip. */
function blade([x, y, z], angle) {
  const length = 21
  const section = (s, t) => {
    const r = (length * (1 - Math.cos(Math.PI * s))) / 2
    const u = r / length
    const round = Math.sqrt(Math.max(1 - (2 * u - 1) ** 6, 0))
    const width = round * mix(1.1, 2.6, smoothstep(0.05, 0.6, u))
    const a = width * Math.cos(TURN * t)
    const b = round * mix(0.75, 0.4, u) * Math.sin(TURN * t)
    const pitch = mix(0.95, 0.4, u)
    const across = a * Math.cos(pitch) - b * Math.sin(pitch)
    return [
      x + a * Math.sin(pitch) + b * Math.cos(pitch),
      y + r * Math.cos(angle) - across * Math.sin(angle),
      z + r * Math.sin(angle) + across * Math.cos(angle),
    ]
  }
  return loft(section, { spacing: 1.2 })
}

function engines() {
  const result = []
  for (const side of [1, -1]) {
    const hub = [46, -4.5, 34 * side]
    result.push(revolve(COWL, [28, -4.5, 34 * side]), revolve(spinner, hub, 1.2))
    for (let i = 0; i < 3; i++) result.push(blade(hub, (TURN * i) / 3 + 0.35))
  }
  return result
}

/** Makes an airplane of about 14,000 evenly spread vertices, with x in [-100, 100]. */
export function airplane() {
  const parts = [
    fuselage(),
    ...windows(),
    wings({
      x: 32,
      y: -6.5,
      halfSpan: 98,
      root: 38,
      end: 15,
      sweep: 15,
      dihedral: 9,
      thickness: 0.135,
      camber: 0.02,
      tip: 0.17,
      fairing: { at: 12, reach: 9 },
    }),
    wings({
      x: -70,
      y: 9,
      halfSpan: 38,
      root: 24,
      end: 12,
      sweep: 8,
      dihedral: 3,
      thickness: 0.11,
      camber: 0,
      tip: 0.3,
      fairing: { at: 3, reach: 4 },
    }),
    fin(),
    ...engines(),
  ]
  return toScreen(fit(merge(parts)))
}
