// createWarp in p5 sketches, on each supported p5: checks the picture on the canvas.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as m from '../support/browser/matrix.js'
import { directions, geometryCode, sphereMesh } from '../support/browser/mesh.js'
import { colorAt, differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHosts, p5HostsInThisRun } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const size = 200

const { browsers, server } = await openHosts(p5HostsInThisRun)

/**
 * f(p) = u g(p / u) with g(p) = (0.15 sin(2.4 y + 1), 0.11 sin(3.2 z), 0.12 sin(2 x)), in the sketch and in the oracle. The unit
 * u is 1 for p5's own shapes, which have size 1 in local space and are scaled.
 */
const waves = (u) => ({
  code: `({ glsl, position }) => glsl.vec3(
    position.y().mult(${2.4 / u}).add(1).sin().mult(${0.15 * u}),
    position.z().mult(${3.2 / u}).sin().mult(${0.11 * u}),
    position.x().mult(${2 / u}).sin().mult(${0.12 * u}),
  )`,
  offset: ([x, y, z]) => [
    0.15 * u * Math.sin((2.4 / u) * y + 1),
    0.11 * u * Math.sin((3.2 / u) * z),
    0.12 * u * Math.sin((2 / u) * x),
  ],
  identityPlusJacobian: ([x, y, z]) =>
    m.linear([
      [1, 0.36 * Math.cos((2.4 / u) * y + 1), 0],
      [0, 1, 0.352 * Math.cos((3.2 / u) * z)],
      [0.24 * Math.cos((2 / u) * x), 0, 1],
    ]),
})

const mapValues = (object, change) =>
  Object.fromEntries(Object.entries(object).map(([key, value]) => [key, change(value, key)]))

