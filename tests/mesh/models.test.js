// Tests the models of the gallery: their meshes, and how they are written as OBJ.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { models, toOBJ } from '../../web/models/index.js'

const point = (values, i) => [values[3 * i], values[3 * i + 1], values[3 * i + 2]]
const sub = (a, b) => a.map((x, k) => x - b[k])
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

const corners = ({ indices }, face) => [0, 1, 2].map((k) => indices[3 * face + k])
const countFaces = ({ indices }) => indices.length / 3

function faceNormal({ positions }, [a, b, c]) {
  const p = point(positions, a)
  return cross(sub(point(positions, b), p), sub(point(positions, c), p))
}

/** Counts the edges whose neighbouring triangle does not have the same edge in reverse. */
function countOpenEdges(mesh) {
  const balance = new Map()
  for (let face = 0; face < countFaces(mesh); face++) {
    const places = corners(mesh, face).map((i) => point(mesh.positions, i).join())
    places.forEach((a, k) => {
      const b = places[(k + 1) % 3]
      const [key, sign] = a < b ? [`${a} ${b}`, 1] : [`${b} ${a}`, -1]
      balance.set(key, (balance.get(key) ?? 0) + sign)
    })
  }
  return [...balance.values()].filter((count) => count !== 0).length
}

function bounds({ positions }) {
  const axis = (k) => positions.filter((_, i) => i % 3 === k)
  return [0, 1, 2].map((k) => [
    axis(k).reduce((m, x) => Math.min(m, x)),
    axis(k).reduce((m, x) => Math.max(m, x)),
  ])
}

