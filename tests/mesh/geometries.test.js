// Tests 'warpjet/mesh' with geometries of three.js: the results are geometries too, with all their attributes.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { compileWarp } from 'warpjet'
import { bakeWarp, exportGLB, loadMesh, subdivide, surfaceVariation } from 'warpjet/mesh'

const up = compileWarp(({ glsl }) => glsl.vec3(0, 0, 1))

const valuesAt = (attribute, i) =>
  Array.from({ length: attribute.itemSize }, (_, k) => attribute.getComponent(i, k))

/** Maps each position → the value of the attribute `name` there. */
function mapByPosition({ attributes }, name) {
  const byPosition = new Map()
  for (let i = 0; i < attributes.position.count; i++)
    byPosition.set(valuesAt(attributes.position, i).join(), valuesAt(attributes[name], i))
  return byPosition
}

/** Makes a square of two triangles with all members that a geometry may have; each attribute is linear in x and y. */
function square() {
  const geometry = new THREE.PlaneGeometry(2, 2)
  const set = (name, Class, size, evaluate, normalized) => {
    const numbers = [0, 1, 2, 3].flatMap((i) =>
      evaluate(...valuesAt(geometry.attributes.position, i)),
    )
    geometry.setAttribute(name, new Class(numbers, size, normalized))
  }
  set('heat', THREE.Float32BufferAttribute, 1, (x, y) => [3 * x + y])
  set('uv1', THREE.Float32BufferAttribute, 2, (x, y) => [x, 5 * y])
  set('color', THREE.Uint8BufferAttribute, 3, (x, y) => [100 + 50 * x, 100 + 50 * y, 7], true)
  set('kind', THREE.Uint16BufferAttribute, 1, (x) => [x > 0 ? 9 : 4])
  const shared = new THREE.InterleavedBuffer(new Float32Array([1, 2, 3, 4, 5, 6, 7, 8]), 2)
  geometry.setAttribute('second', new THREE.InterleavedBufferAttribute(shared, 1, 1))
  const target = geometry.attributes.position.clone()
  for (let i = 0; i < 4; i++) target.setZ(i, target.getX(i))
  geometry.morphAttributes.position = [target]
  geometry.addGroup(0, 3, 1)
  geometry.addGroup(3, 3, 0)
  geometry.userData.name = 'mine'
  return geometry
}

