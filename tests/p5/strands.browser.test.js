// Compares exactNormals of p5.strands shaders, in every style in which they can be written, with the same warp made with createWarp.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHosts, p5HostsInThisRun } from '../support/browser/sketch.js'

const hosts = p5HostsInThisRun
  .filter(([version]) => version === '2.x')
  .map(([, renderer, scripts]) => [
    renderer,
    [...scripts, '/dist/p5.warpjet.min.js', '/dist/warpjet.glsl.min.js'],
  ])

const { browsers, server } = await openHosts(p5HostsInThisRun)

const scene = (shading, shape = 'sphere(60, 48, 32)') =>
  `noStroke(); ambientLight(40); directionalLight(255, 255, 255, 0.4, 0.6, -1); ${shading}; fill('coral'); rotateX(0.4); ${shape}`

/** Maps a title → a strands sketch, and the same warp. */
const sketches = {
  "begin and end, in world space, with millis(), as in p5's reference": {
    strands: `buildMaterialShader(() => {
      const t = millis()
      worldInputs.begin()
      worldInputs.position.y += 20 * sin(t * 0.001 + worldInputs.position.x * 0.05)
      worldInputs.end()
    })`,
    byHand: `atVertices(({ glsl, position, millis }) =>
      glsl.vec3(0, millis.mult(0.001).add(position.x.mult(0.05)).sin().mult(20), 0), { space: 'world' })`,
  },
  'noise() and random() that only change colours': {
    strands: `baseMaterialShader().modify(() => {
      getObjectInputs((inputs) => {
        inputs.position.y += sin(inputs.position.x * 4) * 0.25
        return inputs
      })
      getFinalColor((color) => color * (noise(1.5) + random() > 9 ? 0.5 : 1))
    })`,
    byHand: `atVertices(({ glsl, position: { x } }) => glsl.vec3(0, x.mult(4).sin().mult(0.25), 0))`,
  },
  'begin and end, in object space, with declarations, an if, an else and a for': {
    strands: `baseMaterialShader().modify(() => {
      objectInputs.begin()
      let lift = 0
      const y = objectInputs.position.y
      if (y > 0) {
        lift = y * y * 0.5
      } else if (y > -0.5) {
        lift = y * 0.25
      } else {
        lift = -0.125
      }
      for (let i = 1; i < 4; i++) {
        lift += sin(objectInputs.position.z * 4 * i) * 0.0625 / i
      }
      let moved = objectInputs.position + [lift, 0, 0]
      objectInputs.position = moved
      objectInputs.end()
    })`,
    byHand: `atVertices(({ glsl, position: { y, z } }) => {
      let lift = y.gt(0).ifElse(y.mult(y).mult(0.5), y.gt(-0.5).ifElse(y.mult(0.25), -0.125))
      for (let i = 1; i < 4; i++) lift = lift.add(z.mult(4 * i).sin().mult(0.0625 / i))
      return glsl.vec3(lift, 0, 0)
    })`,
  },
  'begin and end, in camera space, with mix, smoothstep and a swizzle': {
    strands: `baseMaterialShader().modify(() => {
      cameraInputs.begin()
      const far = length(cameraInputs.position.xy)
      const near = smoothstep(10, 60, far)
      cameraInputs.position.z = mix(cameraInputs.position.z, cameraInputs.position.z + 25 * cos(far * 0.0625), near)
      cameraInputs.end()
    })`,
    byHand: `atVertices(({ glsl, position }) => {
      const far = position.xy.length()
      const near = glsl.smoothstep(10, 60, far)
      return glsl.vec3(0, 0, near.mult(far.mult(0.0625).cos().mult(25)))
    }, { space: 'camera' })`,
  },
  'a ternary, min, max, abs, pow, atan and clamp': {
    strands: `baseMaterialShader().modify(() => {
      getObjectInputs((inputs) => {
        const p = inputs.position
        const a = p.x > 0 ? pow(abs(p.x) + 0.25, 2) : 0.0625
        const b = max(min(p.y, 0.5), -0.25) * 0.5 + clamp(p.z, -0.5, 0.75) * 0.25
        inputs.position += [a * 0.5, 0, b + atan(p.y, 2) * 0.25]
        return inputs
      })
    })`,
    byHand: `atVertices(({ glsl, position: { x, y, z } }) => {
      const a = x.gt(0).ifElse(x.abs().add(0.25).pow(2), 0.0625)
      const b = y.min(0.5).max(-0.25).mult(0.5).add(z.clamp(-0.5, 0.75).mult(0.25))
      return glsl.vec3(a.mult(0.5), 0, b.add(y.atan2(2).mult(0.25)))
    })`,
  },
  'mod, which on WEBGPU is an operator': {
    isGLSL: true,
    strands: `baseMaterialShader().modify(() => {
      getObjectInputs((inputs) => {
        inputs.position.z += mod(inputs.position.y * 4 + 8, 16) * 0.0625
        return inputs
      })
    })`,
    byHand: `atVertices(({ glsl, position: { y } }) =>
      glsl.vec3(0, 0, y.mult(4).add(8).mod(16).mult(0.0625)))`,
  },
  'a varying that another hook reads': {
    strands: `baseMaterialShader().modify(() => {
      const lift = sharedFloat()
      getObjectInputs((inputs) => {
        lift = sin(inputs.position.x * 4) * 0.25
        inputs.position.y += lift
        return inputs
      })
      getFinalColor((color) => color * (lift > 9 ? 0.5 : 1))
    })`,
    byHand: `atVertices(({ glsl, position: { x } }) => glsl.vec3(0, x.mult(4).sin().mult(0.25), 0))`,
  },
  'a uniform with a name, and one whose value a function returns': {
    strands: `baseMaterialShader().modify(() => {
      const amount = uniformFloat('amount', 0.25)
      const way = uniformVector3(() => [0, 1, 0.5])
      const wave = (a) => sin(a * 4) * amount
      objectInputs.begin()
      objectInputs.position += way * wave(objectInputs.position.x)
      objectInputs.end()
    })`,
    byHand: `atVertices(({ glsl, position }) =>
      glsl.vec3(0, 1, 0.5).mult(position.x.mult(4).sin().mult(0.25)))`,
  },
  'a handwritten WGSL hook with an if, in compact style': {
    isWGSL: true,
    strands: `baseMaterialShader().modify({
      'Vertex getObjectInputs': \`(v: Vertex){
        var m = v;
        if (m.position.x > 0.0) { m.position.y += sin(m.position.x * 4.0) * 0.25; }
        return m;
      }\`,
    })`,
    byHand: `atVertices(({ glsl, position: { x } }) =>
      glsl.vec3(0, x.gt(0).ifElse(x.mult(4).sin().mult(0.25), 0), 0))`,
  },
  'GLSL hooks with uniforms that have the names of warp inputs': {
    isGLSL: true,
    strands: `baseMaterialShader().modify({
      uniforms: { 'float millis': () => 0.25, 'vec2 size': () => [4, 0.5], 'float instance': () => 0.125 },
      'Vertex getObjectInputs': \`(Vertex inputs) {
        inputs.position.x += sin(inputs.position.y * size.x) * millis + instance * inputs.position.z * inputs.position.z;
        return inputs;
      }\`,
    })`,
    byHand: `atVertices(({ glsl, position: { y, z } }) =>
      glsl.vec3(y.mult(4).sin().mult(0.25).add(z.mult(z).mult(0.125)), 0, 0))`,
  },
  'instances, each placed and deformed according to its number': {
    strands: `buildMaterialShader(() => {
      worldInputs.begin()
      worldInputs.position.x += (instanceID() - 1) * 60
      worldInputs.position.y += 8 * sin(worldInputs.position.x * 0.125 + instanceID())
      worldInputs.end()
    })`,
    byHand: `atVertices(({ glsl, position, instance }) => {
      const x = instance.sub(1).mult(60)
      return glsl.vec3(x, position.x.add(x).mult(0.125).add(instance).sin().mult(8), 0)
    }, { space: 'world' })`,
    shape: 'model(ball, 3)',
  },
}

