// Rows for passes that draw the scene with their own materials.
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

/** Makes a row that draws with a composer with one pass, which `make` creates. */
const pass =
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
  Bokeh: pass(
    (scene, view) => new BokehPass(scene, view, { focus: 4, aperture: 0.01, maxblur: 0.02 }),
  ),
  Outline: pass((scene, view, object) => {
    const made = new OutlinePass(new THREE.Vector2(size, size), scene, view, [object])
    made.edgeStrength = 5
    made.visibleEdgeColor.set(0xff0000)
    return made
  }),
  RenderPixelated: pass((scene, view) => new RenderPixelatedPass(3, scene, view), {
    isFirst: true,
    // It outlines edges between normals of the size of a pixel. The vertices moved by hand have normals that three.js interpolates.
    options: { normals: 'vertex' },
  }),
  SAO: pass((scene, view) => {
    const made = new SAOPass(scene, view)
    made.params.output = SAOPass.OUTPUT.Normal
    return made
  }),
  SSAO: pass((scene, view) => {
    const made = new SSAOPass(scene, view, size, size)
    made.kernelRadius = 0.4
    made.minDistance = 0.001
    return made
  }),
  SSR: pass(
    (scene, view, object, renderer) =>
      new SSRPass({ renderer, scene, camera: view, width: size, height: size, selects: null }),
  ),
  ...(GTAOPass && { GTAO: pass((scene, view) => new GTAOPass(scene, view, size, size)) }),
}