describe('subdivide', () => {
  const original = square()
  const before = JSON.stringify(original.toJSON())
  const finer = subdivide(original, { levels: 2 })

  test('returns a BufferGeometry with 16 times the triangles, and leaves the original unchanged', () => {
    assert.equal(finer.constructor, THREE.BufferGeometry)
    assert.equal(finer.index.count, 2 * 16 * 3)
    assert.equal(finer.attributes.position.count, 25)
    assert.equal(finer.userData.name, 'mine')
    assert.equal(JSON.stringify(original.toJSON()), before)
  })

  test('interpolates each attribute, and keeps its type', () => {
    for (let i = 0; i < 25; i++) {
      const [x, y] = valuesAt(finer.attributes.position, i)
      assert.deepEqual(valuesAt(finer.attributes.heat, i), [3 * x + y])
      assert.deepEqual(valuesAt(finer.attributes.uv1, i), [x, 5 * y])
      assert.deepEqual(valuesAt(finer.attributes.uv, i), [(x + 1) / 2, (y + 1) / 2])
      const [red, , blue] = valuesAt(finer.attributes.color, i)
      assert.ok(Math.abs(255 * red - (100 + 50 * x)) <= 1 && Math.abs(255 * blue - 7) < 1e-6)
      assert.ok([4, 9].includes(valuesAt(finer.attributes.kind, i)[0]))
      assert.equal(valuesAt(finer.morphAttributes.position[0], i)[2], x)
    }
    assert.ok(
      finer.attributes.color.array instanceof Uint8Array && finer.attributes.color.normalized,
    )
    // Reads only the attribute's own part of the shared array.
    assert.deepEqual(
      [0, 1, 2, 3].map((i) => finer.attributes.second.getX(i)),
      [2, 4, 6, 8],
    )
    assert.deepEqual(mapByPosition(finer, 'second').get('0,0,0'), [5])
  })

  test('groups contain the parts of their triangles', () => {
    assert.deepEqual(finer.groups, [
      { start: 0, count: 48, materialIndex: 1 },
      { start: 48, count: 48, materialIndex: 0 },
    ])
    // The diagonal between the two triangles is x = y.
    for (let i = 0; i < finer.index.count; i++) {
      const [x, y] = valuesAt(finer.attributes.position, finer.index.getX(i))
      assert.ok(i < 48 ? x <= y : x >= y)
    }
  })

  test('a new vertex between vertices with different bones is moved by both bones', () => {
    const strip = new THREE.PlaneGeometry(1, 1)
    strip.setAttribute(
      'skinIndex',
      new THREE.Uint16BufferAttribute([7, 0, 0, 0, 2, 0, 0, 0, 7, 0, 0, 0, 2, 3, 0, 0], 4),
    )
    strip.setAttribute(
      'skinWeight',
      new THREE.Float32BufferAttribute([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0], 4),
    )
    const { attributes } = subdivide(strip, { levels: 1 })
    const weights = (x, y) => {
      for (let i = 0; i < attributes.position.count; i++)
        if (valuesAt(attributes.position, i).join() === [x, y, 0].join())
          return Object.fromEntries(
            valuesAt(attributes.skinWeight, i).flatMap((w, k) =>
              w ? [[valuesAt(attributes.skinIndex, i)[k], w]] : [],
            ),
          )
    }
    assert.deepEqual(weights(0, 0.5), { 7: 0.5, 2: 0.5 })
    assert.deepEqual(weights(-0.5, 0), { 7: 1 })
    assert.deepEqual(weights(0.5, 0), { 2: 0.75, 3: 0.25 })
    assert.deepEqual(weights(0, -0.5), { 7: 0.5, 2: 0.25, 3: 0.25 })
  })

  test('splits triangles only where the warp bends them', () => {
    const bump = compileWarp(({ glsl, position }) =>
      glsl.vec3(0, 0, position.dot(position).mult(-20).exp()),
    )
    const split = subdivide(square(), { warp: bump, tolerance: 0.01 })
    assert.ok(split.index.count > 300)
    for (let i = 0; i < split.attributes.position.count; i++) {
      const [x, y] = valuesAt(split.attributes.position, i)
      assert.ok(Math.abs(valuesAt(split.attributes.heat, i)[0] - (3 * x + y)) < 1e-5)
    }
    const full = subdivide(square(), { warp: bump, tolerance: 1e-6, maxTriangles: 100 })
    assert.match(full.userData.warnings[0], /maxTriangles/)
  })
})

describe('bakeWarp', () => {
  test('moves the vertices of a geometry, and keeps everything else', () => {
    const original = square()
    original.computeBoundingSphere()
    const baked = bakeWarp(original, up)
    assert.equal(baked.constructor, THREE.BufferGeometry)
    assert.equal(baked.boundingSphere, null)
    for (let i = 0; i < 4; i++) {
      const [x, y, z] = valuesAt(original.attributes.position, i)
      assert.deepEqual(valuesAt(baked.attributes.position, i), [x, y, z + 1])
      for (const name of ['uv', 'uv1', 'heat', 'color', 'kind', 'second'])
        assert.deepEqual(
          valuesAt(baked.attributes[name], i),
          valuesAt(original.attributes[name], i),
          name,
        )
    }
    assert.deepEqual(baked.groups, original.groups)
    assert.equal(original.attributes.position.getZ(0), 0)
    assert.equal(baked.toJSON().type, 'BufferGeometry')
  })

  for (const relative of [true, false])
    for (const withNormals of [true, false])
      test(`warps morph targets, ${relative ? 'relative' : 'absolute'}, ${withNormals ? 'with' : 'without'} normals`, () => {
        const original = morphingSphere(relative, withNormals)
        const before = JSON.stringify(original.toJSON())
        const baked = bakeWarp(original, waves)
        assert.equal(JSON.stringify(original.toJSON()), before)
        assert.equal(baked.morphTargetsRelative, relative)
        assert.equal(baked.morphAttributes.position[1].name, 'second')
        const originalMesh = new THREE.Mesh(original)
        const bakedMesh = new THREE.Mesh(baked)
        for (const influences of [
          [0, 0],
          [1, 0],
          [0, 1],
        ]) {
          originalMesh.morphTargetInfluences = bakedMesh.morphTargetInfluences = influences
          for (let i = 0; i < original.attributes.position.count; i++) {
            const at = originalMesh.getVertexPosition(i, new THREE.Vector3())
            const expected = at.clone().add(new THREE.Vector3(0, 0, height(at.x, at.y)))
            const place = bakedMesh.getVertexPosition(i, new THREE.Vector3())
            assert.ok(place.distanceTo(expected) < 1e-6, `${influences}: vertex ${i}`)
            const normal = transformNormal(normalOf(originalMesh, i), at)
            assert.ok(
              normalOf(bakedMesh, i).distanceTo(normal) < 1e-5,
              `${influences}: normal ${i}`,
            )
          }
        }
      })

  test('rejects a geometry without positions', () => {
    assert.throws(() => bakeWarp(new THREE.BufferGeometry(), up), {
      name: 'WarpError',
      message: 'bakeWarp: the geometry has no attribute "position".',
    })
  })
})

