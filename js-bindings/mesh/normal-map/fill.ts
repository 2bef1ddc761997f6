/**
 * Copies the colour of the nearest texel with a triangle to each texel without one, so that mipmaps blend in no other colours. `texels`
 * has 3 bytes per texel.
 */
export function fillEmptyTexels(texels: Uint8Array, owners: Int32Array, size: number) {
  const isFilled = Uint8Array.from(owners, (owner) => (owner >= 0 ? 1 : 0))
  const queue = new Uint32Array(owners.length)
  let end = 0
  for (let texel = 0; texel < owners.length; texel++) if (isFilled[texel]) queue[end++] = texel
  const spread = (from: number, to: number) => {
    if (isFilled[to]) return
    isFilled[to] = 1
    texels.copyWithin(3 * to, 3 * from, 3 * from + 3)
    queue[end++] = to
  }
  for (let start = 0; start < end; start++) {
    const texel = queue[start]!
    const column = texel % size
    if (column > 0) spread(texel, texel - 1)
    if (column < size - 1) spread(texel, texel + 1)
    if (texel >= size) spread(texel, texel - size)
    if (texel < size * (size - 1)) spread(texel, texel + size)
  }
}
