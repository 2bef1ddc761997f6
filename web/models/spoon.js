/**
 * A tablespoon along x, 200 units long, bowl at +x and opening upwards in p5. It is one loft: a
 * thin lens whose middle line follows the bowl's hollow and the handle's curve. The vertices are as
 * dense along the handle as in the bowl, so the handle can be bent round and round.
 */

import { loft } from './loft.js'
import { clamp, cross, fit, mix, normalize, smoothstep, sub, toScreen } from './mesh.js'

const SPACING = 1.12
const TURN = 2 * Math.PI

// The bowl is an egg with its broad end at the neck; the neck is thinnest at NECK.
const BOWL = { from: 30, to: 100, halfWidth: 22.5, depth: 11.5 }
const NECK = 20

const inBowl = (x) => clamp((x - BOWL.from) / (BOWL.to - BOWL.from), 0, 1)

/** Returns half the width at x. */
function halfWidth(x) {
  // The root of u (1 - u) is an ellipse; the extra u / (u + 0.09) draws its neck end out into
  // shoulders.
  const u = inBowl(x)
  const egg = BOWL.halfWidth * 2.3 * (1 - 0.28 * u) * Math.sqrt((u * (1 - u) * u) / (u + 0.09))
  const along = clamp((NECK - x) / (NECK + 100), 0, 1)
  const handle = mix(3.2, 8.8, smoothstep(0.05, 0.92, along) ** 1.25)
  const end = clamp((-86 - x) / 14, 0, 1)
  const stem = handle * Math.sqrt(Math.max(1 - end * end, 0))
  // A smooth maximum joins neck and bowl; at the bowl's tip, only the egg is left.
  const fade = stem * (1 - smoothstep(BOWL.from - 4, BOWL.from + 30, x))
  return Math.hypot(egg, fade)
}

/** Returns the height of the handle's middle line: up out of the bowl, over the neck, down to a lifted end. */
function handleHeight(x) {
  const along = clamp((BOWL.from + 10 - x) / (BOWL.from + 110), 0, 1)
  return 14 * smoothstep(0, 0.5, along) - 11 * smoothstep(0.2, 1, along) + 5 * along ** 6
}

/** Returns the height of the middle surface at x and the fraction w in [-1, 1] of the half width. */
function height(x, w) {
  const u = inBowl(x)
  const deep = Math.sin(Math.PI * u ** 0.85) ** 0.8 * (1 - Math.exp(-((u / 0.15) ** 2)))
  // Steeper than a parabola at the rim, flatter in the middle.
  const hollow = BOWL.depth * deep * (1 - Math.abs(w) ** 2.3)
  // The tip of the bowl looks up a little; the handle is slightly vaulted, but flat at its end.
  const vault = 0.018 * halfWidth(x) ** 2 * (1 - w * w) * (1 - smoothstep(-80, -20, x))
  return handleHeight(x) - hollow + 1.5 * u * u + vault
}

const thickness = (x) => mix(1.3, 2.5, Math.exp(-(((x - NECK) / 26) ** 2)))

const middlePoint = (x, w) => [x, height(x, w), w * halfWidth(x)]

function section(s, t) {
  const x = -100 * Math.cos(Math.PI * s)
  const w = Math.cos(TURN * t)
  const p = middlePoint(x, w)
  // Thickness is added along the normal of the middle surface; vertical thickness would thin steep walls.
  const e = 1e-3
  const [x0, x1] = [Math.max(x - e, -100), Math.min(x + e, 100)]
  const [w0, w1] = [Math.max(w - e, -1), Math.min(w + e, 1)]
  const along = sub(middlePoint(x1, w), middlePoint(x0, w))
  const across = sub(middlePoint(x, w1), middlePoint(x, w0))
  const n = normalize(cross(across, along))
  // Blunter than an ellipse, so that the rim is round rather than sharp.
  const blunt = Math.sign(0.5 - t) * Math.abs(Math.sin(TURN * t)) ** 0.7
  const half = thickness(x) * blunt * Math.tanh(halfWidth(x) / 3)
  return p.map((value, axis) => value + n[axis] * half)
}

/** Makes a spoon of about 8,000 vertices. */
export function spoon() {
  return toScreen(fit(loft(section, { spacing: SPACING })))
}
