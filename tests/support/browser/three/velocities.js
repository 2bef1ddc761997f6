// Compares velocities, which motion blur and TRAA use, of a warped object with those of the same motion without a warp.
import * as THREE from 'three/webgpu'
import { warp } from 'warpjet/three'
import * as scenes from './scenes.js'
import { rendererFor } from './webgpu-renderer.js'

const { mrt, output, velocity } = THREE.TSL
const { size, motion } = scenes

const makeKnot = () => new THREE.TorusKnotGeometry(0.45, 0.16, 48, 10)
const makeStandard = (more) => new THREE.MeshStandardNodeMaterial({ color: 0xff9060, ...more })

/** The matrices of the instances. */
const matrices = [
  new THREE.Matrix4().makeScale(0.6, 0.5, 0.5).setPosition(-0.5, 0.4, 0),
  new THREE.Matrix4().makeRotationY(0.7).setPosition(0.5, -0.3, 0),
]

const makeInstances = (material) => {
  const mesh = new THREE.InstancedMesh(makeKnot(), material, matrices.length)
  matrices.forEach((matrix, i) => mesh.setMatrixAt(i, matrix))
  return mesh
}

const makeBatch = (material) => {
  const mesh = new THREE.BatchedMesh(matrices.length, 1000, 4000, material)
  const id = mesh.addGeometry(makeKnot())
  matrices.forEach((matrix) => mesh.setMatrixAt(mesh.addInstance(id), matrix))
  return mesh
}

/** Makes a node with which a user displaces vertices. */
const makeUserNode = () => {
  const { positionLocal, vec3 } = THREE.TSL
  return positionLocal.add(vec3(positionLocal.y.mul(5).sin().mul(0.15), 0, 0))
}

/** The motion in the third frame, if the warp moves. */
const laterMotion = new THREE.Matrix4().makeRotationZ(0.05).multiply(motion)

const setMotion = ({ uniforms }, matrix) => {
  uniforms.linear.value = new THREE.Matrix3().setFromMatrix4(matrix)
  uniforms.shift.value = new THREE.Vector3().setFromMatrixPosition(matrix)
}

/**
 * Maps a name → { make, space, isMoving }: `make` makes the object, `space` is that of the warp, and `isMoving` says whether the warp
 * changes.
 */
export const rows = {
  'a still mesh': { make: () => new THREE.Mesh(makeKnot(), makeStandard()) },
  'a still mesh with a classic material': {
    make: () => new THREE.Mesh(makeKnot(), new THREE.MeshStandardMaterial()),
  },
  'a still mesh in the world': {
    make: () => new THREE.Mesh(makeKnot(), makeStandard()),
    space: 'world',
  },
  'a still mesh with a positionNode': {
    make: () => new THREE.Mesh(makeKnot(), makeStandard({ positionNode: makeUserNode() })),
  },
  'a still skinned mesh': { make: scenes.shapes.skin },
  'a still skinned mesh at rest': { make: scenes.shapes.skin, space: 'rest' },
  'a still InstancedMesh': { make: () => makeInstances(makeStandard()) },
  'a still InstancedMesh in the world': {
    make: () => makeInstances(makeStandard()),
    space: 'world',
  },
  'a still InstancedMesh with a positionNode': {
    make: () => makeInstances(makeStandard({ positionNode: makeUserNode() })),
  },
  'a still BatchedMesh': { make: () => makeBatch(makeStandard()) },
  'a mesh that the warp moves': {
    make: () => new THREE.Mesh(makeKnot(), makeStandard()),
    isMoving: true,
  },
  'a mesh that the warp moves in the world': {
    make: () => new THREE.Mesh(makeKnot(), makeStandard()),
    space: 'world',
    isMoving: true,
  },
}

const nextFrame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)))

/** Draws three frames, with a call of `move` before the last. Returns the colors and velocities of the last frame. */
async function drawVelocities(renderer, scene, move) {
  const target = new THREE.RenderTarget(size, size, { count: 2, type: THREE.FloatType })
  target.textures[0].name = 'output'
  target.textures[1].name = 'velocity'
  const camera = scenes.camera()
  renderer.setMRT(mrt({ output, velocity }))
  renderer.setRenderTarget(target)
  // Three.js computes velocities from the second frame on.
  for (let i = 0; i < 3; i++) {
    if (i === 2) move()
    renderer.render(scene, camera)
    await nextFrame()
  }
  renderer.setRenderTarget(null)
  renderer.setMRT(null)
  const [colors, numbers] = [
    await renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size, 0),
    await renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size, 1),
  ]
  target.dispose()
  return { colors: [...colors], numbers: [...numbers] }
}

/** Counts pixels with a wrong velocity, pixels that the object covers, and moving pixels. */
export async function measure(name, backend) {
  const renderer = await rendererFor(backend)
  const { make, space, isMoving } = rows[name]
  const makeScene = (object) => {
    object.matrixAutoUpdate = false
    object.matrix.copy(scenes.place)
    const scene = new THREE.Scene()
    scene.add(new THREE.HemisphereLight(), object)
    return scene
  }
  const object = make()
  const warped = warp(object, scenes.offset, { space, uniforms: scenes.uniforms() })
  warped.update(1000)
  const shown = await drawVelocities(renderer, makeScene(object), () => {
    if (isMoving) setMotion(warped, laterMotion)
  })
  let expected
  if (isMoving) {
    const reference = make()
    const scene = makeScene(reference)
    const place = (matrix) =>
      space === 'world'
        ? reference.matrix.multiplyMatrices(matrix, scenes.place)
        : reference.matrix.multiplyMatrices(scenes.place, matrix)
    place(motion)
    expected = await drawVelocities(renderer, scene, () => place(laterMotion))
  }
  const distance = (i) =>
    Math.hypot(...[0, 1].map((k) => shown.numbers[4 * i + k] - (expected?.numbers[4 * i + k] ?? 0)))
  const all = Array.from({ length: size * size }, (_, i) => i)
  const isDrawn = (i) => shown.colors[4 * i] > 0
  return {
    // The tolerance is a tenth of a pixel: the picture is 2 wide.
    wrong: all.filter((i) => isDrawn(i) && !(distance(i) < 0.2 / size)).length,
    drawn: all.filter(isDrawn).length,
    moving: all.filter(
      (i) => Math.hypot(shown.numbers[4 * i], shown.numbers[4 * i + 1]) > 0.2 / size,
    ).length,
  }
}
