// The option `shader`: a warp on a shader of the sketch, whose hooks still run.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import * as m from '../support/browser/matrix.js'
import { geometryCode, sphereMesh } from '../support/browser/mesh.js'
import { colorAt, differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHosts, p5HostsInThisRun, runSketch } from '../support/browser/sketch.js'

const addon = '/dist/p5.warpjet.min.js'
const more = [addon, '/dist/warpjet.glsl.min.js']

const { browsers, server } = await openHosts(p5HostsInThisRun)

const directional = 'noStroke(); directionalLight(255, 255, 255, 0.4, 0.6, -1)'
const light = `${directional}; ambientLight(40)`
const bend = `({ glsl, position }) => glsl.vec3(position.y.mult(3).sin().mult(0.25), 0, 0)`
// The hook maps (x, y, z) to (-y, x, z), like rotateZ(PI / 2), and its normal too.
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

const bendPixels = `({ glsl, position }) => glsl.vec3(position.y.div(20).sin().mult(15), 0, 0)`

const sphere = sphereMesh(32, 24)
const stretch = m.scaling(1, 1.5, 0.6)
const plain = {
  ...sphere,
  vertices: sphere.vertices.map((p) => m.movePoint(stretch, p)),
  normals: sphere.normals.map((n) => m.turnNormal(stretch, n)),
}
const turn = ([x, y, z]) => [-y, x, z]
const turned = { ...plain, vertices: plain.vertices.map(turn), normals: plain.normals.map(turn) }

/** Draws only red. */
const reds = (image) => ({
  ...image,
  data: image.data.map((value, i) => (i % 4 === 1 || i % 4 === 2 ? 0 : value)),
})

