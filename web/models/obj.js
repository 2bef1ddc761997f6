/**
 * A mesh as Wavefront OBJ text, for p5's `loadModel` and every 3D program. Enters: a mesh (see
 * mesh.js). Leaves: `v`, `vt`, `vn` and `f` lines. Coordinates are written as they are, so y still
 * points down: p5 shows the file upright, other programs want it turned over.
 */

// Never an exponent and never a bare trailing point: p5 splits lines at `\b\s+`, and wants a digit
// last.
const short = (x, decimals) => String(Number(x.toFixed(decimals)) + 0)

const lines = (word, values, width, decimals) => {
  const result = []
  for (let i = 0; i < values.length; i += width) {
    const numbers = Array.from(values.subarray(i, i + width), (x) => short(x, decimals))
    result.push(`${word} ${numbers.join(' ')}`)
  }
  return result
}

/**
 * @param mesh { positions, normals, uvs?, indices }
 * @param name the object's name in the file
 * @returns the text of the file
 */
export function toOBJ(mesh, name) {
  const { positions, normals, uvs, indices } = mesh
  // OBJ counts from 1, and its v runs upwards where ours runs downwards.
  const corner = (i) => (uvs ? `${i + 1}/${i + 1}/${i + 1}` : `${i + 1}//${i + 1}`)
  const faces = []
  for (let i = 0; i < indices.length; i += 3) {
    faces.push(`f ${corner(indices[i])} ${corner(indices[i + 1])} ${corner(indices[i + 2])}`)
  }
  const flipped = uvs ? uvs.map((x, i) => (i % 2 === 1 ? 1 - x : x)) : []
  return [
    `o ${name}`,
    ...lines('v', positions, 3, 3),
    ...lines('vt', flipped, 2, 4),
    ...lines('vn', normals, 3, 4),
    ...faces,
    '',
  ].join('\n')
}
