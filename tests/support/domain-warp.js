// Domain warping as expressions and in plain numbers (Inigo Quilez, Domain warping, 2002): noise from 0 to 1 at a point that such
// noise has moved `level` times, and the vectors q and r that moved it.
import { fbm } from './noise.js'

export function domainWarp({ vec2, fbm }, p, level) {
  const f = (at, x, y) =>
    fbm(at.add(vec2(x, y)))
      .mult(0.5)
      .add(0.5)
  const q = vec2(f(p, 0, 0), f(p, 5.2, 1.3))
  const at = p.add(q.mult(4))
  const r = vec2(f(at, 1.7, 9.2), f(at, 8.3, 2.8))
  return { value: f([p, at, p.add(r.mult(4))][level], 0, 0), q, r }
}

export function plainDomainWarp(p, level) {
  const shift = ([x, y], [u, v], amount) => [x + amount * u, y + amount * v]
  const f = (at, x, y) => 0.5 + fbm(shift(at, [x, y], 1)) / 2
  const q = [f(p, 0, 0), f(p, 5.2, 1.3)]
  const at = shift(p, q, 4)
  const r = [f(at, 1.7, 9.2), f(at, 8.3, 2.8)]
  return { value: f([p, at, shift(p, r, 4)][level], 0, 0), q, r }
}