for (const [version, renderer, scripts] of p5HostsInThisRun) {
  const draw = (options) =>
    drawScenes(browsers[renderer], server, [...scripts, ...more], { ...options, renderer })
  const isOrdered = version !== '1.11'
  const hook = hooks[version === '1.11' ? version : renderer === 'WEBGPU' ? 'wgsl' : 'glsl300']

  describe(`createWarp with the option shader, p5 ${version}, ${renderer}`, () => {
    test("runs before or after the sketch's hooks, and keeps their colours", async () => {
      const spaces = { local: bend, world: bendPixels, camera: bendPixels }
      const orders = { first: spaces, last: isOrdered ? { local: bend } : {} }
      const shape = (warp, model) =>
        `${light}; rotateY(0.5); warps.${warp}(); fill(250, 9, 9); ${model}`
      const setup = [
        hook,
        `plain = ${geometryCode(plain, 'plain')}; turned = ${geometryCode(turned, 'turned')}`,
      ]
      const scenes = {}
      for (const [order, each] of Object.entries(orders))
        for (const [space, offset] of Object.entries(each)) {
          const name = `${space}_${order}`
          const more = order === 'last' ? `, hooks: 'last'` : ''
          setup.push(`warps.${name} = createWarp(${offset}, { space: '${space}', shader: warps.turning${more} })
            warps.${name}_plain = createWarp(${offset}, { space: '${space}' })`)
          scenes[name] = shape(name, 'scale(50); model(plain)')
          const reference =
            order === 'first'
              ? 'scale(50); model(turned)'
              : 'scale(50); rotateZ(PI / 2); model(plain)'
          scenes[`${name} by p5`] = shape(`${name}_plain`, reference)
        }
      scenes.unwarped = `${light}; rotateY(0.5); shader(warps.turning); fill(250, 9, 9); scale(50); model(plain)`
      const images = await draw({ setup: setup.join('\n'), scenes })
      const { unwarped, ...others } = images
      for (const name of Object.keys(others).filter((each) => !each.endsWith(' by p5'))) {
        const red = reds(images[name])
        assert.ok(litPixels(red).length > 4000, `${name}: ${litPixels(red).length} lit`)
        assert.equal(litPixels(images[name]).filter(({ color }) => color[1] > 0).length, 0, name)
        const differing = differingPixels(red, reds(images[`${name} by p5`]), 3)
        assert.ok(differing < 25, `${name}: ${differing} pixels differ`)
        assert.ok(differingPixels(red, reds(unwarped), 30) > 500, `${name} moves`)
      }
    })

    test('passes on uniforms that the sketch or the warp sets', async () => {
      const { whole, half, quarter } = await draw({
        setup: `${hook}; distort = createWarp(${bend}, { shader: warps.turning })`,
        scenes: {
          whole: `noStroke(); distort(); fill(200, 0, 0); sphere(60)`,
          half: `shader(warps.turning); warps.turning.setUniform('red', 0.5); noStroke(); distort(); fill(200, 0, 0); sphere(60)`,
          quarter: `noStroke(); distort({ red: 0.25 }); fill(200, 0, 0); sphere(60)`,
        },
      })
      const red = (image) => colorAt(image, 100, 100)[0]
      assert.deepEqual([red(whole), red(half), red(quarter)], [200, 100, 50])
    })

    if (version !== '1.11')
      test('extends shaders of p5.strands, with and without exactNormals', async () => {
        const isExact = renderer === 'WEBGL'
        const { image, reference } = await draw({
          setup: `
            const strands = buildMaterialShader(() => {
              getObjectInputs((inputs) => {
                inputs.position.x += sin(inputs.position.y * 4) * 0.25
                return inputs
              })
              getPixelInputs((inputs) => { inputs.color = [0.5, 0, 0, 1]; return inputs })
            })
            warps.image = createWarp(({ glsl, position }) => glsl.vec3(0, position.x.mult(3).sin().mult(0.2), 0),
              { shader: ${isExact ? 'exactNormals(strands)' : 'strands'} })
            warps.reference = createWarp(({ glsl, position }) => {
              const x = position.y.mult(4).sin().mult(0.25)
              return glsl.vec3(x, position.x.add(x).mult(3).sin().mult(0.2), 0)
            })`,
          scenes: {
            image: `${isExact ? directional : 'noStroke()'}; warps.image(); scale(60); sphere(1, 48, 32)`,
            reference: `${isExact ? directional : 'noStroke()'}; warps.reference(); fill(128, 0, 0); scale(60); sphere(1, 48, 32)`,
          },
        })
        assert.ok(litPixels(reference).length > 5000)
        const differing = differingPixels(image, reference, 3)
        assert.ok(differing < 25, `${differing} pixels differ`)
      })

    test('rejects unsupported shaders', async () => {
      const options = (more) =>
        `(createWarp(({ glsl }) => glsl.vec3(0, 0, 0), { ${more} }), 'nothing was said')`
      const cases = {
        'shader: 3':
          /"shader": expected a shader that modify\(\) or buildMaterialShader\(\) made, got the number 3/,
        'shader: baseStrokeShader()':
          /expected a shader of shapes, .* got one without hooks for the vertices of shapes/,
        "shader: baseMaterialShader(), type: 'normal'": /"type" and "shader" exclude each other/,
        "shader: baseMaterialShader(), hooks: 'middle'":
          /expected 'first' or 'last' for the option "hooks", got the text "middle"/,
        ...(!isOrdered && {
          "shader: baseMaterialShader(), hooks: 'last'":
            /on p5 1.11 the hooks of the shader always run first/,
        }),
      }
      const isGpu = renderer === 'WEBGPU'
      const { page, messages } = await runSketch(
        browsers[renderer],
        server,
        [...scripts, ...more],
        `${isGpu ? 'async ' : ''}function setup() {
          ${isGpu ? 'await ' : ''}createCanvas(50, 50, ${renderer}); noLoop(); window.done = true
        }`,
      )
      for (const [more, sentence] of Object.entries(cases)) {
        const said = await page.evaluate(
          `(() => { try { return ${options(more)} } catch (error) { return error.message } })()`,
        )
        assert.match(said, sentence)
      }
      await leavePage(page)
      assert.deepEqual(messages, [])
    })
  })
}