for (const [version, renderer, p5] of p5HostsInThisRun) {
  const draw = ({ files = p5, ...options }) =>
    drawScenes(browsers[renderer], server, [...files, addon], { size, renderer, ...options })

  describe(`createWarp on p5 ${version}, ${renderer}`, () => {
    test('has exact normals, shown as colours, for an offset in each space', async () => {
      // Describes the same scene twice: as calls of p5, and as matrices.
      const scene = `
        perspective(PI / 3, 1, 10, 2000)
        camera(60, -90, 300, 10, 5, 0, 0, 1, 0)
        translate(20, -15, 10)
        rotateZ(0.5)
        rotateY(-0.8)
        rotateX(0.4)
        scale(1.3, 0.8, 1.1)`
      const view = m.lookAt([60, -90, 300], [10, 5, 0], [0, 1, 0])
      const model = m.product(
        m.translation(20, -15, 10),
        m.rotation(0.5, 0, 1),
        m.rotation(-0.8, 2, 0),
        m.rotation(0.4, 1, 2),
        m.scaling(1.3, 0.8, 1.1),
        m.scaling(80, 80, 80),
      )
      const identity = m.scaling(1, 1, 1)
      const focal = 1 / Math.tan(Math.PI / 6)
      const spaces = {
        local: { unit: 1, before: identity, after: m.product(view, model) },
        world: { unit: 80, before: model, after: view },
        camera: { unit: 80, before: m.product(view, model), after: identity },
      }
      const images = await draw({
        setup: Object.entries(spaces)
          .map(([space, { unit }]) => {
            const options = `{ type: 'normal', space: '${space}' }`
            return `warps.${space} = createWarp(${waves(unit).code}, ${options})`
          })
          .join('\n'),
        scenes: mapValues(spaces, (_, space) => `${scene}; warps.${space}(); sphere(80, 160, 120)`),
      })

      for (const [space, { unit, before, after }] of Object.entries(spaces)) {
        const { offset, identityPlusJacobian } = waves(unit)
        const seen = directions(120)
          .map((direction) => {
            const p = m.movePoint(before, direction)
            const [x, y, z] = m.movePoint(after, m.add(p, offset(p)))
            const moved = m.product(after, identityPlusJacobian(p), before)
            return {
              normal: m.turnNormal(moved, direction),
              toEye: m.normalize([-x, -y, -z]),
              screen: [x, y].map((c) => ((1 + (focal * c) / -z) * size) / 2),
            }
          })
          .filter(({ normal, toEye }) => m.dot(normal, toEye) > 0.3)

        assert.ok(seen.length >= 15, `${space}: ${seen.length} points face the camera`)
        for (const { normal, screen } of seen) {
          const color = colorAt(images[space], ...screen)
          const expected = normal.map((value) => 255 * Math.max(value, 0))
          const error = Math.max(...color.map((value, i) => Math.abs(value - expected[i])))
          assert.ok(error <= 3, `${space}, at ${screen}: ${color} for ${expected}`)
        }
      }
    })

    test('is lit like a mesh that was moved vertex by vertex, with each material', async () => {
      const { code, offset, identityPlusJacobian } = waves(1)
      const sphere = sphereMesh(32, 24)
      const warped = {
        ...sphere,
        vertices: sphere.vertices.map((p) => m.add(p, offset(p))),
        normals: sphere.normals.map((n) => m.turnNormal(identityPlusJacobian(n), n)),
      }
      const materials = {
        lights: 'orbitControl(); lights()',
        fill: `lights(); fill('orange')`,
        specular: 'lights(); specularMaterial(250, 80, 80); shininess(20)',
        ambient: `ambientLight(120); directionalLight(90, 0, 90, 0, 1, -1); ambientMaterial('teal')`,
        texture: 'texture(stripes)',
        'lit texture': 'lights(); texture(stripes)',
        imageLight: 'imageLight(stripes)',
        // p5 2.3 itself draws no normalMaterial() on WEBGPU.
        ...(renderer === 'WEBGL' && { normalMaterial: 'normalMaterial()' }),
      }
      const setup = `
        distort = createWarp(${code})
        stripes = createImage(32, 32)
        for (let y = 0; y < 32; y++)
          for (let x = 0; x < 32; x++) stripes.set(x, y, color(y < 20 ? 'purple' : 'yellow'))
        stripes.updatePixels()
        plain = ${geometryCode(sphere, 'plain')}
        moved = ${geometryCode(warped, 'moved')}`
      const scenes = {}
      for (const [name, material] of Object.entries(materials)) {
        scenes[name] = `scale(60); ${material}; distort(); model(plain)`
        scenes[`${name} after the warp`] = `scale(60); distort(); ${material}; model(plain)`
        scenes[`${name} by vertex`] = `scale(60); noStroke(); ${material}; model(moved)`
      }
      const images = await draw({ setup, scenes })

      for (const name of Object.keys(materials)) {
        const image = images[name]
        const lit = litPixels(image).length
        assert.ok(lit > 5000, `${name}: ${lit} pixels are lit`)
        for (const other of [`${name} after the warp`, `${name} by vertex`]) {
          const differing = differingPixels(images[other], image, 2)
          assert.ok(differing < 0.005 * lit, `${other}: ${differing} of ${lit} pixels differ`)
        }
        for (const other of Object.keys(materials))
          if (other !== name) assert.notDeepEqual(image, images[other], `${name} and ${other}`)
      }
    })

    test('follows normalMaterial() before and after the warp, in each frame, until another material is set', async () => {
      const setup = `
        distort = createWarp(${waves(1).code})
        again = createWarp(${waves(1).code})`
      const normals = 'normalMaterial(); distort(); sphere(60)'
      const scenes = {
        first: normals,
        second: normals,
        'the other order': 'distort(); normalMaterial(); sphere(60)',
        third: `lights(); ${normals}`,
        'another warp': 'normalMaterial(); distort(); again(); sphere(60)',
        'after push and pop': 'normalMaterial(); push(); distort(); pop(); again(); sphere(60)',
        'in vain': `normalMaterial(); distort(); fill('red'); again(); sphere(60)`,
      }
      // Frames without push() and pop(), as in typical sketches.
      const { first, 'in vain': red, ...others } = await draw({ setup, scenes, isPushed: false })
      for (const [name, image] of Object.entries(others)) assert.deepEqual(image, first, name)
      assert.deepEqual(colorAt(red, size / 2, size / 2), [255, 0, 0])
    })

    test("supports p5's random() over expressions, with and without friendly errors", async () => {
      // Like p5.warp's own stress test; each branch moves by 40 to the right.
      const setup = `
        distort = createWarp(({ glsl, position }) => {
          const { x, y } = { x: position.x().mult(0).add(40), y: position.y().mult(0).add(40) }
          return glsl.vec3(random([x, y]), 0, 0)
        }, { space: 'world' })`
      for (const files of [p5, p5.map((file) => file.replace('.js', '.min.js'))]) {
        const scenes = { image: `noStroke(); distort(); fill('red'); plane(20)` }
        const { image } = await draw({ files, setup, scenes })
        assert.deepEqual(colorAt(image, size / 2 + 40, size / 2), [255, 0, 0])
      }
    })

    test('passes view-space normals to lights and textures', async () => {
      const setup = `
        distort = createWarp(${waves(1).code}, { type: 'normal' })
        stripes = createImage(8, 8)`
      const { alone, ...others } = await draw({
        setup,
        scenes: {
          alone: 'distort(); sphere(60)',
          lit: 'lights(); distort(); sphere(60)',
          textured: 'distort(); texture(stripes); sphere(60)',
        },
      })
      for (const [name, image] of Object.entries(others)) assert.deepEqual(image, alone, name)
    })

    test('reads each input and the uniforms of defs', async () => {
      // Each of these moves by 40 to the right; the mouse is at 30, 10.
      const shifts = {
        position: ({ position }) => position.x().mult(0).add(40),
        normal: ({ normal }) => normal.z().mult(40),
        uv: ({ uv }) => uv.x().add(uv.y()).mult(40),
        color: ({ color }) => color.x().add(color.w()).mult(20),
        millis: ({ millis }) => millis.min(40),
        mouse: ({ mouse }) => mouse.x().add(mouse.y()),
        mouseX: ({ mouseX, mouseY }) => mouseX.add(mouseY),
        size: ({ size }) => size.x().mult(0.2),
        width: ({ width, height }) => width.add(height).mult(0.1),
        pixelDensity: ({ pixelDensity }) => pixelDensity.mult(40),
        defs:
          renderer === 'WEBGL'
            ? ({ glsl }) => glsl.param('twice(amount)').add(glsl.vec3Param('shift').z())
            : ({ glsl }) =>
                glsl.param('amount').mult(glsl.param('twice(1)')).add(glsl.vec3Param('shift').z()),
        matrix: ({ glsl }) =>
          glsl
            .mat3Param('turn')
            .mult(glsl.vec3(0, 40, 0))
            .x(),
        'own function': ({ glsl, position }) =>
          glsl
            .fn({
              name: 'halved',
              source: {
                glsl: 'float halved(float x) { return 0.5 * x; }',
                wgsl: 'fn halved(x: f32) -> f32 { return 0.5 * x; }',
              },
              arity: 1,
              derivatives: [0.5],
            })(80)
            .add(position.x().mult(0)),
      }
      const twice =
        renderer === 'WEBGPU'
          ? 'fn twice(x: f32) -> f32 { return 2.0 * x; }'
          : 'float twice(float x) { return 2.0 * x; }'
      const defs = `uniform float amount;
        uniform vec3 shift;
        uniform mat3 turn;
        ${twice}`
      const warps = Object.entries(shifts).map(
        ([name, shift]) => `
          const shift = ${shift}
          const offset = (inputs) => inputs.glsl.vec3(shift(inputs), 0, 0)
          warps['${name}'] = createWarp(offset, {
            space: 'world', defs: ${JSON.stringify(defs)}, surfaceVariation: false
          })`,
      )
      const shape = `fill('red'); plane(20)`
      const images = await draw({
        setup: warps.map((code) => `{ ${code} }`).join('\n'),
        scenes: {
          ...mapValues(shifts, (_, name) => `warps['${name}'](); ${shape}`),
          matrix: `warps.matrix({ turn: [0, -1, 0, 1, 0, 0, 0, 0, 1] }); ${shape}`,
          defs: `warps.defs({ amount: 15, shift: [0, 0, 10] }); ${shape}`,
          'defs again': `warps.defs(); ${shape}`,
          'defs by vector': `warps.defs({ amount: 0, shift: createVector(0, 0, 40) }); ${shape}`,
        },
      })
      for (const [name, image] of Object.entries(images)) {
        const lit = litPixels(image)
        const mean = (axis) => lit.reduce((sum, pixel) => sum + pixel[axis], 0) / lit.length
        assert.deepEqual([mean('x'), mean('y')].map(Math.round), [40, 0], name)
      }
    })

    test('leaves no hole where there is no normal', async () => {
      // Two triangles; the lower right one has no normal at its corner.
      const tile = {
        vertices: [
          [-50, -50, 0],
          [50, -50, 0],
          [-50, 50, 0],
          [50, 50, 0],
        ],
        normals: [
          [0, 0, 1],
          [0, 0, 1],
          [0, 0, 1],
          [0, 0, 0],
        ],
        uvs: [0, 0, 1, 0, 0, 1, 1, 1],
        faces: [
          [0, 1, 2],
          [2, 1, 3],
        ],
      }
      const still = '({ glsl }) => glsl.vec3(0, 0, 0)'
      const light = 'ambientLight(60); directionalLight(200, 200, 200, 0, 0, -1)'
      const { colored, ...lit } = await draw({
        setup: `
          tile = ${geometryCode(tile, 'tile')}
          still = createWarp(${still})
          colors = createWarp(${still}, { type: 'normal' })
          flat = createWarp(({ glsl, position }) => glsl.vec3(0, 0, position.z().neg()))
          stairs = createWarp(({ glsl, position }) => {
            const x = position.x()
            return glsl.vec3(x.mult(5).floor().div(5).sub(x), 0, 0)
          })`,
        scenes: {
          // p5 2.3 draws nothing with ortho() on WEBGPU.
          ...(renderer === 'WEBGL' && { colored: 'ortho(); colors(); model(tile)' }),
          still: `${light}; still(); model(tile)`,
          flat: `${light}; flat(); sphere(60)`,
          stairs: `${light}; noStroke(); stairs(); plane(120, 120, 40, 40)`,
        },
      })
      for (const [name, image] of Object.entries(lit)) {
        const inside = litPixels(image).filter(
          ({ x, y }) => Math.max(Math.abs(x), Math.abs(y)) < 35,
        )
        const dark = inside.filter(({ color }) => color[0] < 59)
        assert.deepEqual([inside.length, dark.length], [70 * 70, 0], name)
      }
      if (!colored) return
      const blue = colorAt(colored, size / 2 + 50 - 100 / 3, size / 2 + 50 - 100 / 3)[2]
      assert.ok(Math.abs(blue - (2 / 3) * 255) < 3, `${blue} at the triangle's centre`)
    })
  })
}
