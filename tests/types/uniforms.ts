// Checks which values of uniforms the types allow and reject. Compiled only, never run.
import { createWarp } from '../../js-bindings/p5.js'
import {
  compileWarp,
  type Mat3,
  type Mat4,
  type OffsetFunction,
  type Scalar,
  type Vec2,
  type Vec3,
  type Vec4,
  type Vector,
} from '../../js-bindings/warpjet.js'

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
      // TypeScript does not know the lengths of these arrays.
      const any: (Vector | Mat3 | Mat4)[] = [uniforms.list, uniforms.numbers]
      // @ts-expect-error a number has no components
      uniforms.amount.x()
      // @ts-expect-error two numbers are no vec3
      uniforms.follow.z()
      // @ts-expect-error nothing declares "amont"
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
  // @ts-expect-error the value of amount is a number
  distort({ amount: [1] })
  // @ts-expect-error the value of at is three numbers
  distort({ at: 1 })
  // @ts-expect-error the warp reads "amount"
  createWarp({}, twist, { uniforms: { at: 1 } })
}

// A uniform can be an image.
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
  // @ts-expect-error the value of picture is an image
  distort({ picture: 3 })
}
