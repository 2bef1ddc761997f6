// Computes what sketches in p5.strands should draw on WEBGPU, in double precision: functions of p5, and meshes that a sketch's `move`
// moves.
export const millis = 1700
export const seconds = millis / 1000
const { abs, cos, floor, fround, hypot, max, min, sin } = Math
export const clamp = (x, from, to) => min(to, max(from, x))
export const mix = (a, b, t) => a + (b - a) * t
export const smoothstep = (from, to, x) => {
  const t = clamp((x - from) / (to - from), 0, 1)
  return t * t * (3 - 2 * t)
}
export const mod = (x, y) => x - y * floor(x / y)
export const fract = (x) => x - floor(x)
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
export const add = (a, b) => a.map((x, k) => x + b[k])
export const scale = (a, factor) => a.map((x) => x * factor)

const gap = fround(2 * fround(0.142857142857))
const start = fround(fround(0.5 * fround(0.142857142857)) - 1)

/**
 * Returns one of 49 directions on an octahedron, of about length 1. Rounds like float32, which decides on which face a point at an edge is.
 */
function gradient(hash) {
  const j = mod(hash, 49)
  const [x, y] = [floor(j / 7), mod(j, 7)].map((k) => fround(fround(k * gap) + start))
  const z = fround(fround(1 - abs(x)) - abs(y))
  const sign = (k) => (k < 0 ? -1 : 1)
  const folded = z > 0 ? [x, y, z] : [x - sign(x), y - sign(y), z]
  return scale(folded, 1.79284291400159 - 0.85373472095314 * dot(folded, folded))
}

function simplex(p) {
  const scramble = (x) => mod((x * 34 + 10) * x, 289)
  const skew = (p[0] + p[1] + p[2]) / 3
  const cell = p.map((x) => floor(x + skew))
  const first = p.map((x, k) => x - cell[k] + (cell[0] + cell[1] + cell[2]) / 6)
  // The path to the opposite corner takes the largest component first.
  const order = [0, 1, 2].sort((a, b) => first[b] - first[a])
  const corner = [0, 0, 0]
  let sum = 0
  for (let step = 0; step < 4; step++) {
    const fromCorner = first.map((x, k) => x - corner[k] + step / 6)
    const [i, j, k] = cell.map((x, axis) => mod(x, 289) + corner[axis])
    const direction = gradient(scramble(scramble(scramble(k) + j) + i))
    sum += max(0.5 - dot(fromCorner, fromCorner), 0) ** 4 * dot(direction, fromCorner)
    if (step < 3) corner[order[step]] = 1
  }
  return 105 * sum
}

/** Mirrors p5's noise() as its reference describes it: four octaves, each with half the amplitude of the one before. */
export function noise(x, y = 0, z = 0) {
  let sum = 0
  for (let octave = 0; octave < 4; octave++)
    sum += simplex([x, y, z].map((k) => k * 2 ** octave)) / 2 ** octave
  return (sum + 1) / 2
}

/** Returns the red of a pixel of the page's image `heights`, which has 16 × 16 pixels; from 0 to 255. */
export const redAt = (column, row) =>
  Math.round(128 + 60 * sin(column * 0.4) * cos(row * 0.4) + 40 * cos(row * 0.4))

/** Samples that image between pixel centers. */
export function heightAt(u, v) {
  const [x, y] = [u * 16 - 0.5, v * 16 - 0.5]
  const [i, j] = [floor(x), floor(y)]
  const texel = (i, j) => redAt(clamp(i, 0, 15), clamp(j, 0, 15)) / 255
  const row = (j) => mix(texel(i, j), texel(i + 1, j), x - i)
  return mix(row(j), row(j + 1), y - j)
}

/** The numbers in the storage `lifts` of the page. */
export const lifts = [0.25, -0.125, 0.375, 0.0625]

/** Mirrors p5's random() in a vertex shader, with its roundings: a hash of the vertex number and the count of earlier calls. */
export function randomOf(vertex, seed, count) {
  const f = fround
  const s = f(f(seed * f(0.7548776662)) - floor(f(seed * f(0.7548776662))))
  const point = [
    f(vertex + s),
    f(f(vertex * f(0.569840291)) + f(count * f(0.6180339887))),
    f(s + f(count * f(0.7548776662))),
  ]
  const p = [0.1031, 0.103, 0.0973].map((factor, k) => f(fract(f(point[k] * f(factor)))))
  const q = [p[1], p[0], p[2]].map((x) => f(x + f(33.33)))
  const sum = f(f(f(p[0] * q[0]) + f(p[1] * q[1])) + f(p[2] * q[2]))
  const [x, y, z] = p.map((each) => f(each + sum))
  return f(fract(f(f(x + y) * z)))
}

/** Returns position, normal and uv of a point of the surface: a sphere without its poles. */
const pointAt = (u, v) => {
  const [a, b] = [2 * Math.PI * u, Math.PI * (0.08 + 0.84 * v)]
  const n = [cos(a) * sin(b), -cos(b), sin(a) * sin(b)]
  return { p: n, n, uv: [u, v] }
}

const [rows, columns] = [72, 96]
const toWorld = ([x, y, z]) => {
  const [c, s] = [cos(0.4), sin(0.4)]
  return scale([x, c * y - s * z, s * y + c * z], 40)
}

/** Returns the position in world space to which a sketch moves a point of the surface. */
function movedPoint({ move, space, later = (p) => p }, u, v, instance, eye, vertex) {
  const { p, n, uv } = pointAt(u, v)
  if (!space) return later(toWorld(move(p, n, uv, instance, vertex)))
  const [x, y, z] = toWorld(p)
  if (space === 'world') return move([x, y, z])
  return add(move([x, y, z - eye]), [0, 0, eye])
}

/** Makes the data of a p5.Geometry. `pointOf(u, v, vertex)` returns a vertex, and its finite differences are the normals. */
function makeMesh(pointOf) {
  const [vertices, normals, uvs, faces] = [[], [], [], []]
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++) {
      const [u, v, e] = [i / columns, j / rows, 1e-6]
      const vertex = j * (columns + 1) + i
      const difference = (du, dv) => {
        const [from, to] = [pointOf(u - du, v - dv, vertex), pointOf(u + du, v + dv, vertex)]
        return add(to, scale(from, -1))
      }
      const [a, b] = [difference(e, 0), difference(0, e)]
      const normal = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
      ]
      vertices.push(pointOf(u, v, vertex))
      normals.push(scale(normal, -1 / hypot(...normal)))
      uvs.push(u, v)
      if (i < columns && j < rows)
        faces.push(
          [vertex, vertex + 1, vertex + columns + 2],
          [vertex, vertex + columns + 2, vertex + columns + 1],
        )
    }
  return { vertices, normals, uvs, faces }
}

export const sphere = () => makeMesh((u, v) => pointAt(u, v).p)

/** Returns the meshes that a sketch should show, one for each instance. */
export const meshesByHand = (sketch, eye) =>
  Array.from({ length: sketch.instances ?? 1 }, (_, i) =>
    makeMesh((u, v, vertex) => movedPoint(sketch, u, v, i, eye, vertex)),
  )
