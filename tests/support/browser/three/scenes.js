// Scenes for the tests of 'warpjet/three': each is drawn with a warp, and with the same motion through matrices of three.js itself.
import * as THREE from 'three'

/** The matrix of the motion: a rotation, a shear and a translation. */
export const motion = new THREE.Matrix4()
  .makeRotationFromEuler(new THREE.Euler(0.4, 0.7, -0.3))
  .multiply(new THREE.Matrix4().makeShear(0.3, 0, 0, 0.2, 0, 0))
  .setPosition(0.2, 0.1, -0.15)

/** The matrix of a reflection in x, followed by the motion. */
export const mirroredMotion = motion.clone().multiply(new THREE.Matrix4().makeScale(-1, 1, 1))

/** The motion as an offset. The linear part is a uniform, and the translation depends on the time. */
export const offset = ({ position, uniforms, millis }) =>
  uniforms.linear
    .mult(position)
    .sub(position)
    .add(uniforms.shift.mult(millis.div(1000)))

export const uniforms = (matrix = motion) => ({
  linear: new THREE.Matrix3().setFromMatrix4(matrix),
  shift: new THREE.Vector3().setFromMatrixPosition(matrix),
})

/** The same offset with a constant matrix. */
export const constantOffset =
  ({ elements: e }) =>
  ({ glsl, position }) =>
    glsl
      .mat3(glsl.vec3(e[0], e[1], e[2]), glsl.vec3(e[4], e[5], e[6]), glsl.vec3(e[8], e[9], e[10]))
      .mult(position)
      .sub(position)
      .add(glsl.vec3(e[12], e[13], e[14]))

/** Makes materials double-sided, so that the picture does not depend on which side the renderer considers the front. */
export function makeDoubleSided(object) {
  object.traverse(({ material }) => {
    for (const each of [material ?? []].flat()) each.side = THREE.DoubleSide
  })
  return object
}

/** Flips the bitangents of an object that a matrix mirrors: three.js itself leaves the sign in the tangent attribute unchanged. */
export function flipBitangents(object) {
  object.traverse(({ geometry }) => {
    const { tangent } = geometry?.attributes ?? {}
    for (let i = 0; i < (tangent?.count ?? 0); i++) tangent.setW(i, -tangent.getW(i))
  })
  return object
}

function makeNormalMap() {
  const data = new Uint8Array(4 * 16 * 16)
  for (let i = 0; i < 256; i++) {
    const [x, y] = [Math.sin(i * 0.8), Math.cos(Math.floor(i / 16) * 0.9)]
    data.set([128 + 60 * x, 128 + 60 * y, 220, 255], 4 * i)
  }
  const texture = new THREE.DataTexture(data, 16, 16)
  texture.needsUpdate = true
  texture.magFilter = THREE.LinearFilter
  return texture
}

const makeKnot = () => new THREE.TorusKnotGeometry(0.45, 0.16, 48, 10)

function withTangents(geometry) {
  geometry.computeTangents()
  return geometry
}

function withMorphs(geometry) {
  const { position, normal } = geometry.attributes
  const scaleAndShear = (attribute, factor) => {
    const copy = attribute.clone()
    for (let i = 0; i < copy.count; i++)
      copy.setXYZ(i, copy.getX(i) * factor, copy.getY(i) + 0.2 * copy.getX(i), copy.getZ(i))
    return copy
  }
  geometry.morphAttributes.position = [scaleAndShear(position, 1.3), scaleAndShear(position, 0.6)]
  geometry.morphAttributes.normal = [scaleAndShear(normal, 0.8), scaleAndShear(normal, 1.5)]
  return geometry
}

