// Reads the displacement that a vertex shader computes, as a warp.
import type { IUniform } from 'three'
import { markLibraryFunction } from '../../errors/operators.js'
import type { External } from '../../glsl-source/listing.js'
import { readOffset } from '../../glsl-source/offset.js'
import { Place } from '../../options/place.js'
import type { Settings, WarpSpace } from '../settings.js'
import { ThreeWarp } from '../three-warp.js'
import { three } from '../values.js'
import { withNamesOfShader } from './exact-names.js'
import { movedFunction } from './position-code.js'
import type { ExactShader } from './shader.js'
import { makeVertexSource } from './vertex-source.js'

/** A variable of the shader that the displacement reads, and whose value the CPU does not know. */
export interface Parameter {
  name: string
  type: string
  isAttribute: boolean
}

export interface Displacement {
  warp: ThreeWarp
  parameters: readonly Parameter[]
  /** The message about statements of the shader that are ignored, if there are any. */
  note: string | undefined
  /** The message about a loop that is cut off before its end, if there is one. */
  cutOff: string | undefined
}

/** A warp made of the displacement of a shader. It cannot be evaluated on the CPU if it reads variables that only the shader has. */
class DisplacementWarp extends ThreeWarp {
  parameters: readonly Parameter[] = []

  override get canRunOnCpu() {
    return this.parameters.length === 0 && super.canRunOnCpu
  }

  override get mirrors() {
    return this.parameters.length === 0 ? super.mirrors : false
  }
}

export interface ExactSettings extends Pick<Settings, 'method' | 'normals' | 'surfaceVariation'> {
  /** The option, or `untilEnd`. */
  maxIterations: number
}

/** Returns the displacement of a shader. `values` has values on the CPU for variables that are not in `shader.uniforms`. */
export function readDisplacement(
  shader: ExactShader,
  { maxIterations, ...settings }: ExactSettings,
  space: WarpSpace,
  values: Record<string, () => unknown> = {},
  material: object = {},
): Displacement {
  const { text, attributes, note } = makeVertexSource(shader)
  const { offset, externals, cutOff } = readOffset(new Place(settings.method), 'glsl', text, {
    function: movedFunction,
    returns: 'position',
    maxIterations,
  })
  const uniforms: Record<string, () => unknown> = {}
  for (const external of externals) {
    const value = values[external.name] ?? valueOf(shader.uniforms, external, attributes, material)
    if (value) uniforms[external.name] = value
  }
  const warp = new DisplacementWarp(
    // Passes only these inputs: in a shader, millis, size and instance may be variables of the user.
    markLibraryFunction(({ glsl, position, normal, uv, uniforms }) =>
      offset({ glsl, position, normal, uv, uniforms } as never),
    ),
    { ...settings, space, uniforms, fadeNoise: false, isShared: false },
    new Map(),
  )
  const namesRead = warp.namesRead()
  const inputs = new Set(['position', 'normal', 'uv'])
  warp.parameters = externals
    .filter(
      ({ name, type, isRead }) =>
        !inputs.has(name) && !uniforms[name] && (isSampler(type) ? isRead : namesRead.has(name)),
    )
    .map(({ name, type }) => ({
      name: withNamesOfShader(name),
      type,
      isAttribute: attributes.has(withNamesOfShader(name)) || name.startsWith('gl_'),
    }))
  return {
    warp,
    parameters: warp.parameters,
    note,
    cutOff: cutOff && `has normals as if a loop ended early: ${withNamesOfShader(cutOff)}`,
  }
}

const isSampler = (type: string) => /sampler/i.test(type)

/** Returns a function that returns the current value of a uniform; `undefined` if the shader has no usable value. */
function valueOf(
  uniforms: Record<string, IUniform>,
  { name, shape, type }: External,
  attributes: ReadonlySet<string>,
  material: object,
): (() => unknown) | undefined {
  const [root = '', ...path] = withNamesOfShader(name).match(/\w+/g) ?? []
  if (!uniforms[root] || attributes.has(root)) return undefined
  // Three.js sets its own uniforms to properties of the material after the shader is compiled.
  const rootValue = () => uniforms[root]?.value ?? (material as Record<string, unknown>)[root]
  const read = () => path.reduce<unknown>((value, part) => partOf(value, part, shape), rootValue())
  let last = read()
  if (!isUsable(last, type, shape)) return undefined
  // An error here would be thrown by `render()`, so a value of another kind, such as a missing texture, is ignored.
  return () => {
    const current = read()
    if (isUsable(current, type, shape)) last = current
    return last
  }
}

/** Returns an element of an array or a member of a structure. An array of vectors may be a flat list of their components. */
function partOf(value: unknown, part: string, [columns, rows]: readonly [number, number]) {
  const list = value as ArrayLike<number> | undefined
  const size = columns * rows
  const start = Number(part) * size
  return size > 1 && typeof list?.[0] === 'number' && start >= 0
    ? Array.from({ length: size }, (_, i) => list[start + i])
    : (value as Record<string, unknown> | undefined)?.[part]
}

function isUsable(value: unknown, type: string, [columns, rows]: readonly [number, number]) {
  if (isSampler(type)) return type === 'sampler2D' && three.values!.isImage(value)
  if (typeof value === 'boolean') return type === 'bool'
  const numbers = [three.values!.toNumbers(value)].flat() as unknown[]
  const components = ArrayBuffer.isView(numbers[0]) ? [...(numbers[0] as Float32Array)] : numbers
  return (
    components.length === columns * rows && components.every((each) => typeof each === 'number')
  )
}
