// A warp and three sets of named expressions with everything that the languages write differently, for the golden files.
import { compile, compileWarp, targets } from '../../dist/warpjet.js'

const turnOffset = ({ glsl, position, normal, millis }) => {
  const spin = glsl.rotate(glsl.vec3(0.2, 1, 0), position.y().add(millis.div(1000)))
  const ridge = position.x().mod(0.5).sub(0.25).abs().tanh().add(position.z().round())
  return spin
    .mult(position)
    .sub(position)
    .add(normal.scale(ridge.mult(0.2)))
}

const pieces = (glsl) => {
  const [x, v, m] = [glsl.param('x'), glsl.vec2Param('v'), glsl.mat2Param('m')]
  const bump = glsl.fn({
    name: 'bump',
    arity: 1,
    source: {
      glsl: 'float bump(float x) { return exp(-x * x); }',
      wgsl: 'fn bump(x: f32) -> f32 { return exp(-x * x); }',
    },
    derivatives: [(x) => x.mult(-2).mult(bump(x))],
  })
  const inside = x.gt(-1).and(x.lt(1), v.x().ne(0)).or(x.eq(2))
  return {
    inside,
    rounded: x.round().add(x.trunc(), x.ceil(), x.sign()),
    curve: x.sinh().div(x.cosh()).add(x.asinh()).sub(glsl.atan(v.y(), v.x())),
    slope: glsl.derivative(bump(x.mult(3)).add(v.length()), x),
    chosen: inside.ifElse(v, v.yx().inversesqrt()),
    back: m.inverse().mult(v),
    jacobian: glsl.jacobian(v.mult(v.x()).mod(x), v),
  }
}

const images = (glsl) => {
  const uv = glsl.vec2Param('uv')
  const height = glsl.texture('heightMap', uv).r()
  return {
    height,
    slope: glsl.gradient(height, uv),
    color: glsl.texture('picture', uv.add(height), { filter: 'bspline', wrap: 'mirror' }),
  }
}

const loops = (glsl) => {
  const [x, v] = [glsl.param('x'), glsl.vec2Param('v')]
  const sum = glsl.repeat(3, 0, (outer, i) =>
    glsl.repeat(4, outer, (inner, k) => inner.add(v.x().mult(i).add(v.y().mult(k)).sin().mult(x))),
  )
  return { sum, slope: glsl.gradient(sum, v), octaves: v.fbm({ octaves: 3 }) }
}

/** Generates the code of the warp and of the expressions in each language. Maps the name of a golden file → its code. */
export const languageTexts = () =>
  Object.fromEntries(
    targets.flatMap((target) => {
      const ending = target === 'wgsl' ? 'wgsl' : `${target}.glsl`
      const { declarations, code } = compile(pieces, { target })
      const image = compile(images, { target })
      const loop = compile(loops, { target })
      return [
        [`language-loops.${ending}`, loop.declarations + loop.code],
        [`language-images.${ending}`, image.declarations + image.code],
        [`language-warp.${ending}`, compileWarp(turnOffset, { target }).code],
        [`language-pieces.${ending}`, declarations + code],
      ]
    }),
  )
