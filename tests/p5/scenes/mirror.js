// A shape under a warp that mirrors must be lit like the same shape under p5's scale(-1, 1, 1), with normals that point outwards.
import { addon, glslAddon } from '../../support/browser/p5-hosts.js'

const scales = 'glsl.vec3(position.x().mult(uniforms.flip.sub(1)), 0, 0)'

const setup = `
  noStroke()
  for (const space of ['local', 'world', 'camera'])
    warps[space] = createWarp(({ glsl, position }) => glsl.vec3(position.x().mult(-2), 0, 0), { space })
  warps.byUniform = createWarp(({ glsl, position, uniforms }) => ${scales}, { uniforms: { flip: 1 } })
  // On p5's sphere, whose local radius is 1, the normal equals the position, so that this warp is linear, too.
  warps.along = createWarp(({ glsl, position, normal }) =>
    glsl.vec3(position.x().mult(-2), 0, 0).add(normal.mult(0.2)))`

const lit = `ambientLight(40); directionalLight(255, 255, 255, 0.4, 0.6, -1); pointLight(0, 120, 255, -200, -100, 100)
  specularMaterial(255, 127, 80); shininess(20)`
const turned = 'translate(20, 10, 0); rotateX(0.4); rotateZ(0.5)'
const cone = 'cone(50, 110, 32, 8)'

/** Maps a name to two drawings of the same shape: one mirrored with a warp, one with p5's scale(). */
const pairs = {
  local: [`${turned}; warps.local(); ${cone}`, `${turned}; scale(-1, 1, 1); ${cone}`],
  world: [`warps.world(); ${turned}; ${cone}`, `scale(-1, 1, 1); ${turned}; ${cone}`],
  camera: [`warps.camera(); ${turned}; ${cone}`, `scale(-1, 1, 1); ${turned}; ${cone}`],
  'along the normal': [
    'warps.along(); sphere(60, 64, 48)',
    'scale(-0.8, 1.2, 1.2); sphere(60, 64, 48)',
  ],
  ...Object.fromEntries(
    [1, 0.6, -0.6, -1].map((flip) => [
      `flipped with a uniform of ${flip}`,
      [
        `${turned}; warps.byUniform({ flip: ${flip} }); ${cone}`,
        `${turned}; scale(${flip}, 1, 1); ${cone}`,
      ],
    ]),
  ),
}

const inMaterial = (material) => () => ({
  setup,
  pairs: Object.fromEntries(
    Object.entries(pairs).map(([name, pair]) => [name, pair.map((code) => `${material}; ${code}`)]),
  ),
  ...{ lit: 2000, tolerance: 8, differing: 0.01 },
})

const hooks = {
  '2.x': `'Vertex getObjectInputs': '(Vertex inputs) { inputs.position.x *= flip; return inputs; }'`,
  1.11: `'vec3 getLocalPosition': '(vec3 position) { return vec3(position.x * flip, position.yz); }'`,
}

export default [
  {
    title: "a warp that mirrors is lit as under p5's scale(), in each space and with a uniform",
    table: inMaterial(lit),
  },
  {
    title: "a warp that mirrors has the same normals as p5's scale()",
    // p5 has no normalMaterial() on WebGPU.
    isOn: ({ isWebGPU }) => !isWebGPU,
    table: inMaterial('normalMaterial()'),
  },
  {
    title: 'normals point outwards when exactNormals corrects a hook that mirrors',
    // On WebGPU exactNormals reads no hooks in WGSL.
    isOn: ({ isWebGPU }) => !isWebGPU,
    table: ({ version, p5 }) => ({
      files: [...p5, addon, glslAddon],
      setup: `
        noStroke()
        warps.hook = exactNormals(baseMaterialShader().modify({
          uniforms: { 'float flip': 1 },
          ${hooks[version]}
        }))`,
      pairs: Object.fromEntries(
        [1, -1].map((flip) => [
          flip,
          [
            `${lit}; ${turned}; shader(warps.hook); warps.hook.setUniform('flip', ${flip}); ${cone}`,
            `${lit}; ${turned}; scale(${flip}, 1, 1); ${cone}`,
          ],
        ]),
      ),
      ...{ lit: 2000, tolerance: 8, differing: 0.01 },
    }),
  },
]
