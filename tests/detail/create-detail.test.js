// `createDetail`: meshes that any renderer divides for the screen.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import * as THREE from 'three'
import { compileWarp } from 'warpjet'
import { createDetail } from 'warpjet/detail'
import { bakeWarp, surfaceVariation } from 'warpjet/mesh'
import { edgesNotUsed } from '../support/deviation.js'
import { pixelsOf, quantile, screenErrors } from '../support/screen-error.js'

const { cos, hypot, sin } = Math

/** Turns points around the y axis, by as many radians as `turn` times their height. */
const twist = ({ glsl, position: p, uniforms }) => {
  const angle = p.y().mult(uniforms.turn)
  const [c, s] = [angle.cos(), angle.sin()]
  const x = p.x().mult(c).sub(p.z().mult(s))
  return glsl.vec3(x, p.y(), p.x().mult(s).add(p.z().mult(c))).sub(p)
}
const warp = compileWarp(twist, { uniforms: { turn: 0.01 } })

/** Adds 0 times a noise. This takes so long that only samples that a view may show are warped. */
const costlyTwist = (inputs) => {
  const { glsl, position, uniforms } = inputs
  return twist(inputs).add(glsl.fbm(position.mult(0.01)).mult(uniforms.none))
}

/** Makes the same warp in plain numbers. */
const twistBy = (turn) => (vertices) => {
  const p = vertices.positions
  return Float64Array.from(p, (_, i) => {
    const [x, y, z] = p.slice(i - (i % 3), i - (i % 3) + 3)
    const a = turn * y
    return [x * cos(a) - z * sin(a), y, x * sin(a) + z * cos(a)][i % 3]
  })
}

const { attributes, index } = new THREE.BoxGeometry(240, 240, 240)
const mesh = {
  positions: attributes.position.array,
  normals: attributes.normal.array,
  uvs: attributes.uv.array,
  indices: index.array,
}

function viewFrom(...place) {
  const camera = new THREE.PerspectiveCamera(60, 4 / 3, 5, 3000)
  camera.position.set(...place)
  camera.lookAt(0, 0, 0)
  camera.updateMatrixWorld()
  const { projectionMatrix, matrixWorldInverse } = camera
  const { elements } = projectionMatrix.clone().multiply(matrixWorldInverse)
  return { matrix: elements, width: 800, height: 600 }
}
const near = viewFrom(300, 200, 400)

const all = ({ indices }) => Array.from({ length: indices.length / 3 }, (_, t) => t)
const errorsOf = (divided, turn, view) => screenErrors(divided, twistBy(turn), view, all(divided))

test('a box of 12 triangles is within a pixel of the twisted box, and has no cracks', () => {
  const divided = createDetail(mesh, warp)
  assert.equal(divided.update(near), true)
  assert.ok(quantile(errorsOf(mesh, 0.01, near), 1) > 10, 'the given mesh is within 10 pixels')
  const errors = errorsOf(divided, 0.01, near)
  assert.ok(quantile(errors, 0.999) <= 1, `${quantile(errors, 0.999)}`)
  assert.ok(quantile(errors, 1) <= 1.5, `${quantile(errors, 1)}`)
  assert.deepEqual(edgesNotUsed(2, divided), [])
  divided.dispose()
})

test('fewer triangles suffice from afar, for a larger tolerance, or if only the front is drawn', () => {
  const divided = createDetail(mesh, warp)
  const count = (...args) => {
    divided.update(...args)
    return divided.indices.length
  }
  const both = count(near)
  assert.ok(count(viewFrom(3000, 2000, 4000)) < both / 2)
  assert.ok(count(near, { tolerance: 8 }) < both / 2)
  assert.ok(count({ ...near, side: 'front' }) < both)
  divided.dispose()
})

