// createWarp in p5 sketches, on each host: checks pictures of the canvas. scenes.browser.test.js compares further scenes with p5 itself.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as m from '../support/browser/matrix.js'
import { directions, geometryCode } from '../support/browser/mesh.js'
import { addon, openP5Hosts } from '../support/browser/p5-hosts.js'
import { waves } from '../support/browser/p5-waves.js'
import { colorAt, litPixels } from '../support/browser/pixels.js'
import { drawScenes, p5Versions } from '../support/browser/sketch.js'

const size = 200

const hosts = await openP5Hosts()

const mapValues = (object, change) =>
  Object.fromEntries(Object.entries(object).map(([key, value]) => [key, change(value, key)]))

for (const { name: host, renderer, isV1, p5, draw } of hosts)
  describe(`createWarp on ${host}`, () => {
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
            const p = m.transformPoint(before, direction)
            const [x, y, z] = m.transformPoint(after, m.add(p, offset(p)))
            const moved = m.product(after, identityPlusJacobian(p), before)
            return {
              normal: m.transformNormal(moved, direction),
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
          assert.ok(error <= 3, `${space}, at ${screen}: expected ${expected}, got ${color}`)
        }
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
        // fill() selects another material.
        'without normalMaterial()': `normalMaterial(); distort(); fill('red'); again(); sphere(60)`,
      }
      // Frames without push() and pop(), as in typical sketches.
      const {
        first,
        'without normalMaterial()': red,
        ...others
      } = await draw({ setup, scenes, isPushed: false })
      for (const [name, image] of Object.entries(others)) assert.deepEqual(image, first, name)
      assert.deepEqual(colorAt(red, size / 2, size / 2), [255, 0, 0])
    })

    test("supports p5's random() over expressions, with and without friendly errors", async () => {
      // Like the stress test of the library p5.warp. Each branch moves the plane by 40 to the right.
      const setup = `
        distort = createWarp(({ glsl, position }) => {
          const { x, y } = { x: position.x().mult(0).add(40), y: position.y().mult(0).add(40) }
          return glsl.vec3(random([x, y]), 0, 0)
        }, { space: 'world' })`
      for (const scripts of [p5, p5.map((file) => file.replace('.js', '.min.js'))]) {
        const files = [...scripts, addon]
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
      // Each shift moves the plane by 40 to the right. The mouse is at 30, 10.
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
        'function by fn()': ({ glsl, position }) =>
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
      // Two triangles. The lower right one has a zero normal at its outer corner.
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

    test('moves strokes if the sketch sets them or by the option `stroke`', async () => {
      const setup = `
        const still = ({ glsl }) => glsl.vec3(0, 0, 0)
        warps.left = createWarp(still)
        warps.on = createWarp(still, { stroke: true })
        warps.off = createWarp(still, { stroke: false })
        warps.normal = createWarp(({ normal }) => normal.mult(1e-6), { surfaceVariation: false })
        warps.uv = createWarp(({ uv, glsl }) => glsl.vec3(uv.x().mult(1e-6), 0, 0), { surfaceVariation: false })
        warps.invalid = createWarp(({ uv, glsl }) => glsl.vec3(uv.x().mult(1e-6), 0, 0),
          { stroke: true, surfaceVariation: false })
        warps.away = createWarp(({ glsl }) => glsl.vec3(500, 0, 0), { space: 'world', stroke: true })
        fill(255, 0, 0)`
      const lines = `stroke(0, 0, 255); strokeWeight(10);`
      const scenes = {
        // p5's default is thin black lines.
        'a sketch that never sets a stroke': 'warps.left(); plane(100)',
        'the option': `strokeWeight(10); warps.on(); plane(100)`,
        'a sketch that sets a stroke before': `${lines} warps.left(); plane(100)`,
        'a sketch that sets a stroke afterwards': `warps.left(); ${lines} plane(100)`,
        'noStroke() before': `${lines} noStroke(); warps.on(); plane(100)`,
        'noStroke() after': `${lines} warps.on(); noStroke(); plane(100)`,
        'turned off': `${lines} warps.off(); plane(100)`,
        'an offset that depends on the normal': `${lines} warps.normal(); plane(100)`,
        'an offset that depends on uv': `${lines} warps.uv(); plane(100)`,
        'another shader': `${lines} warps.away(); shader(baseMaterialShader()); plane(100)`,
        resetShader: `${lines} warps.away(); resetShader(); plane(100)`,
        'after pop()': `${lines} push(); warps.away(); plane(100); pop(); plane(100)`,
        invalid: `${lines} try { warps.invalid() } catch ({ message }) {
          if (/lines have no normal, uv or fill/.test(message)) { noStroke(); fill(0, 255, 0); plane(100) } }`,
      }
      const expected = {
        'a sketch that never sets a stroke': 'red',
        'the option': 'black',
        'noStroke() before': 'red',
        'noStroke() after': 'red',
        'turned off': 'red',
        'an offset that depends on the normal': 'red',
        'an offset that depends on uv': 'red',
        invalid: 'green',
      }
      const colors = { red: [255, 0, 0], blue: [0, 0, 255], black: [0, 0, 0], green: [0, 255, 0] }
      const images = await draw({ setup, scenes })
      for (const [name, image] of Object.entries(images))
        assert.deepEqual(colorAt(image, 52, 100), colors[expected[name] ?? 'blue'], name)
    })

    if (!isV1)
      test('moves fills and strokes of instances by their own offsets', async () => {
        const { fills, strokes } = await draw({
          setup: `
            shape = buildGeometry(() => plane(20))
            warps.row = createWarp(({ glsl, instance }) => glsl.vec3(instance.sub(1).mult(50), 0, 0), { space: 'world' })`,
          scenes: {
            fills: `noStroke(); warps.row(); fill('red'); model(shape, 3)`,
            strokes: `noFill(); stroke('red'); strokeWeight(4); warps.row(); model(shape, 3)`,
          },
        })
        for (const x of [-50, 0, 50]) assert.deepEqual(colorAt(fills, 100 + x, 100), [255, 0, 0])
        assert.equal(litPixels(fills).length, 3 * 400)
        const countNear = (x) =>
          litPixels(strokes).filter((pixel) => Math.abs(pixel.x - x) < 25).length
        assert.ok(countNear(0) > 200, `${countNear(0)} pixels of an outline`)
        for (const x of [-50, 50])
          assert.ok(
            Math.abs(countNear(x) - countNear(0)) <= 4,
            `${countNear(x)} pixels at ${x}, ${countNear(0)} in the middle`,
          )
      })
  })

// Without `--all`, no other test of sketches runs on p5 1.11.
test('p5 1.11 draws warps that move, are lit by their normals, and read uniforms', async () => {
  const scripts = [p5Versions['1.11'], addon, '/dist/warpjet.deformers.min.js']
  const { moved, slope } = await drawScenes(hosts[0].webgl, hosts[0].server, scripts, {
    setup: `
      warps.move = createWarp(({ glsl, uniforms }) => glsl.vec3(uniforms.far, 0, 0), {
        space: 'world', uniforms: { far: 10 } })
      warps.slope = createWarp(warpjet.shear({ axis: 'x', direction: 'z', amount: -0.5 }),
        { type: 'normal', space: 'world' })`,
    scenes: {
      moved: `warps.move({ far: 40 }); fill('red'); plane(20)`,
      slope: `ortho(); warps.slope(); plane(100)`,
    },
  })
  assert.deepEqual(colorAt(moved, 140, 100), [255, 0, 0])
  assert.deepEqual(colorAt(moved, 100, 100), [0, 0, 0])
  // The normal of z = -x / 2.
  const normal = [0.5, 0, 1].map((x) => x / Math.hypot(0.5, 1))
  colorAt(slope, 100, 100).forEach((value, i) =>
    assert.ok(Math.abs(value - 255 * normal[i]) <= 1, `channel ${i}: ${value}`),
  )
})
