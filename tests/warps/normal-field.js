// Defines how normals vary around the vertices of the tests: as if each vertex were on a sphere of its own, as large as the mesh. Around a
// vertex, the normal is a linear function of the position.
import { add, dot, normalize, subtract } from '../support/browser/matrix.js'

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]

/** Returns the gradients of x, y and z of the normal, by the names of the shader's attributes. */
export function normalGradients(normal, size) {
  const unit = normal.some(Boolean) ? normalize(normal) : [0, 0, 0]
  const scale = Math.hypot(...normal) / size
  const [normalXGradient, normalYGradient, normalZGradient] = axes.map((axis, i) =>
    axis.map((x, k) => scale * (x - unit[i] * unit[k])),
  )
  return { normalXGradient, normalYGradient, normalZGradient }
}

/** Returns the normal at `p` near a vertex; that of the vertex itself if its surroundings are unknown. */
export function normalAt(p, vertex) {
  const { position, normal, normalXGradient, normalYGradient, normalZGradient } = vertex
  if (!normalXGradient) return normal
  const step = subtract(p, position)
  const change = [
    dot(normalXGradient, step),
    dot(normalYGradient, step),
    dot(normalZGradient, step),
  ]
  return add(normal, change)
}
