// Warps that mirror space: the outer side of a closed surface stays outside. The test is purely geometric: the signed volume of a closed
// mesh has the sign of the winding of its triangles, and each vertex normal must point to their front side.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { compile, compileWarp } from 'warpjet'
import { chain, inflate, stretch, twist } from 'warpjet/deformers'
import { glslOffset } from 'warpjet/glsl'
import { bakeWarp, exportGLB, loadMesh, subdivide } from 'warpjet/mesh'
import { warp as warpObject } from 'warpjet/three'
import { sphere } from '../support/meshes.js'

const vec = (numbers, i) => [...numbers.slice(3 * i, 3 * i + 3)]
const minus = (a, b) => a.map((x, i) => x - b[i])
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

function* trianglesOf({ positions, indices }) {
  for (let i = 0; i < (indices ?? positions).length / (indices ? 1 : 3); i += 3)
    yield [0, 1, 2].map((k) => (indices ? indices[i + k] : i + k))
}

/** The signed volume of a closed mesh: above 0 if the front sides are outside. */
function volumeOf(mesh) {
  let volume = 0
  for (const corners of trianglesOf(mesh)) {
    const [a, b, c] = corners.map((i) => vec(mesh.positions, i))
    volume += dot(a, cross(b, c)) / 6
  }
  return volume
}

/** The minimum cosine of the angle between a vertex normal and the front of a triangle around it. */
function minCosine(mesh) {
  let least = 1
  for (const corners of trianglesOf(mesh)) {
    const [a, b, c] = corners.map((i) => vec(mesh.positions, i))
    const front = cross(minus(b, a), minus(c, a))
    const size = Math.hypot(...front)
    if (size < 1e-9) continue
    for (const i of corners) least = Math.min(least, dot(front, vec(mesh.normals, i)) / size)
  }
  return least
}

/** A fine mesh with its front outside. */
const round = (() => {
  const mesh = sphere(48, 32)
  const indices = mesh.indices.slice()
  if (volumeOf(mesh) < 0)
    for (let i = 0; i < indices.length; i += 3)
      [indices[i + 1], indices[i + 2]] = [indices[i + 2], indices[i + 1]]
  return { ...mesh, indices }
})()

function isOutside(mesh, message) {
  const [volume, cosine] = [volumeOf(mesh), minCosine(mesh)]
  assert.ok(volume > 0.5, `${message}: the triangles enclose ${volume}`)
  assert.ok(cosine > 0.5, `${message}: a normal is off by the cosine ${cosine}`)
}

const mirror = ({ glsl, position }) => glsl.vec3(position.x().mult(-2), 0, 0)

/** Makes an offset function from a function that returns the new position. */
const to = (place) => (inputs) => place(inputs).sub(inputs.position)

const byUniform = to(({ glsl, position, uniforms }) =>
  glsl.vec3(position.x().mult(uniforms.scale), position.y(), position.z()),
)

const mirrors = {
  'a mirror': mirror,
  'a point reflection': ({ position }) => position.mult(-2),
  'two axes changed for each other': to(({ glsl, position }) =>
    glsl.vec3(position.y(), position.x(), position.z()),
  ),
  'a mirror with a scale that grows to the side': to(({ glsl, position: p }) =>
    glsl.vec3(p.x().mult(p.y().mult(p.y()).add(1)).neg(), p.y(), p.z()),
  ),
  'a mirror with a wave': to(({ glsl, position: p }) =>
    glsl.vec3(p.x().neg(), p.y().add(p.x().mult(2).sin().mult(0.2)), p.z()),
  ),
  'a mirror with varying thickness': to(({ glsl, position: p }) =>
    glsl.vec3(p.x().mult(p.z().mult(3).sin().mult(0.4).sub(1)), p.y(), p.z()),
  ),
  'a twisted mirror': chain(mirror, twist({ angle: 0.8, length: 1 })),
  'a twist, mirrored': chain(twist({ angle: 0.8, length: 1 }), mirror),
  'an inflated mirror': chain(mirror, inflate({ amount: 0.2 })),
  'a mirror twisted about an oblique axis': chain(
    mirror,
    twist({ angle: 0.8, length: 1, axis: [0.3, 1, -0.2] }),
  ),
  'a rotated mirror': chain(mirror, ({ glsl, position }) =>
    glsl
      .rotate(glsl.vec3(1, 2, 0.5), 0.7)
      .mult(position)
      .sub(position),
  ),
  'a mirror in GLSL source': glslOffset(
    'vec3 offset(vec3 position) { return vec3(-2.0 * position.x, 0.0, 0.0); }',
  ),
}

