// Combines warps with other people's code, with WebGPURenderer: each row draws a warped object and the same motion without a warp.
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

const knot = () => new THREE.TorusKnotGeometry(0.45, 0.16, 48, 10)
const movedKnot = () => knot().applyMatrix4(motion)
const standard = (more) => new THREE.MeshStandardNodeMaterial({ color: 0xff9060, ...more })

export function warpByMotion(object, options) {
  const warped = warp(object, scenes.offset, { uniforms: scenes.uniforms(), ...options })
  warped.update(1000)
  return warped
}

const places = [
  new THREE.Matrix4().makeScale(0.6, 0.5, 0.5).setPosition(-0.5, 0.4, 0),
  new THREE.Matrix4()
    .makeRotationY(0.7)
    .scale(new THREE.Vector3(0.4, 0.6, 0.5))
    .setPosition(0.5, -0.3, 0),
]

const makeInstances = (geometry, material) => {
  const mesh = new THREE.InstancedMesh(geometry, material, places.length)
  places.forEach((matrix, i) => mesh.setMatrixAt(i, matrix))
  return mesh
}

const makeBatch = (geometry, material) => {
  const mesh = new THREE.BatchedMesh(places.length, 1000, 4000, material)
  const id = mesh.addGeometry(geometry)
  places.forEach((matrix) => mesh.setMatrixAt(mesh.addInstance(id), matrix))
  return mesh
}

/** A node with which the user displaces vertices. */
const userNode = () => {
  const { positionLocal, vec3 } = TSL
  return positionLocal.add(vec3(positionLocal.y.mul(5).sin().mul(0.15), 0, 0))
}

const meshOf = (material) => ({
  object: new THREE.Mesh(knot(), material()),
  reference: new THREE.Mesh(movedKnot(), material()),
  still: new THREE.Mesh(knot(), material()),
})
const variants = (make) => ({
  object: make(knot()),
  reference: make(movedKnot()),
  still: make(knot()),
})

/** Overrides the materials with one that shows normals. */
const overrideMaterials = (scene) => (scene.overrideMaterial = new THREE.MeshNormalNodeMaterial())

