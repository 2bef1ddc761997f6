/**
 * The methods of the benchmark: every way in which a user can draw a warped mesh. `program(workload)` returns the parts in which
 * the programs differ: `declarations` above main; `body`, which computes `vec3 moved, turned` (the warped position and normal)
 * from `position` and `normal`; and `generation`, the time of the compiler in milliseconds. `flat` is true if the fragment stage
 * computes the normal.
 */
import { compileWarp } from '../../dist/warpjet.js'

const unmoved = '  vec3 moved = position, turned = normal;'

const names = { position: 'moved', normal: 'turned' }

/** Returns the compiled warp and `generation`, in milliseconds. */
export function generate(workload, options = {}) {
  const start = performance.now()
  const warp = compileWarp(workload.warp, { outputs: names, ...options })
  return { ...warp, generation: performance.now() - start }
}

/** Wraps the offset, without normals, in a function, which finite differences call several times. */
function writeOffsetFunction(workload) {
  const { code, declarations, generation } = generate(workload, { normals: false })
  return {
    generation,
    declarations: `uniform float h;
${declarations}
vec3 offsetAt(vec3 position) {
${code}
  return offset;
}`,
  }
}

/** Two perpendicular directions tangent to the surface. */
const tangents = `
  vec3 u = normalize(cross(abs(normal.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), normal));
  vec3 v = cross(normal, u);`

const central = `${tangents}
  vec3 du = 2.0 * h * u + offsetAt(position + h * u) - offsetAt(position - h * u);
  vec3 dv = 2.0 * h * v + offsetAt(position + h * v) - offsetAt(position - h * v);
  vec3 moved = position + offsetAt(position), turned = normalize(cross(du, dv));`

const forward = `${tangents}
  vec3 offset = offsetAt(position);
  vec3 du = h * u + offsetAt(position + h * u) - offset;
  vec3 dv = h * v + offsetAt(position + h * v) - offset;
  vec3 moved = position + offset, turned = normalize(cross(du, dv));`

/** The steps among which the best h is searched for, in units of the mesh. */
const steps = Array.from({ length: 18 }, (_, i) => 10 ** (i / 3 - 3))

const finiteDifferences = (body) => (workload) => ({ ...writeOffsetFunction(workload), body })

function positionsOnly(workload) {
  const { code, declarations, generation } = generate(workload, { normals: false })
  return { declarations, body: `${code}\n  vec3 turned = normal;`, generation }
}

/** I + J, where J is the Jacobian of the offset, transforms tangents, and its cofactor matrix transforms normals. */
const byHand = (workload) => `${workload.handwritten}
  dx.x += 1.0;
  dy.y += 1.0;
  dz.z += 1.0;
  vec3 moved = position + offset;
  vec3 turned = normalize(cross(dy, dz) * normal.x + cross(dz, dx) * normal.y + cross(dx, dy) * normal.z);`

export const methods = [
  { name: 'no warp', program: () => ({ body: unmoved }) },
  { name: 'positions only', program: positionsOnly },
  {
    name: 'warpjet',
    program(workload) {
      const { code, declarations, generation } = generate(workload)
      return { declarations, body: code, generation }
    },
  },
  {
    name: 'central differences',
    steps,
    program: finiteDifferences(central),
  },
  {
    name: 'forward differences',
    steps,
    program: finiteDifferences(forward),
  },
  { name: 'dFdx', flat: true, program: positionsOnly },
  { name: 'by hand', program: (workload) => ({ body: byHand(workload) }) },
]
