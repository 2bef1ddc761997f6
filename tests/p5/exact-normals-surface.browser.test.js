// exactNormals for hooks that move vertices along the normal, by texture coordinates or by an image: compares the light with that of the
// same warp by createWarp. Also tests messages about unsupported hooks.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHosts, p5HostsInThisRun, runSketch } from '../support/browser/sketch.js'

const addons = ['/dist/p5.warpjet.min.js', '/dist/warpjet.glsl.min.js']

const { browsers, server } = await openHosts(p5HostsInThisRun)

const scene = (shading, shape = 'sphere(60, 60, 48)') =>
  `noStroke(); ambientLight(40); directionalLight(255, 255, 255, 0.4, 0.6, -1); ${shading}; fill('coral'); rotateX(0.4); ${shape}`

const strands = (moves) => `baseMaterialShader().modify(() => { ${moves} })`
const image = `
  warps.image = createImage(32, 32)
  warps.image.loadPixels()
  for (let i = 0; i < 1024; i++)
    warps.image.pixels.set([128 + 120 * Math.sin((i % 32) * 0.39), 0, 0, 255], 4 * i)
  warps.image.updatePixels()`

/** Maps a name to [a shader of p5.strands, the arguments of createWarp for the same warp]. */
const inStrands = {
  'along the normal': [
    strands(`getObjectInputs((inputs) => {
      inputs.position += inputs.normal * 0.15 * sin(inputs.position.y * 6)
      return inputs
    })`),
    `({ normal, position }) => normal.mult(position.y.mult(6).sin().mult(0.15))`,
  ],
  'with texture coordinates': [
    strands(`getObjectInputs((inputs) => {
      inputs.position.y += 0.12 * sin(inputs.texCoord.x * 18.849556)
      return inputs
    })`),
    `({ glsl, uv }) => glsl.vec3(0, uv.x.mult(18.849556).sin().mult(0.12), 0)`,
  ],
  'along the normal, in world space': [
    strands(`getWorldInputs((inputs) => {
      inputs.position += normalize(inputs.normal) * 8 * sin(inputs.position.y * 0.1)
      return inputs
    })`),
    `({ normal, position }) => normal.normalize().mult(position.y.mult(0.1).sin().mult(8)), { space: 'world' }`,
  ],
  'along the normal, in camera space': [
    strands(`getCameraInputs((inputs) => {
      inputs.position += normalize(inputs.normal) * 8 * sin(inputs.position.y * 0.1)
      return inputs
    })`),
    `({ normal, position }) => normal.normalize().mult(position.y.mult(0.1).sin().mult(8)), { space: 'camera' }`,
  ],
}

/** Maps a name to such a pair, whose hook reads an image. */
const inImages = {
  'with an image': [
    strands(`const heights = uniformTexture(() => warps.image)
    getObjectInputs((inputs) => {
      inputs.position += inputs.normal * 0.2 * getTexture(heights, inputs.texCoord).r
      return inputs
    })`),
    `({ glsl, normal, uv, uniforms }) => normal.mult(glsl.texture(uniforms.map, uv).x.mult(0.2)), { uniforms: { map: warps.image } }`,
  ],
}

/** Maps a name to a height in p5.strands. The kinks of % and mod() are between vertices of the plane. */
const heights = {
  'noise()': 'noise(x * 0.03, y * 0.03) * 25',
  '%': 'abs(((x + 101) % 30) - 15) + abs(((y + 102) % 50) - 25) * 0.5',
  'mod()': 'abs(mod(x + 101, 40) - 20) * (0.5 + y * 0.004)',
  'a condition and a loop': 'hillAt(x, y)',
}
/** Returns a shader of p5.strands that moves vertices in world space; `normal` is code that changes the normal. */
const inWorld = (height, normal) => `baseMaterialShader().modify(() => {
  const slope = uniformFloat(() => 0.3)
  getWorldInputs((inputs) => {
    const hillAt = (x, y) => {
      let s = 0
      for (let i = 1; i < 4; i++) {
        if (x > 0) { s += sin(x * 0.05 * i) * 3 } else { s += x * 0.05 * i }
        s += min(max(y * slope, -10), 10)
      }
      return s
    }
    const heightAt = (x, y) => ${height}
    let x = inputs.position.x
    let y = inputs.position.y
    ${normal}
    inputs.position.z += heightAt(x, y)
    return inputs
  })
})`
const byDifferences = `
    let byX = (heightAt(x + 0.05, y) - heightAt(x - 0.05, y)) * 10
    let byY = (heightAt(x, y + 0.05) - heightAt(x, y - 0.05)) * 10
    inputs.normal = normalize(inputs.normal - [byX, byY, 0] * inputs.normal.z)`

/** Maps a name to such a pair, whose shader is modified by a hook of p5 1.11. */
const inOldHooks = {
  'along the normal': [
    `baseMaterialShader().modify({ 'vec3 getLocalPosition': \`(vec3 position) {
      return position + aNormal * 0.15 * sin(position.y * 6.0);
    }\` })`,
    inStrands['along the normal'][1],
  ],
  'with texture coordinates': [
    `baseMaterialShader().modify({ 'vec3 getLocalPosition': \`(vec3 position) {
      return position + vec3(0.0, 0.12 * sin(aTexCoord.x * 18.849556), 0.0);
    }\` })`,
    inStrands['with texture coordinates'][1],
  ],
}

