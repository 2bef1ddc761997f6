// The values of uniform nodes in the previous frame, for velocities.
import type { Object3D } from 'three'
import { tsl, type AnyNode, type Frame } from '../tsl.js'
import type { NodesByName } from '../uniforms.js'

type Value = number | { clone(): Value; copy(value: Value): Value }

interface UniformNode extends AnyNode {
  isUniformNode?: boolean
  isBufferNode?: boolean
  value: unknown
}

const isCloneable = (value: unknown): value is Exclude<Value, number> =>
  typeof (value as { clone?: unknown } | null)?.clone === 'function'

const copyOf = (value: Value): Value => (isCloneable(value) ? value.clone() : value)

/** Maps a uniform node → the node of its value in the previous frame. */
const previousNodes = new WeakMap<AnyNode, AnyNode>()

/** Returns the nodes, with uniforms replaced by their previous values. Other nodes count as constant in time. */
export const previousValues = (now: NodesByName): NodesByName =>
  Object.fromEntries(Object.entries(now).map(([name, node]) => [name, previousOf(node)]))

function previousOf(node: AnyNode): AnyNode {
  const { isUniformNode, isBufferNode, value } = node as UniformNode
  const canRecord = typeof value === 'number' || isCloneable(value)
  if (!isUniformNode || isBufferNode || !canRecord) return node
  let previous = previousNodes.get(node)
  if (!previous) previousNodes.set(node, (previous = makePrevious(node as UniformNode)))
  return previous
}

interface Recorded {
  frameId: number
  now: Value
  before: Value
}

/** Records the values per object, since a value can depend on the object, as its world matrix does. */
function makePrevious(node: UniformNode): AnyNode {
  const recorded = new WeakMap<Object3D, Recorded>()
  return tsl.uniform(copyOf(node.value as Value)).onObjectUpdate(({ frameId, object }: Frame) => {
    const last = recorded.get(object)
    if (last?.frameId === frameId) return last.before
    const now = copyOf(node.value as Value)
    const before = last?.now ?? now
    recorded.set(object, { frameId, now, before })
    return before
  })
}
