// A warped mesh is lit like a mesh that was moved vertex by vertex, in double precision.
import assert from 'node:assert/strict'
import * as m from '../../support/browser/matrix.js'
import { geometryCode, sphereMesh } from '../../support/browser/mesh.js'
import { waves } from '../../support/browser/p5-waves.js'

const { code, offset, identityPlusJacobian } = waves(1)
const sphere = sphereMesh(32, 24)
const warped = {
  ...sphere,
  vertices: sphere.vertices.map((p) => m.add(p, offset(p))),
  normals: sphere.normals.map((n) => m.transformNormal(identityPlusJacobian(n), n)),
}

const materials = {
  lights: 'orbitControl(); lights()',
  fill: `lights(); fill('orange')`,
  specular: 'lights(); specularMaterial(250, 80, 80); shininess(20)',
  ambient: `ambientLight(120); directionalLight(90, 0, 90, 0, 1, -1); ambientMaterial('teal')`,
  texture: 'texture(stripes)',
  'lit texture': 'lights(); texture(stripes)',
  imageLight: 'imageLight(stripes)',
  normalMaterial: 'normalMaterial()',
}

export default [
  {
    title: 'a warp is lit like a mesh that was moved vertex by vertex, with each material',
    table: ({ isWebGPU }) => ({
      setup: `
        distort = createWarp(${code})
        stripes = createImage(32, 32)
        for (let y = 0; y < 32; y++)
          for (let x = 0; x < 32; x++) stripes.set(x, y, color(y < 20 ? 'purple' : 'yellow'))
        stripes.updatePixels()
        plain = ${geometryCode(sphere, 'plain')}
        moved = ${geometryCode(warped, 'moved')}`,
      pairs: Object.fromEntries(
        Object.entries(materials)
          // p5 2.3 itself draws no normalMaterial() on WEBGPU.
          .filter(([name]) => !(isWebGPU && name === 'normalMaterial'))
          .flatMap(([name, material]) => {
            const byVertex = `scale(60); noStroke(); ${material}; model(moved)`
            return [
              [name, [`scale(60); ${material}; distort(); model(plain)`, byVertex]],
              [
                `${name} after the warp`,
                [`scale(60); distort(); ${material}; model(plain)`, byVertex],
              ],
            ]
          }),
      ),
      ...{ lit: 5000, tolerance: 2, differing: 0.005 },
      check(images) {
        const shown = Object.entries(images).filter(([name]) => materials[name])
        for (const [name, [image]] of shown)
          for (const [other, [another]] of shown)
            if (other !== name) assert.notDeepEqual(image, another, `${name} and ${other}`)
      },
    }),
  },
]