const waves = compileWarp(({ glsl, position }) =>
  glsl.vec3(0, 0, position.x().mult(2).sin().add(position.y().mult(3).cos()).mult(0.2)),
)
const height = (x, y) => 0.2 * (Math.sin(2 * x) + Math.cos(3 * y))

/** Transforms a normal with the inverse transpose of the Jacobian of `waves`; `dx` and `dy` are the slopes of `height`. */
function transformNormal(normal, { x, y }) {
  const [dx, dy] = [0.4 * Math.cos(2 * x), -0.6 * Math.sin(3 * y)]
  const matrix = new THREE.Matrix3().set(1, 0, 0, 0, 1, 0, dx, dy, 1).invert().transpose()
  return normal.applyMatrix3(matrix).normalize()
}

/** Returns the normal of a vertex under morph targets, which are added up as in the shaders of three.js. */
function normalOf({ geometry, morphTargetInfluences: influences }, i) {
  const { attributes, morphAttributes, morphTargetsRelative } = geometry
  const total = influences.reduce((sum, influence) => sum + influence, 0)
  const normal = new THREE.Vector3().fromBufferAttribute(attributes.normal, i)
  const targets = morphAttributes.normal
  if (targets && !morphTargetsRelative) normal.multiplyScalar(1 - total)
  targets?.forEach((target, t) =>
    normal.addScaledVector(new THREE.Vector3().fromBufferAttribute(target, i), influences[t]),
  )
  return normal.normalize()
}

/** Makes a sphere with two morph targets: a larger sphere next to it, and one that is stretched along an axis. */
function morphingSphere(relative, withNormals) {
  const geometry = new THREE.SphereGeometry(1, 12, 8)
  const targets = [
    geometry.clone().scale(1.5, 1.5, 1.5).translate(1, 0, 0.5),
    geometry.clone().scale(1, 2, 0.5),
  ]
  const { attributes } = geometry
  for (const name of withNormals ? ['position', 'normal'] : ['position'])
    geometry.morphAttributes[name] = targets.map((target) => {
      const attribute = target.attributes[name].clone()
      if (relative)
        attribute.array.forEach((_, i) => (attribute.array[i] -= attributes[name].array[i]))
      return attribute
    })
  geometry.morphAttributes.position[1].name = 'second'
  geometry.morphTargetsRelative = relative
  return geometry
}

test('exportGLB and surfaceVariation accept geometries, too', () => {
  const geometry = new THREE.BoxGeometry()
  assert.ok(exportGLB(geometry).length > 500)
  assert.equal(
    surfaceVariation(geometry).normalXGradients.length,
    3 * geometry.attributes.position.count,
  )
})

test('loadMesh returns a BufferGeometry with the option "as"', async () => {
  const file = new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\nf 1/1 2/1 3/1\n')
  const geometry = await loadMesh(file, { as: THREE.BufferGeometry })
  assert.ok(geometry instanceof THREE.BufferGeometry)
  assert.deepEqual([...geometry.attributes.position.array], [0, 0, 0, 1, 0, 0, 0, 1, 0])
  assert.deepEqual(valuesAt(geometry.attributes.normal, 0), [0, 0, 1])
  assert.equal(geometry.index.count, 3)
  assert.deepEqual([...new THREE.Mesh(geometry).geometry.index.array], [0, 1, 2])
  for (const as of [5, Array, class {}])
    await assert.rejects(loadMesh(file, { as }), {
      name: 'WarpError',
      message:
        /^loadMesh: expected the class BufferGeometry of three\.js for the option "as", got /,
    })
})
