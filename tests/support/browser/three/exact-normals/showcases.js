// Two of three's example scenes, reconstructed in TSL from their formulas: a raging sea and a procedural terrain. With `isByHand`,
// `material` computes normals like the example, from heights at two shifted points. `heightNear(x, z)(dx, dz)` is the height in double
// precision at (x + dx, z + dz); the points at which its octaves are evaluated have the rounding errors that float32 has at (x, z).
import * as TSL from 'three/tsl'
import * as THREE from 'three/webgpu'
import { noise } from './materialx.js'

const {
  Fn,
  Loop,
  abs,
  cross,
  float,
  mx_noise_float,
  pow,
  positionLocal,
  sign,
  sin,
  transformNormalToView,
} = TSL
const { uniform, varying, vec3 } = TSL

const makePlane = (size, pieces) =>
  new THREE.PlaneGeometry(size, size, pieces, pieces).rotateX(-Math.PI / 2)

/** A product of two waves, minus three octaves of the absolute value of MaterialX noise. */
const sea = {
  geometry: (pieces = 256) => makePlane(2, pieces),
  parameters: () => ({
    time: uniform(1.3),
    iterations: uniform(3),
    frequency: uniform(new THREE.Vector2(3, 1)),
    height: uniform(0.15),
    smallFrequency: uniform(2),
    smallHeight: uniform(0.18),
  }),
  material({ time, iterations, frequency, height, smallFrequency, smallHeight }, isByHand) {
    const elevation = Fn(([place]) => {
      const large = sin(place.x.mul(frequency.x).add(time.mul(1.25)))
        .mul(sin(place.z.mul(frequency.y).add(time.mul(1.25))))
        .mul(height)
        .toVar()
      Loop({ type: 'float', start: float(1), end: iterations.add(1) }, ({ i }) => {
        const noisePoint = vec3(place.xz.add(2).mul(smallFrequency).mul(i), time.mul(0.3))
        large.subAssign(abs(mx_noise_float(noisePoint, 1, 0).mul(smallHeight).div(i)))
      })
      return large
    })
    const material = new THREE.MeshStandardNodeMaterial({ color: '#271442', roughness: 0.15 })
    const raised = elevation(positionLocal)
    const position = positionLocal.add(vec3(0, raised, 0))
    material.positionNode = position
    if (isByHand) {
      const shift = uniform(0.01)
      const directionTo = (x, z) => {
        const place = positionLocal.add(vec3(x, 0, z))
        return place
          .add(vec3(0, elevation(place), 0))
          .sub(position)
          .normalize()
      }
      const normal = cross(directionTo(shift, 0), directionTo(0, shift.negate()))
      material.normalNode = transformNormalToView(normal)
    }
    material.emissiveNode = TSL.color('#ff0a81').mul(raised.remap(0.2, -0.25).pow(7))
    return material
  },
  heightNear: (x0, z0) => (dx, dz) => {
    const [x, z] = [x0 + dx, z0 + dz]
    const phase = 1.3 * 1.25
    let height = Math.sin(3 * x + phase) * Math.sin(z + phase) * 0.15
    for (let i = 1; i <= 3; i++)
      height -= Math.abs((noise([(x + 2) * 2 * i, (z + 2) * 2 * i, 1.3 * 0.3]) * 0.18) / i)
    return height
  },
}

/** The sum of octaves of MaterialX noise at a point that noise has shifted, squared with its sign preserved. */
const terrain = {
  geometry: (pieces = 500) => makePlane(10, pieces),
  parameters: () => ({
    iterations: uniform(3),
    frequency: uniform(0.175),
    strength: uniform(10),
    warpFrequency: uniform(6),
    warpStrength: uniform(1),
    offset: uniform(new THREE.Vector2(0.4, -0.7)),
  }),
  material({ iterations, frequency, strength, warpFrequency, warpStrength, offset }, isByHand) {
    const elevation = Fn(([place]) => {
      const at = place.add(offset).toVar()
      at.addAssign(mx_noise_float(at.mul(frequency).mul(warpFrequency), 1, 0).mul(warpStrength))
      const height = float(0).toVar()
      Loop(
        { type: 'float', start: float(1), end: iterations.toFloat(), condition: '<=' },
        ({ i }) => {
          const octave = at.mul(frequency).mul(i.mul(2)).add(i.mul(987))
          height.addAssign(mx_noise_float(octave, 1, 0).div(i.add(1).mul(2)))
        },
      )
      const side = sign(height)
      height.assign(pow(abs(height), 2).mul(side).mul(strength))
      return height
    })
    const material = new THREE.MeshStandardNodeMaterial({ color: '#85d534', roughness: 0.5 })
    const vNormal = varying(vec3())
    const vPosition = varying(vec3())
    material.positionNode = Fn(() => {
      const position = positionLocal.xyz.toVar()
      const shift = uniform(0.01)
      const neighbours = isByHand
        ? [vec3(shift, 0, 0), vec3(0, 0, shift.negate())].map((each) =>
            positionLocal.add(each).toVar(),
          )
        : []
      position.y.addAssign(elevation(positionLocal.xz))
      const [a, b] = neighbours.map((each) => {
        each.y.addAssign(elevation(each.xz))
        return each.sub(position).normalize()
      })
      if (isByHand) vNormal.assign(cross(a, b))
      vPosition.assign(position.add(vec3(offset.x, 0, offset.y)))
      return position
    })()
    if (isByHand) material.normalNode = transformNormalToView(vNormal)
    material.colorNode = TSL.mix(
      TSL.color('#ffe894'),
      TSL.color('#85d534'),
      vPosition.y.step(-0.06),
    )
    return material
  },
  heightNear(x0, z0) {
    const shiftPoint = (x, z) => {
      const place = [x + 0.4, z - 0.7]
      const shift = noise(place.map((each) => each * 0.175 * 6))
      return place.map((each) => each + shift)
    }
    const octave = (at, i) => at.map((each) => each * 0.175 * 2 * i + 987 * i)
    // In float32, these coordinates have only four correct decimals.
    const errors = [1, 2, 3].map((i) =>
      octave(shiftPoint(x0, z0), i).map((each) => Math.fround(each) - each),
    )
    return (dx, dz) => {
      const at = shiftPoint(x0 + dx, z0 + dz)
      let height = 0
      for (let i = 1; i <= 3; i++)
        height += noise(octave(at, i).map((each, k) => each + errors[i - 1][k])) / ((i + 1) * 2)
      return height * Math.abs(height) * 10
    }
  },
}

export const showcases = { sea, terrain }
