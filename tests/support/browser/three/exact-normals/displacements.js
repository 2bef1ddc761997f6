// Displacements as people write them in TSL, each with the same motion of a vertex in double precision, written by hand.
import * as TSL from 'three/tsl'
import { Vector3 } from 'three'

const { float, positionLocal, sin, uniform, vec3 } = TSL

const add = (a, b) => a.map((x, i) => x + b[i])

/** `position()` makes the positionNode; `move(p, n, uv)` moves a vertex. Planes are two triangles that face the viewer. */
export const displacements = {
  'a sine along the view': {
    shape: 'plane',
    position: () =>
      positionLocal.add(
        vec3(0, 0, sin(positionLocal.x.mul(5).add(uniform(0.4))).mul(uniform(0.2))),
      ),
    move: (p) => add(p, [0, 0, 0.2 * Math.sin(5 * p[0] + 0.4)]),
  },
}
