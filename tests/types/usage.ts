// Checks which uses the shipped types allow and reject. Compiled only, never run.
import { createWarp, type Loading, type WarpModel } from '../../js-bindings/p5.js'
import {
  compile,
  compileWarp,
  gen,
  type AnyMatrix,
  type Expression,
  type FunctionOptions,
  type Mat2,
  type Mat3,
  type Mat4,
  type Matrix,
  type OffsetFunction,
  type OwnFunction,
  type Scalar,
  type TextureOptions,
  type Vec2,
  type Vec3,
  type Vec4,
  type Vector,
} from '../../js-bindings/warpjet.js'

compileWarp(({ glsl, position, normal, uv, color, millis, mouseX, size }) => {
  const t: Scalar = millis.div(1000).add(mouseX, 2)
  const v: Vec3 = position.mult(2).add(normal, t).sub(1)
  const scaled: Vec3 = t.mult(v)
  const pair: Vec2 = uv.add(size.yx()).clamp(0, 1)
  const angle: Scalar = t.atan(position.length())
  const chosen: Vec3 = t.gt(1).and(angle.lt(2)).ifElse(scaled, normal)
  const d: Vec3 = glsl.derivative(chosen, position.x())
  // @ts-expect-error a vec2 and a vec3 do not fit together
  uv.add(position)
  // @ts-expect-error strings are not operands
  t.add('1')
  // @ts-expect-error a vec2 has no z
  uv.z()
  return glsl
    .vec3(pair, color.a())
    .add(d)
    .mix(glsl.vec3(0, 0, 0), glsl.smoothstep(0, 1, t))
})

// @ts-expect-error an offset is a vec3
compileWarp(({ uv }) => uv, { target: 'glsl100' })
compileWarp(({ normal }) => normal, {
  surfaceVariation: true,
  names: { normalXGradient: 'aByX', uGradient: 'aU' },
})
// @ts-expect-error neither true nor false
compileWarp(({ normal }) => normal, { surfaceVariation: 'yes' })
// @ts-expect-error no such target
compileWarp(({ position }) => position, { target: 'hlsl' })

const { code, stats } = compile((glsl) => ({ y: glsl.sin(glsl.param('x')), two: 2 }))
export const text: string = code + stats.nodes

gen(
  (ad) => {
    const x = ad.param('x')
    ad.sum(x, 1).output('y')
    ad.vecMix(ad.vec2(x, 1), ad.vec2(0, 1), 0.5).outputDeriv('dy', x)
  },
  { debug: true, maxDepthPerVariable: 4 },
)

// Operations by component return a number for numbers, otherwise the type of the vectors.
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
  // @ts-expect-error two sizes, beside a number
  x.clamp(p, q)
  // @ts-expect-error one operand too many
  x.pow(2, 3)
  // @ts-expect-error one too few
  glsl.mod(x)
  // @ts-expect-error atan takes two at most
  glsl.atan(x, 1, 2)
  // @ts-expect-error no such operation
  x.sine()
  return { y: glsl.sum(...numbers), z: glsl.sum(...vectors), number, vector }
})

// Vectors have different types by size, and components in any order.
compile((glsl) => {
  const [x, p, q, c] = [
    glsl.param('x'),
    glsl.vec3Param('p'),
    glsl.vec2Param('q'),
    glsl.vec4Param('c'),
  ]
  const numbers: Scalar[] = [p.dot(p), q.length(), glsl.dist(p, p), c.a(), p.b(), q.t(), q.v()]
  const parts: Vec3[] = [p.zyx(), q.xxy(), c.rgb(), p.xy().ttt(), p.cross(p), p.reflect(p)]
  const four: Vec4 = glsl.vec4(q, p.xx()).add(q.xyxy())
  const bent: Vec2 = glsl.refract(q, q.normalize(), 1.5).faceforward(q, q)
  // @ts-expect-error a cross product is of vec3s
  q.cross(q)
  // @ts-expect-error as a function too
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
  return { n: numbers[0]!, v: parts[0]!, four, bent }
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
  // @ts-expect-error as functions too
  glsl.mult(m, q)
  // @ts-expect-error the other way round
  glsl.mult(q, m)
  // @ts-expect-error two matrices
  glsl.mult(m, n)
  // @ts-expect-error a matrix does not divide
  glsl.div(2, m)
  // @ts-expect-error nor by a method
  x.div(m)
  // @ts-expect-error no sine of a matrix
  m.sin()
  // @ts-expect-error as a function too
  glsl.sin(m)
  // @ts-expect-error a vector has no inverse
  p.inverse()
  // @ts-expect-error columns of another size
  glsl.mat3(q, q, q)
  // @ts-expect-error no vector of matrices
  glsl.vec3(m)
  // @ts-expect-error the index of a column is a number, not an expression
  m.column(x)
  // @ts-expect-error about an axis, not an angle
  x.rotate(p)
  return { m: same[0]!, v: vectors[0]!, x: numbers[0]!, n }
})