function makeSkinnedMesh(material, geometry = new THREE.CylinderGeometry(0.25, 0.25, 1.4, 12, 12)) {
  const { position } = geometry.attributes
  const [indices, weights] = [[], []]
  for (let i = 0; i < position.count; i++) {
    const height = (position.getY(i) + 0.7) / 0.7
    const bone = Math.min(1, Math.floor(height))
    indices.push(bone, bone + 1, 0, 0)
    weights.push(1 - (height - bone), height - bone, 0, 0)
  }
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4))
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4))
  const bones = [0, 1, 2].map(() => new THREE.Bone())
  bones[0].position.y = -0.7
  bones[1].position.y = bones[2].position.y = 0.7
  bones[0].add(bones[1])
  bones[1].add(bones[2])
  const mesh = new THREE.SkinnedMesh(geometry, material)
  mesh.add(bones[0])
  mesh.bind(new THREE.Skeleton(bones))
  bones[1].rotation.z = 0.7
  bones[2].rotation.x = -0.8
  return mesh
}

/** The matrices of instances. */
const matrices = [
  [-0.6, 0.5, 0, 0.5, 0.5, 0.5],
  [0.6, 0.4, 0.2, 0.3, 0.8, 0.5],
  [0, -0.5, 0, 0.9, 0.4, 0.6],
].map(([x, y, z, ...scale], i) =>
  new THREE.Matrix4().compose(
    new THREE.Vector3(x, y, z),
    new THREE.Quaternion().setFromEuler(new THREE.Euler(0.3 * i, 0.5, 0.2 * i)),
    new THREE.Vector3(...scale),
  ),
)

const makeStandard = (more) =>
  new THREE.MeshStandardMaterial({ color: 0xff9060, roughness: 0.5, ...more })

function makeInstances(material) {
  const mesh = new THREE.InstancedMesh(makeKnot(), material, matrices.length)
  matrices.forEach((matrix, i) => mesh.setMatrixAt(i, matrix))
  return mesh
}

function makeBatch(material) {
  const [a, b] = [makeKnot(), new THREE.SphereGeometry(0.4, 16, 12)]
  const hasOldApi = !THREE.BatchedMesh?.prototype.addInstance
  const count = a.attributes.position.count + b.attributes.position.count
  const mesh = new THREE.BatchedMesh(
    matrices.length,
    3 * count,
    3 * (a.index.count + b.index.count),
    material,
  )
  const geometries = hasOldApi ? [] : [mesh.addGeometry(a), mesh.addGeometry(b)]
  matrices.forEach((matrix, i) => {
    const id = hasOldApi ? mesh.addGeometry(i % 2 ? b : a) : mesh.addInstance(geometries[i % 2])
    mesh.setMatrixAt(id, matrix)
  })
  return mesh
}

const makeSeparateMeshes = (material, geometries) => {
  const group = new THREE.Group()
  matrices.forEach((matrix, i) => {
    const mesh = new THREE.Mesh(geometries[i % geometries.length], material)
    mesh.userData.before = matrix
    group.add(mesh)
  })
  return group
}

/**
 * Maps a name → a function that makes the object to warp, or two functions { warped, moved } if matrices of three.js cannot shear such an
 * object: `moved` makes an equivalent group of meshes.
 */
