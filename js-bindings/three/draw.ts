/**
 * Wraps `renderBufferDirect`, through which WebGLRenderer draws every object with every material: in shadows, override passes, cascades
 * and clones, too. The wrapped function draws a warped object with a variant of the material.
 */
import type { Material, Mesh, WebGLRenderer } from 'three'
import type { Warpable } from './pose.js'
import { variantsOf } from './registry.js'
import type { Variant } from './variant.js'

const wrapped = new WeakSet<WebGLRenderer>()

/** Wraps `renderBufferDirect` and `compile` of a renderer, once. */
export function wrapRenderer(renderer: WebGLRenderer) {
  if (wrapped.has(renderer)) return
  wrapped.add(renderer)
  wrapDraw(renderer)
  wrapCompile(renderer)
}

function wrapDraw(renderer: WebGLRenderer) {
  const draw = renderer.renderBufferDirect
  renderer.renderBufferDirect = function (camera, scene, geometry, material, object, group) {
    const variant = variantsOf(object)?.get(material, object as Warpable)
    if (variant === undefined)
      return draw.call(this, camera, scene, geometry, material, object, group)
    const { compilations } = variant
    const asMaterial = variant as unknown as Material
    if (variant.added !== undefined || variant.original.isMeshDistanceMaterial)
      prepare(variant, renderer)
    draw.call(this, camera, scene, geometry, asMaterial, object, group)
    if (variant.compilations !== compilations) prepare(variant, renderer)
  }
}

/** Gives a variant the uniforms and the light that other code sets on the original. */
function prepare(variant: Variant, renderer: WebGLRenderer) {
  const { original, added } = variant
  const asMaterial = variant as unknown as Material
  added?.share(original, asMaterial, renderer)
  if (!original.isMeshDistanceMaterial) return
  const { properties } = renderer
  const { light } = properties.get(original) as { light?: unknown }
  Object.assign(properties.get(asMaterial) as object, { light })
}

/** Wraps `compile`, which takes materials from the objects and does not call `renderBufferDirect`. */
function wrapCompile(renderer: WebGLRenderer) {
  const { compile } = renderer
  renderer.compile = function (scene, camera, target) {
    const restore: (() => void)[] = []
    scene.traverse((object) => {
      const { material } = object as Mesh
      const variants = material && variantsOf(object)
      if (!variants) return
      const toVariant = (each: Material) =>
        (variants.get(each, object as Warpable) as unknown as Material | undefined) ?? each
      const mesh = object as Mesh
      mesh.material = Array.isArray(material) ? material.map(toVariant) : toVariant(material)
      restore.push(() => void (mesh.material = material))
    })
    try {
      return compile.call(this, scene, camera, target)
    } finally {
      for (const putBack of restore) putBack()
    }
  }
}
