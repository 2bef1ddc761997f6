/** The uniforms of a warp: those of the addon, which carry the inputs that change per draw call, and those of the sketch. */
import {
  drawInputs,
  lazily,
  samplingNumbers,
  samplingUniforms,
  scalarOrArray,
  type Declared,
  type FrameConstants,
  type Host,
  type HostText,
  type HostWarp,
  type Target,
} from '../compile/hosts.js'
import { WarpError } from '../errors/errors.js'
import { ownProperty } from '../options/guards.js'
import { glslType } from './hooks/styles.js'
import { sketchOf, type Canvas, type Shader, type Uniform } from './host.js'
import { samplingOf } from './sampling.js'
import { uniformsIn, type WarpSettings } from './settings.js'
import { p5Image, place, toUniformValue } from './uniform-value.js'

export const p5: Host = {
  name: 'p5.js',
  inputs: Object.keys(drawInputs) as (keyof typeof drawInputs)[],
  // The option `defs` declares parameters.
  hasParameters: true,
  prefix: 'uWarpjet',
  // The adapter reads the sampling from the p5.Texture that p5 makes of an image.
  sampling: { hasTransform: false },
}

/** Maps uniform names to values that p5's `setUniform` accepts; a p5.Vector may replace an array of numbers. */
export type WarpUniforms = Record<string, unknown>

interface Input {
  uniform: string
  read: (canvas: Canvas) => number | number[]
}

const inputs: Record<string, Input> = {
  millis: {
    uniform: 'uWarpjetMillis',
    read: (canvas) => sketchOf(canvas).millis(),
  },
  mouse: {
    uniform: 'uWarpjetMouse',
    read: (canvas) => [sketchOf(canvas).mouseX, sketchOf(canvas).mouseY],
  },
  size: {
    uniform: 'uWarpjetSize',
    read: (canvas) => [canvas.width, canvas.height],
  },
  pixelDensity: {
    uniform: 'uWarpjetPixelDensity',
    read: (canvas) => canvas.pixelDensity(),
  },
}

/** Input name → uniform name, for `compileWarp`. */
export const inputUniforms = Object.fromEntries(
  Object.entries(inputs).map(([name, { uniform }]) => [name, uniform]),
)

/** Returns the current value of each input, by name. */
export const inputsNow = (canvas: Canvas) =>
  Object.fromEntries(Object.entries(inputs).map(([name, { read }]) => [name, read(canvas)]))

/** Selects the inputs from the `uniforms` of a compiled warp, which include the sketch's own parameters. */
const inputsAmong = (read: readonly Declared[]) =>
  read.flatMap(({ name, type }) => (Object.hasOwn(inputs, name) ? { type, ...inputs[name]! } : []))

/** Returns the inputs and frame constants that the shader must declare. */
export const declaredInputs = ({ uniforms, frame }: HostText): Declared[] => [
  ...inputsAmong(uniforms).map(({ type, uniform }) => ({ type, name: uniform })),
  ...frame.map((name) => ({ type: 'vec4' as const, name })),
]

/** Returns the uniforms that the code reads and the shader must declare; in WGSL these include those of `defs`. */
export function declaredUniforms(
  { uniforms }: HostWarp,
  { parameters }: HostText,
  { defs }: WarpSettings,
  target: Target,
): Declared[] {
  const names = new Set(
    uniforms.inShader.flatMap(({ label }) => [
      label,
      `${label}Size`,
      samplingUniforms(label).settings,
    ]),
  )
  if (target === 'wgsl') for (const name of uniformsIn(defs)) names.add(name)
  return parameters.filter(({ name }) => names.has(name))
}

/**
 * Maps names to values for one call: the inputs of the canvas, and the uniforms of the option, each with the value that overrides it
 * in this call. Each value is read on first access.
 */
export type CallValues = Readonly<Record<string, number | number[]>>

export function valuesOf(
  canvas: Canvas,
  overrides: WarpUniforms,
  { uniforms }: HostWarp,
): CallValues {
  const inputReaders = Object.entries(inputs).map(
    ([name, { read }]) => [name, () => read(canvas)] as const,
  )
  const uniformReaders = [...uniforms.declared].flatMap(([name, { numbers, image }]) => {
    if (image) return []
    const overridden = Object.hasOwn(overrides, name) && uniforms.numbersFor(name, overrides[name])
    const read = () => scalarOrArray(overridden || numbers(place))
    return [[name, read] as const]
  })
  const properties = [...inputReaders, ...uniformReaders].map(([name, read]) => [
    name,
    { enumerable: true, get: lazily(read) },
  ])
  return Object.defineProperties({}, Object.fromEntries(properties) as PropertyDescriptorMap)
}