const assertNear = (actual, expected, tolerance = 0.01) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not ${expected}`)

/** Maps a model → the min and max number of its vertices. */
const VERTICES = {
  airplane: [13000, 15500],
  spoon: [6000, 10000],
  hand: [10000, 20000],
  bunny: [1839, 1839],
  teapot: [8066, 8066],
}
// Body, spout, handle and lid of the teapot are open shells; all other models are watertight.
const CLOSED = ['airplane', 'spoon', 'hand', 'bunny']

const meshes = Object.fromEntries(Object.entries(models).map(([name, make]) => [name, make()]))

for (const [name, mesh] of Object.entries(meshes)) {
  const { positions, normals, uvs, indices } = mesh
  const count = positions.length / 3

  test(`${name} has the number of vertices of a gallery model, all of them used`, () => {
    const [min, max] = VERTICES[name]
    assert.ok(count >= min && count <= max, `${count} vertices`)
    assert.equal(new Set(indices).size, count)
    assert.equal(normals.length, positions.length)
    assert.equal(uvs.length, 2 * count)
  })

  test(`${name} has finite positions, unit normals, and uvs in the unit square`, () => {
    assert.ok(positions.every(Number.isFinite))
    assert.ok(uvs.every((x) => x >= 0 && x <= 1))
    for (let i = 0; i < count; i++) assertNear(Math.hypot(...point(normals, i)), 1, 1e-5)
  })

  test(`${name} is centred and its longest side measures 200`, () => {
    const box = bounds(mesh)
    box.forEach(([low, high]) => assertNear(low + high, 0))
    assertNear(Math.max(...box.map(([low, high]) => high - low)), 200)
  })

  test(`${name} has no degenerate triangle, and its triangles face in the direction of their normals`, () => {
    let facingAway = 0
    for (let face = 0; face < countFaces(mesh); face++) {
      const triangle = corners(mesh, face)
      const n = faceNormal(mesh, triangle)
      assert.ok(Math.hypot(...n) > 0.01, `triangle ${face} has no area`)
      if (triangle.some((i) => dot(n, point(normals, i)) <= 0)) facingAway++
    }
    assert.ok(facingAway <= 0.001 * countFaces(mesh), `${facingAway} triangles face away`)
  })

  test(`${name} encloses a positive volume${CLOSED.includes(name) ? ' without a gap' : ''}`, () => {
    let volume = 0
    for (let face = 0; face < countFaces(mesh); face++) {
      const [a, b, c] = corners(mesh, face).map((i) => point(positions, i))
      volume += dot(a, cross(b, c)) / 6
    }
    assert.ok(volume > 0, `volume ${volume}`)
    if (CLOSED.includes(name)) assert.equal(countOpenEdges(mesh), 0)
  })

  test(`${name} as OBJ has a line for every vertex and face, with short numbers`, () => {
    const lines = toOBJ(mesh, name).trim().split('\n')
    const linesOf = (word) => lines.filter((line) => line.startsWith(`${word} `))
    assert.equal(lines[0], `o ${name}`)
    assert.deepEqual(
      ['v', 'vt', 'vn', 'f'].map((word) => linesOf(word).length),
      [count, count, count, countFaces(mesh)],
    )
    const numberPattern = /^-?\d+(\.\d{1,4})?$/
    for (const line of [...linesOf('v'), ...linesOf('vt'), ...linesOf('vn')]) {
      assert.ok(
        line
          .split(' ')
          .slice(1)
          .every((x) => numberPattern.test(x)),
        line,
      )
    }
    assert.deepEqual(
      linesOf('f')[0].split(' ').slice(1),
      corners(mesh, 0).map((i) => `${i + 1}/${i + 1}/${i + 1}`),
    )
  })
}

test('toOBJ counts from one, flips v, and omits missing uvs', () => {
  const triangle = {
    positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, -0.12345, 1e-9]),
    normals: new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]),
    indices: new Uint32Array([0, 1, 2]),
  }
  const start = 'o t\nv 0 0 0\nv 1 0 0\nv 0 -0.123 0\n'
  const vn = 'vn 0 0 1\nvn 0 0 1\nvn 0 0 1\n'
  assert.equal(toOBJ(triangle, 't'), `${start}${vn}f 1//1 2//2 3//3\n`)
  const uvs = new Float32Array([0, 0, 1, 0, 0.5, 0.75])
  assert.equal(
    toOBJ({ ...triangle, uvs }, 't'),
    `${start}vt 0 1\nvt 1 1\nvt 0.5 0.25\n${vn}f 1/1/1 2/2/2 3/3/3\n`,
  )
})

test('the models are upright when y points down', () => {
  const highest = ({ positions }) => {
    let best = 0
    for (let i = 1; i < positions.length / 3; i++) {
      if (positions[3 * i + 1] < positions[3 * best + 1]) best = i
    }
    return point(positions, best)
  }
  const [fin] = highest(meshes.airplane)
  assert.ok(fin < -70, 'expected the tail fin as the highest part of the airplane')
  const [middleFinger] = highest(meshes.hand)
  assert.ok(Math.abs(middleFinger) < 10, 'expected the middle finger as the highest part')
  const [lid, , deep] = highest(meshes.teapot)
  assert.ok(Math.hypot(lid, deep) < 25, 'expected the knob of the lid as the highest part')
  const feet = [...meshes.bunny.positions].filter((_, i, all) => i % 3 === 0 && all[i + 1] > 85)
  assert.ok(
    Math.max(...feet) - Math.min(...feet) > 80,
    'expected the feet of the bunny at the bottom',
  )
})

test('the airplane and the spoon are dense enough to twist and bend', () => {
  for (const name of ['airplane', 'spoon']) {
    const mesh = meshes[name]
    let longest = 0
    for (let face = 0; face < countFaces(mesh); face++) {
      const p = corners(mesh, face).map((i) => point(mesh.positions, i))
      for (let k = 0; k < 3; k++)
        longest = Math.max(longest, Math.hypot(...sub(p[k], p[(k + 1) % 3])))
    }
    assert.ok(longest < 3.2, `${name}: an edge of ${longest} units`)
  }
})