test('a surface is exact where its normals turn within a short part of a side', () => {
  // A square whose left and right normals are almost opposite, and a triangle far away, beside which the square is too small to be cut.
  const slope = 0.1
  const square = {
    positions: [-10, -10, 0, 10, -10, 0, 10, 10, 0, -10, 10, 0, 0, 0, 200, 1, 0, 200, 0, 1, 200],
    normals: [-1, 1, 1, -1, 0, 0, 0].flatMap((x) => [x, 0, slope].map((n) => n / hypot(x, slope))),
    indices: [0, 1, 2, 0, 2, 3, 4, 5, 6],
  }
  const move = ({ normal }) => normal.mult(50)
  const movePlainly = ({ positions, normals }) =>
    Float64Array.from(positions, (x, i) => x + 50 * normals[i])
  const divided = createDetail(square, compileWarp(move, { normals: false }))
  const view = viewFrom(0, -300, 100)
  divided.update(view)
  const errors = screenErrors(divided, movePlainly, view, all(divided))
  assert.ok(quantile(errors, 1) <= 1, `${quantile(errors, 1)}`)
  divided.dispose()
})

test('the division is fine enough for all of several views', () => {
  const divided = createDetail(mesh, warp)
  const other = viewFrom(-300, -200, -400)
  divided.update([near, other])
  for (const view of [near, other]) assert.ok(quantile(errorsOf(divided, 0.01, view), 0.999) <= 1)
  divided.dispose()
})

/** Returns the indices of the triangles of the twisted surface that face the eye. */
function findFacing(divided, turn, view) {
  const warped = twistBy(turn)(divided)
  return all(divided).filter((t) => {
    const corners = [0, 1, 2].map((i) => pixelsOf(warped, 3 * divided.indices[3 * t + i], view))
    if (!corners.every(Boolean)) return false
    const [[ax, ay], [bx, by], [cx, cy]] = corners
    return (bx - ax) * (cy - ay) > (cx - ax) * (by - ay)
  })
}

test('parts that faced away or were outside of the view are within a pixel once they are seen', () => {
  const costly = compileWarp(costlyTwist, { uniforms: { turn: 0.01, none: 0 } })
  const divided = createDetail(mesh, costly)
  for (const place of [
    [300, 200, 400],
    [-300, -200, -400],
    [100, 500, -100],
    [150, 90, 170],
  ]) {
    const view = { ...viewFrom(...place), side: 'front' }
    divided.update(view)
    const errors = screenErrors(divided, twistBy(0.01), view, findFacing(divided, 0.01, view))
    assert.ok(errors.length > 500)
    assert.ok(quantile(errors, 0.999) <= 1, `${place}: ${quantile(errors, 0.999)}`)
    // Samples that were not warped would look like strong bends, and cause many more triangles.
    const fresh = createDetail(mesh, costly)
    fresh.update(view)
    assert.ok(divided.indices.length < 2 * fresh.indices.length)
    fresh.dispose()
  }
  divided.dispose()
})

test('the function of a uniform has one value for all samples of an update', () => {
  const count = (turn) => {
    const divided = createDetail(mesh, compileWarp(costlyTwist, { uniforms: { turn, none: 0 } }))
    divided.update({ ...near, side: 'front' })
    const { length } = divided.indices
    divided.dispose()
    return length
  }
  let calls = 0
  const alternating = count(() => (calls++ % 2 ? 0.004 : 0.01))
  assert.ok([0.004, 0.01].map((turn) => count(turn)).includes(alternating), `${alternating}`)
})

test('update returns whether arrays changed, and reads new uniforms', () => {
  const divided = createDetail(mesh, warp)
  assert.deepEqual([divided.positions.length, divided.indices.length], [0, 0])
  divided.update(near)
  assert.equal(divided.update(near), false)
  assert.equal(divided.update(near, { uniforms: { turn: 0.03 } }), true)
  assert.ok(quantile(errorsOf(divided, 0.03, near), 0.999) <= 1)
  divided.dispose()
  assert.equal(divided.update(near), true, 'starts anew')
  divided.dispose()
})

