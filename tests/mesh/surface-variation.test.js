// Tests the normals of warps that depend on normal and uv, computed from the gradients of normal and uv over the surface.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { describe, test } from 'node:test'
import { WarpError, compileWarp } from 'warpjet'
import { bakeWarp, subdivide, surfaceVariation } from 'warpjet/mesh'
import { models } from '../../web/models/index.js'
import { interpolatePoints, subdivide as loopSubdivide } from '../../web/models/subdivide.js'
import { angleBetween } from '../support/browser/oracle.js'
import { movedNormal, surfaceMesh, surfaces } from '../support/surfaces.js'

const { sin, cos, PI } = Math

/** Each warp as an offset function, and as a reference in double precision. */
const warps = {
  'bumps along the normal': {
    warp: ({ position, normal }) => {
      const wave = (x, frequency, phase) => x.mult(frequency).add(phase).sin()
      const [x, y, z] = [position.x(), position.y(), position.z()]
      const height = wave(x, 3, 1)
        .mult(0.08)
        .add(wave(y, 4, 0).mult(0.06), wave(z, 5, 1.5).mult(0.05))
      return normal.mult(height)
    },
    offset: ([x, y, z], normal) => {
      const height = 0.08 * sin(3 * x + 1) + 0.06 * sin(4 * y) + 0.05 * sin(5 * z + 1.5)
      return normal.map((k) => k * height)
    },
  },
  inflated: {
    warp: ({ normal }) => normal.mult(0.25),
    offset: (_, normal) => normal.map((k) => k * 0.25),
  },
  'a swirl that depends on the normal': {
    warp: ({ glsl, position, normal }) =>
      glsl.vec3(
        normal.y().mult(position.z()).mult(0.2),
        normal.x().mult(2).sin().mult(0.1),
        normal.x().mult(normal.z()).mult(0.3),
      ),
    offset: ([, , z], [a, b, c]) => [0.2 * b * z, 0.1 * sin(2 * a), 0.3 * a * c],
  },
  'bumps that depend on uv': {
    warp: ({ normal, uv }) =>
      normal.mult(
        uv
          .x()
          .mult(6 * PI)
          .sin()
          .mult(
            uv
              .y()
              .mult(4 * PI)
              .cos(),
          )
          .mult(0.07),
      ),
    offset: (_, normal, [u, v]) => normal.map((k) => k * 0.07 * sin(6 * PI * u) * cos(4 * PI * v)),
    // All u meet at the poles.
    skips: 'sphere',
  },
}

const triples = (numbers) =>
  Array.from({ length: numbers.length / 3 }, (_, i) => [...numbers.slice(3 * i, 3 * i + 3)])

/** Returns the errors in degrees at the vertices where there is an oracle. */
function errors(normals, expected) {
  return triples(normals).flatMap((normal, i) =>
    expected[i] ? [angleBetween(normal, expected[i])] : [],
  )
}

const mean = (numbers) => numbers.reduce((sum, x) => sum + x, 0) / numbers.length
const quantile = (numbers, share) =>
  numbers.toSorted((a, b) => a - b)[Math.floor(share * (numbers.length - 1))]

for (const [name, surface] of Object.entries(surfaces))
  describe(`a ${name}`, () => {
    const { mesh, exact } = surfaceMesh(surface, 64, 32)
    const uvs = Array.from({ length: mesh.uvs.length / 2 }, (_, i) =>
      mesh.uvs.slice(2 * i, 2 * i + 2),
    )
    for (const [title, { warp, offset, skips }] of Object.entries(warps)) {
      if (skips === name) continue
      test(`${title}: normals within 0.01° with exact gradients, within 0.5° with computed ones`, () => {
        const expected = uvs.map(([u, v]) => movedNormal(surface, offset, u, v))
        const compiled = compileWarp(warp, { surfaceVariation: true })
        const errorsOf = (variation) =>
          errors(compiled.evaluate({ ...mesh, ...variation }).normals, expected)
        const withExact = Math.max(...errorsOf(exact))
        const computed = Math.max(...errorsOf(surfaceVariation(mesh)))
        assert.ok(withExact < 0.01, `${withExact}° off with exact gradients`)
        assert.ok(computed < 0.5, `${computed}° off with gradients computed from the triangles`)
        const zeros = Object.fromEntries(
          Object.entries(exact).map(([key, numbers]) => [key, numbers.map(() => 0)]),
        )
        const without = Math.max(...errorsOf(zeros))
        // An inflated sphere is a sphere, so its normals stay the same, and so do those of every parallel surface.
        if (title !== 'inflated') assert.ok(without > 1.5, `${without}° off without gradients`)
        const baked = errors(bakeWarp(mesh, compiled).normals, expected)
        assert.ok(Math.max(...baked) === computed, 'bakeWarp computes other gradients')
      })
    }
  })

