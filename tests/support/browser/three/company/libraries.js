// Rows for packages with their own rendering, deformation or instancing, bundled by Vite for libraries.browser.test.js.
import { MeshDistortMaterial } from '@react-three/drei/core/MeshDistortMaterial'
import { MeshWobbleMaterial } from '@react-three/drei/core/MeshWobbleMaterial'
import { InstancedMesh2 } from '@three.ez/instanced-mesh'
import {
  EffectComposer,
  EffectPass,
  NormalPass,
  OutlineEffect,
  RenderPass,
  SSAOEffect,
} from 'postprocessing'
import * as THREE from 'three'
import CustomShaderMaterial from 'three-custom-shader-material/vanilla'
import { Text } from 'troika-three-text'
import { warp } from 'warpjet/three'
import {
  camera,
  floor,
  litScene,
  makeRow,
  mesh,
  renderer,
  run,
  size,
  standard,
  torus,
  userMotionByHand,
} from './lib.js'
import { renderMaterial } from './react-material.js'
import { straightCamera, twistByHand } from './twisted.js'

const wobble = await renderMaterial(MeshWobbleMaterial, { speed: 0, factor: 1, roughness: 0.6 })
wobble.time = 1
const distort = await renderMaterial(MeshDistortMaterial, {
  speed: 0,
  distort: 0.5,
  roughness: 0.6,
})

/** Returns drei's material with the offset of these tests written into its shader by hand, after drei's motion. */
function distortByHand() {
  const material = distort.clone()
  for (const name of ['time', 'distort', 'radius']) material[name] = distort[name]
  const { onBeforeCompile } = distort
  material.onBeforeCompile = function (shader) {
    onBeforeCompile.call(this, shader)
    shader.vertexShader = shader.vertexShader.replace(
      '#include <project_vertex>',
      `float slope = 0.8 * cos( 4.0 * transformed.x );
      transformed.z += 0.2 * sin( 4.0 * transformed.x );
      vec3 n = vNormal * mat3( modelViewMatrix );
      n.x -= slope * n.z;
      vNormal = normalize( normalMatrix * n );
      #include <project_vertex>`,
    )
  }
  material.customProgramCacheKey = () => 'distort by hand'
  return material
}

/** Makes a row that draws with a composer of postprocessing; `makePasses` receives the scene, the camera and the object. */
const makeComposerRow =
  (makePasses) =>
  ({ put, renderer }) => {
    const scene = litScene()
    const object = mesh()
    scene.add(object, floor())
    put(object)
    const view = camera()
    const composer = new EffectComposer(renderer)
    composer.setSize(size, size)
    composer.addPass(new RenderPass(scene, view))
    for (const pass of makePasses(scene, view, object)) composer.addPass(pass)
    composer.render(0.016)
    composer.dispose()
    renderer.autoClear = true
  }

const font = new URL(
  '/node_modules/@fontsource/fredoka/files/fredoka-latin-400-normal.woff',
  location,
)

/**
 * Draws text that a warp or a matrix moves linearly (shear and translation): each letter is drawn as one square, which cannot bend.
 */
async function drawText({ way, renderer }) {
  const scene = litScene()
  const made = new Text()
  Object.assign(made, {
    text: 'warp',
    fontSize: 0.9,
    anchorX: 'center',
    anchorY: 'middle',
    color: 0xffaa33,
  })
  made.font = String(font)
  await new Promise((done) => made.sync(done))
  scene.add(made)
  const warped =
    way === 'warped' &&
    warp(made, ({ glsl, position }) =>
      glsl.vec3(position.y().mult(0.5), 0.2, position.x().mult(0.3)),
    )
  if (way === 'byHand') {
    made.matrixAutoUpdate = false
    made.matrix.set(1, 0.5, 0, 0, 0, 1, 0, 0.2, 0.3, 0, 1, 0, 0, 0, 0, 1)
  }
  renderer.render(scene, camera())
  renderer.render(scene, camera())
  if (warped) warped.dispose()
}

/** The matrices of the instances. */
const matrices = [-0.8, 0.8].map((x) =>
  new THREE.Matrix4().compose(
    new THREE.Vector3(x, 0, 0),
    new THREE.Quaternion().setFromEuler(new THREE.Euler(0.3, x, 0)),
    new THREE.Vector3(0.6, 0.6, 0.6),
  ),
)

