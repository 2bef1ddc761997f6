// The company tests, which combine warps with other code, with WebGPURenderer: a row draws a warped object, and compares it with an object
// that has the same motion without a warp.
import * as THREE from 'three/webgpu'
import { warp } from 'warpjet/three'
import { addSurfaceVariation, warpMaterial, warpNode } from 'warpjet/three/webgpu'
import { countDiffering } from './pixels.js'
import * as scenes from './scenes.js'
import * as velocities from './velocities.js'
import * as torus from './wavy-torus.js'
import { draw, rendererFor } from './webgpu-renderer.js'

const { TSL } = THREE
const { motion } = scenes

const makeKnot = () => new THREE.TorusKnotGeometry(0.45, 0.16, 48, 10)
const makeMovedKnot = () => makeKnot().applyMatrix4(motion)
const makeStandard = (more) => new THREE.MeshStandardNodeMaterial({ color: 0xff9060, ...more })

export function warpByMotion(object, options) {
  const warped = warp(object, scenes.offset, { uniforms: scenes.uniforms(), ...options })
  warped.update(1000)
  return warped
}

/** The matrices of the instances. */
const matrices = [
  new THREE.Matrix4().makeScale(0.6, 0.5, 0.5).setPosition(-0.5, 0.4, 0),
  new THREE.Matrix4()
    .makeRotationY(0.7)
    .scale(new THREE.Vector3(0.4, 0.6, 0.5))
    .setPosition(0.5, -0.3, 0),
]

const makeInstances = (geometry, material) => {
  const mesh = new THREE.InstancedMesh(geometry, material, matrices.length)
  matrices.forEach((matrix, i) => mesh.setMatrixAt(i, matrix))
  return mesh
}

const makeBatch = (geometry, material) => {
  const mesh = new THREE.BatchedMesh(matrices.length, 1000, 4000, material)
  const id = mesh.addGeometry(geometry)
  matrices.forEach((matrix) => mesh.setMatrixAt(mesh.addInstance(id), matrix))
  return mesh
}

/** Makes a node with which a user displaces vertices. */
const makeUserNode = () => {
  const { positionLocal, vec3 } = TSL
  return positionLocal.add(vec3(positionLocal.y.mul(5).sin().mul(0.15), 0, 0))
}

const makeMeshes = (material) => ({
  object: new THREE.Mesh(makeKnot(), material()),
  reference: new THREE.Mesh(makeMovedKnot(), material()),
  still: new THREE.Mesh(makeKnot(), material()),
})
const makeVariants = (make) => ({
  object: make(makeKnot()),
  reference: make(makeMovedKnot()),
  still: make(makeKnot()),
})

/** Overrides the materials with one that shows normals. */
const overrideMaterials = (scene) => (scene.overrideMaterial = new THREE.MeshNormalNodeMaterial())

/**
 * Maps a name → { object, reference, still }: the object to warp, one that is moved without a warp, and one that is not moved. `warp` warps
 * the object in another way than `warpByMotion`, and `warped` is the part of the object to warp, if not all of it. `prepare` changes the
 * scenes before the warp, and `afterwards` the objects after it; with `isDrawnBefore`, a frame is drawn before `afterwards`.
 */
