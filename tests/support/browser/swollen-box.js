// A warp that twists a box with sides of length 1 and lets it swell, and a texture of squares for the sides of the box, for pictures from
// all sides. The functions import nothing, so that tests can put their source into pages.

export const swell = ({ glsl, position }) =>
  glsl
    .rotateY(position.y().mult(1.8))
    .mult(position.mult(position.mult(2).simplex().mult(0.3).add(1)))
    .sub(position)

/**
 * Returns the RGBA bytes of a picture of 240 × 240 pixels with squares of seven colors, which show how far a point of a surface is off.
 * All channels are 0 or 255.
 */
export function paintSquares() {
  const side = 240
  const bytes = new Uint8Array(4 * side * side)
  for (let i = 0; i < side * side; i++) {
    const [column, row] = [i % side, Math.floor(i / side)].map((x) => Math.floor(x / 40))
    const colorBits = 1 + ((column + 3 * row) % 7)
    bytes.set([...[1, 2, 4].map((bit) => (colorBits & bit ? 255 : 0)), 255], 4 * i)
  }
  return bytes
}
