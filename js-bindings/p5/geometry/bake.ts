/**
 * Bakes warps that are called inside `buildGeometry()` or after `beginGeometry()`: p5 collects vertices there and draws nothing, so the
 * CPU moves them, with the uniforms of that call.
 */
import { arrayNames, lazily, variationNames, type Vertices } from '../../compile/hosts.js'
import { WarpError } from '../../errors/errors.js'
import {
  rendererOf,
  stateOf,
  type BuiltShape,
  type GeometryBuilder,
  type Renderer,
  type Shader,
  type Vector,
} from '../host.js'
import type { MadeWarp } from '../made-warps.js'
import type { CallValues, WarpUniforms } from '../sketch-uniforms.js'
import { variationOf } from '../variation/shape-variation.js'
import { nameOf } from '../variation/variation-buffers.js'

/** Moves the vertices of a shape; `name` is the name that p5 gave it. */
type Bake = (shape: BuiltShape, name: string) => Pick<BuiltShape, 'vertices' | 'vertexNormals'>

interface Baking {
  bake: Bake
  /** True if the warp moves vertices after the model's transforms. */
  isInWorldSpace: boolean
}

/** Maps each builder → the warps called since it was started, by the warp's shader. */
const warpsOf = new WeakMap<GeometryBuilder, Map<Shader, Baking>>()

/**
 * Applies the warp to the geometry being built, if one is being built. Called whenever a warp is applied. Throws a `WarpError` for a warp
 * that cannot be baked.
 */
export function bakeIntoGeometry(
  made: MadeWarp,
  shader: Shader,
  overrides: WarpUniforms,
  values: CallValues,
) {
  const renderer = rendererOf(made.canvas)!
  const builder = renderer.geometryBuilder
  if (!builder) return
  checkBakeable(made)
  const warps = warpsOf.get(builder) ?? watchBuilder(builder, renderer)
  warps.set(shader, {
    bake: bakeOf(made, overrides, values),
    isInWorldSpace: made.settings.space === 'world',
  })
}

function checkBakeable({ settings: { space, shader } }: MadeWarp) {
  if (space === 'camera')
    throw new WarpError(
      `buildGeometry: a warp of space: 'camera' depends on the camera, and a geometry has none; call the warp before model(…), or make it with space: 'world'.`,
    )
  if (Object.keys(shader?.hooks.modified.vertex ?? {}).length > 0)
    throw new WarpError(
      'buildGeometry: the hooks of the option "shader" run only on the GPU; call the warp before model(…), or make it without that option.',
    )
}

/** Makes the builder move the shapes that it collects while a warp is in use. */
function watchBuilder(builder: GeometryBuilder, renderer: Renderer) {
  const warps = new Map<Shader, Baking>()
  warpsOf.set(builder, warps)
  const add = builder.addGeometry.bind(builder)
  builder.addGeometry = (shape) => {
    const { userFillShader } = stateOf(renderer)
    const warp = userFillShader && warps.get(userFillShader)
    if (!warp) add(shape)
    else if (warp.isInWorldSpace) addMoved(builder, add, shape, warp.bake)
    else add({ ...shape, ...warp.bake(shape, nameOf(shape)) })
  }
  return warps
}

/** p5 transforms shapes while it collects them, so warps in world space move the vertices that p5 has added. */
function addMoved(
  { geometry }: GeometryBuilder,
  add: (shape: BuiltShape) => void,
  shape: BuiltShape,
  bake: Bake,
) {
  const countsBefore = {
    vertices: geometry.vertices.length,
    vertexNormals: geometry.vertexNormals.length,
    uvs: geometry.uvs.length,
    faces: geometry.faces.length,
    vertexColors: geometry.vertexColors.length,
  }
  add(shape)
  const { vertices, vertexNormals } = bake(
    {
      vertices: geometry.vertices.slice(countsBefore.vertices),
      vertexNormals: geometry.vertexNormals.slice(countsBefore.vertexNormals),
      uvs: geometry.uvs.slice(countsBefore.uvs) as number[],
      faces: geometry.faces
        .slice(countsBefore.faces)
        .map((face) => face.map((corner) => corner - countsBefore.vertices)),
      vertexColors: geometry.vertexColors.slice(countsBefore.vertexColors),
    },
    '',
  )
  vertices.forEach((vertex, i) => (geometry.vertices[countsBefore.vertices + i] = vertex))
  vertexNormals.forEach(
    (normal, i) => (geometry.vertexNormals[countsBefore.vertexNormals + i] = normal),
  )
}

/** Returns a copy of a vector, with other components. */
const vectorLike = (vector: Vector, x: number, y: number, z: number) =>
  Object.assign(vector.copy!(), { x, y, z })

function bakeOf(made: MadeWarp, overrides: WarpUniforms, values: CallValues): Bake {
  const { canvas, warp, settings } = made
  const cpu = lazily(() => warp.cpu())
  const undeclared = Object.entries(overrides).filter(([name]) => !warp.uniforms.declared.has(name))
  const uniforms = lazily(() => ({ ...values, instance: 0, ...Object.fromEntries(undeclared) }))
  return (shape, name) => {
    const mesh = verticesOf(shape, stateOf(rendererOf(canvas)!).curFillColor as number[])
    if (warp.varies && settings.surfaceVariation !== false) {
      const variation = variationOf(shape, name)
      for (const each of variationNames) mesh[arrayNames[each]] = variation[each]
    }
    const { positions, normals } = withBakeErrors(() =>
      cpu().evaluate(mesh, { uniforms: uniforms() as never }),
    )
    const withComponents = (vectors: Vector[], numbers: Float32Array) =>
      vectors.map((vector, i) =>
        vectorLike(vector, numbers[3 * i]!, numbers[3 * i + 1]!, numbers[3 * i + 2]!),
      )
    return {
      vertices: withComponents(shape.vertices, positions),
      vertexNormals: normals ? withComponents(shape.vertexNormals, normals) : shape.vertexNormals,
    }
  }
}

function verticesOf(shape: BuiltShape, fill: readonly number[]): Vertices {
  const { vertices, vertexNormals, vertexColors } = shape
  const count = vertices.length
  const flat = (vectors: Vector[]) => {
    const numbers = new Float32Array(3 * vectors.length)
    vectors.forEach(({ x, y, z }, i) => numbers.set([x, y, z], 3 * i))
    return numbers
  }
  const mesh: Vertices = { positions: flat(vertices) }
  if (vertexNormals.length === count) mesh.normals = flat(vertexNormals)
  const uvs = shape.uvs.flat()
  if (uvs.length === 2 * count) mesh.uvs = Float32Array.from(uvs)
  const colors = Array.from({ length: 4 * count }, (_, i) => vertexColors[i] ?? fill[i % 4]!)
  mesh.colors = Float32Array.from(colors)
  return mesh
}

function withBakeErrors<Result>(evaluate: () => Result): Result {
  try {
    return evaluate()
  } catch (error) {
    if (!(error instanceof WarpError)) throw error
    const advice = /only the GPU/.test(error.message) ? ' Call it before model(…) instead.' : ''
    throw new WarpError(error.message.replace(/^evaluate: /, 'buildGeometry: ') + advice)
  }
}