/** Maps a name → { object, reference, still }: the object to warp, one that is moved without a warp, and one that is not moved. */
const rows = {
  'positionNode on an InstancedMesh': () =>
    variants((geometry) => makeInstances(geometry, standard({ positionNode: userNode() }))),
  'positionNode on a BatchedMesh': () =>
    variants((geometry) => makeBatch(geometry, standard({ positionNode: userNode() }))),
  'positionNode set after warp': () => ({
    // The user's node applies before the motion.
    object: new THREE.Mesh(knot(), standard()),
    reference: new THREE.Mesh(knot(), standard()),
    still: new THREE.Mesh(knot(), standard({ positionNode: userNode() })),
    afterwards: ({ object, reference }) => {
      object.material.positionNode = userNode()
      object.material.needsUpdate = true
      reference.material.positionNode = userNode()
      reference.matrix.multiply(motion)
    },
  }),
  'positionNode on an InstancedMesh, set after warp': () => ({
    ...variants((geometry) => makeInstances(geometry, standard())),
    afterwards: (all) => {
      for (const { material } of Object.values(all)) {
        material.positionNode = userNode()
        material.needsUpdate = true
      }
    },
  }),
  'another material after warp': () => ({
    ...meshOf(() => standard()),
    afterwards: (all) => {
      for (const mesh of Object.values(all))
        mesh.material = new THREE.MeshLambertMaterial({ color: 0x40ff80 })
    },
  }),
  'another material between frames': () => ({
    ...meshOf(() => standard()),
    isDrawnBefore: true,
    afterwards: (all) => {
      for (const mesh of Object.values(all))
        mesh.material = new THREE.MeshPhongMaterial({ color: 0x40ff80 })
    },
  }),
  'an override material': () => ({ ...meshOf(() => standard()), prepare: overrideMaterials }),
  'a plain twin of the same geometry and material beside it': () => {
    const all = {}
    const made = { geometry: knot(), material: new THREE.MeshStandardMaterial() }
    for (const name of ['object', 'reference', 'still']) {
      const group = new THREE.Group()
      const twin = new THREE.Mesh(made.geometry, made.material)
      twin.position.set(-0.7, 0.3, -0.3)
      const geometry = name === 'reference' ? movedKnot() : made.geometry
      group.add(twin, new THREE.Mesh(geometry, made.material))
      all[name] = group
    }
    return { ...all, warped: all.object.children[1] }
  },
  'a skinned mesh at rest': () => ({
    ...variantsAtRest(scenes.shapes.skin),
    options: { space: 'rest' },
  }),
  'morph targets at rest': () => ({
    ...variantsAtRest(scenes.shapes.morphs),
    options: { space: 'rest' },
  }),
  'instances with morph targets': () => {
    const make = (isMoved) => {
      const geometry = withMorphs(isMoved)
      const mesh = makeInstances(geometry, standard())
      const dummy = new THREE.Mesh(geometry)
      places.forEach((_, i) => {
        dummy.morphTargetInfluences = [0.4 + 0.3 * i]
        mesh.setMorphAt(i, dummy)
      })
      return mesh
    }
    return { object: make(), reference: make(true), still: make() }
  },
  PointsNodeMaterial: () =>
    variants((geometry) => new THREE.Points(geometry, new THREE.PointsNodeMaterial())),
  'PointsNodeMaterial with a positionNode': () => ({
    object: points(),
    reference: points(),
    still: points(),
    afterwards: ({ reference }) => reference.matrix.multiply(motion),
  }),
  'warpMaterial on an InstancedMesh with a positionNode': () => {
    const all = variants((geometry) =>
      makeInstances(geometry, standard({ positionNode: userNode() })),
    )
    return { ...all, warp: (mesh) => replaceMaterial(mesh) }
  },
  'warpNode on an InstancedMesh': () => ({
    ...variants((geometry) => makeInstances(geometry, standard())),
    warp(mesh) {
      const made = warpNode(scenes.offset, { uniforms: scenes.uniforms() })
      made.update(1000)
      mesh.material.positionNode = made.node
    },
  }),
  'warpNode inside other nodes on an InstancedMesh': () => ({
    ...variants((geometry) => makeInstances(geometry, standard())),
    warp(mesh) {
      const made = warpNode(scenes.offset, { uniforms: scenes.uniforms() })
      made.update(1000)
      mesh.material.positionNode = made.node.add(TSL.vec3(0, 0, 0))
    },
  }),
}

const points = () =>
  new THREE.Points(knot(), new THREE.PointsNodeMaterial({ positionNode: userNode() }))

function replaceMaterial(mesh) {
  const made = warpMaterial(mesh.material, scenes.offset, { uniforms: scenes.uniforms() })
  made.update(1000)
  mesh.material = made.material
}

function variantsAtRest(make) {
  const reference = make()
  reference.geometry.applyMatrix4(motion)
  return { object: make(), reference, still: make() }
}

/** Makes a knot with a relative morph target: three.js throws for others on an InstancedMesh. */
function withMorphs(isMoved) {
  const geometry = knot()
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
  const sceneOf = (given) => {
    given.matrixAutoUpdate = false
    given.matrix.copy(scenes.place)
    const scene = scenes.sceneOf(given, 'directional')
    prepare(scene)
    return scene
  }
  const all = [object, reference, still].map(sceneOf)
  if (row.warp) row.warp(object)
  else warpByMotion(row.warped ?? object, options)
  if (isDrawnBefore) for (const scene of all) await draw(renderer, scene)
  afterwards?.({ object, reference, still })
  const pictures = []
  for (const scene of all) pictures.push(await draw(renderer, scene))
  const [shown, wanted, before] = pictures
  return { differing: countDiffering(shown, wanted), moved: countDiffering(wanted, before) }
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
    const replaced = withName(standard({ vertexNode: TSL.vec4(0, 0, 0, 1) }), 'screen')
    attempt(withName(new THREE.Mesh(knot(), replaced), 'boat'))
    attempt(withName(new THREE.Mesh(knot(), new THREE.PointsNodeMaterial()), 'dust'))
    attempt(withName(new THREE.Sprite(new THREE.SpriteNodeMaterial()), 'tree'))
    const mesh = withName(new THREE.Mesh(knot(), standard()), 'ship')
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
