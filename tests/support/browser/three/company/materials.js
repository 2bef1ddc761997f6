// Rows of the company tests for changes that users make to materials and their shaders.
import * as THREE from 'three'
import {
  checker,
  makeRow,
  mesh,
  renderer,
  standard,
  torus,
  userMotion,
  withMotion,
  withOnBeforeCompile,
} from './lib.js'
import { straightCamera, twistByHand } from './twisted.js'

/** Makes a fragment shader output red where the GLSL expression `condition` is true. */
const redden = (shader, condition = 'true') => {
  shader.fragmentShader = shader.fragmentShader.replace(
    '#include <dithering_fragment>',
    `#include <dithering_fragment>\nif ( ${condition} ) gl_FragColor.r = 1.0;`,
  )
}

const replaceInVertexShader = (from, to) => (shader) => {
  shader.vertexShader = shader.vertexShader.replace(from, to)
}

const userBeginVertex = `vec3 transformed = vec3( position );\n${userMotion}`

/** Makes a material that adds a uniform and stores the shader in `userData`, like three's examples. */
const makeTinted = () => {
  const material = standard()
  material.onBeforeCompile = function (shader) {
    shader.uniforms.tint = { value: 0 }
    shader.fragmentShader = `uniform float tint;\n${shader.fragmentShader}`.replace(
      '#include <dithering_fragment>',
      'gl_FragColor.r = tint;',
    )
    this.userData.shader = shader
  }
  return material
}

/** Makes a mesh that a bone rotates or, by hand, one with rotated vertices. */
function makeSkinned(way, material) {
  const turn = new THREE.Matrix4().makeRotationY(0.6)
  if (way === 'byHand') return mesh(standard(), torus().applyMatrix4(turn))
  const geometry = torus()
  const { count } = geometry.attributes.position
  const weights = Float32Array.from({ length: 4 * count }, (_, i) => Number(i % 4 === 0))
  geometry.setAttribute(
    'skinIndex',
    new THREE.Uint16BufferAttribute(new Array(4 * count).fill(0), 4),
  )
  geometry.setAttribute('skinWeight', new THREE.BufferAttribute(weights, 4))
  const made = new THREE.SkinnedMesh(geometry, material)
  const bone = new THREE.Bone()
  made.add(bone)
  made.bind(new THREE.Skeleton([bone]))
  bone.rotation.y = 0.6
  return made
}

/** Makes a mesh with morph targets for positions and normals or, by hand, one with morphed vertices. */
function makeMorphed(way, material) {
  const geometry = torus()
  const targets = ['position', 'normal'].map((name) => {
    const target = geometry.attributes[name].clone()
    for (let i = 0; i < target.count; i++)
      target.setXYZ(i, 0.5 * target.getY(i), 0, name === 'normal' ? 0.3 : 0.2)
    return target
  })
  const influence = 0.8
  if (way === 'byHand') {
    for (const [k, name] of ['position', 'normal'].entries()) {
      const attribute = geometry.attributes[name]
      for (let i = 0; i < attribute.count; i++)
        for (const j of [0, 1, 2])
          attribute.setComponent(
            i,
            j,
            attribute.getComponent(i, j) + influence * targets[k].getComponent(i, j),
          )
    }
    return mesh(standard(), geometry)
  }
  geometry.morphAttributes = { position: [targets[0]], normal: [targets[1]] }
  geometry.morphTargetsRelative = true
  const made = mesh(material, geometry)
  made.morphTargetInfluences = [influence]
  return made
}

/** Maps the first four letters of a chunk → a function that makes a mesh whose shader uses the chunk. */
const meshMakers = { skin: makeSkinned, morp: makeMorphed, disp: makeDisplaced }

/** Shader chunks of three.js that a user may replace. */
const chunks = [
  'begin_vertex',
  'beginnormal_vertex',
  'defaultnormal_vertex',
  'normal_vertex',
  'skinbase_vertex',
  'skinnormal_vertex',
  'skinning_vertex',
  'morphtarget_vertex',
  'morphnormal_vertex',
  'displacementmap_vertex',
  'project_vertex',
  'worldpos_vertex',
]

/** Makes the mesh of three's example materials_modified, which rotates positions and normals about y by an angle that depends on y. */
const makeTwisted = (way) =>
  way === 'byHand'
    ? twistByHand()
    : mesh(
        withOnBeforeCompile(
          replaceInVertexShader(
            '#include <begin_vertex>',
            `float theta = sin( 1.0 + position.y ) / 2.0;
            float c = cos( theta );
            float s = sin( theta );
            mat3 m = mat3( c, 0, s, 0, 1, 0, - s, 0, c );
            vec3 transformed = vec3( position ) * m;
            vNormal = vNormal * m;`,
          ),
        ),
      )

