/**
 * Writes a mesh (see mesh.js) as Wavefront OBJ with `v`, `vt`, `vn` and `f` lines, for p5's
 * `loadModel` and every 3D program. Coordinates are written unchanged, so y points down: p5 shows
 * the file upright, other programs need it flipped.
 */

// Writes no exponent and no trailing decimal point: p5 splits lines at `\b\s+`, which matches only after a
// digit.
const formatNumber = (x, decimals) => String(Number(x.toFixed(decimals)) + 0)

const writeLines = (word, values, width, decimals) => {
  const result = []
  for (let i = 0; i < values.length; i += width) {
    const numbers = Array.from(values.subarray(i, i + width), (x) => formatNumber(x, decimals))
    result.push(`${word} ${numbers.join(' ')}`)
  }
  return result
}

/**
 * @param mesh { positions, normals, uvs?, indices }
 * @param name the object's name in the file
 * @returns the content of the file
 */
export function toOBJ(mesh, name) {
  const { positions, normals, uvs, indices } = mesh
  // OBJ counts from 1, and its v points up where ours points down.
  const corner = (i) => (uvs ? `${i + 1}/${i + 1}/${i + 1}` : `${i + 1}//${i + 1}`)
  const faces = []
  for (let i = 0; i < indices.length; i += 3) {
    faces.push(`f ${corner(indices[i])} ${corner(indices[i + 1])} ${corner(indices[i + 2])}`)
  }
  const flipped = uvs ? uvs.map((x, i) => (i % 2 === 1 ? 1 - x : x)) : []
  return [
    `o ${name}`,
    ...writeLines('v', positions, 3, 3),
    ...writeLines('vt', flipped, 2, 4),
    ...writeLines('vn', normals, 3, 4),
    ...faces,
    '',
  ].join('\n')
}