const declaration = /\buniform\s+(?:\w+p\s+)?(?:float|vec[234]|mat[234]|sampler2D)\s+[\w\s,]+;/g

/** Returns the option `defs` for `target`. In WGSL, `declaredUniforms` replaces the GLSL declarations, which become blank lines. */
export const defsFor = ({ defs }: WarpSettings, target: Target) =>
  target === 'wgsl' ? defs.replace(declaration, (text) => text.replace(/.+/g, '')) : defs

const adviceToDeclare = (name: string) =>
  `give it a value by the option { uniforms: { ${name}: 0.5 } }, and read it as uniforms.${name}`

/** Throws for a parameter that neither p5 nor `defs` declares: the shader would fail, and p5 would print all of its source. */
export function rejectUndeclared(
  { uniforms }: HostWarp,
  { parameters }: HostText,
  shader: Shader,
  ours: readonly Declared[],
  defs: string,
  target: Target,
) {
  const isWgsl = target === 'wgsl'
  const uniform = isWgsl && /\buniform\s+\w+\s+(\w+)/.exec(defs)
  if (uniform)
    throw new WarpError(
      `createWarp: on a WEBGPU canvas the option "defs" cannot declare uniforms like this; ${adviceToDeclare(uniform[1]!)}.`,
    )
  const declared = new Set(`${shader.vertSrc()} ${defs}`.match(/\w+/g))
  for (const { name } of ours) declared.add(name)
  for (const { name, type } of parameters) {
    if (/^(?!gl_)[A-Za-z_]\w*$/.test(name) && !declared.has(name))
      throw new WarpError(
        uniforms.declared.has(name)
          ? `createWarp: the warp reads "${name}" by glsl.${type === 'float' ? 'param' : `${type}Param`}; a uniform of the option "uniforms" is read as uniforms.${name}.`
          : `createWarp: the warp reads "${name}", which nothing declares; ${isWgsl ? adviceToDeclare(name) : `add the option { defs: "uniform ${glslType(type)} ${name};" }`}.`,
      )
  }
}

export function setInputs(
  shader: Shader,
  inputs: readonly Declared[],
  canvas: Canvas,
  frame: FrameConstants,
) {
  for (const { uniform, read } of inputsAmong(inputs)) shader.setUniform(uniform, read(canvas))
  for (const [name, values] of Object.entries(frame))
    if (shader.uniforms[name]) shader.setUniform(name, values)
}

/** Sets the uniforms of the option `uniforms` to their current values, or to those that override them in this call. */
function setDeclared(
  shader: Shader,
  overrides: WarpUniforms,
  { declared, labelOf }: HostWarp['uniforms'],
  values: CallValues,
) {
  for (const [name, { image }] of declared) {
    const label = labelOf(name)
    // The shader lacks uniforms that the warp never reads.
    if (!shader.uniforms[label]) continue
    if (image)
      setImage(shader, label, name, Object.hasOwn(overrides, name) ? overrides[name] : image())
    else shader.setUniform(label, values[name])
  }
}

/** Sets an image, its sampling and, in WebGL 1, its size in texels. */
function setImage(shader: Shader, label: string, name: string, image: unknown) {
  shader.setUniform(label, p5Image(name, image))
  const texture = shader.uniforms[label]!.texture!
  const { settings } = samplingUniforms(label)
  if (shader.uniforms[settings]) shader.setUniform(settings, samplingNumbers(samplingOf(texture)))
  if (shader.uniforms[`${label}Size`])
    shader.setUniform(`${label}Size`, [texture.width, texture.height])
}

/** Sets the sketch's own uniforms. The shader lacks those that `defs` declares but the warp never reads. */
export function setUniforms(
  shader: Shader,
  overrides: WarpUniforms,
  { uniforms }: HostWarp,
  { defs }: WarpSettings,
  values: CallValues,
) {
  const { declared, names } = uniforms
  setDeclared(shader, overrides, uniforms, values)
  const words = new Set(defs.match(/\w+/g))
  for (const [name, value] of Object.entries(overrides)) {
    if (declared.has(name)) continue
    const uniform = ownProperty(shader.uniforms, name) as Uniform | undefined
    if (uniform) shader.setUniform(name, toUniformValue(name, value, uniform))
    else if (!words.has(name))
      throw new WarpError(
        declared.size
          ? `The warp has no uniform "${name}"; it has ${names.join(', ')}.`
          : `The warp has no uniform "${name}"; createWarp's option "uniforms" must declare it: { uniforms: { ${name}: 0.5 } }.`,
      )
  }
}