export const shapes = {
  plain: () => new THREE.Mesh(makeKnot(), makeStandard()),
  'normal map': () =>
    new THREE.Mesh(
      makeKnot(),
      makeStandard({ normalMap: makeNormalMap(), normalScale: new THREE.Vector2(1, 1) }),
    ),
  'bump map': () =>
    new THREE.Mesh(makeKnot(), makeStandard({ bumpMap: makeNormalMap(), bumpScale: 4 })),
  'vertex tangents': () =>
    new THREE.Mesh(withTangents(makeKnot()), makeStandard({ normalMap: makeNormalMap() })),
  'flat shading': () => new THREE.Mesh(makeKnot(), makeStandard({ flatShading: true })),
  'back side': () => new THREE.Mesh(makeKnot(), makeStandard({ side: THREE.BackSide })),
  'double side': () =>
    new THREE.Mesh(new THREE.PlaneGeometry(1, 1, 8, 8), makeStandard({ side: THREE.DoubleSide })),
  wireframe: () =>
    new THREE.Mesh(new THREE.SphereGeometry(0.6, 8, 6), makeStandard({ wireframe: true })),
  morphs: () => {
    const mesh = new THREE.Mesh(withMorphs(makeKnot()), makeStandard())
    mesh.morphTargetInfluences = [0.4, 0.3]
    return mesh
  },
  skin: () => makeSkinnedMesh(makeStandard()),
  instances: {
    warped: () => makeInstances(makeStandard()),
    moved: () => makeSeparateMeshes(makeStandard(), [makeKnot()]),
  },
  batch: {
    warped: () => makeBatch(makeStandard()),
    moved: () =>
      makeSeparateMeshes(makeStandard(), [makeKnot(), new THREE.SphereGeometry(0.4, 16, 12)]),
  },
  group: () => {
    const group = new THREE.Group()
    group.add(
      new THREE.Mesh(makeKnot(), makeStandard()),
      new THREE.Mesh(new THREE.SphereGeometry(0.4), [makeStandard()]),
    )
    group.children[1].geometry.clearGroups()
    group.children[1].geometry.addGroup(0, Infinity, 0)
    return group
  },
  points: () =>
    new THREE.Points(makeKnot(), new THREE.PointsMaterial({ size: 3, sizeAttenuation: false })),
  line: () => new THREE.Line(makeKnot(), new THREE.LineBasicMaterial({ color: 0xffff00 })),
  'dashed line': () => {
    const line = new THREE.LineSegments(
      makeKnot().toNonIndexed(),
      new THREE.LineDashedMaterial({ dashSize: 0.05, gapSize: 0.05 }),
    )
    return line.computeLineDistances()
  },
  clipping: () =>
    new THREE.Mesh(
      makeKnot(),
      makeStandard({
        clippingPlanes: [new THREE.Plane(new THREE.Vector3(1, 0.2, 0), 0.1)],
        clipShadows: true,
        side: THREE.DoubleSide,
      }),
    ),
  displacement: () =>
    new THREE.Mesh(
      makeKnot(),
      makeStandard({ displacementMap: makeNormalMap(), displacementScale: 0.1 }),
    ),
  'environment map': () => {
    const material = new THREE.MeshBasicMaterial({ envMap: makeNormalMap() })
    material.envMap.mapping = THREE.EquirectangularReflectionMapping
    return new THREE.Mesh(makeKnot(), material)
  },
  'a shader that onBeforeCompile changes': () => {
    const material = makeStandard()
    const isRed = { value: 1 }
    material.onBeforeCompile = (shader) => {
      shader.uniforms.isRed = isRed
      shader.fragmentShader = `uniform float isRed;\n${shader.fragmentShader}`.replace(
        '#include <opaque_fragment>',
        '#include <opaque_fragment>\ngl_FragColor.r += 0.5 * isRed;',
      )
    }
    return new THREE.Mesh(makeKnot(), material)
  },
  "a ShaderMaterial with three's chunks": () =>
    new THREE.Mesh(
      makeKnot(),
      new THREE.ShaderMaterial({
        vertexShader: THREE.ShaderLib.normal.vertexShader,
        fragmentShader: THREE.ShaderLib.normal.fragmentShader,
        uniforms: THREE.UniformsUtils.clone(THREE.ShaderLib.normal.uniforms),
      }),
    ),
  'alpha test': () => {
    const alphaMap = makeNormalMap()
    return new THREE.Mesh(makeKnot(), makeStandard({ alphaMap, alphaTest: 0.5 }))
  },
  'custom shadow materials': () => {
    const mesh = new THREE.Mesh(makeKnot(), makeStandard())
    const holes = { alphaMap: makeNormalMap(), alphaTest: 0.5 }
    mesh.customDepthMaterial = new THREE.MeshDepthMaterial({
      depthPacking: THREE.RGBADepthPacking,
      ...holes,
    })
    mesh.customDistanceMaterial = new THREE.MeshDistanceMaterial(holes)
    return mesh
  },
  ShadowMaterial: () => new THREE.Mesh(makeKnot(), new THREE.ShadowMaterial({ opacity: 0.8 })),
  ...Object.fromEntries(
    [
      ['Basic', { color: 0x80ff40 }],
      ['Lambert', {}],
      ['Phong', { shininess: 40 }],
      ['Physical', { clearcoat: 1, roughness: 0.4 }],
      ['Toon', {}],
      ['Normal', {}],
      ['Matcap', { matcap: makeNormalMap() }],
      ['Depth', {}],
    ].map(([name, more]) => [
      `Mesh${name}Material`,
      () => new THREE.Mesh(makeKnot(), new THREE[`Mesh${name}Material`](more)),
    ]),
  ),
}

