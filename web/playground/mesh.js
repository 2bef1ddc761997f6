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

/** What the frame has kept of the shape → arrays. */
function arraysOf({ vertices, vertexNormals, uvs, faces }) {
  const flat = (list) => Float32Array.from(list.flatMap(({ x, y, z }) => [x, y, z]))
  return {
    positions: flat(vertices),
    normals: flat(vertexNormals),
    uvs: uvs.length === 2 * vertices.length ? Float32Array.from(uvs) : undefined,
    indices: Uint32Array.from(faces.flat()),
  }
}

/** `inside` is the frame's; `uniforms` are the clock's, the mouse's and the canvas's, by name. → the file's bytes */
export async function glbOf(inside, uniforms) {
  const warps = (inside?.warps ?? []).filter(({ maker }) => maker === 'createWarp')
  const { drawn } = inside ?? {}
  if (!warps.length || !drawn)
    throw new Error(
      'There is no shape to save: the sketch must draw one with a warp of createWarp.',
    )
  if (warps.length > 1)
    throw new Error(
      `The sketch has ${warps.length} warps: leave one, so that it is clear which shape to save.`,
    )
  const [{ made, space }] = warps
  if (space === 'camera')
    throw new Error(
      'A warp in space: "camera" depends on where one looks from, and cannot be saved.',
    )
  const { point, direction } = mover(drawn.matrix)
  const own = arraysOf(drawn.geometry)
  const isInWorld = space === 'world'
  const given = isInWorld
    ? { ...own, positions: moved(own.positions, point), normals: moved(own.normals, direction) }
    : own
  const read = made.uniforms.map(({ name }) => name).filter((name) => name in uniforms)
  const values = Object.fromEntries(read.map((name) => [name, uniforms[name]]))
  const { positions, normals, uvs, indices } = given
  const warped = made.evaluate({ positions, normals, ...(uvs && { uvs }) }, { uniforms: values })
  const [toWorld, turn] = isInWorld ? [(p) => p, (n) => n] : [point, direction]
  const { exportGLB } = await import('../../dist/mesh.js')
  return exportGLB({
    positions: moved(warped.positions, (p) => upright(toWorld(p))),
    normals: moved(warped.normals, (n) => upright(turn(n))),
    ...(uvs && { uvs }),
    indices,
  })
}
