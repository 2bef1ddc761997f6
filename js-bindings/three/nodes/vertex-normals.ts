/**
 * Normals of vertices with WebGPURenderer where a warp collapses the surface. Three.js normalizes normals in the vertex stage, so that a
 * vertex without a normal would weigh as much as its neighbors. We pass the normals a second time, with almost no weight at collapsed
 * vertices. Pixels between such vertices get the geometric normal of their triangle.
 */
import type { Builder } from './builder.js'
import { normalizeOr, onBack } from './facing.js'
import { tsl, type AnyNode } from './tsl.js'

/** The part of a NodeMaterial that we use. */
interface NormalMaterial {
  setupNormal(builder: Builder): unknown
  isShadowPassMaterial?: boolean
}

/** For a zero normal, `functionFor` returns the normal before the warp times this. */
const shortFactor = 1e-6

/**
 * Replaces the normals that a material reads, and returns what the vertex stage needs; `undefined` if the material reads no vertex normals.
 */
export function vertexNormalsFor(
  builder: Builder,
  material: NormalMaterial,
): VertexNormals | undefined {
  const hasNormals = builder.geometry.hasAttribute('normal') && !builder.isFlatShading()
  return hasNormals && !material.isShadowPassMaterial
    ? new VertexNormals(builder, material)
    : undefined
}

export class VertexNormals {
  private readonly varying = tsl.varyingProperty('vec3', 'warpjetViewNormal')
  private weight: AnyNode | undefined

  constructor(
    private readonly builder: Builder,
    material: NormalMaterial,
  ) {
    let node: AnyNode | undefined
    const withNormals = tsl.Fn(() => {
      this.assignNormals()
      return material.setupNormal(builder)
    })
    builder.context.setupNormal = () => (node ??= tsl.subBuild(withNormals(), 'NORMAL', 'vec3'))
  }

  /** Records whether the warp collapsed the surface at the vertex, from the normals after the warp and before it. */
  mark(normal: AnyNode, rest: AnyNode) {
    const isCollapsed = tsl
      .length(rest)
      .mul(2 * shortFactor)
      .greaterThan(tsl.length(normal))
    this.weight = tsl.select(isCollapsed, shortFactor, 1).toVar()
  }

  /** Passes the normal, in the vertex stage, after three.js has applied the matrices of instances. */
  pass() {
    this.varying.assign(tsl.transformNormalToView(tsl.normalLocal).mul(this.weight!))
  }

  private assignNormals() {
    const facing = normalizeOr(tsl.normalFlat, tsl.vec3(0, 0, 1))
    const hasWeight = this.varying.dot(this.varying).greaterThan(1e-10)
    const normal = tsl.select(hasWeight, this.varying.normalize(), onBack(this.builder, facing))
    tsl.normalViewGeometry.assign(normal)
  }
}