describe('the outer side stays outside', () => {
  for (const [name, offset] of Object.entries(mirrors))
    test(name, () => {
      isOutside(round, 'before')
      for (const perFrame of [false, true])
        isOutside(bakeWarp(round, compileWarp(offset, { perFrame })), name)
    })

  test('the normal at (1, 0, 0) of a sphere is (-1, 0, 0)', () => {
    const { normal, position } = compileWarp(mirror).evaluateAt([1, 0, 0], { normal: [1, 0, 0] })
    assert.deepEqual(
      [position, normal.map((x) => x + 0)],
      [
        [-1, 0, 0],
        [-1, 0, 0],
      ],
    )
  })

  test('a warp that does not mirror leaves triangles unchanged, and so does one that folds', () => {
    for (const offset of [
      twist({ angle: 0.8, length: 1 }),
      ({ glsl, position }) => glsl.vec3(position.x().mult(-2), position.y().mult(-2), 0),
      ({ glsl, position }) => glsl.vec3(position.x().mult(position.x()).mult(-1.5), 0, 0),
      ({ glsl, position }) => glsl.vec3(position.x().neg(), 0, 0),
    ])
      assert.deepEqual(bakeWarp(round, compileWarp(offset)).indices, round.indices)
  })

  test('normals are continuous at a fold', () => {
    // The derivative of x - x² changes its sign at 0.5; the surface y = 0 flips there, and so does the paper's normal.
    const fold = compileWarp(({ glsl, position }) =>
      glsl.vec3(position.x().mult(position.x()).neg(), position.x(), 0),
    )
    const at = (x) => fold.evaluateAt([x, 0, 0], { normal: [0, 1, 0] }).normal
    for (const x of [0.3, 0.499, 0.501, 0.7]) {
      const size = Math.hypot(1, 1 - 2 * x)
      const expected = [-1 / size, (1 - 2 * x) / size, 0]
      at(x).forEach((number, i) => assert.ok(Math.abs(number - expected[i]) < 1e-6, `${x}`))
    }
  })
})

