// Rows of the company tests for passes that draw the scene with their own materials.
import * as THREE from 'three'
import { BokehPass } from 'three/addons/postprocessing/BokehPass.js'
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js'
import { OutlinePass } from 'three/addons/postprocessing/OutlinePass.js'
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js'
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js'
import { RenderPixelatedPass } from 'three/addons/postprocessing/RenderPixelatedPass.js'
import { SAOPass } from 'three/addons/postprocessing/SAOPass.js'
import { SSAOPass } from 'three/addons/postprocessing/SSAOPass.js'
import { SSRPass } from 'three/addons/postprocessing/SSRPass.js'
import { camera, floor, litScene, mesh, size } from './lib.js'

const { GTAOPass } = await import('three/addons/postprocessing/GTAOPass.js').catch(() => ({}))

/** Makes a row that draws with a composer. It has the pass that `make` creates, after a RenderPass unless `isFirst`. */
const makeComposerRow =
  (make, { isFirst = false, options } = {}) =>
  ({ put, renderer }) => {
    const scene = litScene()
    const object = mesh()
    scene.add(object, floor())
    put(object, options)
    const view = camera()
    const composer = new EffectComposer(renderer)
    composer.setPixelRatio(1)
    composer.setSize(size, size)
    if (!isFirst) composer.addPass(new RenderPass(scene, view))
    const made = make(scene, view, object, renderer)
    composer.addPass(made)
    composer.addPass(new OutputPass())
    composer.render(0.016)
    composer.dispose()
    made.dispose?.()
  }

export const rows = {
  Bokeh: makeComposerRow(
    (scene, view) => new BokehPass(scene, view, { focus: 4, aperture: 0.01, maxblur: 0.02 }),
  ),
  Outline: makeComposerRow((scene, view, object) => {
    const made = new OutlinePass(new THREE.Vector2(size, size), scene, view, [object])
    made.edgeStrength = 5
    made.visibleEdgeColor.set(0xff0000)
    return made
  }),
  RenderPixelated: makeComposerRow((scene, view) => new RenderPixelatedPass(3, scene, view), {
    isFirst: true,
    // This pass outlines differences between normals of adjacent pixels. So the normals must be interpolated between vertices, as those of
    // the geometry that is moved by hand.
    options: { normals: 'vertex' },
  }),
  SAO: makeComposerRow((scene, view) => {
    const made = new SAOPass(scene, view)
    made.params.output = SAOPass.OUTPUT.Normal
    return made
  }),
  SSAO: makeComposerRow((scene, view) => {
    const made = new SSAOPass(scene, view, size, size)
    made.kernelRadius = 0.4
    made.minDistance = 0.001
    return made
  }),
  SSR: makeComposerRow(
    (scene, view, object, renderer) =>
      new SSRPass({ renderer, scene, camera: view, width: size, height: size, selects: null }),
  ),
  ...(GTAOPass && {
    GTAO: makeComposerRow((scene, view) => new GTAOPass(scene, view, size, size)),
  }),
}