const rows = {
  'positionNode on an InstancedMesh': () =>
    makeVariants((geometry) =>
      makeInstances(geometry, makeStandard({ positionNode: makeUserNode() })),
    ),
  'positionNode on a BatchedMesh': () =>
    makeVariants((geometry) => makeBatch(geometry, makeStandard({ positionNode: makeUserNode() }))),
  'positionNode set after warp': () => ({
    // The user's node applies before the motion.
    object: new THREE.Mesh(makeKnot(), makeStandard()),
    reference: new THREE.Mesh(makeKnot(), makeStandard()),
    still: new THREE.Mesh(makeKnot(), makeStandard({ positionNode: makeUserNode() })),
    afterwards: ({ object, reference }) => {
      object.material.positionNode = makeUserNode()
      object.material.needsUpdate = true
      reference.material.positionNode = makeUserNode()
      reference.matrix.multiply(motion)
    },
  }),
  'positionNode on an InstancedMesh, set after warp': () => ({
    ...makeVariants((geometry) => makeInstances(geometry, makeStandard())),
    afterwards: (all) => {
      for (const { material } of Object.values(all)) {
        material.positionNode = makeUserNode()
        material.needsUpdate = true
      }
    },
  }),
  'another material after warp': () => ({
    ...makeMeshes(() => makeStandard()),
    afterwards: (all) => {
      for (const mesh of Object.values(all))
        mesh.material = new THREE.MeshLambertMaterial({ color: 0x40ff80 })
    },
  }),
  'another material between frames': () => ({
    ...makeMeshes(() => makeStandard()),
    isDrawnBefore: true,
    afterwards: (all) => {
      for (const mesh of Object.values(all))
        mesh.material = new THREE.MeshPhongMaterial({ color: 0x40ff80 })
    },
  }),
  'an override material': () => ({
    ...makeMeshes(() => makeStandard()),
    prepare: overrideMaterials,
  }),
  'an unwarped mesh with the same geometry and material': () => {
    const all = {}
    const [geometry, material] = [makeKnot(), new THREE.MeshStandardMaterial()]
    for (const name of ['object', 'reference', 'still']) {
      const group = new THREE.Group()
      const twin = new THREE.Mesh(geometry, material)
      twin.position.set(-0.7, 0.3, -0.3)
      const shape = name === 'reference' ? makeMovedKnot() : geometry
      group.add(twin, new THREE.Mesh(shape, material))
      all[name] = group
    }
    return { ...all, warped: all.object.children[1] }
  },
  'a skinned mesh at rest': () => ({
    ...makeVariantsAtRest(scenes.shapes.skin),
    options: { space: 'rest' },
  }),
  'morph targets at rest': () => ({
    ...makeVariantsAtRest(scenes.shapes.morphs),
    options: { space: 'rest' },
  }),
  'instances with morph targets': () => {
    const make = (isMoved) => {
      const geometry = makeMorphingKnot(isMoved)
      const mesh = makeInstances(geometry, makeStandard())
      const dummy = new THREE.Mesh(geometry)
      matrices.forEach((_, i) => {
        dummy.morphTargetInfluences = [0.4 + 0.3 * i]
        mesh.setMorphAt(i, dummy)
      })
      return mesh
    }
    return { object: make(), reference: make(true), still: make() }
  },
  PointsNodeMaterial: () =>
    makeVariants((geometry) => new THREE.Points(geometry, new THREE.PointsNodeMaterial())),
  'PointsNodeMaterial with a positionNode': () => ({
    object: makePoints(),
    reference: makePoints(),
    still: makePoints(),
    afterwards: ({ reference }) => reference.matrix.multiply(motion),
  }),
  'warpMaterial on an InstancedMesh with a positionNode': () => {
    const all = makeVariants((geometry) =>
      makeInstances(geometry, makeStandard({ positionNode: makeUserNode() })),
    )
    return { ...all, warp: (mesh) => replaceMaterial(mesh) }
  },
  'warpNode on an InstancedMesh': () => ({
    ...makeVariants((geometry) => makeInstances(geometry, makeStandard())),
    warp(mesh) {
      const made = warpNode(scenes.offset, { uniforms: scenes.uniforms() })
      made.update(1000)
      mesh.material.positionNode = made.node
    },
  }),
  'warpNode inside other nodes on an InstancedMesh': () => ({
    ...makeVariants((geometry) => makeInstances(geometry, makeStandard())),
    warp(mesh) {
      const made = warpNode(scenes.offset, { uniforms: scenes.uniforms() })
      made.update(1000)
      mesh.material.positionNode = made.node.add(TSL.vec3(0, 0, 0))
    },
  }),
}

