// Checks which operations of numbers, vectors and matrices the types allow and reject. Compiled only, never run.
import {
  compile,
  type Mat2,
  type Mat3,
  type Scalar,
  type Vec2,
  type Vec3,
  type Vec4,
} from '../../js-bindings/warpjet.js'

// Componentwise operations return a number if all operands are numbers, otherwise the type of the vectors.
compile((glsl) => {
  const [x, p, q] = [glsl.param('x'), glsl.vec3Param('p'), glsl.vec2Param('q')]
  const numbers: Scalar[] = [
    x.pow(2),
    x.atan(),
    x.atan(2),
    glsl.atan(1, x),
    glsl.clamp(x, 0, 1),
    x.step(0.5),
    x.sinh().round(),
    x.radians(),
    x.lt(2).not(),
    glsl.max(...[x, 1, 2]),
    x.scale(2),
  ]
  const vectors: Vec3[] = [
    x.pow(p),
    p.pow(x),
    p.atan(),
    p.atan(x),
    glsl.atan(p, 1),
    glsl.clamp(p, 0, p),
    x.smoothstep(1, p),
    p.gt(0).and(x.lt(2)).ifElse(p, 1),
    p.not(),
    glsl.mix(0, p, x),
    x.mix(p, 0.5),
    glsl.ifElse(x.gt(0), p, 0),
    x.vecIfElse(p, p),
    glsl.vecSum(p, p, p),
    p.prod(p, 2),
    p.degrees(),
  ]
  // @ts-expect-error a number is expected, not a vector
  const number: Scalar = glsl.sin(p)
  // @ts-expect-error a vector is expected, not a number
  const vector: Vec3 = glsl.pow(x, 2)
  // @ts-expect-error two sizes
  glsl.pow(p, q)
  // @ts-expect-error vectors of two sizes, although x is a number
  x.clamp(p, q)
  // @ts-expect-error one operand too many
  x.pow(2, 3)
  // @ts-expect-error one operand too few
  glsl.mod(x)
  // @ts-expect-error atan takes at most two operands
  glsl.atan(x, 1, 2)
  // @ts-expect-error no such operation
  x.sine()
  return { y: glsl.sum(...numbers), z: glsl.sum(...vectors), number, vector }
})

// The type of a vector depends on its size; its components can be read in any order.
compile((glsl) => {
  const [x, p, q, c] = [
    glsl.param('x'),
    glsl.vec3Param('p'),
    glsl.vec2Param('q'),
    glsl.vec4Param('c'),
  ]
  const numbers: Scalar[] = [p.dot(p), q.length(), glsl.dist(p, p), c.a(), p.b(), q.t(), q.v()]
  const vectors: Vec3[] = [p.zyx(), q.xxy(), c.rgb(), p.xy().ttt(), p.cross(p), p.reflect(p)]
  const four: Vec4 = glsl.vec4(q, p.xx()).add(q.xyxy())
  const bent: Vec2 = glsl.refract(q, q.normalize(), 1.5).faceforward(q, q)
  // @ts-expect-error a cross product needs two vec3s
  q.cross(q)
  // @ts-expect-error the same with glsl.cross
  glsl.cross(p, q)
  // @ts-expect-error a number has no length
  x.length()
  // @ts-expect-error two sizes
  p.dot(q)
  // @ts-expect-error a number is no direction
  p.reflect(1)
  // @ts-expect-error the ratio is one number
  glsl.refract(p, p, p)
  // @ts-expect-error no fourth component
  p.w()
  // @ts-expect-error letters of two sets
  p.xg()
  return { n: numbers[0]!, v: vectors[0]!, four, bent }
})

// Matrices have only the operations that apply to them.
compile((glsl) => {
  const [x, p, q] = [glsl.param('x'), glsl.vec3Param('p'), glsl.vec2Param('q')]
  const [m, n]: [Mat3, Mat2] = [glsl.mat3Param('m'), glsl.mat2(1, 2, 3, 4)]
  const same: Mat3[] = [
    glsl.mat3(p, p, p),
    glsl.mat3(...[p, p, p]),
    glsl.mat3(1),
    glsl.mat3(n),
    glsl.mat3Rows(p, p, p),
    m.mult(m),
    m.mult(m, 2, m),
    m.mult(2),
    x.mult(m),
    glsl.mult(2, m, m),
    m.add(m, 1).sub(m).neg().div(2, x),
    glsl.div(m, 2),
    m.mix(m, x),
    x.gt(0).ifElse(m, m),
    m.transpose().inverse().scale(2),
    glsl.inverse(m),
    x.rotateX().mult(glsl.rotate(p, 0.5)),
    p.rotate(1),
    m.derivative(x),
  ]
  const vectors: Vec3[] = [
    m.mult(p),
    m.mult(m, p),
    p.mult(m),
    p.mult(m, 2, p),
    glsl.mult(m, p),
    glsl.mult(p, m),
    x.mult(m, p),
    m.column(0),
    glsl.row(m, 2),
  ]
  const numbers: Scalar[] = [m.determinant(), glsl.determinant(n)]
  // @ts-expect-error two sizes
  m.mult(n)
  // @ts-expect-error a vector of another size
  m.mult(q)
  // @ts-expect-error a row of another size
  q.mult(m)
  // @ts-expect-error a vector of another size
  glsl.mult(m, q)
  // @ts-expect-error a row of another size
  glsl.mult(q, m)
  // @ts-expect-error matrices of two sizes
  glsl.mult(m, n)
  // @ts-expect-error a matrix is no divisor
  glsl.div(2, m)
  // @ts-expect-error the same with the method
  x.div(m)
  // @ts-expect-error no sine of a matrix
  m.sin()
  // @ts-expect-error the same with glsl.sin
  glsl.sin(m)
  // @ts-expect-error a vector has no inverse
  p.inverse()
  // @ts-expect-error columns of another size
  glsl.mat3(q, q, q)
  // @ts-expect-error no vector of matrices
  glsl.vec3(m)
  // @ts-expect-error the index of a column is a number, not an expression
  m.column(x)
  // @ts-expect-error a vector is no angle
  x.rotate(p)
  return { m: same[0]!, v: vectors[0]!, x: numbers[0]!, n }
})