// Derivatives.
compile((glsl) => {
  const [x, p, q] = [glsl.param('x'), glsl.vec3Param('p'), glsl.vec2Param('q')]
  const slope: Scalar = x.sin().derivative(x)
  const second: Vec3 = glsl.derivative(glsl.derivative(p, p.x()), x)
  const ascent: Vec2 = glsl.gradient(q.length(), q)
  const square: Mat3 = p.sin().jacobian(p)
  const tall: Matrix<2, 3> = glsl.jacobian(p, q)
  const wide: Matrix<3, 2> = tall.transpose()
  const products: [Mat3, Mat2, Vec3, Vec2] = [
    tall.mult(wide),
    glsl.mult(wide, tall),
    tall.mult(q),
    glsl.mult(p, tall),
  ]
  const parts: [Vec3, Vec2] = [tall.column(0), tall.row(2)]
  const turned: Vec3 = p.adjustNormal(p, p)
  // @ts-expect-error by one input, not by three
  x.derivative(p)
  // @ts-expect-error a gradient is of a number
  glsl.gradient(p, p)
  // @ts-expect-error a Jacobian is of a vector
  glsl.jacobian(x, p)
  // @ts-expect-error of two sizes, so no mat3
  const wrong: Mat3 = glsl.jacobian(p, q)
  // @ts-expect-error these two do not fit
  tall.mult(tall)
  // @ts-expect-error nor as a function
  glsl.mult(tall, tall)
  // @ts-expect-error only square ones have it
  tall.inverse()
  // @ts-expect-error the position is a vec3
  glsl.adjustNormal(p, p, q)
  square.output('J')
  square.outputDeriv('dJ', x)
  return { slope, second, ascent, square, tall, v: products[2], w: parts[1], turned, wrong }
})

// Warps on the CPU.
{
  const warp = compileWarp(({ position }) => position, { tangents: true })
  const positions = new Float32Array(3)
  const moved = warp.evaluate(
    { positions, normals: [0, 1, 0] },
    { uniforms: { millis: 3, at: [1, 2] } },
  )
  const all: [Float32Array, Float32Array | undefined] = [moved.positions, moved.tangents]
  const at: number[] = warp.evaluateAt([1, 2, 3], { normal: [0, 1, 0], uniforms: {} }).position
  const box: { min: number[]; max: number[] } = warp.bounds({ min: [0, 0, 0], max: [1, 1, 1] })
  const folded: { mask: Uint8Array; count: number } = warp.foldover(
    { positions },
    { uniforms: { millis: 0 } },
  )
  // @ts-expect-error positions must be there
  warp.evaluate({ normals: [0, 1, 0] })
  // @ts-expect-error no text
  warp.evaluate({ positions }, { uniforms: { millis: '3' } })
  // @ts-expect-error beside the mesh
  warp.evaluate({ positions, uniforms: { millis: 3 } })
  // @ts-expect-error a box has two corners
  warp.bounds({ min: [0, 0, 0] })
  void [all, at, box, folded]
}

