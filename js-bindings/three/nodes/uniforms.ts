// The uniforms of a warp as nodes of three.js: their values in this frame and, for velocities, in the previous one.
import { Matrix3, Matrix4, Vector2, Vector3, Vector4, type Texture } from 'three'
import { shaderNames } from '../../compile/hosts.js'
import { fillOf } from '../surface.js'
import type { ThreeWarp } from '../three-warp.js'
import { valueNow } from '../uniforms.js'
import { tsl, type AnyNode, type Frame } from './tsl.js'

/** Maps the name of a parameter → its node. */
export type NodesByName = Readonly<Record<string, AnyNode>>

const zeros: Record<string, () => object | number> = {
  float: () => 0,
  vec2: () => new Vector2(),
  vec3: () => new Vector3(),
  vec4: () => new Vector4(),
  mat3: () => new Matrix3(),
  mat4: () => new Matrix4(),
}

type Numbers = number | readonly number[]

interface NumberUniform {
  name: string
  type: string
  read: () => Numbers
}

const numberUniforms = (warp: ThreeWarp): NumberUniform[] => [
  { name: shaderNames.millis, type: 'float', read: () => warp.millis.value },
  { name: shaderNames.orientation, type: 'float', read: () => (warp.isMirroredNow() ? -1 : 1) },
  ...Object.keys(warp.frameNow()).map((name) => ({
    name,
    type: 'vec4',
    read: () => warp.frameNow()[name]!,
  })),
  ...warp.uniforms.inShader
    .filter(({ image }) => !image)
    .map((uniform) => ({
      name: uniform.label,
      type: uniform.type,
      read: () => valueNow(uniform) as Numbers,
    })),
]

const nodeOf = (type: string, read: (frame: Frame) => Numbers) =>
  tsl.uniform(zeros[type]!()).onObjectUpdate((frame, self) => {
    const numbers = read(frame)
    if (typeof numbers === 'number') return numbers
    ;(self.value as Vector3).fromArray(numbers as number[])
    return self.value
  })

/** Returns nodes with the values at the time of a draw call. */
export function uniformsOf(warp: ThreeWarp): NodesByName {
  return {
    ...Object.fromEntries(
      numberUniforms(warp).map(({ name, type, read }) => [name, nodeOf(type, read)]),
    ),
    warpjetColor: tsl.uniform(new Vector4()).onObjectUpdate(({ object }, self) => {
      ;(self.value as Vector4).fromArray(fillOf(object.material))
      return self.value
    }),
    ...Object.fromEntries(
      warp.uniforms.inShader
        .filter(({ image }) => image)
        .map((uniform) => [uniform.label, imageOf(() => valueNow(uniform) as Texture)]),
    ),
  }
}

/** Returns nodes of the numbers' values in the previous frame; in the first frame, of their current values. */
export function previousUniformsOf(warp: ThreeWarp): NodesByName {
  const uniforms = numberUniforms(warp)
  const read = () => new Map(uniforms.map(({ name, read }) => [name, [read()].flat()]))
  const recorded = new WeakMap<Frame, { frameId: number; now: Values; before: Values }>()
  const before = (frame: Frame) => {
    const now = read()
    const last = recorded.get(frame)
    const isSameFrame = last?.frameId === frame.frameId
    const values = isSameFrame ? last!.before : (last?.now ?? now)
    recorded.set(frame, { frameId: frame.frameId, now, before: values })
    return values
  }
  return Object.fromEntries(
    uniforms.map(({ name, type }) => [
      name,
      nodeOf(type, (frame) => {
        const numbers = before(frame).get(name)!
        return type === 'float' ? numbers[0]! : numbers
      }),
    ]),
  )
}

type Values = ReadonlyMap<string, readonly number[]>

/**
 * Returns a node that can be an argument of a function. In GLSL one argument is the image and its sampler; three.js writes the image's
 * name.
 */
function imageOf(read: () => Texture): AnyNode {
  const node = tsl.texture(read()) as unknown as {
    generate: (builder: unknown, output: string) => unknown
    onObjectUpdate: (work: () => Texture) => AnyNode
  }
  const { generate } = node
  node.generate = (builder, output) =>
    generate.call(node, builder, output === 'sampler2D' ? 'texture' : output)
  return node.onObjectUpdate(read)
}