class WithPrivateField extends THREE.MeshStandardMaterial {
  #tint = 0.9
  onBeforeCompile(shader) {
    redden(shader, String(this.#tint > 0.5))
  }
  customProgramCacheKey() {
    return `private ${this.#tint}`
  }
}

class WithArguments extends THREE.MeshStandardMaterial {
  constructor(options) {
    super()
    this.color.set(options.color)
    this.child = { parent: this }
    this.userData.self = this
  }
}

function makeTargetTexture() {
  const target = new THREE.WebGLRenderTarget(16, 16)
  const scene = new THREE.Scene()
  scene.background = new THREE.Color(0x20c060)
  renderer.setRenderTarget(target)
  renderer.render(scene, new THREE.Camera())
  renderer.setRenderTarget(null)
  return target.texture
}

/** Makes a material whose program depends on `userData.isRed`. */
function makeSwitchable() {
  const material = standard()
  material.userData.isRed = false
  material.onBeforeCompile = (shader) => redden(shader, String(material.userData.isRed))
  material.customProgramCacheKey = () => `red ${material.userData.isRed}`
  return material
}

/** Derives a material from another like troika-three-text. */
function deriveMaterial() {
  const base = standard()
  return Object.create(base, {
    isDerivedMaterial: { value: true },
    onBeforeCompile: {
      get: () => (shader, renderer) => {
        base.onBeforeCompile(shader, renderer)
        redden(shader)
      },
      set: (value) => {
        base.onBeforeCompile = value
      },
    },
    customProgramCacheKey: { value: () => 'derived' },
  })
}

function makeDisplaced(way, material = standard()) {
  const map = new THREE.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1)
  map.needsUpdate = true
  if (way !== 'byHand')
    return mesh(Object.assign(material, { displacementMap: map, displacementScale: 0.12 }))
  const geometry = torus()
  const { position, normal } = geometry.attributes
  for (let i = 0; i < position.count; i++)
    position.setXYZ(
      i,
      ...[0, 1, 2].map((k) => position.getComponent(i, k) + 0.12 * normal.getComponent(i, k)),
    )
  return mesh(standard(), geometry)
}

export const rows = {
  'begin_vertex is replaced': makeRow((way) =>
    withMotion(way, () =>
      withOnBeforeCompile(replaceInVertexShader('#include <begin_vertex>', userBeginVertex)),
    ),
  ),
  'code is appended to begin_vertex': makeRow((way) =>
    withMotion(way, () =>
      withOnBeforeCompile(
        replaceInVertexShader('#include <begin_vertex>', `#include <begin_vertex>\n${userMotion}`),
      ),
    ),
  ),
  'a motion is inserted before project_vertex': makeRow((way) =>
    withMotion(way, () =>
      withOnBeforeCompile(
        replaceInVertexShader(
          '#include <project_vertex>',
          `${userMotion}\n#include <project_vertex>`,
        ),
      ),
    ),
  ),
  'materials_modified of three.js': makeRow(makeTwisted, { view: straightCamera }),
  ...Object.fromEntries(
    chunks.map((name) => [
      `${name} is replaced by its own source`,
      makeRow((way) => {
        const make = meshMakers[name.slice(0, 4)] ?? ((_, material) => mesh(material))
        return make(
          way,
          withOnBeforeCompile(replaceInVertexShader(`#include <${name}>`, THREE.ShaderChunk[name])),
        )
      }),
    ]),
  ),
  'onBeforeCompile is an accessor property': makeRow(() => mesh(deriveMaterial())),
  'the material has defines': makeRow(() => {
    const material = withOnBeforeCompile((shader) => {
      shader.fragmentShader = shader.fragmentShader.replace(
        '#include <dithering_fragment>',
        '#ifdef RED\ngl_FragColor.r = 1.0;\n#endif',
      )
    })
    material.defines.RED = ''
    return mesh(material)
  }),
  'color, map and flatShading change': makeRow(() => mesh(), {
    then({ object: { material } }) {
      material.color.set('orange')
      Object.assign(material, { map: checker(), flatShading: true, needsUpdate: true })
    },
  }),
  'customProgramCacheKey changes': makeRow(() => mesh(makeSwitchable()), {
    then({ object: { material } }) {
      material.userData.isRed = true
      material.needsUpdate = true
    },
  }),
  'onBeforeCompile is replaced': makeRow(() => mesh(), {
    then({ object: { material } }) {
      material.onBeforeCompile = (shader) => redden(shader)
      material.needsUpdate = true
    },
  }),
  'userData.shader is set by onBeforeCompile': makeRow(() => mesh(makeTinted()), {
    then: ({ object }) => (object.material.userData.shader.uniforms.tint.value = 1),
  }),
  'userData.shader is set, and another mesh shares the material': makeRow(
    () => mesh(makeTinted()),
    {
      after({ object, scene }) {
        const box = new THREE.Mesh(new THREE.BoxGeometry(0.5, 0.5, 0.5), object.material)
        box.position.set(1, 1, 0)
        scene.add(box)
      },
      then: ({ object }) => (object.material.userData.shader.uniforms.tint.value = 1),
    },
  ),
  'material.onBeforeRender changes the color': makeRow(() => {
    const material = standard()
    material.onBeforeRender = function () {
      this.color.set('lime')
    }
    return mesh(material)
  }),
  'the class has a private field': makeRow(() => mesh(new WithPrivateField())),
  'the class has constructor arguments, fields and circular userData': makeRow(() =>
    mesh(new WithArguments({ color: 'orange' })),
  ),
  'the map is the texture of a render target': makeRow(() =>
    mesh(standard({ map: makeTargetTexture() })),
  ),
  'the material has a displacementMap': makeRow((way) => makeDisplaced(way)),
}