test('attributes are interpolated', () => {
  const divided = createDetail(mesh, warp)
  divided.update(near)
  assert.deepEqual(
    Object.keys(divided).filter((name) => name.endsWith('s')),
    ['positions', 'indices', 'normals', 'uvs'],
  )
  const { positions, normals, uvs } = divided
  for (let v = 0; v < positions.length / 3; v++) {
    const at = (from, size) => from.subarray(size * v, size * v + size)
    const side = at(normals, 3).findIndex((x) => Math.abs(x) > 0.5)
    assert.ok(Math.abs(Math.hypot(...at(normals, 3)) - 1) < 1e-6)
    assert.ok(Math.abs(at(positions, 3)[side] - 120 * at(normals, 3)[side]) < 1e-3)
    // The texture of a side of three's box covers it: u and v are the other two coordinates, in some order and direction.
    const places = [...at(positions, 3)].filter((_, k) => k !== side).map((x) => Math.abs(x) / 240)
    const inTexture = [...at(uvs, 2)].map((x) => Math.abs(x - 0.5))
    const difference = (a, b) => Math.hypot(...a.sort().map((x, k) => x - b.sort()[k]))
    assert.ok(difference(places, inTexture) < 1e-5)
  }
  divided.dispose()
})

test('curved triangles round a coarse sphere, and a box stays a box', () => {
  const still = compileWarp(({ glsl }) => glsl.vec3(0, 0, 0))
  const { attributes, index } = new THREE.SphereGeometry(100, 24, 16)
  const ball = {
    positions: attributes.position.array,
    normals: attributes.normal.array,
    indices: index.array,
  }
  const depthOf = (given, options) => {
    const divided = createDetail(given, still, options)
    divided.update(near, { tolerance: 0.1 })
    const { positions, indices } = divided
    const depth = all(divided).map((t) => {
      const corners = [0, 1, 2].map((i) => 3 * indices[3 * t + i])
      const middle = [0, 1, 2].map((k) => corners.reduce((sum, v) => sum + positions[v + k], 0) / 3)
      return 100 - Math.hypot(...middle)
    })
    divided.dispose()
    return Math.max(...depth)
  }
  assert.ok(depthOf(ball) > 0.8, 'the faces of a sphere of 24 × 16 lie inside of it')
  const depth = depthOf(ball, { curved: true })
  // Errors of the surface in the direction of the eye are not visible.
  assert.ok(depth < 0.3, `${depth}`)
  const box = createDetail(mesh, still, { curved: true })
  box.update(near)
  for (let v = 0; v < box.positions.length / 3; v++) {
    const place = box.positions.subarray(3 * v, 3 * v + 3).map(Math.abs)
    assert.ok(Math.abs(Math.max(...place) - 120) < 1e-4)
  }
  box.dispose()
})

