// Formulas of the displacements in JavaScript, in double precision, as oracles. cases.js has the same formulas in GLSL.
const { sin, cos, floor, exp, hypot, min, abs, sqrt, PI } = Math
export const mod = (x, y) => x - y * floor(x / y)
const fract = (x) => x - floor(x)
const mix = (a, b, t) => a + (b - a) * t

/** Permutes integers. These are small enough to be exact in float32, so that GLSL computes the same. */
const scramble = (x) => mod((x * 34 + 1) * x, 289)
const cell = (x, y, z) => scramble(scramble(scramble(mod(x, 289)) + mod(y, 289)) + mod(z, 289))

/** Gradient noise, with a quintic fade. */
export function noise(x, y, z) {
  const [i, j, k] = [x, y, z].map(floor)
  const [u, v, w] = [x, y, z].map(fract)
  const fade = (t) => t * t * t * (t * (t * 6 - 15) + 10)
  const corner = (a, b, c) => {
    const h = cell(i + a, j + b, k + c)
    const angle = (h * 2 * PI) / 289
    const z = mod(h * 7, 289) / 144.5 - 1
    const r = sqrt(1 - z * z)
    return r * cos(angle) * (u - a) + r * sin(angle) * (v - b) + z * (w - c)
  }
  const [a, b, c] = [fade(u), fade(v), fade(w)]
  const edge = (y, z) => mix(corner(0, y, z), corner(1, y, z), a)
  return mix(mix(edge(0, 0), edge(1, 0), b), mix(edge(0, 1), edge(1, 1), b), c)
}

export const glslNoise = `
float scramble(float x) { return mod((x * 34.0 + 1.0) * x, 289.0); }
float cell(vec3 p) {
  p = mod(p, 289.0);
  return scramble(scramble(scramble(p.x) + p.y) + p.z);
}
float corner(vec3 i, vec3 f, vec3 c) {
  float h = cell(i + c);
  float angle = h * 6.283185307179586 / 289.0;
  float z = mod(h * 7.0, 289.0) / 144.5 - 1.0;
  float r = sqrt(1.0 - z * z);
  return dot(vec3(r * cos(angle), r * sin(angle), z), f - c);
}
float noise(vec3 p) {
  vec3 i = floor(p);
  vec3 f = fract(p);
  vec3 a = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float z0 = mix(mix(corner(i, f, vec3(0, 0, 0)), corner(i, f, vec3(1, 0, 0)), a.x),
                 mix(corner(i, f, vec3(0, 1, 0)), corner(i, f, vec3(1, 1, 0)), a.x), a.y);
  float z1 = mix(mix(corner(i, f, vec3(0, 0, 1)), corner(i, f, vec3(1, 0, 1)), a.x),
                 mix(corner(i, f, vec3(0, 1, 1)), corner(i, f, vec3(1, 1, 1)), a.x), a.y);
  return mix(z0, z1, a.z);
}
`

export const waves = [
  [1, 0.4, 0.25, 1.7],
  [-0.5, 1, 0.18, 2.6],
  [0.3, -1, 0.1, 4.3],
]

/** Moves a point of a plane by Gerstner waves: directions, steepness and wave numbers. */
export function gerstner([x, y, z], time) {
  let moved = [x, y, z]
  for (const [dx, dy, steepness, k] of waves) {
    const length = hypot(dx, dy)
    const [a, b] = [dx / length, dy / length]
    const phase = k * (a * x + b * y) - time
    moved = [
      moved[0] + ((a * steepness) / k) * cos(phase),
      moved[1] + ((b * steepness) / k) * cos(phase),
      moved[2] + (steepness / k) * sin(phase),
    ]
  }
  return moved
}

/** Returns the height of ridges: four octaves of folded noise. */
export function ridges(x, y) {
  let [sum, amplitude, frequency] = [0, 0.4, 1.3]
  for (let i = 0; i < 4; i++) {
    const ridge = 1 - abs(noise(x * frequency, y * frequency, 0.37))
    sum += amplitude * ridge * ridge
    amplitude *= 0.45
    frequency *= 2.1
  }
  return sum
}

/** Returns the distance to the nearest point of a jittered grid. */
export function voronoi(x, y) {
  const [i, j] = [floor(x), floor(y)]
  let nearest = 8
  for (let b = -1; b <= 1; b++)
    for (let a = -1; a <= 1; a++) {
      const h = cell(i + a, j + b, 3)
      const px = a + 0.15 + (0.7 * mod(h, 17)) / 17 - (x - i)
      const py = b + 0.15 + (0.7 * mod(h, 23)) / 23 - (y - j)
      nearest = min(nearest, px * px + py * py)
    }
  return sqrt(nearest)
}

/** The texels of a height map of 8 × 8 texels. */
export const texels = Float32Array.from({ length: 64 }, (_, i) => fract(sin(i * 12.9) * 43.7))

/** Samples the height map like WebGL, with a linear filter and clamped coordinates. */
export function heightMap(u, v) {
  const texelAt = (x, y) => texels[Math.max(0, min(7, y)) * 8 + Math.max(0, min(7, x))]
  const [x, y] = [u * 8 - 0.5, v * 8 - 0.5]
  const [i, j] = [floor(x), floor(y)]
  return mix(
    mix(texelAt(i, j), texelAt(i + 1, j), x - i),
    mix(texelAt(i, j + 1), texelAt(i + 1, j + 1), x - i),
    y - j,
  )
}

export const ripple = ([x, y], time) => {
  const d = hypot(x - 0.3, y + 0.2)
  return 0.2 * sin(9 * d - time) * exp(-1.5 * d)
}
