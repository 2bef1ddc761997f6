// An offset with a Jacobian that was derived by hand, as code for a sketch and in double precision.
import { linear } from './matrix.js'

/**
 * f(p) = u g(p / u) with g(p) = (0.15 sin(2.4 y + 1), 0.11 sin(3.2 z), 0.12 sin(2 x)), in the sketch and in the oracle. The unit
 * u is 1 for p5's own shapes, which have size 1 in local space and are scaled.
 */
export const waves = (u) => ({
  code: `({ glsl, position }) => glsl.vec3(
    position.y().mult(${2.4 / u}).add(1).sin().mult(${0.15 * u}),
    position.z().mult(${3.2 / u}).sin().mult(${0.11 * u}),
    position.x().mult(${2 / u}).sin().mult(${0.12 * u}),
  )`,
  offset: ([x, y, z]) => [
    0.15 * u * Math.sin((2.4 / u) * y + 1),
    0.11 * u * Math.sin((3.2 / u) * z),
    0.12 * u * Math.sin((2 / u) * x),
  ],
  identityPlusJacobian: ([x, y, z]) =>
    linear([
      [1, 0.36 * Math.cos((2.4 / u) * y + 1), 0],
      [0, 1, 0.352 * Math.cos((3.2 / u) * z)],
      [0.24 * Math.cos((2 / u) * x), 0, 1],
    ]),
})