function drawInstances({ put, way, renderer }) {
  const scene = litScene()
  const view = camera()
  if (way === 'byHand') {
    const geometry = torus()
    const parts = matrices.map((matrix) => {
      const part = mesh(standard(), geometry)
      part.applyMatrix4(matrix)
      return part
    })
    scene.add(...parts)
    put(parts[0])
  } else {
    const made = new InstancedMesh2(torus(), standard(), { capacity: 2, renderer })
    let i = 0
    made.addInstances(2, (object) => {
      matrices[i++].decompose(object.position, object.quaternion, object.scale)
    })
    scene.add(made)
    put(made)
  }
  renderer.render(scene, view)
  renderer.render(scene, view)
}

const makeCustom = (options) =>
  mesh(
    new CustomShaderMaterial({
      baseMaterial: THREE.MeshStandardMaterial,
      roughness: 0.6,
      ...options,
    }),
  )

export const rows = {
  'postprocessing NormalPass and SSAOEffect': makeComposerRow((scene, view) => {
    const normals = new NormalPass(scene, view)
    const ssao = new SSAOEffect(view, normals.texture, {
      intensity: 4,
      radius: 0.1,
      worldDistanceThreshold: 20,
      worldDistanceFalloff: 5,
      worldProximityThreshold: 1,
      worldProximityFalloff: 1,
    })
    return [normals, new EffectPass(view, ssao)]
  }),
  'postprocessing OutlineEffect': makeComposerRow((scene, view, object) => {
    const outline = new OutlineEffect(scene, view, { edgeStrength: 5, visibleEdgeColor: 0xff0000 })
    outline.selection.set([object])
    return [new EffectPass(view, outline)]
  }),
  'troika-three-text': drawText,
  '@three.ez/instanced-mesh': drawInstances,
  'three-custom-shader-material, csm_Position': makeRow((way) =>
    way === 'byHand'
      ? mesh(standard(), userMotionByHand(torus()))
      : makeCustom({
          vertexShader:
            'void main() { csm_Position = position + vec3( 0.3 * position.y * position.y, 0.0, 0.0 ); }',
        }),
  ),
  'three-custom-shader-material, csm_Normal and csm_DiffuseColor': makeRow((way) => {
    if (way !== 'byHand')
      return makeCustom({
        vertexShader: 'void main() { csm_Normal = normalize( normal + vec3( 0.0, 0.5, 0.0 ) ); }',
        fragmentShader: 'void main() { csm_DiffuseColor = vec4( 1.0, 0.0, 0.0, 1.0 ); }',
      })
    const geometry = torus()
    const { normal } = geometry.attributes
    for (let i = 0; i < normal.count; i++) {
      const sum = new THREE.Vector3().fromBufferAttribute(normal, i)
      sum.y += 0.5
      normal.setXYZ(i, ...sum.normalize())
    }
    return mesh(standard({ color: 'red' }), geometry)
  }),
  "drei's wobble": makeRow((way) => (way === 'byHand' ? twistByHand() : mesh(wobble)), {
    view: straightCamera,
  }),
  "drei's distort": ({ put, way, renderer }) => {
    const scene = litScene()
    const object = mesh(way === 'byHand' ? distortByHand() : distort)
    scene.add(object)
    if (way === 'warped') put(object)
    renderer.render(scene, camera())
  },
}

/**
 * Casts rays at an instance of @three.ez/instanced-mesh that a warp lifts → maps the warp's space to the heights of two hits: before and
 * after the instance moves.
 */
function hitHeights() {
  const result = {}
  for (const space of ['local', 'world']) {
    const made = new InstancedMesh2(new THREE.PlaneGeometry(2, 2), standard(), {
      capacity: 1,
      renderer,
    })
    made.addInstances(1, (object) => object.position.set(0, 0, 1))
    made.computeBVH()
    const warped = warp(made, ({ glsl }) => glsl.vec3(0, 0, 2), { space })
    const down = new THREE.Raycaster(new THREE.Vector3(0.2, 0.1, 9), new THREE.Vector3(0, 0, -1))
    result[space] = [down.intersectObject(made)[0]?.point.z]
    made.setMatrixAt(0, new THREE.Matrix4().makeTranslation(0, 0, 3))
    result[space].push(down.intersectObject(made)[0]?.point.z)
    warped.dispose()
  }
  return result
}

window.company = {
  hitHeights,
  names: { libraries: Object.keys(rows) },
  run: (_, name) => run(rows[name]),
}
document.title = 'ready'