test('tangents are transformed too', () => {
  const { mesh, exact } = surfaceMesh(surfaces.torus, 24, 12)
  const { warp, offset } = warps['bumps along the normal']
  const tangentAt = (u, v, move) => {
    const at = (u) => {
      const { position, normal } = surfaces.torus(u, v)
      return position.map((x, k) => x + move(position, normal)[k])
    }
    const [after, before] = [at(u + 1e-5), at(u - 1e-5)]
    const along = after.map((x, k) => x - before[k])
    return along.map((x) => x / Math.hypot(...along))
  }
  const uvs = Array.from({ length: mesh.uvs.length / 2 }, (_, i) =>
    mesh.uvs.slice(2 * i, 2 * i + 2),
  )
  const tangents = uvs.flatMap(([u, v]) => [...tangentAt(u, v, () => [0, 0, 0]), 1])
  const moved = compileWarp(warp, { surfaceVariation: true }).evaluate({
    ...mesh,
    ...exact,
    tangents,
  })
  uvs.forEach(([u, v], i) => {
    const actual = [...moved.tangents.slice(4 * i, 4 * i + 3)]
    const angle = angleBetween(actual, tangentAt(u, v, offset))
    assert.ok(angle < 0.01, `${angle}° off`)
  })
})

// The Stanford bunny from npm, smoothed by Loop subdivision. A mesh of 117,570 vertices represents the smooth bunny; the tested meshes use
// its first 7,350 and 29,394 vertices. The reference is the warped large mesh, with the normals of the triangles around each vertex. Where
// these triangles fold over, as in the creases of the neck, the warped surface has no useful normal.
describe('the bunny', () => {
  const { positions, indices } = models.bunny()
  let model = interpolatePoints({ points: triples(positions), triangles: triples(indices) })
  const levels = [model, ...[1, 2, 3].map(() => (model = loopSubdivide(model)))]
  const { points, triangles } = levels[3]
  const originalNormals = areaNormals(points, triangles)
  const normals = originalNormals.map(({ sum }) => unit(sum))

  const heights = {
    'wide bumps': { size: 0.8, frequency: 0.06 },
    'narrow bumps': { size: 0.5, frequency: 0.15 },
  }
  for (const [title, { size, frequency }] of Object.entries(heights)) {
    const height = ([x, y, z]) =>
      size * (3 + sin(frequency * x + 1) + sin(1.2 * frequency * y) + cos(0.9 * frequency * z))
    const warp = compileWarp(
      ({ position, normal }) => {
        const [x, y, z] = ['x', 'y', 'z'].map((axis) => position[axis]().mult(frequency))
        const sum = x.add(1).sin().add(y.mult(1.2).sin(), z.mult(0.9).cos(), 3)
        return normal.mult(sum.mult(size))
      },
      { surfaceVariation: true },
    )
    const moved = points.map((p, i) => p.map((x, k) => x + normals[i][k] * height(p)))
    const reference = areaNormals(moved, triangles).map(({ sum, area }, i) =>
      Math.hypot(...sum) < 0.9 * area || area < 0.2 * originalNormals[i].area ? null : unit(sum),
    )

    for (const level of [1, 2])
      test(`${title}, ${levels[level].points.length} vertices: at most a third of the error that omitting gradients causes`, () => {
        const count = levels[level].points.length
        const mesh = {
          positions: points.slice(0, count).flat(),
          normals: normals.slice(0, count).flat(),
          indices: levels[level].triangles.flat(),
        }
        const expected = reference.slice(0, count)
        assert.ok(expected.filter((normal) => !normal).length < 0.01 * count)
        const zeros = new Float32Array(3 * count)
        const zeroGradients = {
          normalXGradients: zeros,
          normalYGradients: zeros,
          normalZGradients: zeros,
        }
        const errorsWith = errors(
          warp.evaluate({ ...mesh, ...surfaceVariation(mesh) }).normals,
          expected,
        )
        const errorsWithout = errors(warp.evaluate({ ...mesh, ...zeroGradients }).normals, expected)
        const median = (list) => quantile(list, 0.5)
        // On the coarser mesh the worst places, ears and toes, are smaller than its triangles.
        const measures =
          level === 1 ? { median } : { mean, median, quantile95: (list) => quantile(list, 0.95) }
        for (const [name, measure] of Object.entries(measures)) {
          const [actual, bound] = [measure(errorsWith), measure(errorsWithout) / 3]
          assert.ok(actual <= bound, `${name}: ${actual}°, and ${3 * bound}° without gradients`)
        }
      })
  }
})

const bumpy = warps['bumps along the normal'].warp

