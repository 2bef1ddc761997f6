/**
 * Hands p5 how shapes vary as attributes of its own kind: a p5.Geometry has them as arrays beside its vertices, made when a shader
 * first asks, and every renderer that draws with a warp that reads them has buffers of them.
 */
import {
  type VariationInput,
  variationAttribute,
  variationNames,
} from '../../core/inputs/inputs.js'
import type { Renderer, Shader, Shape } from '../host.js'
import { type Variation, variationOf } from './shape-variation.js'

type Drawn = Shape & { dirtyFlags: Record<string, boolean | undefined> }

const source = (name: string) => `warpjet_${name}`

/** What was found out, and which arrays of it were handed over. */
const found = new WeakMap<Drawn, { variation: Variation; handed: Set<string> }>()

/** p5's name of what is between beginShape() and endShape(), which is another shape each time. */
const immediate = '__IMMEDIATE_MODE_GEOMETRY__'

function arrayOf(shape: Drawn, name: VariationInput): Float32Array {
  if (shape.gid === immediate) return new Float32Array(3 * shape.vertices.length)
  let known = found.get(shape)
  // p5 wants it again after the shape has changed.
  const isStale = known?.handed.has(name) && shape.dirtyFlags[source(name)] !== false
  if (!known || isStale)
    found.set(shape, (known = { variation: variationOf(shape, nameOf(shape)), handed: new Set() }))
  known.handed.add(name)
  return known.variation[name]
}

/** Gives the arrays to all that is of the class p5.Geometry. */
export function giveArrays(geometry: { prototype: object } | undefined) {
  if (!geometry) return
  for (const name of variationNames)
    Object.defineProperty(geometry.prototype, source(name), {
      configurable: true,
      get(this: Drawn) {
        return arrayOf(this, name)
      },
    })
}

/** Shared by all scripts of the page, each of which may have a copy of this file. */
const keeping = ((globalThis as Record<symbol, unknown>)[Symbol.for('warpjet.renderers')] ??=
  []) as WeakRef<Renderer>[]

/** p5's name of a shape: 1.11 keeps shapes under their names, and these do not know them. */
export const nameOf = (shape: Shape): string =>
  shape.gid ||
  (keeping
    .flatMap((reference) => Object.entries(reference.deref()?.retainedMode?.geometry ?? {}))
    .find(([, { model }]) => model === shape)?.[0] ??
    '')

/** For a renderer that is to draw with a warp that reads them. */
export function prepareBuffers(renderer: Renderer) {
  const buffers = renderer.buffers?.fill ?? renderer.retainedMode?.buffers.fill
  const [first] = buffers ?? []
  if (!first || buffers!.some(({ attr }) => attr === variationAttribute(variationNames[0]!))) return
  if (renderer.retainedMode) keeping.push(new WeakRef(renderer))
  const RenderBuffer = first.constructor as new (...settings: unknown[]) => typeof first
  for (const name of variationNames)
    buffers!.push(
      new RenderBuffer(
        3,
        source(name),
        `${source(name)}Buffer`,
        variationAttribute(name),
        renderer,
      ),
    )
}

/** Prepares whichever renderer draws with the shader, for one that a sketch puts on by itself. */
export function prepareWhereBound(shader: Shader) {
  const prepare = () => prepareBuffers(shader._renderer as unknown as Renderer)
  // On 1.11 a shader has none before it is drawn with.
  if (shader._renderer) prepare()
  const bind = shader.bindShader!
  shader.bindShader = (...args) => {
    bind.apply(shader, args)
    prepare()
  }
}

/** p5 leaves the attributes of the last shape on for one that lacks them, which is then to read zeros. */
export function forgetLastShape(shader: Shader) {
  const bind = shader.bindShader!
  shader.bindShader = (...args) => {
    bind.apply(shader, args)
    const { registerEnabled, GL } = shader._renderer!
    for (const location of registerEnabled) GL.disableVertexAttribArray(location)
    registerEnabled.clear()
  }
}
