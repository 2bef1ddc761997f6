// Displacements in TSL by loops whose end only the shader knows, far beyond 256 iterations, each with a function that moves a vertex in
// the same way in double precision.
import * as TSL from 'three/tsl'

const { Break, Fn, If, Loop, cos, float, int, positionLocal, sin, uint, uniform, vec3, vec4 } = TSL

/** Moves vertices in the plane, too, so that the outline shows wrong positions. */
const raise = (height) => positionLocal.add(vec3(height.mul(0.3), 0, height))
const moveBy =
  (height) =>
  ([x, y, z]) => [x + 0.3 * height(x, y), y, z + height(x, y)]

export const longLoops = {
  'a break that depends on the position': {
    shape: 'plane',
    position: () =>
      Fn(() => {
        const [sum, reached] = [float(0).toVar(), float(0).toVar()]
        const { x, y } = positionLocal
        Loop(uniform(1e6), ({ i }) => {
          If(reached.greaterThanEqual(x.mul(150).add(700)), () => void Break())
          reached.addAssign(0.85)
          sum.addAssign(sin(float(i).mul(0.05).add(y.mul(2))).mul(0.006))
        })
        return raise(sum)
      })(),
    move: moveBy((x, y) => {
      let [sum, reached] = [0, 0]
      for (let i = 0; reached < 700 + 150 * x; i++) {
        reached += 0.85
        sum += 0.006 * Math.sin(0.05 * i + 2 * y)
      }
      return sum
    }),
  },
  'a uniform number of iterations, in nested loops': {
    shape: 'plane',
    position: () =>
      Fn(() => {
        const sum = float(0).toVar()
        const { x, y } = positionLocal
        Loop({ type: 'uint', start: uint(0), end: uniform(300, 'uint') }, ({ i }) => {
          Loop({ type: 'int', start: int(0), end: uniform(5, 'int'), name: 'j' }, ({ j }) => {
            const angle = float(i).mul(0.02).add(float(j).mul(0.05)).add(x.mul(3))
            sum.addAssign(
              sin(angle)
                .mul(cos(y.mul(2)))
                .mul(0.004),
            )
          })
        })
        return raise(sum)
      })(),
    move: moveBy((x, y) => {
      let sum = 0
      for (let i = 0; i < 300; i++)
        for (let j = 0; j < 5; j++)
          sum += 0.004 * Math.sin(0.02 * i + 0.05 * j + 3 * x) * Math.cos(2 * y)
      return sum
    }),
  },
}

/** A loop that changes 36 numbers, so that it cannot stay a loop. `move` takes the number of its iterations. */
export const manyStates = {
  shape: 'plane',
  position: () =>
    Fn(() => {
      const vectors = Array.from({ length: 9 }, () => vec4(0).toVar())
      Loop({ type: 'float', start: float(0), end: uniform(400) }, ({ i }) => {
        vectors[0].addAssign(vec4(sin(positionLocal.x.mul(3).add(i.mul(0.02))).mul(0.008)))
        for (const each of vectors.slice(1)) each.addAssign(vec4(i.mul(1e-7)))
      })
      return raise(vectors.reduce((sum, each) => sum.add(each)).x)
    })(),
  moveAfter: (iterations) =>
    moveBy((x) => {
      let sum = 0
      for (let i = 0; i < iterations; i++) sum += 0.008 * Math.sin(3 * x + 0.02 * i) + 8e-7 * i
      return sum
    }),
}