// Images.
compile((glsl) => {
  const [uv, p] = [glsl.vec2Param('uv'), glsl.vec3Param('p')]
  const options: TextureOptions = { filter: 'bspline', wrap: 'mirror' }
  const color: Vec4 = glsl.texture('heightMap', uv, options).add(glsl.texture('other', uv))
  // @ts-expect-error a place has two coordinates
  glsl.texture('heightMap', p)
  // @ts-expect-error the name comes first
  glsl.texture(uv, 'heightMap')
  // @ts-expect-error no such filter
  glsl.texture('heightMap', uv, { filter: 'linear' })
  // @ts-expect-error no such option
  glsl.texture('heightMap', uv, { lod: 1 })
  return { color }
})

// The types of uniforms follow from their values.
{
  const list: number[] = [1, 2, 3]
  const vector = { x: 1, y: 2, z: 3, add() {} }
  const color = { setAlpha(_: number) {} }
  const declared = {
    amount: 0.5,
    on: true,
    wind: [1, 0],
    center: [0, 0, 0],
    tint: [1, 0, 0, 1],
    turn: [1, 0, 0, 0, 1, 0, 0, 0, 1],
    list,
    numbers: new Float32Array(4),
    vector,
    color,
    speed: () => 3,
    follow: () => [1, 2],
    target: () => vector,
  } as const
  const warp = compileWarp(
    ({ glsl, uniforms }) => {
      const amount: Scalar = uniforms.amount
      const [on, speed]: Scalar[] = [uniforms.on, uniforms.speed.mult(2)]
      const wind: Vec2 = uniforms.wind.add(uniforms.follow)
      const center: Vec3 = uniforms.center.add(uniforms.vector, uniforms.target)
      const tint: Vec4 = uniforms.tint.add(uniforms.color)
      const turn: Mat3 = uniforms.turn
      // TypeScript does not know the lengths of these.
      const any: (Vector | Mat3 | Mat4)[] = [uniforms.list, uniforms.numbers]
      // @ts-expect-error a number has no components
      uniforms.amount.x()
      // @ts-expect-error two numbers are no vec3
      uniforms.follow.z()
      // @ts-expect-error nothing declares it
      uniforms.amont
      void [on, any]
      return turn.mult(center).add(glsl.vec3(wind, amount.add(speed, tint.w())))
    },
    {
      uniforms: {
        ...declared,
        wind: [1, 0],
        follow: () => [1, 2],
        turn: [1, 0, 0, 0, 1, 0, 0, 0, 1],
      },
    },
  )
  warp.evaluate({ positions: list }, { uniforms: { amount: 2, wind: [0, 1] } })
  // @ts-expect-error a string is not a value of a uniform
  compileWarp(({ position }) => position, { uniforms: { name: 'red' } })
  // @ts-expect-error there are no uniforms without the option
  compileWarp(({ position, uniforms }) => position.mult(uniforms.amount))

  const twist: OffsetFunction<{ amount: number }> = ({ position, uniforms }) =>
    position.mult(uniforms.amount)
  const still: OffsetFunction = ({ position }) => position.mult(0)
  const distort = createWarp({}, twist, { uniforms: { amount: 0.5, at: [1, 2, 3] }, defs: '' })
  distort({ amount: 2, at: list, more: 'of defs' })
  distort()
  createWarp({}, still, { uniforms: { amount: 0.5 } })({ amount: 1 })
  createWarp({}, still)({ anything: 1 })
  // @ts-expect-error a number
  distort({ amount: [1] })
  // @ts-expect-error no number
  distort({ at: 1 })
  // @ts-expect-error the warp reads "amount"
  createWarp({}, twist, { uniforms: { at: 1 } })
}

// An image among the uniforms.
{
  const [image, graphics] = [
    { width: 3, height: 2, pixels: [1] },
    { width: 3, height: 2 },
  ]
  const distort = createWarp(
    {},
    ({ glsl, uv, uniforms }) =>
      glsl
        .texture(uniforms.picture, uv)
        .rgb()
        .add(glsl.texture(uniforms.layer, uv).rgb())
        .mult(uniforms.amount),
    { uniforms: { picture: image, layer: () => graphics, amount: 2 } },
  )
  distort({ picture: graphics })
  // @ts-expect-error an image
  distort({ picture: 3 })
}