describe('uniforms decide whether a warp mirrors', () => {
  const uniforms = { scale: 1 }
  const ofSize = {
    'a width': byUniform,
    'a size': to(({ position, uniforms }) => position.mult(uniforms.scale)),
    'a width, twisted': chain(byUniform, twist({ angle: 0.8, length: 1 })),
    'a twist, then a width': chain(twist({ angle: 0.8, length: 1 }), byUniform),
    'a width of something thicker here than there': to(({ glsl, position: p, uniforms }) =>
      glsl.vec3(p.x().mult(p.y().mult(p.y()).add(1)).mult(uniforms.scale), p.y(), p.z()),
    ),
    'a change that depends on a uniform': ({ glsl, position: p, uniforms }) =>
      glsl.vec3(p.x().mult(uniforms.scale.sub(1)), 0, 0),
    'a mirror of uniform width': to(({ glsl, position: p, uniforms }) =>
      glsl.vec3(p.x().mult(uniforms.scale.neg()), p.y().neg(), p.z()),
    ),
  }
  for (const [name, offset] of Object.entries(ofSize))
    for (const perFrame of [false, true])
      test(`${name}${perFrame ? ', once a frame' : ''}`, () => {
        const warp = compileWarp(offset, { uniforms, perFrame })
        for (const size of [1, 0.8, -0.8, -1, -1.5])
          isOutside(bakeWarp(round, warp, { uniforms: { scale: size } }), `${size}`)
        // The current value of the option applies.
        isOutside(bakeWarp(round, warp), 'as declared')
      })

  test('the time can decide it, too', () => {
    const warp = compileWarp(
      to(({ glsl, position: p, millis }) =>
        glsl.vec3(p.x().mult(millis.div(1000).cos()), p.y(), p.z()),
      ),
      { perFrame: true },
    )
    for (const millis of [0, 500, 2700, 3100, 6283])
      isOutside(bakeWarp(round, warp, { uniforms: { millis } }), `${millis}`)
  })

  test('the deformer stretch mirrors if it is pulled through itself', () => {
    const warp = compileWarp(stretch({ amount: ({ uniforms }) => uniforms.by }), {
      uniforms: { by: 0 },
    })
    for (const by of [0.5, -0.5, -2])
      isOutside(bakeWarp(round, warp, { uniforms: { by } }), `${by}`)
  })

  test('normals of a collapsed surface are zero', () => {
    const warp = compileWarp(byUniform, { uniforms })
    const at = (normal) => warp.evaluateAt([0.6, 0.8, 0], { normal, uniforms: { scale: 0 } }).normal
    assert.deepEqual(at([0, 1, 0]), [0, 0, 0])
    assert.deepEqual(at([0.6, 0.8, 0]), [1, 0, 0])
  })

  test('the code has one sign factor, which is a frame constant', () => {
    const warp = compileWarp(byUniform, { uniforms, perFrame: true })
    const { warpjetFrame0 } = warp.frameUniforms({ scale: -3 })
    assert.ok(warpjetFrame0.includes(-1), `${warpjetFrame0}`)
    assert.ok(warp.frameUniforms({ scale: 3 }).warpjetFrame0.includes(1))
    for (const target of ['glsl300', 'glsl100', 'wgsl']) {
      const { code } = compileWarp(byUniform, { uniforms, target })
      assert.match(code, /scale < 0\.0/)
    }
  })

  test('the code of a warp that cannot mirror has no sign factor', () => {
    for (const offset of [
      to(({ glsl, position: p, uniforms }) =>
        glsl.vec3(p.x().mult(uniforms.scale.exp()), p.y(), p.z()),
      ),
      to(({ glsl, position, uniforms }) => glsl.rotateY(uniforms.scale).mult(position)),
      to(({ glsl, position, uniforms }) =>
        glsl.rotate(glsl.vec3(0.6, 0, 0.8), uniforms.scale).mult(position),
      ),
      twist({ angle: ({ uniforms }) => uniforms.scale, length: 1, axis: [0.6, 0, 0.8] }),
      to(({ glsl, position: p, uniforms }) =>
        glsl.vec3(p.x().mult(uniforms.scale), p.y().mult(uniforms.scale), p.z()),
      ),
    ])
      assert.doesNotMatch(compileWarp(offset, { uniforms }).code, /-1\.0 : 1\.0/)
  })
})

test('adjustNormal and its building blocks return normals on the outer side', () => {
  const { evaluate } = compile((glsl) => {
    const position = glsl.vec3Param('position')
    const of = (factor) =>
      glsl.vec3(position.x().mult(factor), 0, 0).adjustNormal(glsl.vec3Param('normal'), position)
    return { known: of(-2), byUniform: of(glsl.param('by')) }
  })
  const at = (by) => evaluate({ position: [1, 0, 0], normal: [1, 0, 0], by })
  assert.deepEqual(
    at(-3).known.map((x) => x + 0),
    [-1, 0, 0],
  )
  assert.deepEqual(
    at(-3).byUniform.map((x) => x + 0),
    [-1, 0, 0],
  )
  assert.deepEqual(
    at(3).byUniform.map((x) => x + 0),
    [1, 0, 0],
  )
})

