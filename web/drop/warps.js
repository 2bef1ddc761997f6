/**
 * The warps of the page. Each is written for a model about 2 units high around the origin, with y upwards; `amount` is in [0, 1],
 * `time` is an angle. `warpPoint` returns the warped position. `fitWarp` converts a warp into an offset function for a model of any
 * position and size.
 */

const rotateY = (glsl, { x, y, z }, angle) => {
  const [s, c] = [angle.sin(), angle.cos()]
  return glsl.vec3(x.mult(c).add(z.mult(s)), y, z.mult(c).sub(x.mult(s)))
}

export const warps = [
  {
    name: 'Twist',
    warpPoint: (glsl, { p, amount, time }) =>
      rotateY(glsl, p, p.y.mult(amount).mult(4).mult(time.cos())),
  },
  {
    name: 'Bend',
    warpPoint(glsl, { p, amount, time }) {
      // Never 0, the curvature of a circle of infinite radius.
      const curvature = amount.mult(time.cos()).mult(2).add(0.002)
      const angle = p.y.mult(curvature)
      const halfSine = angle.mult(0.5).sin()
      return glsl.vec3(
        p.x.mult(angle.cos()).sub(halfSine.mult(halfSine).mult(2).div(curvature)),
        p.x.add(glsl.val(1).div(curvature)).mult(angle.sin()),
        p.z,
      )
    },
  },
  {
    name: 'Waves',
    warpPoint: (glsl, { p, amount, time }) =>
      glsl.vec3(
        p.x.add(p.y.mult(5).add(time).sin().mult(amount).mult(0.25)),
        p.y.add(p.z.mult(5).add(time.mult(2)).sin().mult(amount).mult(0.15)),
        p.z.add(p.x.mult(5).add(time).sin().mult(amount).mult(0.25)),
      ),
  },
  {
    name: 'Wobble',
    warpPoint(glsl, { p, amount, time }) {
      // The foot, at y = -1, does not move.
      const height = p.y.add(1).mult(amount).mult(0.4)
      return glsl.vec3(
        p.x.add(p.y.mult(1.5).add(time).sin().mult(height)),
        p.y.mult(time.mult(2).sin().mult(amount).mult(0.25).add(1)),
        p.z.add(p.y.mult(2).add(time.mult(2)).cos().mult(height).mult(0.6)),
      )
    },
  },
  {
    name: 'Bulge',
    warpPoint(glsl, { p, amount, time }) {
      const v = glsl.vec3(p.x, p.y, p.z)
      const away = v.sub(glsl.vec3(time.cos().mult(0.5), time.sin().mult(0.6), 0.3))
      return v.add(away.mult(away.dot(away).mult(-4).exp().mult(amount).mult(1.6)))
    },
  },
  {
    name: 'Ripple',
    warpPoint(glsl, { p, amount, time }) {
      // Never 0, where the square root has no derivative.
      const radius = p.x.mult(p.x).add(p.z.mult(p.z)).add(1e-4).sqrt()
      return glsl.vec3(
        p.x,
        p.y.add(radius.mult(9).sub(time.mult(2)).sin().mult(amount).mult(0.2)),
        p.z,
      )
    },
  },
  {
    name: 'Ball',
    warpPoint(glsl, { p, amount, time }) {
      const v = glsl.vec3(p.x, p.y, p.z)
      const ball = v.mult(glsl.val(0.8).div(v.dot(v).add(1e-3).sqrt()))
      return v.mix(ball, amount.mult(time.cos().mult(0.5).add(0.5)))
    },
  },
  {
    name: 'Genie',
    warpPoint(glsl, { p, amount, time }) {
      const v = glsl.vec3(p.x, p.y, p.z)
      const spout = glsl.vec3(0.7, -1.3, 0)
      const above = glsl.vec3(1.2, -0.2, 0)
      const start = v.dist(spout).div(3.5)
      const progress = amount.mult(time.cos().mult(0.5).add(0.5)).mult(1.5)
      const t = glsl.smoothstep(start, start.add(0.5), progress)
      // A quadratic Bézier curve from the vertex to the spout.
      return v.mix(above, t).mix(above.mix(spout, t), t)
    },
  },
]

/** Swizzles that bring an axis of the model to the warp's y and back. They are cyclic, so nothing is mirrored. */
const axes = {
  x: { from: 'zxy', back: 'yzx' },
  y: { from: 'xyz', back: 'xyz' },
  z: { from: 'yzx', back: 'zxy' },
}

/** The axes of the model along which a warp can act. */
export const sides = Object.keys(axes)

/** Returns the offset function, with uniforms `center`, `unit`, `amount` and `time`. */
export const fitWarp =
  ({ warpPoint }, axis) =>
  ({ glsl, position }) => {
    const [center, unit] = [glsl.vec3Param('center'), glsl.param('unit')]
    const q = position.sub(center).div(unit)
    const inputs = { amount: glsl.param('amount'), time: glsl.param('time') }
    const { from, back } = axes[axis]
    const [x, y, z] = [...from].map((name) => q[name]())
    const target = warpPoint(glsl, { ...inputs, p: { x, y, z } })
    return target[back]().sub(q).mult(unit)
  }
