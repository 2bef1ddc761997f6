// The warps of the gallery with operators, by their names in sketches.js. Each is self-contained, since operators are translated in its
// source code, which cannot access variables around it.

const rotateAboutY = (rate, time) => `({ position, millis }) => {
  const { x, y, z } = position
  const angle = y * ${rate} * Math.sin(millis / ${time})
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)]
  return [x * cos - z * sin, y, x * sin + z * cos] - position
}`

const waves = (frequency, time, height) => `({ position, millis }) => {
  const wave = (x) => Math.sin(x * ${frequency} + millis / ${time}) * ${height}
  return [wave(position.y), wave(position.z), wave(position.x)]
}`

const bumps = `({ normal, position, millis }) => {
  const wave = (x) => Math.sin(x * 0.1 + millis / 900)
  const { x, y, z } = position
  const height = (wave(x) + wave(y) + wave(z)) * 4.5
  return normal.normalize() * height
}`

const relief = (level) => `({ glsl, position, millis }) => {
  const f = (p, ...shift) => glsl.fbm(p + glsl.vec3(...shift), { octaves: 3 }) * 0.5 + 0.5
  const p = position * 0.5 + millis / 30000
  let at = p
  if (${level} > 0) at = p + [f(p, 0, 0, 0), f(p, 5.2, 1.3, 2.8), f(p, 1.7, 9.2, 4.1)] * 4
  if (${level} > 1) at = p + [f(at, 1.7, 9.2, 0), f(at, 8.3, 2.8, 5.1), f(at, 3.9, 6.4, 2.2)] * 4
  return position * ((f(at, 0, 0, 0) - 0.5) * 0.9)
}`

const swaying = `({ position, millis }) => {
  const angle = position.y * 5 + millis / 700
  return [Math.sin(angle), 0, Math.cos(angle)] * 0.4
}`