for (const [renderer, scripts] of hosts)
  test(`${renderer}: exactNormals makes each style of p5.strands look like the same warp made with createWarp, unlike the original shader`, async () => {
    const entries = Object.entries(sketches).filter(
      ([, { isGLSL, isWGSL }]) => !(renderer === 'WEBGL' ? isWGSL : isGLSL),
    )
    const images = await drawScenes(browsers[renderer], server, scripts, {
      renderer,
      // exactNormals computes normals at vertices.
      setup: `window.atVertices = (offset, options) => createWarp(offset, { ...options, normals: 'vertex' })
      p5.prototype.millis = () => 1700
      window.ball = buildGeometry(() => sphere(28, 24, 16))
      ${entries
        .map(
          ([, { strands, byHand }], i) =>
            `warps.plain${i} = ${strands}\nwarps.own${i} = exactNormals(warps.plain${i})\nwarps.byHand${i} = ${byHand}`,
        )
        .join('\n')}`,
      scenes: Object.fromEntries(
        entries.flatMap(([name, { shape }], i) => [
          [name, scene(`shader(warps.own${i})`, shape)],
          [`${name}, plain`, scene(`shader(warps.plain${i})`, shape)],
          [`${name}, by hand`, scene(`warps.byHand${i}()`, shape)],
        ]),
      ),
    })
    const problems = entries.flatMap(([name]) => {
      const byHand = images[`${name}, by hand`]
      const differing = differingPixels(images[name], byHand, 2)
      const plain = differingPixels(images[`${name}, plain`], byHand, 8)
      const lit = litPixels(images[name]).length
      return differing < 20 && plain > 500 && lit > 3000
        ? []
        : [`${name}: ${differing} pixels differ, ${plain} without exactNormals; ${lit} are lit`]
    })
    assert.deepEqual(problems, [])
  })

