// The values of uniform nodes in the frame before, for velocities.
import type { Object3D } from 'three'
import { tsl, type AnyNode, type Frame } from '../tsl.js'
import type { NodesByName } from '../uniforms.js'

type Value = number | { clone(): Value; copy(value: Value): Value }

interface UniformNode extends AnyNode {
  isUniformNode?: boolean
  isBufferNode?: boolean
  value: unknown
}

const isCopied = (value: unknown): value is Exclude<Value, number> =>
  typeof (value as { clone?: unknown } | null)?.clone === 'function'

const copyOf = (value: Value): Value => (isCopied(value) ? value.clone() : value)

/** Maps a uniform node → the node of its value in the frame before. */
const known = new WeakMap<AnyNode, AnyNode>()

/** Returns the nodes, with uniforms replaced by their previous values. Other nodes count as constant in time. */
export const previousValues = (now: NodesByName): NodesByName =>
  Object.fromEntries(Object.entries(now).map(([name, node]) => [name, previousOf(node)]))

function previousOf(node: AnyNode): AnyNode {
  const { isUniformNode, isBufferNode, value } = node as UniformNode
  const isNumbers = typeof value === 'number' || isCopied(value)
  if (!isUniformNode || isBufferNode || !isNumbers) return node
  let made = known.get(node)
  if (!made) known.set(node, (made = makePrevious(node as UniformNode)))
  return made
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