for (const [version, renderer, scripts] of p5HostsInThisRun)
  describe(`p5 ${version}, ${renderer}`, () => {
    const isOld = version === '1.11'
    const isWebGPU = renderer === 'WEBGPU'

    test('has the light of the same warp', async () => {
      const pairs = isOld ? inOldHooks : { ...inStrands, ...(!isWebGPU && inImages) }
      const entries = Object.entries(pairs)
      const images = await drawScenes(browsers[renderer], server, [...scripts, ...addons], {
        renderer,
        // exactNormals computes normals at vertices.
        setup: `${image}
          window.atVertices = (offset, options) => createWarp(offset, { ...options, normals: 'vertex' })
          ${entries.map(([, [shader, warp]], i) => `warps.plain${i} = ${shader}; warps.own${i} = exactNormals(warps.plain${i}); warps.byHand${i} = atVertices(${warp})`).join('\n')}`,
        scenes: Object.fromEntries(
          entries.flatMap(([name], i) => [
            [name, scene(`shader(warps.own${i})`)],
            [`${name}, a ring`, scene(`shader(warps.own${i})`, 'torus(50, 20, 60, 40)')],
            [`${name}, plain`, scene(`shader(warps.plain${i})`)],
            [`${name}, by hand`, scene(`warps.byHand${i}()`)],
            [`${name}, a ring, by hand`, scene(`warps.byHand${i}()`, 'torus(50, 20, 60, 40)')],
          ]),
        ),
      })
      for (const [name] of entries)
        for (const title of [name, `${name}, a ring`]) {
          const expected = images[`${title}, by hand`]
          assert.ok(litPixels(expected).length > 4000, title)
          const differing = differingPixels(images[title], expected, 3)
          assert.ok(differing < 40, `${title}: ${differing} pixels differ`)
        }
      for (const [name] of entries)
        assert.ok(
          differingPixels(images[`${name}, plain`], images[`${name}, by hand`], 8) > 1000,
          `${name}: wrong light would not be detected`,
        )
    })

    if (!isOld)
      test('has the light of normals that the sketch computes by finite differences', async () => {
        const entries = Object.entries(heights)
        const images = await drawScenes(browsers[renderer], server, [...scripts, ...addons], {
          renderer,
          setup: entries
            .map(
              ([, height], i) =>
                `warps.plain${i} = ${inWorld(height, '')}; warps.own${i} = exactNormals(warps.plain${i}); warps.byHand${i} = ${inWorld(height, byDifferences)}`,
            )
            .join('\n'),
          scenes: Object.fromEntries(
            entries.flatMap(([name], i) =>
              ['own', 'plain', 'byHand'].map((kind) => [
                `${name}, ${kind}`,
                scene(`shader(warps.${kind}${i})`, 'plane(150, 150, 80, 80)'),
              ]),
            ),
          ),
        })
        for (const [name] of entries) {
          const expected = images[`${name}, byHand`]
          assert.ok(litPixels(expected).length > 4000, name)
          const differing = differingPixels(images[`${name}, own`], expected, 4)
          assert.ok(differing < 100, `${name}: ${differing} pixels differ`)
          const wrong = differingPixels(images[`${name}, plain`], expected, 8)
          assert.ok(wrong > 3000, `${name}: wrong light would only be detected in ${wrong} pixels`)
        }
      })

    test('messages about unsupported hooks use the names of the sketch', async () => {
      const mistakes = {
        ...(!isOld && {
          random: [
            strands(`getObjectInputs((inputs) => {
              if (inputs.position.x > 0) inputs.position += inputs.normal * random() * 0.2
              return inputs
            })`),
            /^exactNormals: the shader stays as it is\. random\(\) in getObjectInputs .* write noise\(\)/,
          ],
          lines: [
            'baseStrokeShader()',
            /^WarpError: exactNormals: expected a shader of surfaces.* a shader of lines/,
          ],
          'a filter': ['baseFilterShader()', /^WarpError: exactNormals: expected .* got a filter/],
        }),
        ...(isOld && {
          lines: [
            'baseStrokeShader()',
            /^WarpError: exactNormals: expected a shader of surfaces.* a shader of lines/,
          ],
        }),
        ...(isWebGPU && {
          'a storage': [
            `(() => {
              const list = createStorage(new Float32Array(100))
              return ${strands(`const list = uniformStorage('list', warps.list ??= createStorage(new Float32Array(100)))
              getObjectInputs((inputs) => {
                inputs.position.y += list[floor(inputs.position.x)]
                return inputs
              })`)}
            })()`,
            /^exactNormals: the shader stays as it is\. uniformStorage\(\) "list" in getObjectInputs .* differs over the surface/,
          ],
        }),
        ...(!isWebGPU && {
          'no hooks': [
            `createShader('void main() {}', 'void main() {}')`,
            /^WarpError: exactNormals: expected .* got one without hooks, such as createShader/,
          ],
        }),
      }
      const { page } = await runSketch(
        browsers[renderer],
        server,
        [...scripts, ...addons],
        `const warps = {}
        window.said = {}
        ${isWebGPU ? 'async ' : ''}function setup() {
          ${isWebGPU ? 'await ' : ''}createCanvas(50, 50, ${renderer})
          const { warn } = console
          ${Object.entries(mistakes)
            .map(
              ([name, [shader]]) => `{
            const shader = ${shader}
            console.warn = (text) => (said['${name}'] = text)
            try { exactNormals(shader) } catch (error) { said['${name}'] = error.name + ': ' + error.message }
            console.warn = warn
          }`,
            )
            .join('\n')}
          window.done = true
        }`,
      )
      const said = await page.evaluate('said')
      await leavePage(page)
      for (const [name, [, message]] of Object.entries(mistakes))
        assert.match(`${said[name]}`, message, name)
    })
  })