export const offsetSources = {
  'airplane-twist': `({ position, millis }) => {
    const { x, y, z } = position
    const angle = Math.sin(millis / 1200) * x * 0.015
    const [sin, cos] = [Math.sin(angle), Math.cos(angle)]
    const turnedY = y * cos - z * sin
    const turnedZ = y * sin + z * cos
    return [x, turnedY, turnedZ] - position
  }`,
  'along-the-normal-rough': bumps,
  'along-the-normal-exact': bumps,
  'bunny-twist': rotateAboutY(0.015, 900),
  'bunny-flatten': `({ position, millis }) => {
    const amount = (Math.sin(millis / 900) * 1.5 + 0.5).clamp(0, 0.97)
    return [-(position.x * amount), 0, 0]
  }`,
  carousel: `({ glsl, position, millis }) => {
    const down = position.y / 170 + 0.5
    const across = position.x * 0.05 + position.y * 0.03
    const phase = glsl.param('phase') - millis / 300
    const ripple = Math.sin(across + phase) * down * 14
    const trail = down * down * -50
    return [trail, trail / 5, ripple]
  }`,
  'coarse-and-fine': rotateAboutY(0.014, 1000),
  'domain-warping-3d-plain': relief(0),
  'domain-warping-3d-warped': relief(1),
  'domain-warping-3d-twice': relief(2),
  fingers: `({ position, millis }) => {
    const up = (position.y / -200).clamp(0, 1)
    const wave = Math.sin(position.x * 0.03 + millis / 250)
    return [0, 0, up * up * wave * 70]
  }`,
  genie: `({ glsl, position, millis }) => {
    const spout = glsl.vec3(100, 186, 0)
    const above = glsl.vec3(150, 0, 0)
    const progress = Math.sin(millis / 1300) * 0.75 + 0.5
    const start = position.dist(spout) / 480
    const t = glsl.smoothstep(start, start + 0.5, progress)
    return position.mix(above, t).mix(above.mix(spout, t), t) - position
  }`,
  lotus: `({ glsl, position }) => {
    const bend = glsl.param('bend')
    const [x, y, z] = [position.x * 0.34, position.y, position.z]
    const along = y * -0.5 + 0.5
    const angle = along * bend
    const front = z * 0.04 - x * x * 1.6
    const radius = 1.5 / bend
    const inner = radius - front
    const up = Math.sin(angle) * inner
    const out = radius - Math.cos(angle) * inner
    return [x, -up, out] - position
  }`,
  'raked-sand': `({ glsl, position }) => {
    const height = glsl.texture('heights', position.xy + 0.5, { filter: 'bspline' }).r
    return [0, 0, height * 14]
  }`,
  'shadow-map-fartower': swaying,
  'one-edge-per-side': `({ position, millis }) => {
    const { x, y, z } = position
    const angle = Math.sin(y * 6 + millis / 1500) * 0.6
    const [sin, cos] = [Math.sin(angle), Math.cos(angle)]
    return [x * cos - z * sin, y, x * sin + z * cos] - position
  }`,
  'sine-cube': waves(0.035, 800, 22),
  'sine-sphere': `({ position, millis }) => {
    const time = millis / 700
    const wave = (x, phase) => Math.sin(x * 7 + time + phase) * 0.13
    return [wave(position.y, 0), wave(position.z, 2), wave(position.x, 4)]
  }`,
  spoon: `({ position, millis }) => {
    const { x, y, z } = position
    const [from, length] = [-10, 50]
    const curvature = Math.sin(millis / 1500) * 0.018 + 0.0185
    const radius = 1 / curvature
    const along = (x - from).clamp(0, length)
    const beyond = x - from - along
    const angle = along / radius
    const [sin, cos] = [Math.sin(angle), Math.cos(angle)]
    const inner = radius - y
    const bentX = inner * sin + beyond * cos + from
    const bentY = radius - inner * cos + beyond * sin
    return [bentX, bentY, z] - position
  }`,
  'tangent-plane': waves(0.04, 800, 16),
  'text-bulge': `({ glsl, position, mouse, size, millis }) => {
    const away = position.xy - (mouse - size / 2)
    const near = Math.exp(away.dot(away) / -16000)
    const wave = Math.sin(position.x * 0.01 + millis / 600) * 14
    return glsl.vec3(away * near * 0.6, near * 90 + wave)
  }`,
  'three-corridor': `({ position, uniforms }) => {
    const { curve, roll } = uniforms
    const angle = position.z * curve
    const reach = 1 / curve - position.x
    const x = 1 / curve - reach * Math.cos(angle)
    const y = position.y + Math.sin(position.z * 0.35) * roll
    return [x, y, reach * Math.sin(angle)] - position
  }`,
  'three-glass': `({ position, millis, uniforms }) => {
    const { twist, flutes } = uniforms
    const around = [position.x, position.z]
    const height = position.y
    const turn = height * twist * (Math.sin(millis / 2500) * 0.5 + 1)
    const angle = Math.atan2(position.z, position.x)
    const swell = Math.cos(angle * 7) * flutes * Math.min(height * 0.5, 1)
    const wide = around * (swell + 1)
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)]
    const x = wide.x * cos - wide.y * sin
    const z = wide.x * sin + wide.y * cos
    return [x - position.x, 0, z - position.z]
  }`,
  'three-grass': `({ glsl, position, millis, uniforms }) => {
    const { wind, gusts, direction } = uniforms
    const way = glsl.vec3(Math.cos(direction), 0, Math.sin(direction))
    const place = position.xz * gusts - way.xz * (millis / 900)
    const strength = (place.simplex() * 0.5 + 0.6) * wind
    const flutter = Math.sin(position.x * 5 + position.z * 7 + millis / 120) * 0.03
    const bend = Math.max(position.y, 0) ** 2 * (strength + flutter)
    return way * bend - [0, bend * bend * 0.4, 0]
  }`,
  'three-lanterns': `({ position, millis, uniforms }) => {
    const along = Math.sin(position.x * 0.21 + millis / 2600)
    const across = Math.sin(position.z * 0.27 - millis / 3100)
    const slow = (along + across) * uniforms.swell
    const ripple = Math.sin(position.xz.length() * 0.9 - millis / 700) * uniforms.ripple
    const lift = slow + ripple
    return [lift * 0.25, lift, 0]
  }`,
  'three-sea': `({ position, millis, uniforms }) => {
    const waves = [
      { toward: [1, 0.3], length: 5, steepness: 0.5 },
      { toward: [0.6, -0.8], length: 2.9, steepness: 0.4 },
      { toward: [0.2, 1], length: 1.7, steepness: 0.3 },
      { toward: [-0.5, 0.9], length: 0.9, steepness: 0.25 },
    ]
    let offset = [0, 0, 0]
    for (const { toward, length, steepness } of waves) {
      const far = Math.hypot(toward[0], toward[1])
      const [x, z] = [toward[0] / far, toward[1] / far]
      const k = (2 * Math.PI) / length
      const way = position.x * x + position.z * z
      const phase = way * k - millis * (Math.sqrt(9.8 * k) / 1000) * uniforms.speed
      const height = uniforms.height * (steepness / k)
      const forth = Math.cos(phase) * height
      offset += [forth * x, Math.sin(phase) * height, forth * z]
    }
    return offset
  }`,
  'three-terrain': `({ position, uniforms }) => {
    const place = position.xz
    const hill = Math.exp(place.dot(place) * -0.09) * 0.9 + 0.1
    const ridges = (place * uniforms.detail).ridged({ octaves: 5, seed: 4 })
    return [0, ridges * hill * uniforms.height, 0]
  }`,
}
