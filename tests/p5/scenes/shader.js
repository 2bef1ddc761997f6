// The option `shader`: a warp on a shader of the sketch, whose hooks must still run. In the reference pictures, p5 or the warp performs the
// motion of the hook.
import assert from 'node:assert/strict'
import * as m from '../../support/browser/matrix.js'
import { geometryCode, sphereMesh } from '../../support/browser/mesh.js'
import { addon, glslAddon } from '../../support/browser/p5-hosts.js'
import { litPixels } from '../../support/browser/pixels.js'

const directional = 'noStroke(); directionalLight(255, 255, 255, 0.4, 0.6, -1)'
const light = `${directional}; ambientLight(40)`
export const bend = `({ glsl, position }) => glsl.vec3(position.y.mult(3).sin().mult(0.25), 0, 0)`
const bendPixels = `({ glsl, position }) => glsl.vec3(position.y.div(20).sin().mult(15), 0, 0)`

// The hook maps positions and normals (x, y, z) to (-y, x, z), like rotateZ(PI / 2).
const hooks = {
  glsl300: `
    warps.turning = baseMaterialShader().modify({
      uniforms: { 'float red': () => 1 },
      vertexDeclarations: 'const float one = 1.0;',
      'vec3 turned': '(vec3 v) { return vec3(-v.y, v.x, v.z); }',
      'Vertex getObjectInputs': '(Vertex inputs) { inputs.position = turned(inputs.position); inputs.normal = one * turned(inputs.normal); return inputs; }',
      'vec4 getFinalColor': '(vec4 color, vec2 texCoord) { return vec4(red * color.r, 0.0, 0.0, 1.0); }',
    })`,
  1.11: `
    warps.turning = baseMaterialShader().modify({
      uniforms: { 'float red': () => 1 },
      'vec3 getLocalPosition': '(vec3 v) { return vec3(-v.y, v.x, v.z); }',
      'vec3 getLocalNormal': '(vec3 v) { return vec3(-v.y, v.x, v.z); }',
      'vec4 getFinalColor': '(vec4 color) { return vec4(red * color.r, 0.0, 0.0, 1.0); }',
    })`,
  wgsl: `
    warps.turning = baseMaterialShader().modify({
      uniforms: { 'red: f32': () => 1 },
      vertexDeclarations: 'fn turned(v: vec3<f32>) -> vec3<f32> { return vec3<f32>(-v.y, v.x, v.z); }',
      'Vertex getObjectInputs': '(given: Vertex) { var inputs = given; inputs.position = turned(inputs.position); inputs.normal = turned(inputs.normal); return inputs; }',
      'vec4f getFinalColor': '(color: vec4<f32>, texCoord: vec2<f32>) { return vec4<f32>(hooks.red * color.r, 0.0, 0.0, 1.0); }',
    })`,
}
/** Returns code that sets warps.turning to a shader of the sketch. */
export const turningShader = ({ isV1, isWebGPU }) =>
  hooks[isV1 ? 1.11 : isWebGPU ? 'wgsl' : 'glsl300']

const sphere = sphereMesh(32, 24)
const stretch = m.scaling(1, 1.5, 0.6)
const plain = {
  ...sphere,
  vertices: sphere.vertices.map((p) => m.transformPoint(stretch, p)),
  normals: sphere.normals.map((n) => m.transformNormal(stretch, n)),
}
const turn = ([x, y, z]) => [-y, x, z]
const turned = { ...plain, vertices: plain.vertices.map(turn), normals: plain.normals.map(turn) }

/** Returns an image with only its red channel. */
const onlyRed = (image) => ({
  ...image,
  data: image.data.map((value, i) => (i % 4 === 1 || i % 4 === 2 ? 0 : value)),
})

/** Maps the option `hooks` → a map from space to offset. On p5 1.11, the hooks of the shader always run first. */
const ordersOf = ({ isV1 }) => ({
  first: { local: bend, world: bendPixels, camera: bendPixels },
  ...(!isV1 && { last: { local: bend } }),
})

export default [
  {
    title: "a warp runs before or after the sketch's hooks, and keeps their colours",
    table: (host) => {
      const setup = [
        turningShader(host),
        `plain = ${geometryCode(plain, 'plain')}; turned = ${geometryCode(turned, 'turned')}`,
      ]
      const pairs = {}
      for (const [order, spaces] of Object.entries(ordersOf(host)))
        for (const [space, offset] of Object.entries(spaces)) {
          const name = `${space}_${order}`
          const hooksLast = order === 'last' ? `, hooks: 'last'` : ''
          setup.push(`warps.${name} = createWarp(${offset}, { space: '${space}', shader: warps.turning${hooksLast} })
            warps.${name}_plain = createWarp(${offset}, { space: '${space}' })`)
          const byP5 = order === 'first' ? 'model(turned)' : 'rotateZ(PI / 2); model(plain)'
          pairs[name] = [
            `warps.${name}(); fill(250, 9, 9); scale(50); model(plain)`,
            `warps.${name}_plain(); fill(250, 9, 9); scale(50); ${byP5}`,
            'shader(warps.turning); fill(250, 9, 9); scale(50); model(plain)',
          ].map((code) => `${light}; rotateY(0.5); ${code}`)
        }
      return {
        ...{ setup: setup.join('\n'), pairs, view: onlyRed },
        ...{ lit: 4000, tolerance: 3, differing: 24, different: [500, 30] },
        check(images) {
          for (const [name, [image]] of Object.entries(images)) {
            const others = litPixels(image).filter(({ color }) => color[1] > 0).length
            assert.equal(others, 0, `${name}: pixels that the hook did not colour`)
          }
        },
      }
    },
  },
  {
    title: 'a warp extends shaders of p5.strands, with and without exactNormals',
    isOn: ({ isV1 }) => !isV1,
    table({ isWebGPU, p5 }) {
      const look = isWebGPU ? 'noStroke()' : directional
      return {
        files: [...p5, addon, glslAddon],
        setup: `
          const strands = buildMaterialShader(() => {
            getObjectInputs((inputs) => {
              inputs.position.x += sin(inputs.position.y * 4) * 0.25
              return inputs
            })
            getPixelInputs((inputs) => { inputs.color = [0.5, 0, 0, 1]; return inputs })
          })
          warps.image = createWarp(({ glsl, position }) => glsl.vec3(0, position.x.mult(3).sin().mult(0.2), 0),
            { shader: ${isWebGPU ? 'strands' : 'exactNormals(strands)'} })
          warps.reference = createWarp(({ glsl, position }) => {
            const x = position.y.mult(4).sin().mult(0.25)
            return glsl.vec3(x, position.x.add(x).mult(3).sin().mult(0.2), 0)
          })`,
        pairs: {
          strands: [
            `${look}; warps.image(); scale(60); sphere(1, 48, 32)`,
            `${look}; warps.reference(); fill(128, 0, 0); scale(60); sphere(1, 48, 32)`,
          ],
        },
        ...{ lit: 5000, tolerance: 3, differing: 24 },
      }
    },
  },
]
