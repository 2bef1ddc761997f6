// A mirroring warp is lit like the same shape under p5's `scale(-1, 1, 1)`: normals point outwards.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHosts, p5HostsInThisRun, p5InThisRun } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'

const { browsers, server } = await openHosts(p5HostsInThisRun)

const scales = 'glsl.vec3(position.x().mult(uniforms.flip.sub(1)), 0, 0)'

const setup = `
  noStroke()
  for (const space of ['local', 'world', 'camera'])
    warps[space] = createWarp(({ glsl, position }) => glsl.vec3(position.x().mult(-2), 0, 0), { space })
  warps.byUniform = createWarp(({ glsl, position, uniforms }) => ${scales}, { uniforms: { flip: 1 } })
  // On p5's sphere, whose local radius is 1, the normal equals the position, so this warp is linear there, too.
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

const materials = { lit, normals: 'normalMaterial()' }

for (const [version, renderer, scripts] of p5HostsInThisRun)
  describe(`p5 ${version}, ${renderer}`, () => {
    for (const [material, code] of Object.entries(materials)) {
      // p5 has no normalMaterial() on WebGPU.
      if (renderer === 'WEBGPU' && material === 'normals') continue
      test(`${material}: a mirroring warp draws the same as p5's scale(), in each space and with a uniform`, async () => {
        const scenes = Object.entries(pairs).flatMap(([name, [warped, moved]]) => [
          [name, `${code}; ${warped}`],
          [`${name}, with scale()`, `${code}; ${moved}`],
        ])
        const images = await drawScenes(browsers[renderer], server, [...scripts, addon], {
          renderer,
          setup,
          scenes: Object.fromEntries(scenes),
        })
        for (const name of Object.keys(pairs)) {
          const [image, expected] = [images[name], images[`${name}, with scale()`]]
          const covered = litPixels(expected).length
          assert.ok(covered > 2000, `${name}: ${covered} pixels`)
          const differing = differingPixels(image, expected, 8)
          assert.ok(differing < covered / 100, `${name}: ${differing} of ${covered} pixels differ`)
        }
      })
    }
  })

const hooks = {
  '2.x': `'Vertex getObjectInputs': '(Vertex inputs) { inputs.position.x *= flip; return inputs; }'`,
  1.11: `'vec3 getLocalPosition': '(vec3 position) { return vec3(position.x * flip, position.yz); }'`,
}

for (const [version, p5] of p5InThisRun)
  test(`p5 ${version}: normals point outwards when exactNormals corrects a hook that mirrors`, async () => {
    const drawFlipped = (flip) =>
      `shader(warps.hook); warps.hook.setUniform('flip', ${flip}); ${cone}`
    const images = await drawScenes(
      browsers.WEBGL,
      server,
      [p5, addon, '/dist/warpjet.glsl.min.js'],
      {
        setup: `
          noStroke()
          warps.hook = exactNormals(baseMaterialShader().modify({
            uniforms: { 'float flip': 1 },
            ${hooks[version]}
          }))`,
        scenes: Object.fromEntries(
          [1, -1].flatMap((flip) => [
            [flip, `${lit}; ${turned}; ${drawFlipped(flip)}`],
            [`${flip}, with scale()`, `${lit}; ${turned}; scale(${flip}, 1, 1); ${cone}`],
          ]),
        ),
      },
    )
    for (const flip of [1, -1]) {
      const expected = images[`${flip}, with scale()`]
      const differing = differingPixels(images[flip], expected, 8)
      assert.ok(differing < litPixels(expected).length / 100, `${flip}: ${differing} pixels differ`)
    }
  })
