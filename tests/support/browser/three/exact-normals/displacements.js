// Displacements as people write them in TSL, each with a function that moves a vertex in the same way in double precision.
import * as THREE from 'three'
import * as TSL from 'three/tsl'
import { fractal, hash, noise } from './materialx.js'

const {
  Fn,
  If,
  Loop,
  abs,
  acos,
  atan,
  attribute,
  cos,
  distance,
  dot,
  exp,
  float,
  floor,
  fract,
  instanceIndex,
  ivec2,
} = TSL
const { instancedArray, mat3, min, mix, mx_fractal_noise_float, mx_noise_float, mx_noise_vec3 } =
  TSL
const {
  normalGeometry,
  normalLocal,
  normalize,
  positionGeometry,
  positionLocal,
  positionWorld,
  pow,
  rotate,
} = TSL
const {
  select,
  sin,
  smoothstep,
  texture,
  textureLoad,
  uint,
  uniform,
  uniformArray,
  uv,
  varying,
  vec2,
  vec3,
} = TSL

const add = (a, b) => a.map((x, i) => x + b[i])
const scale = (a, factor) => a.map((x) => x * factor)
const mixVectors = (a, b, t) => a.map((x, i) => x + (b[i] - x) * t)
const unit = (a) => scale(a, 1 / Math.hypot(...a))
const smoothstepAt = (from, to, x) => {
  const t = Math.min(1, Math.max(0, (x - from) / (to - from)))
  return t * t * (3 - 2 * t)
}
/** Returns a function that moves a point along an axis by `height(p, …)`. */
const along =
  (axis, height) =>
  (p, ...others) =>
    add(p, scale(axis, height(p, ...others)))
const up = [0, 0, 1]

const waves = [
  [1, 0.2, 0.06, 4],
  [-0.4, 1, 0.04, 6],
  [0.7, -0.7, 0.025, 9],
]

/** Makes a texture of 8 × 8 heights with a linear filter. */
function makeHeightmap(heights) {
  const map = new THREE.DataTexture(
    Float32Array.from({ length: 256 }, (_, i) => (i % 4 ? 0 : heights[i >> 2])),
    8,
    8,
    THREE.RGBAFormat,
    THREE.FloatType,
  )
  const filters = { magFilter: THREE.LinearFilter, minFilter: THREE.LinearFilter }
  return Object.assign(map, { ...filters, needsUpdate: true })
}

const heights = Float32Array.from({ length: 64 }, (_, i) => hash(i))
const otherHeights = heights.map((height) => 0.5 - 0.6 * height)
const [heightmap, otherHeightmap] = [heights, otherHeights].map(makeHeightmap)

/** Samples heights like the texture. */
function bilinear(u, v, heights) {
  const [x, y] = [u * 8 - 0.5, v * 8 - 0.5]
  const [i, j] = [Math.floor(x), Math.floor(y)]
  const clamp = (k) => Math.min(7, Math.max(0, k))
  const texel = (i, j) => heights[8 * clamp(j) + clamp(i)]
  const row = (j) => texel(i, j) + (texel(i + 1, j) - texel(i, j)) * (x - i)
  return row(j) + (row(j + 1) - row(j)) * (y - j)
}

const raisedBy = (map) => positionLocal.add(vec3(0, 0, texture(map, uv()).r.mul(0.4)))

/** Heights of the two instances. */
const lifts = [0.15, 0.3]

/**
 * `position()` makes the positionNode, and `first()` another that is drawn before. `move(p, n, uv, { instance, matrixWorld })` moves a
 * vertex. `prepare` changes the object. If `ignoresPose`, the positionNode reads the geometry, so that the skin has no effect. `shape` is
 * the geometry, and `kind` the kind of object; default: a mesh. Planes are two triangles that face the viewer, and up is towards the
 * viewer.
 */