test('wrong arguments are named', () => {
  const divided = createDetail(mesh, warp)
  const triangle = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] }
  const reading = compileWarp(({ normal }) => normal)
  const onGpu = compileWarp(({ glsl, position }) => {
    const source = 'float bump(float x) { return x; }'
    const bump = glsl.fn({ name: 'bump', source, arity: 1, derivatives: [1] })
    return glsl.vec3(bump(position.x()), 0, 0)
  })
  for (const [act, message] of [
    [
      () => createDetail(5, warp),
      'createDetail: expected a mesh such as { positions, normals, indices } for argument 1, got the number 5.',
    ],
    [
      () => createDetail(mesh, {}),
      'createDetail: expected a result of compileWarp for argument 2, got an empty object.',
    ],
    [
      () => createDetail({ positions: [1, 2] }, warp),
      'createDetail: expected a multiple of 3 numbers, 3 for each vertex, for positions, got 2.',
    ],
    [
      () => createDetail({ ...triangle, uvs: [0, 0] }, warp),
      'createDetail: expected 6 numbers, 2 for each vertex, for uvs, got 2.',
    ],
    [
      () => createDetail({ positions: [0, 0, 0, 1, 0, 0, 0, 1, NaN] }, warp),
      'createDetail: expected a finite number for positions[8], got NaN.',
    ],
    [
      () => createDetail({ ...triangle, indices: [0, 1, 3] }, warp),
      'createDetail: expected the number of one of 3 vertices, from 0, for indices[2], got the number 3.',
    ],
    [
      () => createDetail(triangle, reading),
      'createDetail: the warp reads the normal of each vertex; pass "normals" too.',
    ],
    [
      () => createDetail(triangle, warp, { curved: true }),
      'createDetail: expected 3 numbers per vertex, which a curved mesh needs, for normals, got none.',
    ],
    [
      () => createDetail(new THREE.BoxGeometry(), warp),
      "createDetail: expected a mesh such as { positions, normals, indices } for argument 1, got an object; fromBufferGeometry of 'warpjet/three' makes one of a geometry of three.js.",
    ],
    [
      () => createDetail(mesh, warp, { curved: 1 }),
      'createDetail: expected true or false for the option "curved", got the number 1.',
    ],
    [
      () => divided.update(),
      'update: expected a view such as { matrix, width, height } for argument 1, got undefined.',
    ],
    [
      () => divided.update({ ...near, matrix: [1] }),
      'update: expected an array of 16 finite numbers, column by column, for the option "matrix", got an array of 1.',
    ],
    [
      () => divided.update({ ...near, width: 0 }),
      'update: expected a number above 0 for the option "width", got the number 0.',
    ],
    [
      () => divided.update(near, { tolerance: -1 }),
      'update: expected a number above 0 for the option "tolerance", got the number -1.',
    ],
  ])
    assert.throws(act, { name: 'WarpError', message })
  assert.throws(() => createDetail(triangle, onGpu), {
    name: 'WarpError',
    message: /which only the GPU can do/,
  })
  divided.dispose()
})

test('unknown arrays of a mesh are named', () => {
  const known = 'positions, normals, uvs, colors, tangents, indices'
  const { positions, ...others } = mesh
  for (const [given, message] of [
    [{ ...mesh, index: [0, 1, 2] }, 'a mesh has no property "index"; did you mean indices?'],
    [
      { position: positions, ...others },
      'a mesh has no property "position"; did you mean positions?',
    ],
    [{ vertices: positions }, 'a mesh has no property "vertices"; did you mean positions?'],
    [{ ...mesh, faces: [0, 1, 2] }, 'a mesh has no property "faces"; did you mean indices?'],
    [{ ...mesh, normal: [] }, 'a mesh has no property "normal"; did you mean normals?'],
    [{ ...mesh, uv: [] }, 'a mesh has no property "uv"; did you mean uvs?'],
    [{ ...mesh, color: undefined }, 'a mesh has no property "color"; did you mean colors?'],
    [{ ...mesh, weight: [] }, `a mesh has no property "weight"; its arrays are ${known}.`],
  ])
    assert.throws(() => createDetail(given, warp), {
      name: 'WarpError',
      message: `createDetail: ${message}`,
    })
})

test('createDetail accepts meshes of warpjet/mesh', () => {
  const baked = bakeWarp({ ...mesh, material: { baseColor: [1, 0, 0, 1] } }, warp)
  assert.deepEqual(baked.material, { baseColor: [1, 0, 0, 1] })
  createDetail({ ...baked, warnings: ['animations are left out'] }, warp)
  createDetail({ ...baked, ...surfaceVariation(baked) }, warp)
})