const makePoints = () =>
  new THREE.Points(makeKnot(), new THREE.PointsNodeMaterial({ positionNode: makeUserNode() }))

function replaceMaterial(mesh) {
  const made = warpMaterial(mesh.material, scenes.offset, { uniforms: scenes.uniforms() })
  made.update(1000)
  mesh.material = made.material
}

function makeVariantsAtRest(make) {
  const reference = make()
  reference.geometry.applyMatrix4(motion)
  return { object: make(), reference, still: make() }
}

/** Makes a knot with a relative morph target; for absolute ones on an InstancedMesh, three.js throws. */
function makeMorphingKnot(isMoved) {
  const geometry = makeKnot()
  const [position, normal] = ['position', 'normal'].map((name) => {
    const target = geometry.attributes[name].clone()
    for (let i = 0; i < target.count; i++) target.setXYZ(i, 0, 0.5 * target.getX(i), 0)
    return target
  })
  if (isMoved) {
    const linear = new THREE.Matrix3().setFromMatrix4(motion)
    geometry.applyMatrix4(motion)
    position.applyMatrix3(linear)
    normal.applyMatrix3(new THREE.Matrix3().getNormalMatrix(motion))
  }
  Object.assign(geometry.morphAttributes, { position: [position], normal: [normal] })
  geometry.morphTargetsRelative = true
  return geometry
}

/** Counts the pixels of a row that differ from the motion without a warp, and those that the motion changes. */
async function compare(name, backend) {
  const renderer = await rendererFor(backend)
  const { prepare = () => {}, afterwards, options, isDrawnBefore, ...row } = rows[name]()
  const { object, reference, still } = row
  const makeScene = (subject) => {
    subject.matrixAutoUpdate = false
    subject.matrix.copy(scenes.place)
    const scene = scenes.sceneOf(subject, 'directional')
    prepare(scene)
    return scene
  }
  const all = [object, reference, still].map(makeScene)
  if (row.warp) row.warp(object)
  else warpByMotion(row.warped ?? object, options)
  if (isDrawnBefore) for (const scene of all) await draw(renderer, scene)
  afterwards?.({ object, reference, still })
  const pictures = []
  for (const scene of all) pictures.push(await draw(renderer, scene))
  const [shown, expected, before] = pictures
  return { differing: countDiffering(shown, expected), moved: countDiffering(expected, before) }
}

window.company = {
  names: Object.keys(rows),
  compare,
  velocities: Object.keys(velocities.rows),
  velocity: velocities.measure,
  torus: (backend, settings) => torus.compare(backend, settings, addSurfaceVariation),
  errors: async () => {
    const errors = []
    const attempt = (object) => {
      try {
        warp(object, scenes.offset, { uniforms: scenes.uniforms() })
        errors.push('')
      } catch (error) {
        errors.push(String(error))
      }
    }
    const withName = (object, name) => Object.assign(object, { name })
    const replaced = withName(makeStandard({ vertexNode: TSL.vec4(0, 0, 0, 1) }), 'screen')
    attempt(withName(new THREE.Mesh(makeKnot(), replaced), 'boat'))
    attempt(withName(new THREE.Mesh(makeKnot(), new THREE.PointsNodeMaterial()), 'dust'))
    attempt(withName(new THREE.Sprite(new THREE.SpriteNodeMaterial()), 'tree'))
    const mesh = withName(new THREE.Mesh(makeKnot(), makeStandard()), 'ship')
    warpByMotion(mesh)
    try {
      mesh.onBeforeRender({ isWebGPURenderer: true })
      errors.push('')
    } catch (error) {
      errors.push(String(error))
    }
    return errors
  },
}
// Keeps navigator.gpu alive; otherwise the browser loses the device.
window.gpu = navigator.gpu
document.title = 'ready'
