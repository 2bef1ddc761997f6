// Shapes with detail, and sketches that draw them.
import { size } from './sketches.js'

// Boxes and planes bend more on one side. Otherwise the CPU would divide them uniformly, which compute passes cannot do.
const offsets = {
  twist({ glsl, position }) {
    const angle = position.y().mult(2).exp()
    const [c, s] = [angle.cos(), angle.sin()]
    const [x, y, z] = [position.x(), position.y(), position.z()]
    return glsl.vec3(x.mult(c).sub(z.mult(s)), y, x.mult(s).add(z.mult(c))).sub(position)
  },
  flag: ({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(9).sin().mult(uv.x().pow(2)).mult(30)),
  bend: ({ glsl, position }) => glsl.vec3(0, position.x().mult(0.05).exp().mult(4), 0),
  noise: ({ normal, position, uniforms }) =>
    normal.mult(
      position.mult(2).add(uniforms.shift).simplex().mult(uniforms.height, position.y().add(1)),
    ),
  swelling: ({ normal, position, uniforms }) =>
    normal.mult(position.y().mult(0.05).add(uniforms.shift).sin().mult(uniforms.height)),
  waves: ({ glsl, position, uniforms }) =>
    glsl.vec3(0, position.x().mult(uniforms.waves).sin().mult(0.1), 0),
  bump({ glsl, position, uniforms }) {
    const d = position.sub(glsl.vec3(uniforms.place, 0.1, 0.5))
    return glsl.vec3(0, 0, glsl.dot(d, d).mult(-2000).exp().mult(0.15))
  },
}

/** Maps a warp → a function that returns its uniforms in picture i. */
const uniforms = {
  noise: (i) => ({ shift: i / 10, height: 0.15 }),
  // With a scale of 60, a normal in world space has the length 1/60.
  swelling: (i) => ({ shift: i / 10, height: 900 }),
  waves: (i) => ({ waves: i ? 60 : 4 }),
  bump: (i) => ({ place: i ? 0.23 : -0.2 }),
}

const shapes = {
  box: (p) => p.box(120),
  plane: (p) => p.plane(170, 170, 1, 1),
  ball(p) {
    p.scale(60)
    p.model(ballOf(p))
  },
}

const balls = new WeakMap()

/** Returns an octahedron of radius 1 that is divided three times. Spheres of p5 have a seam whose two sides differ by rounding. */
function ballOf(p) {
  if (balls.has(p)) return balls.get(p)
  const positions = [0, 1, 2].flatMap((axis) =>
    [1, -1].map((sign) => [0, 1, 2].map((i) => (i === axis ? sign : 0))),
  )
  let faces = [0, 1].flatMap((x) =>
    [2, 3].flatMap((y) => [4, 5].map((z) => ((x + y + z) % 2 ? [x, z, y] : [x, y, z]))),
  )
  const middles = new Map()
  const middleOf = (a, b) => {
    const key = `${Math.min(a, b)} ${Math.max(a, b)}`
    if (!middles.has(key)) {
      const sum = positions[a].map((x, i) => x + positions[b][i])
      middles.set(key, positions.push(sum.map((x) => x / Math.hypot(...sum))) - 1)
    }
    return middles.get(key)
  }
  for (let k = 0; k < 3; k++)
    faces = faces.flatMap(([a, b, c]) => {
      const [d, e, f] = [middleOf(a, b), middleOf(b, c), middleOf(c, a)]
      return [
        [a, d, f],
        [d, b, e],
        [f, e, c],
        [d, e, f],
      ]
    })
  const ball = new p5.Geometry(1, 1, function () {
    this.gid = 'ball'
    this.vertices = positions.map((position) => p.createVector(...position))
    this.vertexNormals = positions.map((position) => p.createVector(...position))
    this.uvs = positions.flatMap(() => [0, 0])
    this.faces = faces
  })
  balls.set(p, ball)
  return ball
}

const boxes = new WeakMap()

/** Returns a box as a p5.Geometry of the sketch. */
export function boxOf(p) {
  if (!boxes.has(p))
    boxes.set(
      p,
      p.buildGeometry(() => p.box(1)),
    )
  return boxes.get(p)
}

/**
 * Returns a sketch that draws a shape with detail once per function in `places`. Each of these functions calls rotateX(), translate() and
 * the like for picture i. If `isInside`, the sketch draws the shapes into a framebuffer, which it then draws.
 */
export function sketch({
  shape,
  name,
  space,
  detail = 1,
  look,
  places: transforms = [turn],
  isInside: usesFramebuffer,
  ...others
}) {
  let warp, framebuffer
  return {
    ...others,
    setup(p) {
      const initialUniforms = uniforms[name]?.(0)
      warp = p.createWarp(offsets[name], {
        ...{ space, detail, normals: 'pixel' },
        ...(initialUniforms && { uniforms: initialUniforms }),
      })
      if (usesFramebuffer) framebuffer = p.createFramebuffer()
      others.setup?.(p)
    },
    draw(p, i) {
      framebuffer?.begin()
      if (framebuffer) p.background(0, 0, 100)
      p.noStroke()
      p.lights()
      p.fill(255, 127, 80)
      look?.(p, i)
      warp(uniforms[name]?.(i))
      for (const transform of transforms) {
        p.push()
        transform(p, i)
        const draw = typeof shape === 'function' ? shape : shapes[shape]
        draw(p, i)
        p.pop()
      }
      if (!framebuffer) return
      framebuffer.end()
      p.resetShader()
      p.noLights()
      p.image(framebuffer, -size / 2, -size / 2)
    },
  }
}

export function turn(p, i) {
  p.rotateX(-0.4 + i / 3)
  p.rotateY(0.5 + i / 2)
  p.scale(0.8 + ((i * 0.382) % 1) / 2)
}

/** Transforms for `places` of a sketch: draw a shape near and far in one picture, at different sizes. */
export const around = [
  [0, 60, 0, 1],
  [60, 40, -100, 1.2],
  [0, -50, 50, 0.8],
].map(([x, y, z, size]) => (p, i) => {
  p.translate(x, y, z)
  p.rotateY(0.4 + i / 5)
  p.scale(size)
})
