// Integers that are constants or frame constants keep all 32 bits: compares them with JavaScript's integer arithmetic.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import * as THREE from 'three'
import { glslOffset } from '../../dist/glsl.js'
import { warp } from '../../dist/three.js'
import { compileWarp } from '../../dist/warpjet.js'

const bitsOf = (x) => new Uint32Array(Float32Array.of(x).buffer)[0]

/** The hash pcg of Jarzynski and Olano, "Hash Functions for GPU Rendering" (2020). */
const pcgSource = `uint pcg(uint v) {
  uint state = v * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}`
function pcg(v) {
  const state = (Math.imul(v, 747796405) + 2891336453) >>> 0
  const word = Math.imul((state >>> ((state >>> 28) + 4)) ^ state, 277803737) >>> 0
  return ((word >>> 22) ^ word) >>> 0
}

/**
 * The two 16-bit halves of the integer h, which float32 represents exactly, as coordinates: in GLSL, and in JavaScript. The third
 * coordinate is 0, but reads a frame constant.
 */
const halvesSource = 'vec3(float(h & 65535u), float(h >> 16u), sin(millis) * 0.0)'
const halvesOf = (h) => [h & 0xffff, h >>> 16]
const offsetOf = (source, uniforms = 'uniform float millis;\n') =>
  glslOffset(`#version 300 es\n${uniforms}${source}`)

/** Returns the warped position of a vertex, by default at the origin. */
function warpPosition(offset, options, uniforms, position = [0, 0, 0]) {
  const warp = compileWarp(offset, { normals: false, ...options })
  return warp.evaluateAt(position, { uniforms }).position
}

const optionSets = [{}, { perFrame: true }]

test('constants beyond 2^24 are exact in expressions that also read frame constants', () => {
  const offset = offsetOf(
    `${pcgSource}\nvec3 offset(vec3 p) {
      uint h = pcg(floatBitsToUint(p.x)) + (sin(millis) > 2.0 ? 1u : 0u);
      return ${halvesSource} + vec3(sin(millis), 0.0, 0.0);
    }`,
  )
  for (const target of ['glsl300', 'wgsl'])
    for (const options of optionSets) {
      const { code } = compileWarp(offset, { target, ...options })
      assert.match(code, /\b747796405\b/)
      assert.doesNotMatch(code, /747796416/)
    }
  for (const options of optionSets)
    for (const x of [0.3, -7.25, 1e-20]) {
      const [low, high] = halvesOf(pcg(bitsOf(x)))
      const [moved, y] = warpPosition(offset, options, { millis: 0 }, [x, 0, 0])
      assert.ok(Math.abs(moved - x - low) < 0.01, `${moved} is not ${low}`)
      assert.equal(y, high)
    }
})

test('frame constants are exact in loops and in functions with many calls', () => {
  const calls = Array.from({ length: 30 }, (_, i) => `mixed(p.x + ${i}.0)`).join(' + ')
  const rounds = 'h = (h ^ (h >> 16u)) * 747796405u; h = (h ^ (h >> 15u)) * 2891336453u;'.repeat(4)
  const offset = offsetOf(
    `float mixed(float x) { uint h = floatBitsToUint(x); ${rounds} return float(h >> 20u); }
    vec3 offset(vec3 p) {
      float sum = sin(millis) * 0.0 + ${calls};
      for (int i = 0; i < 9; i++) sum += float((floatBitsToUint(p.x + float(i)) ^ 2891336453u) & 4095u);
      return vec3(0.0, sum, 0.0);
    }`,
  )
  function mixed(x) {
    let h = bitsOf(x)
    for (let i = 0; i < 4; i++) {
      h = Math.imul(h ^ (h >>> 16), 747796405) >>> 0
      h = Math.imul(h ^ (h >>> 15), 2891336453) >>> 0
    }
    return h >>> 20
  }
  assert.match(compileWarp(offset).declarations, /mixed_/)
  for (const options of optionSets)
    for (const x of [0.5, 3.25]) {
      let sum = 0
      for (let i = 0; i < 30; i++) sum += mixed(x + i)
      for (let i = 0; i < 9; i++) sum += (bitsOf(x + i) ^ 2891336453) & 4095
      assert.equal(warpPosition(offset, options, { millis: 0 }, [x, 0, 0])[1], sum)
    }
})

