// Checks which uses the types of 'warpjet' and 'warpjet/p5' allow and reject. Compiled only, never run.
import { type Loading, type WarpModel } from '../../js-bindings/p5.js'
import {
  compile,
  compileWarp,
  gen,
  type AnyMatrix,
  type Expression,
  type FunctionOptions,
  type Mat2,
  type Mat3,
  type Matrix,
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
// @ts-expect-error surfaceVariation is true or false
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
  const warpedNormal: Vec3 = p.adjustNormal(p, p)
  // @ts-expect-error a derivative is with respect to a number
  x.derivative(p)
  // @ts-expect-error only a number has a gradient
  glsl.gradient(p, p)
  // @ts-expect-error only a vector has a Jacobian
  glsl.jacobian(x, p)
  // @ts-expect-error the Jacobian of a vec3 with respect to a vec2 is no mat3
  const wrong: Mat3 = glsl.jacobian(p, q)
  // @ts-expect-error the sizes do not match
  tall.mult(tall)
  // @ts-expect-error the same with glsl.mult
  glsl.mult(tall, tall)
  // @ts-expect-error only square matrices have an inverse
  tall.inverse()
  // @ts-expect-error the position is a vec3
  glsl.adjustNormal(p, p, q)
  square.output('J')
  square.outputDeriv('dJ', x)
  return { slope, second, ascent, square, tall, v: products[2], w: parts[1], warpedNormal, wrong }
})

// Warps on the CPU.
{
  const warp = compileWarp(({ position }) => position, { tangents: true })
  const positions = new Float32Array(3)
  const moved = warp.evaluate(
    { positions, normals: [0, 1, 0] },
    { uniforms: { millis: 3, at: [1, 2] } },
  )
  const arrays: [Float32Array, Float32Array | undefined] = [moved.positions, moved.tangents]
  const point: number[] = warp.evaluateAt([1, 2, 3], { normal: [0, 1, 0], uniforms: {} }).position
  const box: { min: number[]; max: number[] } = warp.bounds({ min: [0, 0, 0], max: [1, 1, 1] })
  const folded: { mask: Uint8Array; count: number } = warp.foldover(
    { positions },
    { uniforms: { millis: 0 } },
  )
  // @ts-expect-error positions are required
  warp.evaluate({ normals: [0, 1, 0] })
  // @ts-expect-error a uniform is no string
  warp.evaluate({ positions }, { uniforms: { millis: '3' } })
  // @ts-expect-error uniforms are in the second argument
  warp.evaluate({ positions, uniforms: { millis: 3 } })
  // @ts-expect-error a box has two corners
  warp.bounds({ min: [0, 0, 0] })
  void [arrays, point, box, folded]
}

// Images.
compile((glsl) => {
  const [uv, p] = [glsl.vec2Param('uv'), glsl.vec3Param('p')]
  const options: TextureOptions = { filter: 'bspline', wrap: 'mirror' }
  const color: Vec4 = glsl.texture('heightMap', uv, options).add(glsl.texture('other', uv))
  // @ts-expect-error a point in an image has two coordinates
  glsl.texture('heightMap', p)
  // @ts-expect-error the name comes first
  glsl.texture(uv, 'heightMap')
  // @ts-expect-error no such filter
  glsl.texture('heightMap', uv, { filter: 'linear' })
  // @ts-expect-error no such option
  glsl.texture('heightMap', uv, { lod: 1 })
  return { color }
})

// Functions of the host, made by glsl.fn().
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
  // @ts-expect-error one argument too many
  bump(x, x)
  // @ts-expect-error at least one argument
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
export const flip = (matrix: AnyMatrix): AnyMatrix => matrix.transpose().neg()

// A model in a sketch. Does not extend p5's own types.
export async function load(sketch: Loading): Promise<number> {
  const model: WarpModel = await sketch.loadWarpModel('bunny.glb', { normalize: false })
  // @ts-expect-error no such option
  await sketch.loadWarpModel('bunny.glb', { size: 2 })
  const varied: WarpModel = await sketch.addSurfaceVariation(model)
  // @ts-expect-error a number is no model
  await sketch.addSurfaceVariation(varied.vertices.length)
  return model.vertices.length + (model.texture ? 1 : 0) + model.warnings.length
}

// A component is a value that can also be called. Operations have aliases.
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