const translation = [0.3, -0.2, 0.25]

/** Makes an image with the same translation in every texel. */
export function shiftMap() {
  const data = Float32Array.from({ length: 16 }, (_, i) => [...translation, 1][i % 4])
  const map = new THREE.DataTexture(data, 2, 2, THREE.RGBAFormat, THREE.FloatType)
  map.needsUpdate = true
  return map
}

/** Returns this translation as a matrix. */
export const shiftMatrix = () => new THREE.Matrix4().makeTranslation(...translation)

function makeLight(kind) {
  const light =
    kind === 'point'
      ? new THREE.PointLight(0xffffff, 12)
      : kind === 'spot'
        ? new THREE.SpotLight(0xffffff, 20, 0, 0.7)
        : new THREE.DirectionalLight(0xffffff, 2)
  light.position.set(1.5, 2.5, 2)
  light.castShadow = true
  light.shadow.mapSize.set(128, 128)
  light.shadow.bias = -0.002
  const { camera } = light.shadow
  Object.assign(camera, { near: 0.5, far: 12 })
  if (kind === 'directional') Object.assign(camera, { left: -3, right: 3, top: 3, bottom: -3 })
  return light
}

/** The side of pictures, in pixels. */
export const size = 96

/** Makes a scene of the object, a floor and a wall behind it, and a light with shadows. */
export function sceneOf(object, kind) {
  const scene = new THREE.Scene()
  scene.add(new THREE.HemisphereLight(0xffffff, 0x404060, 0.4), makeLight(kind), object)
  const wall = new THREE.Mesh(new THREE.PlaneGeometry(8, 8), new THREE.MeshStandardMaterial())
  wall.position.z = -1.2
  const floor = wall.clone()
  floor.rotation.x = -Math.PI / 2
  floor.position.set(0, -1.2, 0)
  wall.receiveShadow = floor.receiveShadow = true
  scene.add(wall, floor)
  scene.fog = new THREE.Fog(0x8080ff, 3, 14)
  // In shadow shaders, points have no defined size.
  object.traverse((part) =>
    Object.assign(part, { castShadow: !part.isPoints, receiveShadow: true }),
  )
  return scene
}

export const camera = () => {
  const made = new THREE.PerspectiveCamera(50, 1, 0.1, 50)
  made.position.set(0.4, 0.6, 3.2)
  made.lookAt(0, -0.1, 0)
  return made
}

/** The matrix of the warped object, with a nonuniform scale. */
export const place = new THREE.Matrix4().compose(
  new THREE.Vector3(0.1, 0.1, 0),
  new THREE.Quaternion().setFromEuler(new THREE.Euler(0.2, -0.4, 0.1)),
  new THREE.Vector3(1.1, 0.9, 1),
)

const plainMotion = motion

/** Makes an object that three's matrices move: before or after the object's matrix, depending on `space`. */
export function makeMoved(make, space, motion = plainMotion) {
  const object = (make.moved ?? make)()
  const setMatrix = (part, before = new THREE.Matrix4()) => {
    const factors = space === 'world' ? [motion, place, before] : [place, before, motion]
    part.matrixAutoUpdate = false
    part.matrix.identity()
    for (const factor of factors) part.matrix.multiply(factor)
  }
  if (space === 'rest') {
    // applyMatrix4 does not transform morph targets.
    object.geometry.applyMatrix4(motion)
    object.matrixAutoUpdate = false
    object.matrix.copy(place)
  } else if (object.isGroup)
    for (const child of object.children) setMatrix(child, child.userData.before)
  else setMatrix(object)
  return object
}

/** Makes the object to warp. */
export function makeUnmoved(make) {
  const object = (make.warped ?? make)()
  object.matrixAutoUpdate = false
  object.matrix.copy(place)
  return object
}
