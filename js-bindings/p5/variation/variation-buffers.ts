/**
 * Passes the gradients of shapes to p5 as vertex attributes. A p5.Geometry has the gradients as arrays next to its vertices, computed on
 * first use. Each renderer that draws with a warp that reads gradients has buffers for them.
 */
import { variationAttribute, variationNames, type VariationInput } from '../../compile/hosts.js'
import { immediateShape, type Renderer, type Shader, type Shape } from '../host.js'
import { variationOf, type Variation } from './shape-variation.js'

type Drawn = Shape & { dirtyFlags: Record<string, boolean | undefined> }

/** Returns the name of the array of a p5.Geometry for a gradient. */
const arrayName = (name: string) => `warpjet_${name}`

/** The gradients of each shape, and the names of the arrays that p5 has read. */
const variations = new WeakMap<Drawn, { variation: Variation; readNames: Set<string> }>()

function arrayOf(shape: Drawn, name: VariationInput): Float32Array {
  if (shape.gid === immediateShape) return new Float32Array(3 * shape.vertices.length)
  let cached = variations.get(shape)
  // p5 reads the array again after the shape has changed.
  const isStale = cached?.readNames.has(name) && shape.dirtyFlags[arrayName(name)] !== false
  if (!cached || isStale)
    variations.set(
      shape,
      (cached = { variation: variationOf(shape, nameOf(shape)), readNames: new Set() }),
    )
  cached.readNames.add(name)
  return cached.variation[name]
}

/** Defines the arrays as getters of the class p5.Geometry. */
export function defineVariationArrays(geometry: { prototype: object } | undefined) {
  if (!geometry) return
  for (const name of variationNames)
    Object.defineProperty(geometry.prototype, arrayName(name), {
      configurable: true,
      get(this: Drawn) {
        return arrayOf(this, name)
      },
    })
}

/** Renderers that map names to shapes (p5 1.11). Shared by all scripts of the page, each of which may contain a copy of this file. */
const renderersWithNames = ((globalThis as Record<symbol, unknown>)[
  Symbol.for('warpjet.renderers')
] ??= []) as WeakRef<Renderer>[]

/** Returns p5's name of a shape. On 1.11 a shape doesn't have its name; renderers map names to shapes. */
export const nameOf = (shape: Shape): string =>
  shape.gid ||
  (renderersWithNames
    .flatMap((reference) => Object.entries(reference.deref()?.retainedMode?.geometry ?? {}))
    .find(([, { model }]) => model === shape)?.[0] ??
    '')

/** Adds buffers of gradients to a renderer, before it draws with a warp that reads them. */
export function prepareBuffers(renderer: Renderer) {
  const buffers = renderer.buffers?.fill ?? renderer.retainedMode?.buffers.fill
  const [first] = buffers ?? []
  if (!first || buffers!.some(({ attr }) => attr === variationAttribute(variationNames[0]!))) return
  if (renderer.retainedMode) renderersWithNames.push(new WeakRef(renderer))
  const RenderBuffer = first.constructor as new (...settings: unknown[]) => typeof first
  for (const name of variationNames)
    buffers!.push(
      new RenderBuffer(
        3,
        arrayName(name),
        `${arrayName(name)}Buffer`,
        variationAttribute(name),
        renderer,
      ),
    )
}

/** Adds the buffers to every renderer that draws with the shader. For shaders that the sketch applies itself. */
export function prepareWhereBound(shader: Shader) {
  const prepare = () => prepareBuffers(shader._renderer as unknown as Renderer)
  // On 1.11 a shader has no renderer before its first use.
  if (shader._renderer) prepare()
  const bind = shader.bindShader!
  shader.bindShader = (...args) => {
    bind.apply(shader, args)
    prepare()
  }
}

/** Disables the attributes of the last shape, which p5 leaves enabled: a shape that lacks them must read zeros. */
export function forgetLastShape(shader: Shader) {
  const bind = shader.bindShader!
  shader.bindShader = (...args) => {
    bind.apply(shader, args)
    const { registerEnabled, GL } = shader._renderer!
    for (const location of registerEnabled) GL.disableVertexAttribArray(location)
    registerEnabled.clear()
  }
}