test('exactNormals of noise() in p5.strands agrees with normals from finite differences', async () => {
  // If p moves by e f(p), and g is the gradient of f, normals become (1 + g·e) n - g (e·n).
  const sketch = (normal) => `baseMaterialShader().modify(() => {
    getObjectInputs((inputs) => {
      const lift = (x, y, z) => noise(x * 1.5 + 8, y * 1.5 + 8, z * 1.5 + 8) * 0.5
      const p = inputs.position
      ${normal}
      inputs.position += [0, lift(p.x, p.y, p.z), 0]
      return inputs
    })
  })`
  const byDifferences = `
    const h = 0.001
    const gx = (lift(p.x + h, p.y, p.z) - lift(p.x - h, p.y, p.z)) / (2 * h)
    const gy = (lift(p.x, p.y + h, p.z) - lift(p.x, p.y - h, p.z)) / (2 * h)
    const gz = (lift(p.x, p.y, p.z + h) - lift(p.x, p.y, p.z - h)) / (2 * h)
    const n = inputs.normal
    inputs.normal = normalize([(1 + gy) * n.x - gx * n.y, n.y, (1 + gy) * n.z - gz * n.y])`
  const images = await drawScenes(browsers.WEBGL, server, hosts[0][1], {
    setup: `
      warps.plain = ${sketch('')}
      warps.own = exactNormals(warps.plain)
      warps.byDifferences = ${sketch(byDifferences)}`,
    scenes: Object.fromEntries(
      ['plain', 'own', 'byDifferences'].map((name) => [name, scene(`shader(warps.${name})`)]),
    ),
  })
  assert.ok(litPixels(images.own).length > 4000)
  const plain = differingPixels(images.plain, images.byDifferences, 8)
  assert.ok(plain > 5000, `${plain} pixels differ without exactNormals`)
  // Finite differences of four octaves are slightly inaccurate where the noise bends most.
  const differing = differingPixels(images.own, images.byDifferences, 8)
  assert.ok(differing < plain / 100, `${differing} pixels differ, ${plain} without exactNormals`)
})

const gpu = hosts.find(([renderer]) => renderer === 'WEBGPU')
if (gpu) {
  test('on WEBGPU a vertex whose surface is collapsed to a point has the normal returned by its hook', async () => {
    const images = await drawScenes(browsers.WEBGPU, server, gpu[1], {
      renderer: 'WEBGPU',
      setup: `warps.plain = baseMaterialShader().modify(() => {
        getObjectInputs((inputs) => {
          if (inputs.position.y < -0.5) { inputs.position = [0, -0.5, 0] }
          return inputs
        })
      })
      warps.own = exactNormals(warps.plain)
      if (warps.own === warps.plain) throw new Error('exactNormals returned the same shader')`,
      scenes: Object.fromEntries(
        ['plain', 'own'].map((name) => [
          name,
          scene(`shader(warps.${name})`, 'rotateX(-0.8); sphere(60, 48, 32)'),
        ]),
      ),
    })
    assert.ok(litPixels(images.plain).length > 3000)
    assert.equal(differingPixels(images.own, images.plain, 2), 0)
  })
}