test('messages about uniforms name update', () => {
  const offset = ({ glsl, position, uniforms, millis }) =>
    glsl.vec3(0, position.x().mult(uniforms.turn, uniforms.now).sin().mult(millis), 0)
  let value = 1
  const warp = compileWarp(offset, { uniforms: { turn: 0.01, now: () => value } })
  const wavy = compileWarp(({ glsl, position }) =>
    glsl.vec3(position.x().mult(glsl.param('k')).sin(), 0, 0),
  )
  const update = (warp, uniforms) => {
    const divided = createDetail(mesh, warp)
    try {
      divided.update(near, { uniforms })
    } finally {
      divided.dispose()
    }
  }
  const known = 'millis, mouse, size, pixelDensity, instance'
  for (const [given, uniforms, message] of [
    [
      warp,
      undefined,
      'the warp reads "millis"; pass a value in the uniforms, as in { "millis": 0 }.',
    ],
    [
      warp,
      { millis: 'late' },
      'expected a finite number for the uniform "millis", got the text "late".',
    ],
    [
      warp,
      { millis: 1, turn: [1, 2] },
      'expected a finite number for the uniform "turn", got an array of 2.',
    ],
    [warp, { millis: 1, turn: NaN }, 'expected a finite number for the uniform "turn", got NaN.'],
    [warp, { millis: 1, turm: 1 }, `the warp has no uniform "turm"; it has ${known}, turn, now.`],
    [wavy, undefined, 'the warp reads "k"; pass a value in the uniforms, as in { "k": 0 }.'],
    [wavy, { k: [1, 2] }, 'expected a finite number for the uniform "k", got an array of 2.'],
    [
      wavy,
      5,
      'expected an object, such as { millis: 1200 }, for the option "uniforms", got the number 5.',
    ],
    [
      wavy,
      null,
      'expected an object, such as { millis: 1200 }, for the option "uniforms", got null.',
    ],
    [
      warp,
      [1],
      'expected an object, such as { millis: 1200 }, for the option "uniforms", got an array of 1.',
    ],
  ])
    assert.throws(() => update(given, uniforms), {
      name: 'WarpError',
      message: `update: ${message}`,
    })
  value = 'late'
  assert.throws(() => update(warp, { millis: 1 }), {
    name: 'WarpError',
    message:
      'update: expected a finite number for the uniform "now", got the text "late"; its function must always return a value of the same type as at first.',
  })
})

// Without a limit there would be thirty million triangles.
test('a wave with thousands of periods makes about a million triangles', () => {
  const warp = compileWarp(
    ({ glsl, position, uniforms }) =>
      glsl.vec3(0, position.x().mult(uniforms.waves).sin().mult(0.1), 0),
    { normals: false, uniforms: { waves: 1 } },
  )
  const { attributes, index } = new THREE.BoxGeometry()
  const mesh = { positions: attributes.position.array, indices: index.array }
  const divided = createDetail(mesh, warp)
  divided.update(near, { uniforms: { waves: 1e5 } })
  const count = divided.indices.length / 3
  // They stay as they are while the camera hardly moves.
  const matrix = near.matrix.map((x) => 1.0001 * x)
  const isChanged = divided.update({ ...near, matrix }, { uniforms: { waves: 1e5 } })
  divided.dispose()
  assert.equal(isChanged, false)
  assert.ok(count > 2 ** 16 && count < 1.2 * 2 ** 20, `${count} triangles`)
})

test('an update without a uniform leaves nothing behind', () => {
  const warp = compileWarp(
    ({ glsl, position, millis, uniforms }) => {
      const moved = position.mult(uniforms.scale)
      return glsl.vec3(0, glsl.fbm(moved, { octaves: 5 }).mult(millis), 0)
    },
    { normals: false, uniforms: { scale: 0.02 } },
  )
  const { attributes, index } = new THREE.SphereGeometry(120)
  const mesh = { positions: attributes.position.array, indices: index.array }
  const divided = createDetail(mesh, warp)
  const uniforms = { millis: 30, scale: 0.02 }
  divided.update(near, { uniforms })
  assert.throws(() => divided.update(near, { uniforms: { scale: 0.02 } }), /millis/)
  const far = viewFrom(-300, 200, -900)
  divided.update(far, { uniforms })
  const fresh = createDetail(mesh, warp)
  fresh.update(far, { uniforms })
  const [count, freshCount] = [divided.indices.length, fresh.indices.length]
  divided.dispose()
  fresh.dispose()
  assert.ok(freshCount > 3 * index.count)
  // Hysteresis keeps some more.
  assert.ok(count >= freshCount && count < 1.5 * freshCount, `${count}, ${freshCount}`)
})
