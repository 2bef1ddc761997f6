// Checks which uses the types of 'warpjet/glsl' allow and reject. Compiled only, never run.
import { Mesh } from 'three'
import { chain, twist } from '../../js-bindings/deformers.js'
import {
  WarpError,
  differentiate,
  exactNormals,
  glslOffset,
  wgslOffset,
  type DifferentiateOptions,
  type GlslOffset,
  type GlslOffsetOptions,
  type GlslOptions,
  type WgslOffset,
  type WgslOffsetOptions,
} from '../../js-bindings/glsl.js'
import { warp as warpThree } from '../../js-bindings/three.js'
import {
  compileWarp,
  type Mat3,
  type OffsetFunction,
  type Scalar,
  type Target,
  type Vec3,
} from '../../js-bindings/warpjet.js'

// A GlslOffset is accepted wherever an offset function is.
const offsetOptions: GlslOffsetOptions = {
  function: 'moved',
  maxIterations: 64,
  returns: 'position',
}
const waves: GlslOffset = glslOffset('vec3 offset(vec3 p) { return p; }')
export const sameWaves: OffsetFunction = waves
const moved = glslOffset('vec3 moved(vec3 p) { return p; }', offsetOptions)
compileWarp(waves, { target: 'wgsl', uniforms: { amount: 0.5, many: 3, isOn: true } })
compileWarp(chain(moved, twist()))
warpThree(new Mesh(), waves, { uniforms: { amount: 0.5 } })
export const read: string[] = compileWarp(waves).uniforms.map(({ name, type }) => `${type} ${name}`)
// Its uniforms can be declared.
const needing: OffsetFunction<{ amount: number }> = glslOffset<{ amount: number }>('…')
compileWarp(needing, { uniforms: { amount: 1 } })

const wgslOptions: WgslOffsetOptions = offsetOptions
export const ridges: WgslOffset = wgslOffset(
  'fn offset(p: vec3f) -> vec3f { return p; }',
  wgslOptions,
)
differentiate('fn f(x: f32) -> f32 { return x; }', { language: 'wgsl' })
// @ts-expect-error no such language
differentiate('', { language: 'hlsl' })
// @ts-expect-error source is required
wgslOffset()

// @ts-expect-error source is required
glslOffset()
// @ts-expect-error a number is not source
glslOffset(5)
// @ts-expect-error no such result
glslOffset('', { returns: 'normal' })
// @ts-expect-error no such option
glslOffset('', { name: 'offset' })
// @ts-expect-error maxIterations is a number
glslOffset('', { maxIterations: '8' })

// differentiate() returns source.
const derivativeOptions: DifferentiateOptions = {
  function: 'map',
  by: 'p',
  target: 'glsl100',
  name: 'mapSlope',
  maxIterations: 8,
}
const target: Target = 'wgsl'
export const texts: string[] = [
  differentiate('float map(vec3 p) { return p.x; }'),
  differentiate('…', derivativeOptions),
  differentiate('…', { target }),
]
// @ts-expect-error no such language
differentiate('', { target: 'hlsl' })
// @ts-expect-error the variable is named, not numbered
differentiate('', { by: 0 })
// @ts-expect-error only an offset can return a position
differentiate('', { returns: 'position' })
export const shared: GlslOptions = { function: 'map', maxIterations: 3 }

// exactNormals() preserves the type of a shader.
const shader = { setUniform: (name: string, value: number) => [name, value] }
exactNormals(shader).setUniform('amount', 1)
exactNormals(shader, { maxIterations: 1000 })
// @ts-expect-error there is no such option in p5
exactNormals(shader, { normals: 'pixel' })
// @ts-expect-error no shader
exactNormals('shader')
// @ts-expect-error a shader is needed
exactNormals()

// glsl.source() makes functions of numbers, vectors and matrices.
compileWarp(({ glsl, position, millis, uniforms }) => {
  const ripple = glsl.source('float ripple(vec2 p, float t) { return p.x * t; }', { uniforms })
  const height: Scalar = ripple(position.xy(), millis).mult(2)
  const noise = glsl.source<Vec3>('vec3 noise(vec3 p) { return p; }', {
    function: 'noise',
    maxIterations: 5,
  })
  const flow: Vec3 = noise(position.mult(3))
  const turn = glsl.source<Mat3>('mat3 turn(mat3 m, float a, int n, bool b) { return m; }')
  const matrix: Mat3 = turn(glsl.rotateX(1), 0.5, 3, millis.gt(2))
  // @ts-expect-error a single number has no components
  ripple(1, 2).yz()
  // @ts-expect-error no such option
  glsl.source('', { target: 'wgsl' })
  // @ts-expect-error source is required
  glsl.source()
  // @ts-expect-error a string is not an operand
  noise('position')
  return matrix.mult(flow.mult(height))
})

export const isWrong = (error: unknown): error is WarpError => error instanceof WarpError
