// Domain warping with expressions and with numbers (Inigo Quilez, Domain warping, 2002). Level 0 is noise from 0 to 1 at p. Level 1 is the
// same noise at p + 4 q, where q is noise at p; level 2 at p + 4 r, where r is noise at p + 4 q.
import { fbm } from './noise.js'

export function domainWarp({ vec2, fbm }, p, level) {
  const f = (point, x, y) =>
    fbm(point.add(vec2(x, y)))
      .mult(0.5)
      .add(0.5)
  const q = vec2(f(p, 0, 0), f(p, 5.2, 1.3))
  const first = p.add(q.mult(4))
  const r = vec2(f(first, 1.7, 9.2), f(first, 8.3, 2.8))
  return { value: f([p, first, p.add(r.mult(4))][level], 0, 0), q, r }
}

export function plainDomainWarp(p, level) {
  const shift = ([x, y], [u, v], amount) => [x + amount * u, y + amount * v]
  const f = (point, x, y) => 0.5 + fbm(shift(point, [x, y], 1)) / 2
  const q = [f(p, 0, 0), f(p, 5.2, 1.3)]
  const first = shift(p, q, 4)
  const r = [f(first, 1.7, 9.2), f(first, 8.3, 2.8)]
  return { value: f([p, first, shift(p, r, 4)][level], 0, 0), q, r }
}