// Functions of the host.
compile((glsl) => {
  const [x, p, q] = [glsl.param('x'), glsl.vec3Param('p'), glsl.vec2Param('q')]
  const bump: OwnFunction<1> = glsl.fn({
    name: 'bump',
    source: { glsl: 'float bump(float x) { return exp(-x * x); }' },
    arity: 1,
    derivatives: [(x) => x.mult(-2).mult(bump(x))],
  })
  const square = glsl.fn({
    name: 'square',
    source: 'float square(float x) { return x * x; }',
    arity: 1,
    derivatives: [(x) => x.mult(2)],
  })
  const blend = glsl.fn({
    name: 'blend',
    source: 'float blend(float x, float y) { return x + y; }',
    arity: 2,
    derivatives: [1, (x, y) => bump(x.sub(y))],
  })
  const declared: FunctionOptions<1> = { name: 'f', source: '', arity: 1, derivatives: [bump] }
  const number: Scalar = blend(x, 2)
  const vector: Vec3 = blend(p, x).add(glsl.fn(declared)(p), square(p))
  // @ts-expect-error two sizes
  blend(p, q)
  // @ts-expect-error one argument too few
  blend(x)
  // @ts-expect-error one too many
  bump(x, x)
  // @ts-expect-error without arguments there is nothing to derive
  glsl.fn({ name: 'f', source: '', arity: 0 })
  // @ts-expect-error at most 16 arguments
  glsl.fn({ name: 'f', source: '', arity: 17 })
  // @ts-expect-error one derivative for each argument
  glsl.fn({ name: 'f', source: '', arity: 2, derivatives: [1] })
  // @ts-expect-error no such language
  glsl.fn({ name: 'f', source: { hlsl: '' }, arity: 1 })
  // @ts-expect-error the source is needed
  glsl.fn({ name: 'f', arity: 1 })
  // @ts-expect-error no such option
  glsl.fn({ name: 'f', source: '', arity: 1, derivative: [1] })
  return { number, vector }
})

// User functions can accept more than one type.
export function wave<Value extends Scalar | Vec3>(value: Value, amount: number): Expression {
  return value.sin().mult(amount)
}
export const doubled = (vector: Vector): Vector => vector.mult(2).normalize()
export const flipped = (matrix: AnyMatrix): AnyMatrix => matrix.transpose().neg()

// A model in a sketch. Does not extend p5's own types.
export async function load(sketch: Loading): Promise<number> {
  const model: WarpModel = await sketch.loadWarpModel('bunny.glb', { normalize: false })
  // @ts-expect-error no such option
  await sketch.loadWarpModel('bunny.glb', { size: 2 })
  const told: WarpModel = await sketch.addSurfaceVariation(model)
  // @ts-expect-error no shape
  await sketch.addSurfaceVariation(told.vertices.length)
  return model.vertices.length + (model.texture ? 1 : 0) + model.warnings.length
}

// A component is a value that can also be called; aliases exist.
compileWarp(({ glsl, position, uv }) => {
  const y: Scalar = position.y.mul(2).oneMinus().saturate()
  const pair: Vec2 = position.zx.add(uv.yx(), position.y())
  const v: Vec3 = position.times(2).negate().pow2()
  const square: Scalar = position.magSq()
  const scaled: Vec3 = position.copy().mult(0.5, y, 0).rem(1, 2, 3).limit(2).setMag(y)
  const angle: Scalar = position.heading().add(position.angleBetween(scaled), position.dot(1, 2, 3))
  const turned: Vec2 = uv.rotate(angle).lerp(1, 2, 0.5).mod(1, 2)
  const [first]: Scalar[] = turned.array()
  const far: Scalar = scaled.dist(1, y, 3).add(scaled.cross(0, 1, 0).length(), first!)
  const low: Scalar = glsl.lerp(y, 1, 0.5)
  const high: Scalar = glsl.oneMinus(low)
  // @ts-expect-error a vec2 has no z
  uv.z.add(1)
  return v.add(glsl.vec3(pair, high.add(square, far)))
})
