// The warps of the gallery once more, with operators, by the names that sketches.js gives them. Each stands for itself, since p5
// would lose what lies around it, too.

const turnedAboutY = (rate, time) => `({ position, millis }) => {
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

export const texts = {
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
  'bunny-twist': turnedAboutY(0.015, 900),
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
  'coarse-and-fine': turnedAboutY(0.014, 1000),
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
}