export const displacements = {
  'a sine': {
    shape: 'plane',
    position: () =>
      positionLocal.add(
        vec3(0, 0, sin(positionLocal.x.mul(5).add(uniform(0.4))).mul(uniform(0.2))),
      ),
    move: along(up, ([x]) => 0.2 * Math.sin(5 * x + 0.4)),
  },
  'Gerstner waves in a function': {
    shape: 'plane',
    position() {
      const wave = Fn(([p, direction, height, frequency]) => {
        const d = normalize(direction).toVar()
        const phase = dot(d, p.xy).mul(frequency)
        return vec3(d.mul(height).mul(cos(phase)), sin(phase).mul(height))
      })
      return Fn(() => {
        const p = positionLocal.toVar()
        const moved = positionLocal.toVar()
        for (const [x, y, height, frequency] of waves)
          moved.addAssign(wave(p, vec2(x, y), height, frequency))
        return moved
      })()
    },
    move: (p) =>
      waves.reduce((moved, [x, y, height, frequency]) => {
        const d = unit([x, y])
        const phase = (d[0] * p[0] + d[1] * p[1]) * frequency
        return add(moved, [...scale(d, height * Math.cos(phase)), height * Math.sin(phase)])
      }, p),
  },
  'waves from an array of uniforms': {
    shape: 'plane',
    position() {
      const list = uniformArray(waves.map((each) => new THREE.Vector4(...each)))
      return Fn(() => {
        const height = float(0).toVar()
        Loop(3, ({ i }) => {
          const wave = list.element(i)
          height.addAssign(sin(dot(wave.xy, positionLocal.xy).mul(wave.w)).mul(wave.z))
        })
        return positionLocal.add(vec3(0, 0, height))
      })()
    },
    move: along(up, ([x, y]) =>
      waves.reduce(
        (sum, [a, b, height, frequency]) => sum + height * Math.sin((a * x + b * y) * frequency),
        0,
      ),
    ),
  },
  'ridges of a terrain': {
    shape: 'plane',
    position: () =>
      Fn(() => {
        const p = positionLocal.toVar()
        const height = float(0).toVar()
        const amount = float(0.4).toVar()
        const frequency = float(1.3).toVar()
        Loop(4, () => {
          height.addAssign(
            float(1)
              .sub(abs(mx_noise_float(p.xy.mul(frequency))))
              .mul(amount),
          )
          amount.mulAssign(0.5)
          frequency.mulAssign(2.1)
        })
        p.z.addAssign(pow(height, 2).mul(0.4))
        return p
      })(),
    move: along(up, ([x, y]) => {
      let height = 0
      for (let i = 0; i < 4; i++)
        height += (1 - Math.abs(noise([x * 1.3 * 2.1 ** i, y * 1.3 * 2.1 ** i]))) * 0.4 * 0.5 ** i
      return 0.4 * height ** 2
    }),
  },
  'ripples by distance': {
    shape: 'plane',
    position() {
      const d = distance(positionLocal.xy, uniform(new THREE.Vector2(0.3, 0.1)))
      return positionLocal.add(
        vec3(
          0,
          0,
          sin(d.mul(14))
            .mul(exp(d.mul(-1.5)))
            .mul(0.12),
        ),
      )
    },
    move: along(up, ([x, y]) => {
      const d = Math.hypot(x - 0.3, y - 0.1)
      return 0.12 * Math.sin(14 * d) * Math.exp(-1.5 * d)
    }),
  },
  'noise along the normal': {
    shape: 'sphere',
    position: () =>
      positionLocal.add(normalLocal.mul(mx_noise_float(positionLocal.mul(2)).mul(0.25))),
    move: (p, n) => add(p, scale(n, 0.25 * noise(scale(p, 2)))),
  },
  'noise with three components': {
    shape: 'sphere',
    position: () => positionLocal.add(mx_noise_vec3(positionLocal.mul(1.5)).mul(0.3)),
    move: (p) =>
      add(
        p,
        [0, 1, 2].map((component) => 0.3 * noise(scale(p, 1.5), component)),
      ),
  },
  'fractal noise': {
    shape: 'plane',
    position: () =>
      positionLocal.add(vec3(0, 0, mx_fractal_noise_float(positionLocal.mul(1.5), 3).mul(0.3))),
    move: along(up, (p) => 0.3 * fractal(scale(p, 1.5), 3)),
  },
  'domain warping': {
    shape: 'plane',
    position() {
      const warped = positionLocal.xy.add(
        vec2(
          mx_noise_float(positionLocal.xy.mul(2)),
          mx_noise_float(positionLocal.xy.mul(2).add(5.2)),
        ).mul(0.4),
      )
      return positionLocal.add(vec3(0, 0, mx_noise_float(warped.mul(1.7)).mul(0.5)))
    },
    move: along(up, ([x, y]) => {
      const q = [x + 0.4 * noise([2 * x, 2 * y]), y + 0.4 * noise([2 * x + 5.2, 2 * y + 5.2])]
      return 0.5 * noise(scale(q, 1.7))
    }),
  },
  'Voronoi cells': {
    shape: 'plane',
    position: () =>
      Fn(() => {
        const p = positionLocal.xy.mul(3).add(20).toVar()
        const cell = floor(p).toVar()
        const nearest = float(8).toVar()
        Loop(
          { start: -1, end: 1, condition: '<=' },
          { start: -1, end: 1, condition: '<=' },
          ({ i, j }) => {
            const other = cell.add(vec2(float(i), float(j))).toVar()
            const seed = uint(other.x.add(other.y.mul(97)))
            const centre = other.add(vec2(TSL.hash(seed), TSL.hash(seed.add(5000))))
            const toCentre = p.sub(centre)
            nearest.assign(min(nearest, dot(toCentre, toCentre)))
          },
        )
        return positionLocal.add(vec3(0, 0, nearest.mul(0.2)))
      })(),
    move: along(up, ([x, y]) => {
      const p = [3 * x + 20, 3 * y + 20]
      const cell = p.map(Math.floor)
      let nearest = 8
      for (let i = -1; i <= 1; i++)
        for (let j = -1; j <= 1; j++) {
          const other = [cell[0] + i, cell[1] + j]
          const seed = other[0] + other[1] * 97
          const centre = [other[0] + hash(seed), other[1] + hash(seed + 5000)]
          nearest = Math.min(nearest, (p[0] - centre[0]) ** 2 + (p[1] - centre[1]) ** 2)
        }
      return 0.2 * nearest
    }),
  },
  'a twist': {
    shape: 'torus',
    position() {
      const angle = positionLocal.y.mul(1.4)
      const [s, c] = [sin(angle), cos(angle)]
      return mat3(c, 0, s.negate(), 0, 1, 0, s, 0, c).mul(positionLocal)
    },
    move: ([x, y, z]) => {
      const [s, c] = [Math.sin(1.4 * y), Math.cos(1.4 * y)]
      return [c * x + s * z, y, -s * x + c * z]
    },
  },
  'a bend by rotate()': {
    shape: 'box',
    position() {
      const p = positionLocal
      return vec3(rotate(p.xy, p.y.mul(0.9)), p.z)
    },
    move([x, y, z]) {
      const [s, c] = [Math.sin(0.9 * y), Math.cos(0.9 * y)]
      return [c * x - s * y, s * x + c * y, z]
    },
  },
  'a heightmap': {
    shape: 'plane',
    position: () => raisedBy(heightmap),
    move: along(up, (p, n, [u, v]) => 0.4 * bilinear(u, v, heights)),
  },
  'a second heightmap in place of the first': {
    shape: 'plane',
    first: () => raisedBy(heightmap),
    position: () => raisedBy(otherHeightmap),
    move: along(up, (p, n, [u, v]) => 0.4 * bilinear(u, v, otherHeights)),
  },
  'texels of a heightmap': {
    shape: 'plane',
    position() {
      const texel = textureLoad(heightmap, ivec2(uv().mul(8))).r
      return positionLocal.add(vec3(0, 0, sin(uv().x.mul(9)).mul(texel).mul(0.3)))
    },
    move: along(up, (p, n, [u, v]) => {
      const texel = heights[8 * Math.floor(8 * v) + Math.floor(8 * u)]
      return 0.3 * Math.sin(9 * u) * texel
    }),
  },
  'a flag by uv': {
    shape: 'plane',
    position: () =>
      positionLocal.add(
        vec3(
          0,
          0,
          sin(uv().x.mul(9).add(uv().y.mul(2)))
            .mul(uv().x)
            .mul(0.2),
        ),
      ),
    move: along(up, (p, n, [u, v]) => 0.2 * u * Math.sin(9 * u + 2 * v)),
  },
  'a morph by noise': {
    shape: 'box',
    position() {
      const round = normalize(positionLocal).mul(0.9)
      const amount = smoothstep(-0.3, 0.4, mx_noise_float(positionLocal.mul(2)))
      return mix(positionLocal, round, amount)
    },
    move: (p) => mixVectors(p, scale(unit(p), 0.9), smoothstepAt(-0.3, 0.4, noise(scale(p, 2)))),
  },
  'angles of a sphere': {
    shape: 'icosahedron',
    position() {
      const p = normalize(positionLocal).toVar()
      const [longitude, latitude] = [atan(p.z, p.x), acos(p.y)]
      return p.mul(sin(longitude.mul(3)).mul(sin(latitude)).mul(0.15).add(1))
    },
    move(vertex) {
      const p = unit(vertex)
      return scale(p, 1 + 0.15 * Math.sin(3 * Math.atan2(p[2], p[0])) * Math.sin(Math.acos(p[1])))
    },
  },
  'a valley with a flat bottom': {
    shape: 'plane',
    position: () =>
      Fn(() => {
        const height = sin(positionLocal.x.mul(4))
          .mul(cos(positionLocal.y.mul(3)))
          .mul(0.2)
          .toVar()
        If(height.lessThan(-0.05), () => {
          height.assign(-0.05)
        }).ElseIf(height.greaterThan(0.1), () => {
          height.assign(height.sub(0.1).mul(2).add(0.1))
        })
        return positionLocal.add(vec3(0, 0, height))
      })(),
    move: along(up, ([x, y]) => {
      const height = 0.2 * Math.sin(4 * x) * Math.cos(3 * y)
      return height < -0.05 ? -0.05 : height > 0.1 ? 2 * (height - 0.1) + 0.1 : height
    }),
  },
  'steps of a terrace': {
    shape: 'plane',
    position() {
      const x = positionLocal.x.mul(3)
      const step = floor(x).add(smoothstep(0.6, 1, fract(x)))
      return positionLocal.add(
        vec3(0, 0, select(positionLocal.y.greaterThan(0), step, step.mul(0.5)).mul(0.1)),
      )
    },
    move: along(up, ([x, y]) => {
      const step = Math.floor(3 * x) + smoothstepAt(0.6, 1, 3 * x - Math.floor(3 * x))
      return 0.1 * (y > 0 ? step : 0.5 * step)
    }),
  },
  'a function with a layout': {
    shape: 'plane',
    position() {
      const hill = Fn(([place, width]) => exp(dot(place, place).mul(width).negate())).setLayout({
        name: 'hill',
        type: 'float',
        inputs: [
          { name: 'place', type: 'vec2' },
          { name: 'width', type: 'float' },
        ],
      })
      return positionGeometry.add(vec3(0, 0, hill(positionGeometry.xy, float(6)).mul(0.4)))
    },
    move: along(up, ([x, y]) => 0.4 * Math.exp(-6 * (x * x + y * y))),
  },
  'a varying for the colour': {
    shape: 'plane',
    position() {
      const height = varying(float(0), 'vHeight')
      return Fn(() => {
        const p = positionLocal.toVar()
        p.z.addAssign(sin(p.x.mul(4)).mul(0.2))
        height.assign(p.z)
        return p
      })()
    },
    move: along(up, ([x]) => 0.2 * Math.sin(4 * x)),
  },
  'waves in world space': {
    shape: 'sphere',
    position: () => positionLocal.mul(sin(positionWorld.x.mul(4)).mul(0.1).add(1)),
    move(p, n, uv, { matrixWorld }) {
      const { x } = new THREE.Vector3(...p).applyMatrix4(matrixWorld)
      return scale(p, 1 + 0.1 * Math.sin(4 * x))
    },
  },
  'grass, instanced': {
    kind: 'instances',
    shape: 'sphere',
    position: () =>
      positionLocal.add(
        vec3(sin(positionLocal.y.mul(3).add(float(instanceIndex).mul(2))).mul(0.2), 0, 0),
      ),
    move: ([x, y, z], n, uv, { instance }) => [x + 0.2 * Math.sin(3 * y + 2 * instance), y, z],
  },
  'instances with an attribute': {
    kind: 'instances',
    shape: 'sphere',
    position: () =>
      positionLocal.add(vec3(0, sin(positionLocal.x.mul(3)).mul(attribute('lift', 'float')), 0)),
    prepare: ({ geometry }) =>
      geometry.setAttribute('lift', new THREE.InstancedBufferAttribute(new Float32Array(lifts), 1)),
    move: ([x, y, z], n, uv, { instance }) => [x, y + lifts[instance] * Math.sin(3 * x), z],
  },
  'instances with storage': {
    kind: 'instances',
    shape: 'sphere',
    position() {
      const list = instancedArray(new Float32Array([...lifts]), 'float')
      return positionLocal.add(
        vec3(0, sin(positionLocal.x.mul(3)).mul(list.element(instanceIndex)), 0),
      )
    },
    move: ([x, y, z], n, uv, { instance }) => [x, y + lifts[instance] * Math.sin(3 * x), z],
  },
  'a skin': {
    kind: 'skin',
    shape: 'sphere',
    position: () => positionLocal.add(vec3(0, sin(positionLocal.x.mul(4)).mul(0.15), 0)),
    move: ([x, y, z]) => [x, y + 0.15 * Math.sin(4 * x), z],
  },
  'a morph target': {
    kind: 'morphs',
    shape: 'sphere',
    position: () => positionLocal.add(vec3(0, sin(positionLocal.x.mul(4)).mul(0.15), 0)),
    move: ([x, y, z]) => [x, y + 0.15 * Math.sin(4 * x), z],
  },
  'positionGeometry on a skinned mesh': {
    kind: 'skin',
    shape: 'sphere',
    ignoresPose: true,
    position: () =>
      positionGeometry.add(normalGeometry.mul(sin(positionGeometry.x.mul(4)).mul(0.15))),
    move: (p, n) => add(p, scale(n, 0.15 * Math.sin(4 * p[0]))),
  },
}

/** Displacements for which we have no derivative with respect to the position, each with a part of the message. */
export const unsupported = {
  'a jitter by vertexIndex': {
    shape: 'plane',
    position: () => positionLocal.add(vec3(0, 0, TSL.hash(TSL.vertexIndex).mul(0.1))),
    message: /depends on vertexIndex/,
  },
  'a vertex attribute': {
    shape: 'plane',
    position: () => positionLocal.add(attribute('shift', 'vec3')),
    prepare: ({ geometry }) =>
      geometry.setAttribute('shift', new THREE.BufferAttribute(new Float32Array(12), 3)),
    message: /depends on the attribute "shift"/,
  },
  'a mip level of a texture': {
    shape: 'plane',
    position: () => positionLocal.add(vec3(0, 0, texture(heightmap, uv()).level(1).r)),
    message: /reads a mip level of a texture/,
  },
  'an offset in a texture': {
    shape: 'plane',
    position: () => positionLocal.add(vec3(0, 0, texture(heightmap, uv()).offset(ivec2(1, 0)).r)),
    message: /reads an offset of a texture/,
  },
}