test('the bits of a uniform are exact, and so are values computed from them', () => {
  const seeds = [0, -0, 1, 2.75, -3.5, 1e-30, 16777217, -1e30, 123456.789]
  const offset = (h) =>
    offsetOf(
      `${pcgSource}\nvec3 offset(vec3 p) { uint h = ${h} + uint(p.z); return ${halvesSource}; }`,
      'uniform float millis, seed;\n',
    )
  const results = {
    'floatBitsToUint(seed)': (seed) => bitsOf(seed),
    'pcg(floatBitsToUint(seed))': (seed) => pcg(bitsOf(seed)),
    'uint(-int(floatBitsToUint(seed)))': (seed) => -bitsOf(seed) >>> 0,
    'uint(floatBitsToInt(seed) >> 3)': (seed) => ((bitsOf(seed) | 0) >> 3) >>> 0,
    'uint(floatBitsToInt(seed) / 3)': (seed) => Math.trunc((bitsOf(seed) | 0) / 3) >>> 0,
    '(seed > 0.0 ? 4294967295u : 2147483648u)': (seed) => (seed > 0 ? 4294967295 : 2147483648),
  }
  for (const [expression, compute] of Object.entries(results))
    for (const options of optionSets)
      for (const seed of seeds) {
        const warpOptions = { ...options, uniforms: { seed: 1 } }
        const [low, high] = warpPosition(
          offset(expression),
          warpOptions,
          { millis: 0, seed },
          [0, 0, 7],
        )
        const expected = halvesOf((compute(seed) + 7) >>> 0)
        assert.deepEqual(
          [low, high],
          expected,
          `${expression} for seed ${seed} ${JSON.stringify(options)}`,
        )
      }
})

test('frame constants are numbers that float32 represents exactly, in every language', () => {
  const bits = offsetOf(
    'vec3 offset(vec3 p) { uint h = floatBitsToUint(millis) ^ floatBitsToUint(p.x); return vec3(float(h & 255u)); }',
  )
  for (const millis of [1200, 1e9, 0.1]) {
    const warp = compileWarp(bits, { perFrame: true, normals: false })
    for (const number of Object.values(warp.frameUniforms({ millis })).flat())
      assert.equal(Math.fround(number), number)
    assert.doesNotMatch(warp.code, /floatBits\w+\(millis/)
  }
  // GLSL ES 1.00 has integers, but no bit operations.
  const steps = glslOffset(
    'uniform float millis; vec3 offset(vec3 p) { int n = int(millis) / 100; return vec3(float(n - n / 7 * 7), p.xy); }',
  )
  for (const target of ['glsl100', 'glsl300', 'wgsl'])
    for (const millis of [1234, 7e8]) {
      const warp = compileWarp(steps, { target, perFrame: true, normals: false })
      const n = Math.trunc(millis / 100) % 7
      assert.equal(warp.evaluateAt([0, 0, 0], { uniforms: { millis } }).position[0], n)
      assert.doesNotMatch(warp.code, /<<|>>|&/)
    }
})

test('frame constants beyond the maximum of 128 are computed in the shader', () => {
  const terms = Array.from(
    { length: 100 },
    (_, i) => `float((floatBitsToUint(millis * ${i + 1}.0) ^ uint(p.x)) & 15u)`,
  )
  const offset = offsetOf(`vec3 offset(vec3 p) { return vec3(0.0, ${terms.join(' + ')}, 0.0); }`)
  const sum = (millis) =>
    terms.reduce((sum, _, i) => sum + (bitsOf(Math.fround(millis * (i + 1))) & 15), 0)
  for (const options of optionSets)
    assert.equal(warpPosition(offset, options, { millis: 7.1875 })[1], sum(7.1875))
})

test('three.js uses the exact values in the shader, in its uniforms, and for raycasting', () => {
  const offset = offsetOf(
    `${pcgSource}\nvec3 offset(vec3 p) { uint h = pcg(floatBitsToUint(seed)) + uint(p.z); return ${halvesSource}; }`,
    'uniform float millis, seed;\n',
  )
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), new THREE.MeshBasicMaterial())
  const warped = warp(mesh, offset, { uniforms: { seed: 1 } })
  const { vertexShader, fragmentShader, uniforms } = THREE.ShaderLib.basic
  const shader = { vertexShader, fragmentShader, uniforms: { ...uniforms } }
  const drawn = []
  const renderer = {
    renderBufferDirect: (...args) => drawn.push(args[3]),
    compile() {},
    properties: { get: () => ({}) },
    capabilities: { maxVaryings: 30 },
  }
  const draw = () => {
    mesh.onBeforeRender(renderer)
    renderer.renderBufferDirect(null, null, mesh.geometry, mesh.material, mesh, null)
    return drawn.at(-1)
  }
  draw().onBeforeCompile(shader, renderer)
  assert.match(shader.vertexShader, /warpjetFrame0/)
  assert.doesNotMatch(
    shader.vertexShader,
    /747796405|2891336453|277803737/,
    'expected no hash in the shader: it is a frame constant',
  )
  for (const seed of [2.75, -1e30, 123456.789]) {
    warped.uniforms.seed.value = seed
    const [low, high] = halvesOf(pcg(bitsOf(seed)))
    const hitsAt = (x, y) =>
      new THREE.Raycaster(new THREE.Vector3(x, y, 5), new THREE.Vector3(0, 0, -1)).intersectObject(
        mesh,
      )
    assert.equal(hitsAt(low + 0.3, high + 0.2).length, 1)
    assert.equal(hitsAt(low + 1.5, high + 0.2).length, 0)
    draw()
    const halves = shader.uniforms.warpjetFrame0.value
    const integers = halves.flatMap((upper) => halves.map((lower) => (upper * 65536 + lower) >>> 0))
    assert.ok(integers.includes(pcg(bitsOf(seed))), `${halves}`)
  }
})