describe('compileWarp', () => {
  const attributes = (warp, options = { surfaceVariation: true }) =>
    compileWarp(warp, options)
      .attributes.map(({ name }) => name)
      .filter((name) => /Gradient$/.test(name))

  test('reads only the gradients that the offset needs', () => {
    assert.deepEqual(
      attributes(({ glsl, position }) => glsl.vec3(position.x().sin(), 0, 0)),
      [],
    )
    assert.deepEqual(attributes(bumpy), ['normalXGradient', 'normalYGradient', 'normalZGradient'])
    assert.deepEqual(
      attributes(({ glsl, normal }) => glsl.vec3(0, normal.y().sin(), 0)),
      ['normalYGradient'],
    )
    assert.deepEqual(
      attributes(({ glsl, uv }) => glsl.vec3(uv.x(), 0, 0)),
      ['uGradient'],
    )
    assert.deepEqual(
      attributes(({ glsl, uv, normal }) => glsl.vec3(uv.y(), normal.x().floor(), 0)),
      ['vGradient'],
    )
    assert.deepEqual(attributes(bumpy, { surfaceVariation: false }), [])
    assert.deepEqual(attributes(bumpy, { surfaceVariation: true, normals: false }), [])
  })

  test('reads the gradients by custom names in every language', () => {
    const names = { normalXGradient: 'aByX', normalZGradient: 'vertex.byZ' }
    for (const target of ['glsl300', 'glsl100', 'wgsl']) {
      const { code } = compileWarp(bumpy, { target, names, surfaceVariation: true })
      assert.match(code, /aByX\.x/)
      assert.match(code, /vertex\.byZ\.z/)
    }
  })

  test('generates no gradient code without the option', () => {
    const { code } = compileWarp(bumpy, { surfaceVariation: false })
    assert.doesNotMatch(code, /Gradient|_warpjet/)
  })

  test('rejects values that are not booleans', () => {
    assert.throws(
      () => compileWarp(bumpy, { surfaceVariation: 'yes' }),
      new WarpError(
        'compileWarp: expected true or false for the option "surfaceVariation", got the text "yes".',
      ),
    )
  })
})

/** Runs a program; returns the lines that it prints on console.error. */
function linesPrintedBy(code) {
  const script = `
    import { compileWarp } from 'warpjet'
    import { bakeWarp, subdivide, surfaceVariation } from 'warpjet/mesh'
    import { warp as warpObject } from 'warpjet/three'
    import { Mesh, MeshStandardMaterial, PlaneGeometry } from 'three'
    const plane = () => new Mesh(new PlaneGeometry(), new MeshStandardMaterial())
    const bumpy = ({ normal, position }) => normal.mult(position.x())
    const plain = ({ glsl, position }) => glsl.vec3(0, position.x(), 0)
    const mesh = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], normals: [0, 0, 1, 0, 0, 1, 0, 0, 1] }
    ${code}`
  const { stderr } = spawnSync(process.execPath, ['--input-type=module', '-e', script], {
    encoding: 'utf8',
  })
  return stderr.trim().split('\n').filter(Boolean)
}

describe('a warning that normals are approximate', () => {
  test('is printed once, if the option is missing', () => {
    const lines = linesPrintedBy('for (let i = 0; i < 3; i++) compileWarp(bumpy).evaluate(mesh)')
    assert.equal(lines.length, 1)
    assert.match(
      lines[0],
      /^compileWarp: the offset depends on normal or uv.*; its option surfaceVariation makes them exact/,
    )
  })

  test('is printed by evaluate, if arrays that the option promised are missing', () => {
    const lines = linesPrintedBy('compileWarp(bumpy, { surfaceVariation: true }).evaluate(mesh)')
    assert.equal(lines.length, 1)
    assert.match(lines[0], /^evaluate: .* warpjet\/mesh/)
  })

  test('is printed once for objects of three.js', () => {
    const lines = linesPrintedBy('for (let i = 0; i < 3; i++) warpObject(plane(), bumpy)')
    assert.equal(lines.length, 1)
    assert.match(lines[0], /^warp: .*; await addSurfaceVariation\(geometry\) makes them exact/)
  })

  test('is not printed if normals are exact, omitted, or approximate by choice', () => {
    const lines = linesPrintedBy(`
      warpObject(plane(), plain)
      warpObject(plane(), bumpy, { surfaceVariation: false })
      compileWarp(plain).evaluate(mesh)
      compileWarp(bumpy, { normals: false }).evaluate(mesh)
      compileWarp(bumpy, { surfaceVariation: false }).evaluate(mesh)
      const warp = compileWarp(bumpy, { surfaceVariation: true })
      warp.evaluate({ ...mesh, ...surfaceVariation(mesh) })
      warp.bounds({ min: [0, 0, 0], max: [1, 1, 1] })
      bakeWarp(mesh, warp)
      subdivide(mesh, { warp, tolerance: 0.1 })`)
    assert.deepEqual(lines, [])
  })
})