describe('offsets that depend on the normal and on uv', () => {
  const grown = ({ glsl, position, normal, uv }) =>
    glsl.vec3(position.x().mult(-2), 0, 0).add(
      normal.mult(
        uv
          .x()
          .mult(2 * Math.PI)
          .sin()
          .mult(0.1)
          .add(0.05),
      ),
    )

  for (const surfaceVariation of [true, false])
    test(`a mirror inflated along the normal is right${surfaceVariation ? ', with surface variation' : ''}`, () => {
      const warp = compileWarp(grown, { surfaceVariation })
      const baked = bakeWarp(round, warp)
      isOutside(baked, 'baked')
    })
})

test('the bitangent points where texture coordinates increase, also in a mirror', () => {
  const warp = compileWarp(
    to(({ glsl, position: p }) => glsl.vec3(p.x().neg(), p.y().add(p.x().sin().mult(0.3)), p.z())),
  )
  // On the plane z = 0, (t, b, n) is (x, y, z).
  const mesh = { positions: [0.4, 0.2, 0], normals: [0, 0, 1], tangents: [1, 0, 0, 1] }
  const { normals, tangents } = warp.evaluate(mesh)
  const [t, n] = [[...tangents.slice(0, 3)], [...normals]]
  const b = cross(n, t).map((x) => x * tangents[3])
  assert.deepEqual(
    n.map((x) => Math.round(x) + 0),
    [0, 0, 1],
  )
  // M b is (0, 1, 0).
  assert.ok(b[1] > 0.9, `${b}`)
  const flipped = warp.evaluate({ ...mesh, tangents: [1, 0, 0, -1] })
  assert.equal(flipped.tangents[3], -tangents[3])
})

describe('bakes', () => {
  const warp = compileWarp(mirror)

  test('without indices: vertices keep their order, and indices reverse the triangles', () => {
    const flat = (numbers, size) =>
      Float32Array.from(round.indices).reduce(
        (all, i, at) => (all.set(numbers.subarray(size * i, size * i + size), size * at), all),
        new Float32Array(size * round.indices.length),
      )
    const soup = { positions: flat(round.positions, 3), normals: flat(round.normals, 3) }
    const baked = bakeWarp(soup, warp)
    isOutside(baked, 'soup')
    assert.equal(baked.positions.length, soup.positions.length)
    soup.positions.forEach((x, i) => assert.ok(baked.positions[i] === (i % 3 ? x : -x)))
    assert.deepEqual([...baked.indices.slice(0, 6)], [0, 2, 1, 3, 5, 4])
    assert.equal(bakeWarp(soup, compileWarp(twist({ angle: 1, length: 1 }))).indices, undefined)
  })

  test('an empty mesh stays empty', () => {
    const baked = bakeWarp({ positions: [] }, warp)
    assert.equal(baked.positions.length, 0)
  })

  test('missing normals are computed first', () => {
    const { positions, indices } = round
    isOutside(bakeWarp({ positions, indices }, warp), 'computed')
  })

  test('and the result survives export and loading', async () => {
    const mesh = await loadMesh(exportGLB(bakeWarp(round, warp)))
    isOutside(mesh, 'from the file')
  })

  test('and subdivides for the warp', () => {
    const finer = subdivide(round, { warp, tolerance: 0.002 })
    assert.ok(volumeOf(finer) > 0, 'the mesh before the warp')
    isOutside(bakeWarp(finer, warp), 'subdivided')
  })

  test('three.js geometries with groups and morph targets, indexed and not indexed', () => {
    for (const geometry of [
      new THREE.BoxGeometry(1, 1, 1, 8, 8, 8),
      new THREE.BoxGeometry(1, 1, 1, 8, 8, 8).toNonIndexed(),
    ]) {
      geometry.morphAttributes.position = [geometry.attributes.position.clone()]
      const baked = bakeWarp(geometry, warp)
      assert.deepEqual(baked.groups, geometry.groups)
      const mesh = {
        positions: baked.attributes.position.array,
        normals: baked.attributes.normal.array,
        indices: baked.index.array,
      }
      isOutside(mesh, geometry.index ? 'indexed' : 'not indexed')
      const untouched = bakeWarp(geometry, compileWarp(twist({ angle: 1, length: 1 })))
      assert.deepEqual(untouched.index, geometry.index)
    }
  })

  test('an object with its own evaluate without reversing its triangles', () => {
    const byHand = { evaluate: ({ positions, normals }) => ({ positions, normals }) }
    assert.deepEqual(bakeWarp(round, byHand).indices, round.indices)
  })
})

