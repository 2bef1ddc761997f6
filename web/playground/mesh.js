/** The shape that a sketch draws with its warp, as a GLB file: moved by the warp, lit by its normals, with y upwards as glTF has it. */

/** What p5 calls its matrix, as 16 numbers by columns; of directions the matrix that keeps them upright on a surface. */
function mover(m) {
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
    const turned = [0, 1, 2].map((i) => cofactors.reduce((sum, each, j) => sum + each[i] * n[j], 0))
    const length = Math.hypot(...turned)
    return length ? turned.map((each) => each / length) : turned
  }
  return { point, direction }
}

function moved(array, move) {
  const result = new Float32Array(array.length)
  for (let i = 0; i < array.length; i += 3)
    result.set(move([array[i], array[i + 1], array[i + 2]]), i)
  return result
}

const upright = ([x, y, z]) => [x, -y, -z]

/**
 * `made` is what the sketch has made, which `frame` evaluates; `uniforms` are the clock's, the mouse's and the canvas's, by name. → the
 * file's bytes
 */
export async function glbOf(made, frame, uniforms) {
  const warps = made.warps
    .map((warp, index) => ({ ...warp, index }))
    .filter(({ hasShapes }) => hasShapes)
  if (warps.length > 1)
    throw new Error(
      `The sketch has ${warps.length} warps: leave one, so that it is clear which shape to save.`,
    )
  const [warp] = warps
  const shapes = warp ? await frame.shapesOf(warp.index) : []
  if (!shapes.length)
    throw new Error(
      'There is no shape to save: the sketch must draw one with a warp of createWarp, or warp a mesh of three.js.',
    )
  if (warp.space === 'camera')
    throw new Error(
      'A warp in space: "camera" depends on where one looks from, and cannot be saved.',
    )
  const read = warp.reads.filter((name) => Object.hasOwn(uniforms, name))
  const values = Object.fromEntries(read.map((name) => [name, uniforms[name]]))
  const { exportGLB } = await import('../../dist/mesh.js')
  const evaluate = (mesh) => frame.evaluate(warp.index, mesh, { uniforms: values })
  return exportGLB(
    joined(await Promise.all(shapes.map((shape) => warped(warp.space, shape, evaluate)))),
  )
}

/** A shape that the frame has kept, moved by the warp to where it stands. */
async function warped(space, { matrix, isUpsideDown, indices, ...own }, evaluate) {
  const { point, direction } = mover(matrix)
  const isInWorld = space === 'world'
  const normals = own.normals && { normals: own.normals }
  const given = isInWorld
    ? {
        positions: moved(own.positions, point),
        ...(normals && { normals: moved(own.normals, direction) }),
      }
    : { positions: own.positions, ...normals }
  const uvs = own.uvs && { uvs: own.uvs }
  const { positions, normals: turned } = await evaluate({ ...given, ...uvs })
  const [toWorld, turn] = isInWorld ? [(p) => p, (n) => n] : [point, direction]
  const end = isUpsideDown ? upright : (vector) => vector
  return {
    positions: moved(positions, (p) => end(toWorld(p))),
    ...(normals && { normals: moved(turned, (n) => end(turn(n))) }),
    ...uvs,
    indices,
  }
}

/** One mesh of some; what not all of them have is left out. */
function joined(meshes) {
  const [first, ...others] = meshes
  if (!others.length) return first
  const join = (arrays) => Float32Array.from(arrays.flatMap((array) => [...array]))
  const kept = ['positions', 'normals', 'uvs'].filter((name) => meshes.every((each) => each[name]))
  let before = 0
  const indices = meshes.flatMap(({ indices, positions }) => {
    const from = before
    before += positions.length / 3
    return Array.from(indices, (index) => from + index)
  })
  return {
    ...Object.fromEntries(kept.map((name) => [name, join(meshes.map((each) => each[name]))])),
    indices: Uint32Array.from(indices),
  }
}