describe('on the CPU', () => {
  const warp = compileWarp(({ normal }) => normal.mult(-0.5), { surfaceVariation: true })
  const variation = { normalYGradient: [0, 1, 0], normalZGradient: [0, 0, 2.5] }

  test('evaluateAt accepts gradients too', () => {
    const bent = compileWarp(({ normal, position }) => normal.mult(position.y()), {
      surfaceVariation: true,
    })
    // For y = 0.5, the Jacobian matrix is I + n (0, 1, 0)ᵀ + 0.5 W, where the rows of W are the gradients of the normal n. Its cofactor
    // matrix transforms n = (1, 0, 0) to (1.5 * 2.25, -2.25, 0).
    const { normal } = bent.evaluateAt([0, 0.5, 0], { normal: [1, 0, 0], ...variation })
    const length = Math.hypot(1.5, 1)
    ;[1.5 / length, -1 / length, 0].forEach((x, i) => assert.ok(Math.abs(normal[i] - x) < 1e-6))
    assert.throws(
      () => bent.evaluateAt([0, 0, 0], { normal: [1, 0, 0], uGradient: [1, 2] }),
      /^WarpError: evaluateAt: expected an array of 3 finite numbers for the uGradient/,
    )
  })

  test('foldover reports where the surface is turned inside out', () => {
    // The warp moves vertices inwards by 0.5: past a centre of curvature at the distance 1/2.5, but not past those at 1 and 1/1.5.
    const mesh = { positions: [0, 0, 0, 0, 0, 0], normals: [1, 0, 0, 1, 0, 0] }
    const normalYGradients = [0, 1, 0, 0, 1, 0]
    const normalZGradients = [0, 0, 2.5, 0, 0, 1.5]
    const { mask } = warp.foldover({ ...mesh, normalYGradients, normalZGradients })
    assert.deepEqual([...mask], [1, 0])
  })
})

describe('meshes', () => {
  const { mesh } = surfaceMesh(surfaces.torus, 16, 8)
  const warp = compileWarp(bumpy, { surfaceVariation: true })

  test('surfaceVariation returns gradients if there are uvs, and leaves the mesh unchanged', () => {
    const before = structuredClone(mesh)
    const names = [
      'normalXGradients',
      'normalYGradients',
      'normalZGradients',
      'uGradients',
      'vGradients',
    ]
    assert.deepEqual(Object.keys(surfaceVariation(mesh)), names)
    assert.deepEqual(Object.keys(surfaceVariation({ ...mesh, uvs: undefined })), names.slice(0, 3))
    assert.deepEqual(mesh, before)
    for (const numbers of Object.values(surfaceVariation(mesh)))
      assert.equal(numbers.length, mesh.positions.length)
    assert.throws(
      () => surfaceVariation({ positions: [1, 2] }),
      /^WarpError: surfaceVariation: positions/,
    )
  })

  test('a coarse mesh, subdivided and baked, has normals within 0.5°', () => {
    const fine = subdivide(mesh, { warp, tolerance: 0.002 })
    assert.deepEqual(Object.keys(fine), ['positions', 'normals', 'uvs', 'indices'])
    const { normals } = bakeWarp(fine, warp)
    const { offset } = warps['bumps along the normal']
    const originalCount = mesh.uvs.length / 2
    for (let i = 0; i < originalCount; i++) {
      const expected = movedNormal(surfaces.torus, offset, mesh.uvs[2 * i], mesh.uvs[2 * i + 1])
      const angle = angleBetween([...normals.slice(3 * i, 3 * i + 3)], expected)
      assert.ok(angle < 0.5, `${angle}° off at vertex ${i}`)
    }
  })
})

function unit(v) {
  return v.map((x) => x / Math.hypot(...v))
}

/** Returns, for each vertex, the sum of the area vectors of its triangles, and the sum of the lengths of these vectors. */
function areaNormals(points, triangles) {
  const sums = points.map(() => ({ sum: [0, 0, 0], area: 0 }))
  for (const corners of triangles) {
    const [p, q, r] = corners.map((i) => points[i])
    const [a, b] = [q, r].map((end) => end.map((x, k) => x - p[k]))
    const areaVector = [
      a[1] * b[2] - a[2] * b[1],
      a[2] * b[0] - a[0] * b[2],
      a[0] * b[1] - a[1] * b[0],
    ]
    const area = Math.hypot(...areaVector)
    for (const i of corners) {
      sums[i].area += area
      for (let k = 0; k < 3; k++) sums[i].sum[k] += areaVector[k]
    }
  }
  return sums
}