describe('rays of three.js', () => {
  const offsets = { 'a mirror': [mirror, {}], 'by a uniform': [byUniform, { scale: -1 }] }
  const sides = {
    FrontSide: THREE.FrontSide,
    BackSide: THREE.BackSide,
    DoubleSide: THREE.DoubleSide,
  }

  /** A mesh that differs from its mirror image, and one that three.js mirrors by its matrix. */
  function pair(side) {
    const geometry = new THREE.ConeGeometry(0.7, 1.4, 24, 6).rotateZ(0.6).translate(0.3, 0, 0)
    const [mesh, other] = [0, 1].map(
      () => new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side })),
    )
    other.scale.x = -1
    for (const each of [mesh, other]) each.updateMatrixWorld(true)
    return [mesh, other]
  }

  const rays = Array.from({ length: 40 }, (_, i) => {
    const from = new THREE.Vector3(3 * Math.cos(i), 2 * Math.sin(3 * i), 3 * Math.sin(i))
    const target = new THREE.Vector3(-0.3 + 0.3 * Math.sin(5 * i), 0.4 * Math.cos(7 * i), 0)
    return new THREE.Raycaster(from, target.sub(from).normalize())
  })

  for (const [name, [offset, uniforms]] of Object.entries(offsets))
    for (const space of ['local', 'rest', 'world'])
      for (const [sideName, side] of Object.entries(sides))
        test(`${name}, ${space}, ${sideName}`, () => {
          const [mesh, other] = pair(side)
          const warped = warpObject(mesh, offset, { space, uniforms })
          let count = 0
          for (const ray of rays) {
            const [hits, expected] = [ray.intersectObject(mesh), ray.intersectObject(other)]
            assert.equal(hits.length, expected.length)
            hits.forEach(({ point, face, normal, faceIndex }, i) => {
              count++
              assert.equal(faceIndex, expected[i].faceIndex)
              assert.ok(point.distanceTo(expected[i].point) < 1e-5)
              // Local points of the other mesh, before its matrix is applied.
              const mirrored = (v) => v.clone().set(-v.x, v.y, v.z)
              assert.ok(face.normal.distanceTo(mirrored(expected[i].face.normal)) < 1e-4)
              assert.ok(normal.normalize().angleTo(mirrored(expected[i].normal)) < 1e-3)
            })
          }
          assert.ok(count > 20, `${count} hits`)
          warped.dispose()
        })

  test('in world space, rays hit an object that its matrix mirrors', () => {
    const [mesh, other] = pair(THREE.FrontSide)
    const [, still] = pair(THREE.FrontSide)
    other.scale.x = 1
    other.updateMatrixWorld(true)
    mesh.scale.x = -1
    mesh.updateMatrixWorld(true)
    for (const [offset, expected] of [
      [mirror, other],
      [({ glsl }) => glsl.vec3(0, 0, 0), still],
    ]) {
      const warped = warpObject(mesh, offset, { space: 'world' })
      for (const ray of rays) {
        const [hits, others] = [ray.intersectObject(mesh), ray.intersectObject(expected)]
        assert.deepEqual(
          hits.map(({ faceIndex }) => faceIndex),
          others.map(({ faceIndex }) => faceIndex),
        )
      }
      warped.dispose()
    }
  })
})

test('an image read at the same point for all vertices does not decide the side, since the CPU cannot read it', () => {
  const offset = ({ glsl, position, uniforms }) =>
    position.mult(glsl.texture(uniforms.map, glsl.vec2(0.5, 0.5)).x())
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 8, 6), new THREE.MeshBasicMaterial())
  const texture = new THREE.DataTexture(new Uint8Array([255, 0, 0, 255]), 1, 1)
  assert.doesNotThrow(() => warpObject(mesh, offset, { uniforms: { map: texture } }))
})
