// Checks which uses the types of 'warpjet/deformers' allow and reject. Compiled only, never run.
import {
  add,
  bend,
  blend,
  bulge,
  chain,
  genie,
  inSpace,
  inflate,
  mask,
  melt,
  noiseDisplace,
  ripple,
  shear,
  spherify,
  stretch,
  taper,
  twist,
  wave,
  type NumberOption,
  type VectorOption,
} from '../../js-bindings/deformers.js'
import { createWarp } from '../../js-bindings/p5.js'
import { compileWarp, type OffsetFunction, type WarpInputs } from '../../js-bindings/warpjet.js'

const all: OffsetFunction[] = [
  twist({ axis: [1, 1, 0], center: [0, 0, 0], angle: Math.PI, length: 100 }),
  bend({ axis: 'z', along: 'y', angle: ({ millis }) => millis.div(1000).sin(), from: 0, to: 50 }),
  taper({ amount: ({ glsl }) => glsl.param('amount') }),
  taper({ amount: ({ uniforms }) => uniforms.amount, center: ({ uniforms }) => uniforms.middle }),
  bulge({ center: ({ glsl, mouse, size }) => glsl.vec3(mouse.sub(size.div(2)), 0), radius: 80 }),
  stretch({ amount: 1, keepVolume: true }),
  wave({ axis: 'x', direction: ({ normal }) => normal, speed: 0 }),
  ripple({ center: ({ mouseX, mouseY }) => [mouseX, mouseY, 0] }),
  melt({ ground: 50 }),
  inflate(),
  genie({ edge: 'x', neck: 0.1 }),
  spherify({ amount: () => 0.5 }),
  shear({ direction: [0, 0, 1] }),
  noiseDisplace({ seed: 3, speed: 0.5 }),
]

export const composed: OffsetFunction = chain(
  add(...all),
  blend(twist(), bend(), ({ glsl, position }) => glsl.smoothstep(10, 20, position.x())),
  mask(wave(), 0.5),
  mask(wave(), ({ color }) => color.r()),
  inSpace([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1], twist()),
  inSpace(({ glsl }) => glsl.rotateY(1), twist()),
  inSpace(({ glsl }) => glsl.mat4Param('toLocal'), twist()),
  inSpace(({ uniforms }) => uniforms.toLocal, twist()),
  ({ glsl }) => glsl.vec3(1, 2, 3),
)

compileWarp(composed)
compileWarp((inputs) => twist({ angle: inputs.millis, center: inputs.glsl.vec3(1, 2, 3) })(inputs))

// A composition with uniforms of its own.
createWarp(
  {},
  chain(twist(), ({ uniforms, glsl }: WarpInputs<{ far: number }>) =>
    glsl.vec3(uniforms.far, 0, 0),
  ),
  { uniforms: { far: 5 } },
)
createWarp({}, chain(twist({ angle: ({ uniforms }) => uniforms.angle }), bend()), {
  uniforms: { angle: 1 },
})

export const number: NumberOption = ({ millis }) => millis
export const vector: VectorOption = [1, 2, 3]

// @ts-expect-error no such option
twist({ amout: 1 })
// @ts-expect-error no such axis
twist({ axis: 'w' })
// @ts-expect-error a point has three numbers
twist({ center: [0, 0] })
// @ts-expect-error a vec3 is no angle
twist({ angle: ({ position }) => position })
// @ts-expect-error a string is not an amount
taper({ amount: '1' })
// @ts-expect-error keepVolume is true or false, not a function
stretch({ keepVolume: () => true })
// @ts-expect-error a seed is a constant
noiseDisplace({ seed: () => 1 })
// @ts-expect-error twist must be called to make an offset function
chain(twist)
// @ts-expect-error a mask has a weight
mask(twist())
// @ts-expect-error a vector is no matrix
inSpace(({ position }) => position, twist())
