// Tests warps that are called while p5 builds a geometry: compares vertices and normals with a computation by hand and with the GPU.
// Also tests p5's functions that take a shader, called with a warp instead.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHosts, p5HostsInThisRun, runSketch } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const font = '/node_modules/@fontsource/fredoka/files/fredoka-latin-700-normal.woff'

const { browsers, server } = await openHosts(p5HostsInThisRun)

const setup = `
  noStroke()
  warps.wave = createWarp(({ glsl, position }) => glsl.vec3(0, position.x.mult(5).sin().mult(0.2), 0))
  warps.bumps = createWarp(({ position, normal, uv, uniforms }) =>
    normal.mult(position.y.mult(6).sin().add(uv.x.mult(6.2831853).cos()).mult(uniforms.height)),
    { uniforms: { height: 0.05 } })
  warps.sway = createWarp(({ glsl, position }) => glsl.vec3(position.y.mult(0.05).sin().mult(20), 0, 0),
    { space: 'world' })
  warps.bend = createWarp(({ normal, position }) => normal.normalize().mult(position.x.mult(0.08).sin().mult(8)),
    { space: 'world' })
`

for (const [version, renderer, scripts] of p5HostsInThisRun)
  describe(`p5 ${version}, ${renderer}`, () => {
    const browser = browsers[renderer]
    const isWebGPU = renderer === 'WEBGPU'

    /** Runs `code` in setup, which sets `result` → the result and the console messages. */
    async function run(code) {
      const { page, messages } = await runSketch(
        browser,
        server,
        [...scripts, addon],
        `const warps = {}
        ${isWebGPU || /\bawait\b/.test(code) ? 'async ' : ''}function setup() {
          ${isWebGPU ? 'await ' : ''}createCanvas(100, 100, ${renderer})
          ${setup}
          window.said = (work) => {
            try { work() } catch (error) { return error.name + ': ' + error.message }
            return 'nothing'
          }
          window.result = undefined
          ${code}
          window.done = true
        }`,
      )
      const result = await page.evaluate('result')
      await leavePage(page)
      return { result, messages }
    }

    test('buildGeometry() with a warp has the vertices and normals computed by hand', async () => {
      const { result, messages } = await run(`
        const numbers = ({ vertices, vertexNormals }) =>
          [vertices, vertexNormals].map((all) => all.map(({ x, y, z }) => [x, y, z]))
        const shape = (warp) => buildGeometry(() => {
          warp()
          push(); translate(10, 0, 0); rotateZ(0.5); sphere(60, 12, 8); pop()
          resetShader()
          beginShape(TRIANGLES); vertex(0, 0, 0); vertex(5, 0, 0); vertex(0, 5, 0); endShape()
        })
        result = [() => {}, warps.wave, warps.sway].map((warp) => numbers(shape(warp)))
        // p5's own shapes stay unchanged.
        result.push(numbers(shape(() => {})))`)
      assert.deepEqual(messages, [])
      const [plain, wave, sway, again] = result
      assert.deepEqual(again, plain)
      const [c, s] = [Math.cos(0.5), Math.sin(0.5)]
      const count = plain[0].length - 3
      assert.ok(count > 90)
      const turn = ([x, y, z]) => [c * x - s * y, s * x + c * y, z]
      const back = ([x, y, z]) => [c * x + s * y, c * y - s * x, z]
      const near = (actual, expected, far, what) =>
        actual.forEach((value, k) =>
          assert.ok(Math.abs(value - expected[k]) < far, `${what}: ${actual} for ${expected}`),
        )
      const unit = (v) => v.map((x) => x / Math.hypot(...v))
      for (let i = 0; i < count; i++) {
        const [p, n] = [plain[0][i], plain[1][i]]
        // The gradients of the sphere of size 1.
        const [x, y, z] = back([p[0] - 10, p[1], p[2]]).map((value) => value / 60)
        const [a, b, d] = back(n)
        const moved = turn([60 * x, 60 * (y + 0.2 * Math.sin(5 * x)), 60 * z])
        near(wave[0][i], [moved[0] + 10, moved[1], moved[2]], 1e-3, 'place')
        const normal = turn([a - Math.cos(5 * x) * b, b, d])
        near(unit(wave[1][i]), unit(normal), 1e-4, 'normal')
        // This shape is in the sketch's own pixels.
        near(
          sway[0][i],
          [p[0] + 20 * Math.sin(0.05 * p[1]), p[1], p[2]],
          1e-3,
          'place in the world',
        )
        near(
          unit(sway[1][i]),
          unit([n[0], n[1] - Math.cos(0.05 * p[1]) * n[0], n[2]]),
          1e-4,
          'normal in the world',
        )
      }
      for (const warped of [wave, sway])
        assert.deepEqual(warped[0].slice(count), plain[0].slice(count), 'after resetShader()')
    })

    test('a warp in buildGeometry() looks as on the GPU, with its uniforms and under lights', async () => {
      const shapes = {
        'local space': ['warps.wave()', 'sphere(60, 40, 30)'],
        'with normal and uv': ['warps.bumps({ height: 0.12 })', 'ellipsoid(60, 50, 40, 60, 40)'],
        'world space': ['warps.sway()', 'push(); rotateZ(0.5); torus(40, 15, 40, 30); pop()'],
        'with normal, in world space': [
          'warps.bend()',
          'push(); scale(1.5, 1, 1); sphere(40, 60, 40); pop()',
        ],
        'between vertices': ['warps.sway()', 'plane(90, 90, 1, 20)'],
      }
      const entries = Object.entries(shapes)
      const look =
        "noStroke(); ambientLight(40); directionalLight(255, 255, 255, 0.4, 0.6, -1); fill('coral'); rotateX(0.3)"
      const images = await drawScenes(browser, server, [...scripts, addon], {
        renderer,
        setup: `${setup}
          warps.built = [${entries.map(([, [warp, shape]]) => `buildGeometry(() => { ${warp}; ${shape} }).clearColors()`)}]
          warps.plain = [${entries.map(([, [, shape]]) => `buildGeometry(() => { ${shape} }).clearColors()`)}]`,
        scenes: Object.fromEntries(
          entries.flatMap(([name, [warp, shape]], i) => [
            [name, `${look}; model(warps.built[${i}])`],
            [
              `${name}, live`,
              `${look.replace('rotateX(0.3)', /sway|bend/.test(warp) ? '' : '$&')}; ${warp}; ${shape}`,
            ],
            [`${name}, level`, `${look.replace('rotateX(0.3)', '')}; model(warps.built[${i}])`],
            [`${name}, unmoved`, `${look}; model(warps.plain[${i}])`],
          ]),
        ),
      })
      for (const [name, [warp]] of entries) {
        const built = images[/sway|bend/.test(warp) ? `${name}, level` : name]
        const lit = litPixels(built).length
        assert.ok(lit > 2000, `${name}: ${lit} pixels are lit`)
        assert.ok(differingPixels(images[name], images[`${name}, unmoved`], 8) > 0.1 * lit, name)
        const differing = differingPixels(built, images[`${name}, live`], 4)
        assert.ok(differing <= 0.01 * lit, `${name}: ${differing} of ${lit} pixels differ`)
      }
    })

    test('warps that buildGeometry() does not support are rejected', async () => {
      const buildWith = async (warp) => {
        const { result } = await run(`
          const warp = ${warp}
          result = said(() => buildGeometry(() => { warp(); sphere(10) }))`)
        return result
      }
      assert.match(
        await buildWith(
          "createWarp(({ glsl, position }) => glsl.vec3(position.z, 0, 0), { space: 'camera' })",
        ),
        /^WarpError: buildGeometry: .*space: 'camera'.*call the warp before model/,
      )
      assert.match(
        await buildWith(`createWarp(({ glsl, uv, uniforms }) =>
          glsl.texture(uniforms.image, uv).xyz, { uniforms: { image: createImage(2, 2) } })`),
        /^WarpError: buildGeometry: .*only the GPU can do\. Call it before model/,
      )
    })

    test('shader(warp) applies the warp without a message', async () => {
      const look = "lights(); noStroke(); fill('red')"
      const images = await drawScenes(browser, server, [...scripts, addon], {
        renderer,
        setup,
        scenes: {
          called: `${look}; warps.wave(); sphere(60)`,
          handed: `${look}; shader(warps.wave); sphere(60)`,
          plain: `${look}; sphere(60)`,
        },
      })
      assert.ok(differingPixels(images.called, images.plain, 8) > 1000)
      assert.equal(differingPixels(images.handed, images.called, 0), 0)
    })

    test('messages of other calls that take a shader say what to write', async () => {
      const calls = {
        filter: 'filter(warps.wave)',
        modify: 'baseMaterialShader().modify(warps.wave)',
        'shader of another canvas': `createGraphics(20, 20, WEBGL).shader(warps.wave)`,
        ...(version === '2.x' && {
          imageShader: 'imageShader(warps.wave)',
          strokeShader: 'strokeShader(warps.wave)',
          build: 'buildMaterialShader(warps.wave)',
        }),
      }
      const { result } = await run(
        `result = { ${Object.entries(calls).map(([name, call]) => `'${name}': said(() => ${call})`)} }`,
      )
      for (const name of Object.keys(calls))
        assert.match(
          result[name],
          name === 'shader of another canvas'
            ? /^WarpError: shader: .*graphics\.createWarp/
            : /^WarpError: \w+: expected a shader, got the function that createWarp returned; .*(warp\(\)|createWarp\(offset)/,
          name,
        )
    })

    test('text() under a warp warns once, with advice for the sketch', async () => {
      const load = version === '2.x' ? 'await loadFont' : 'await new Promise((done) => loadFont'
      const { messages } = await run(`
        textFont(${load}('${font}'${version === '2.x' ? '' : ', done)'}))
        text('a', 0, 0)
        warps.wave()
        text('a', 0, 0)
        text('b', 0, 0)`)
      assert.equal(messages.length, 1, messages.join('; '))
      assert.match(messages[0], /^text: a warp cannot move it, .*textToModel.*createGraphics/)
    })
  })
