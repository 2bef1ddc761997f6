// What the shipped types must allow and refuse; only checked, never run.
import {
  compile,
  compileWarp,
  gen,
  type Scalar,
  type Vec2,
  type Vec3,
} from '../../js-bindings/index.js'

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
  // @ts-expect-error texts are no operands
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
