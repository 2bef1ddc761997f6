/** Exports the shape that a sketch draws with its warp as a GLB file: warped positions and normals, with y upwards as in glTF. */

/** Returns functions that transform points by a column-major 4×4 matrix and normals by its cofactor matrix. */
function makeTransforms(m) {
  const point = ([x, y, z]) =>
    [0, 1, 2].map((i) => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i])
  const column = (i) => [m[4 * i], m[4 * i + 1], m[4 * i + 2]]
  const cross = (a, b) =>
    [0, 1, 2].map((i) => {
      const [j, k] = [(i + 1) % 3, (i + 2) % 3]
      return a[j] * b[k] - a[k] * b[j]
    })
  const cofactors = [
    cross(column(1), column(2)),
    cross(column(2), column(0)),
    cross(column(0), column(1)),
  ]
  const direction = (n) => {
    const result = [0, 1, 2].map((i) => cofactors.reduce((sum, each, j) => sum + each[i] * n[j], 0))
    const length = Math.hypot(...result)
    return length ? result.map((each) => each / length) : result
  }
  return { point, direction }
}

function mapTriples(array, change) {
  const result = new Float32Array(array.length)
  for (let i = 0; i < array.length; i += 3)
    result.set(change([array[i], array[i + 1], array[i + 2]]), i)
  return result
}

const turnUpright = ([x, y, z]) => [x, -y, -z]

/**
 * @param recorded what the sketch in the iframe has created: { warps }
 * @param sketchFrame the iframe with the sketch: evaluates the warps, and returns the shapes that they warp
 * @param uniforms maps the names of inputs (of the clock, the mouse and the canvas) to their current values
 * @returns the file's bytes
 */
export async function glbOf(recorded, sketchFrame, uniforms) {
  const warps = recorded.warps
    .map((warp, index) => ({ ...warp, index }))
    .filter(({ hasShapes }) => hasShapes)
  if (warps.length > 1)
    throw new Error(
      `Expected one warp, got ${warps.length}: remove the others, so that it is clear which shape to save.`,
    )
  const [warp] = warps
  const shapes = warp ? await sketchFrame.shapesOf(warp.index) : []
  if (!shapes.length)
    throw new Error(
      'There is no shape to save: draw one with a warp of createWarp, or warp a mesh of three.js.',
    )
  if (warp.space === 'camera')
    throw new Error('A warp in space: "camera" depends on the camera and cannot be saved.')
  const inputNames = warp.reads.filter((name) => Object.hasOwn(uniforms, name))
  const values = Object.fromEntries(inputNames.map((name) => [name, uniforms[name]]))
  const { exportGLB } = await import('../../dist/mesh.js')
  const evaluate = (mesh) => sketchFrame.evaluate(warp.index, mesh, { uniforms: values })
  return exportGLB(
    merge(await Promise.all(shapes.map((shape) => warpShape(warp.space, shape, evaluate)))),
  )
}

/** Warps a recorded shape and transforms it into world space. */
async function warpShape(space, { matrix, isUpsideDown, indices, ...arrays }, evaluate) {
  const { point, direction } = makeTransforms(matrix)
  const isInWorld = space === 'world'
  const normals = arrays.normals && { normals: arrays.normals }
  const input = isInWorld
    ? {
        positions: mapTriples(arrays.positions, point),
        ...(normals && { normals: mapTriples(arrays.normals, direction) }),
      }
    : { positions: arrays.positions, ...normals }
  const uvs = arrays.uvs && { uvs: arrays.uvs }
  const { positions, normals: warpedNormals } = await evaluate({ ...input, ...uvs })
  const [toWorld, normalToWorld] = isInWorld ? [(p) => p, (n) => n] : [point, direction]
  const flip = isUpsideDown ? turnUpright : (vector) => vector
  return {
    positions: mapTriples(positions, (p) => flip(toWorld(p))),
    ...(normals && { normals: mapTriples(warpedNormals, (n) => flip(normalToWorld(n))) }),
    ...uvs,
    indices,
  }
}

/** Merges meshes into one. Attributes that some of the meshes lack are left out. */
function merge(meshes) {
  if (meshes.length === 1) return meshes[0]
  const concatenate = (arrays) => Float32Array.from(arrays.flatMap((array) => [...array]))
  const shared = ['positions', 'normals', 'uvs'].filter((name) =>
    meshes.every((each) => each[name]),
  )
  let count = 0
  const indices = meshes.flatMap(({ indices, positions }) => {
    const first = count
    count += positions.length / 3
    return Array.from(indices, (index) => first + index)
  })
  return {
    ...Object.fromEntries(
      shared.map((name) => [name, concatenate(meshes.map((each) => each[name]))]),
    ),
    indices: Uint32Array.from(indices),
  }
}
