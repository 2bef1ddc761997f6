import {
  add,
  clamp,
  dot,
  fract,
  heightAt,
  lifts,
  millis,
  mix,
  mod,
  noise,
  randomOf,
  scale,
  seconds,
  smoothstep,
} from './strands-oracle.js'

/**
 * Sketches in p5.strands as people write them, for WEBGPU. `hooks` is the body of the callback of `modify`. `move(p, n, uv, instance,
 * vertex)` returns the moved position of a vertex in double precision, where `vertex` is the index of the vertex. Positions are in the
 * space of the geometry or, with `space`, of the world or the camera. `later`, if present, then moves the result in world space. `rejected`
 * is the message about a sketch without exact normals.
 */
const { abs, atan2, cos, exp, floor, hypot, sin, sqrt } = Math
/** Return functions that move a point upwards or along the normal. */
const liftBy = (height) => (p, n, uv, i) => [p[0], p[1] + height(p, n, uv, i), p[2]]
const pushBy = (height) => (p, n, uv, i) => add(p, scale(n, height(p, n, uv, i)))

const inObject = (statements, above = '') => `${above}
getObjectInputs((inputs) => {
  ${statements}
  return inputs
})`

export const sketches = {
  'a sine': {
    hooks: inObject('inputs.position.y += 0.2 * sin(inputs.position.x * 5)'),
    move: liftBy(([x]) => 0.2 * sin(x * 5)),
  },
  'a sine that travels with millis()': {
    hooks: inObject(`
      const t = millis() * 0.001
      inputs.position.y += 0.2 * sin(inputs.position.x * 4 + t * 2)`),
    move: liftBy(([x]) => 0.2 * sin(x * 4 + seconds * 2)),
  },
  'a time that is a uniform': {
    hooks: `const time = uniformFloat(() => millis() / 1000)
objectInputs.begin()
objectInputs.position.z += 0.15 * cos(objectInputs.position.y * 6 - time)
objectInputs.end()`,
    move: ([x, y, z]) => [x, y, z + 0.15 * cos(y * 6 - seconds)],
  },
  'a sum of waves in a loop': {
    hooks: inObject(`
      let sum = 0
      for (let i = 1; i < 5; i++) {
        sum += sin(inputs.position.x * 2 * i + inputs.position.z * i) / i
      }
      inputs.position.y += sum * 0.1`),
    move: liftBy(
      ([x, , z]) => [1, 2, 3, 4].reduce((s, i) => s + sin(x * 2 * i + z * i) / i, 0) * 0.1,
    ),
  },
  'a ripple by distance': {
    hooks: inObject(`
      const d = length(inputs.position.xz)
      inputs.position.y += sin(d * 12 - millis() / 500) * exp(-2 * d) * 0.4`),
    move: liftBy(([x, , z]) => {
      const d = hypot(x, z)
      return sin(d * 12 - millis / 500) * exp(-2 * d) * 0.4
    }),
  },
  'a twist': {
    hooks: inObject(`
      const p = inputs.position
      const a = p.y * 1.5
      inputs.position = [p.x * cos(a) - p.z * sin(a), p.y, p.x * sin(a) + p.z * cos(a)]`),
    move: ([x, y, z]) => {
      const [c, s] = [cos(1.5 * y), sin(1.5 * y)]
      return [x * c - z * s, y, x * s + z * c]
    },
  },
  'a twist by a helper function': {
    hooks: `const turn = (p, a) => [p.x * cos(a) - p.y * sin(a), p.x * sin(a) + p.y * cos(a), p.z]
${inObject('inputs.position = turn(inputs.position, inputs.position.z * 1.25)')}`,
    move: ([x, y, z]) => {
      const [c, s] = [cos(1.25 * z), sin(1.25 * z)]
      return [x * c - y * s, x * s + y * c, z]
    },
  },
  'a squeeze': {
    hooks: inObject('inputs.position.xz *= 1 + 0.4 * sin(inputs.position.y * 4)'),
    move: ([x, y, z]) => [x * (1 + 0.4 * sin(y * 4)), y, z * (1 + 0.4 * sin(y * 4))],
  },
  'spikes along the normal': {
    hooks: inObject(
      'inputs.position += inputs.normal * 0.2 * pow(abs(sin(inputs.position.x * 4)) + 0.1, 2)',
    ),
    move: pushBy(([x]) => 0.2 * (abs(sin(x * 4)) + 0.1) ** 2),
  },
  'a wave by texCoord': {
    hooks: inObject('inputs.position.y += 0.1 * sin(inputs.texCoord.x * 25.1327)'),
    move: liftBy((p, n, [u]) => 0.1 * sin(u * 25.1327)),
  },
  'the normal and texCoord': {
    hooks: inObject('inputs.position += inputs.normal * sin(inputs.texCoord.y * 12.5) * 0.1'),
    move: pushBy((p, n, [, v]) => 0.1 * sin(v * 12.5)),
  },
  'noise of one number': {
    hooks: inObject('inputs.position.y += noise(inputs.position.x * 1.5 + 4.3) * 0.5'),
    move: liftBy(([x]) => noise(x * 1.5 + 4.3) * 0.5),
  },
  'noise of two numbers': {
    hooks: inObject(
      'inputs.position.y += 0.5 * noise(inputs.position.x * 0.75, inputs.position.z * 0.75)',
    ),
    move: liftBy(([x, , z]) => 0.5 * noise(x * 0.75, z * 0.75)),
  },
  'noise of the position and the time, along the normal': {
    hooks: inObject(`
      const t = millis() * 0.0005
      const p = inputs.position
      inputs.position += inputs.normal * (noise(p.x + t, p.y, p.z) - 0.5) * 0.4`),
    move: pushBy(([x, y, z]) => (noise(x + millis * 0.0005, y, z) - 0.5) * 0.4),
  },
  'noise of a vector': {
    hooks: inObject('inputs.position.x += noise(inputs.position * 0.75) * 0.5'),
    move: ([x, y, z]) => [x + 0.5 * noise(x * 0.75, y * 0.75, z * 0.75), y, z],
  },
  'noise that bends noise': {
    hooks: inObject(`
      const p = inputs.position
      const bend = noise(p.x * 0.5, p.y * 0.5, 2)
      inputs.position.z += 0.4 * noise(p.x * 0.5 + bend, p.y * 0.5 - bend, p.z * 0.5)`),
    move: ([x, y, z]) => {
      const bend = noise(x * 0.5, y * 0.5, 2)
      return [x, y, z + 0.4 * noise(x * 0.5 + bend, y * 0.5 - bend, z * 0.5)]
    },
  },
  'mod()': {
    hooks: inObject('inputs.position.z += mod(inputs.position.y * 4 + 8, 16) * 0.0625'),
    move: ([x, y, z]) => [x, y, z + mod(y * 4 + 8, 16) * 0.0625],
  },
  'the operator %': {
    hooks: inObject('inputs.position.z += ((inputs.position.x * 3 + 20) % 40) * 0.1'),
    move: ([x, y, z]) => [x, y, z + mod(x * 3 + 20, 40) * 0.1],
  },
  'fract()': {
    hooks: inObject('inputs.position.z += fract(inputs.position.x * 0.25 + 0.5) * 0.8'),
    move: ([x, y, z]) => [x, y, z + 0.8 * fract(x * 0.25 + 0.5)],
  },
  'an if and an else': {
    hooks: inObject(`
      let lift = 0
      if (inputs.position.y > 0) {
        lift = inputs.position.y * inputs.position.y
      } else {
        lift = -0.5 * inputs.position.y * inputs.position.y
      }
      inputs.position.x += lift * 0.5`),
    move: ([x, y, z]) => [x + 0.5 * (y > 0 ? y * y : -0.5 * y * y), y, z],
  },
  'an if within a loop': {
    hooks: inObject(`
      let s = 0
      for (let i = 0; i < 4; i++) {
        if (i > 1) { s += sin(inputs.position.x * i) } else { s += inputs.position.x * inputs.position.x * 0.25 }
      }
      inputs.position.y += s * 0.15`),
    move: liftBy(([x]) => 0.15 * (sin(2 * x) + sin(3 * x) + 0.5 * x * x)),
  },
  'a ternary': {
    hooks: inObject(
      'inputs.position.y += inputs.position.x > 0.1 ? sin(inputs.position.x * 3 - 0.3) * 0.3 : 0',
    ),
    move: liftBy(([x]) => (x > 0.1 ? 0.3 * sin(x * 3 - 0.3) : 0)),
  },
  'mix and smoothstep': {
    hooks: inObject(`
      const t = smoothstep(-0.5, 0.5, inputs.position.y)
      inputs.position.x = mix(inputs.position.x, inputs.position.x * 0.4 + 0.2, t)`),
    move: ([x, y, z]) => [mix(x, x * 0.4 + 0.2, smoothstep(-0.5, 0.5, y)), y, z],
  },
  'clamp and mix': {
    hooks: inObject(`
      const t = clamp(inputs.position.y + 0.5, 0, 1)
      inputs.position.z = mix(inputs.position.z, inputs.position.z * 1.5, t)`),
    move: ([x, y, z]) => [x, y, mix(z, z * 1.5, clamp(y + 0.5, 0, 1))],
  },
  'distance, sqrt and atan': {
    hooks: inObject(`
      const p = inputs.position
      const angle = atan(p.z, p.x + 3)
      inputs.position.y += 0.2 * sqrt(1 + sin(angle * 9) * 0.5) * distance(p, [0, 2, 0])`),
    move: liftBy(
      ([x, y, z]) => 0.2 * sqrt(1 + 0.5 * sin(9 * atan2(z, x + 3))) * hypot(x, y - 2, z),
    ),
  },
  'vectors: dot, normalize and cross': {
    hooks: inObject(`
      const axis = normalize(vec3(1, 2, 0.5))
      const along = dot(inputs.position, axis)
      inputs.position += cross(axis, inputs.position) * sin(along * 3) * 0.3`),
    move(p) {
      const axis = scale([1, 2, 0.5], 1 / hypot(1, 2, 0.5))
      const across = [
        axis[1] * p[2] - axis[2] * p[1],
        axis[2] * p[0] - axis[0] * p[2],
        axis[0] * p[1] - axis[1] * p[0],
      ]
      return add(p, scale(across, 0.3 * sin(3 * dot(p, axis))))
    },
  },
  'uniforms of vectors and a colour': {
    hooks: `const way = uniformVec3(() => [0.1, 0.3, -0.2])
const rate = uniformVec2('rate', [4, 2])
${inObject('inputs.position += way * sin(inputs.position.x * rate.x + inputs.position.y * rate.y)')}`,
    move: (p) => add(p, scale([0.1, 0.3, -0.2], sin(p[0] * 4 + p[1] * 2))),
  },
  'a fold with abs, min and max': {
    hooks: inObject(
      'inputs.position.y += max(min(inputs.position.x * 2, 1.5), -1.5) * 0.2 + abs(inputs.position.z - 3) * 0.1',
    ),
    move: liftBy(([x, , z]) => clamp(x * 2, -1.5, 1.5) * 0.2 + abs(z - 3) * 0.1),
  },
  'an image': {
    hooks: inObject(
      'inputs.position.y += 0.4 * getTexture(heights, inputs.texCoord).r',
      'const heights = uniformTexture(() => warps.heights)',
    ),
    move: liftBy((p, n, [u, v]) => 0.4 * heightAt(u, v)),
  },
  'an image that a helper samples at the position': {
    hooks: `const heights = uniformTexture(() => warps.heights)
const heightOf = (p) => getTexture(heights, p.xz * 0.4 + 0.5).r
${inObject('inputs.position.y += 0.5 * heightOf(inputs.position)')}`,
    move: liftBy(([x, , z]) => 0.5 * heightAt(x * 0.4 + 0.5, z * 0.4 + 0.5)),
  },
  'an element of a storage': {
    hooks: inObject(
      'inputs.position.y += lifts[2] * sin(inputs.position.x * 4)',
      'const lifts = uniformStorage(warps.lifts)',
    ),
    move: liftBy(([x]) => lifts[2] * sin(x * 4)),
  },
  'a storage read in a loop': {
    hooks: inObject(
      `let s = 0
      for (let i = 0; i < 4; i++) { s += lifts[i] * sin(inputs.position.x * (i + 1)) }
      inputs.position.y += s`,
      "const lifts = uniformStorage('lifts', warps.lifts)",
    ),
    move: liftBy(([x]) => lifts.reduce((s, lift, i) => s + lift * sin(x * (i + 1)), 0)),
  },
  'a storage indexed by the instance': {
    instances: 3,
    hooks: inObject(
      `const i = instanceID()
      inputs.position.y += lifts[i] * sin(inputs.position.x * 6)
      inputs.position.x += (i - 1) * 1.25`,
      'const lifts = uniformStorage(() => warps.lifts)',
    ),
    move: ([x, y, z], n, uv, i) => [x + (i - 1) * 1.25, y + lifts[i] * sin(x * 6), z],
  },
  'a storage of structures indexed by the instance': {
    instances: 3,
    hooks: inObject(
      `const one = places[instanceID()]
      inputs.position.y += one.height * sin(inputs.position.x * 5)
      inputs.position += one.place`,
      'const places = uniformStorage(() => warps.places)',
    ),
    move: ([x, y, z], n, uv, i) => [
      x + (i - 1) * 1.25,
      y + 0.1 * (i + 1) * sin(x * 5),
      z + 0.25 * i,
    ],
  },
  'a storage indexed by the position': {
    hooks: inObject(
      `const column = floor((inputs.position.x + 1) * 2)
      inputs.position.y += lifts[column] * inputs.position.x`,
      'const lifts = uniformStorage(() => warps.lifts)',
    ),
    move: liftBy(([x]) => lifts[floor((x + 1) * 2)] * x),
    rejected: /uniformStorage\(\) "lifts" in getObjectInputs .* differs over the surface/,
  },
  'random() for colours alone': {
    hooks: `const shade = sharedFloat()
${inObject(`
      shade = random()
      inputs.color = [1, 1 - shade * 0.001, 1 - random() * 0.001, 1]
      inputs.position.y += 0.2 * sin(inputs.position.x * 5)`)}`,
    move: liftBy(([x]) => 0.2 * sin(x * 5)),
  },
  'random() of a vertex beside a wave': {
    hooks: `randomSeed(5)
${inObject(`
      const a = random()
      inputs.position += inputs.normal * a * 0.02
      inputs.position.y += 0.2 * sin(inputs.position.x * 5) + random(-0.01, 0.01)`)}`,
    move(p, n, uv, i, vertex) {
      const [a, b] = [0, 1].map((count) => randomOf(vertex, 5, count))
      const q = add(p, scale(n, a * 0.02))
      return [q[0], q[1] + 0.2 * sin(q[0] * 5) - 0.01 + 0.02 * b, q[2]]
    },
  },
  'random() that multiplies a wave': {
    hooks: `randomSeed(5)
${inObject('inputs.position.z += (0.9 + 0.1 * random()) * 0.2 * sin(inputs.position.y * 6)')}`,
    move: ([x, y, z], n, uv, i, vertex) => [
      x,
      y,
      z + (0.9 + 0.1 * randomOf(vertex, 5, 0)) * 0.2 * sin(y * 6),
    ],
  },
  'random() in a loop': {
    hooks: inObject(`
      let sum = 0
      for (let i = 0; i < 3; i++) { sum += random() }
      inputs.position.y += sum * 0.02`),
    move: (p) => p,
    rejected: /random\(\) in getObjectInputs .* write noise\(\)/,
  },
  'random() behind a branch': {
    hooks: inObject(`
      let lift = 0
      if (inputs.position.x > 0) { lift = random() }
      inputs.position.y += lift * 0.02 + random() * 0.1`),
    move: (p) => p,
    rejected: /random\(\) in getObjectInputs .* write noise\(\)/,
  },
  'instances with different waves': {
    instances: 3,
    hooks: inObject(`
      const i = instanceID()
      inputs.position.z += 0.3 * sin(inputs.position.x * 4 + i * 2)
      inputs.position.x += (i - 1) * 1.25`),
    move: ([x, y, z], n, uv, i) => [x + (i - 1) * 1.25, y, z + 0.3 * sin(x * 4 + i * 2)],
  },
  'a wave in the world': {
    space: 'world',
    hooks: `worldInputs.begin()
worldInputs.position.y += 12 * sin(worldInputs.position.x * 0.08 + millis() * 0.001)
worldInputs.end()`,
    move: liftBy(([x]) => 12 * sin(x * 0.08 + seconds)),
  },
  'noise in the world': {
    space: 'world',
    hooks: `getWorldInputs((inputs) => {
  inputs.position.z += 40 * noise(inputs.position.x * 0.0125, inputs.position.y * 0.0125)
  return inputs
})`,
    move: ([x, y, z]) => [x, y, z + 40 * noise(x * 0.0125, y * 0.0125)],
  },
  'a bulge for the camera': {
    space: 'camera',
    hooks: `cameraInputs.begin()
const p = cameraInputs.position
cameraInputs.position.z += 30 * exp(length(p.xy) * -0.02)
cameraInputs.end()`,
    move: ([x, y, z]) => [x, y, z + 30 * exp(hypot(x, y) * -0.02)],
  },
  'two hooks that move vertices': {
    hooks: `getObjectInputs((inputs) => {
  inputs.position.y += 0.2 * sin(inputs.position.x * 4)
  return inputs
})
getWorldInputs((inputs) => {
  inputs.position.x += 8 * sin(inputs.position.y * 0.08)
  return inputs
})`,
    move: liftBy(([x]) => 0.2 * sin(x * 4)),
    later: ([x, y, z]) => [x + 8 * sin(y * 0.08), y, z],
  },
  'a height that another hook reads': {
    hooks: `const lift = sharedFloat()
${inObject(`
      lift = 0.25 * sin(inputs.position.x * 5)
      inputs.position.y += lift`)}
getPixelInputs((inputs) => {
  inputs.metalness = lift > 9 ? 100 : 0
  return inputs
})`,
    move: liftBy(([x]) => 0.25 * sin(x * 5)),
  },
}
