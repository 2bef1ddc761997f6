// Warps for the tests of normals at pixels. Shapes have a size of about 1.

/** Offsets with normals that are wrong by degrees if they are interpolated over the faces of a coarse mesh. */
export const warps = {
  fbm: ({ glsl, position }) => position.mult(glsl.fbm(position.mult(2)).mult(0.3)),
  simplex: ({ glsl, position }) => position.mult(glsl.simplex(position.mult(2)).mult(0.2)),
  worley: ({ glsl, position }) => position.mult(glsl.worley(position.mult(2)).x().mult(0.2)),
  waves: ({ position }) => {
    const [x, y, z] = ['x', 'y', 'z'].map((axis) => position[axis]())
    return position.mult(x.mult(7).sin().add(y.mult(7).sin(), z.mult(7).sin()).mult(0.04))
  },
  twist: ({ glsl, position }) => {
    const angle = position.y().mult(1.5)
    const [c, s] = [angle.cos(), angle.sin()]
    const [x, z] = [position.x(), position.z()]
    return glsl.vec3(c.mult(x).add(s.mult(z)), position.y(), c.mult(z).sub(s.mult(x))).sub(position)
  },
  'flag by uv': ({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(12).sin().mult(uv.y()).mult(0.1)),
  'blob along the normal': ({ normal, position }) =>
    normal.mult(position.x().mult(5).add(1).sin().add(position.y().mult(4).sin()).mult(0.08)),
}

/** Offsets perpendicular to a plane: the unwarped position of a pixel is its centre. */
export const heights = Object.fromEntries(
  ['fbm', 'simplex', 'worley'].map((name) => [
    name,
    ({ glsl, position }) => {
      const noise = glsl[name](position.mult(4))
      return glsl.vec3(0, 0, (name === 'worley' ? noise.x() : noise).mult(0.1))
    },
  ]),
)
heights.waves = ({ glsl, position }) =>
  glsl.vec3(0, 0, position.x().mult(4).sin().mult(0.15).add(position.y().mult(5).cos().mult(0.1)))
