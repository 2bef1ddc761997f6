// Tests WGSL source: compares values and derivatives with the same GLSL and with finite differences; checks inputs and derived source.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from 'warpjet'
import { differentiate, glslOffset, wgslOffset } from 'warpjet/glsl'
import { ownFunctions } from '../wgsl/own.js'

const points = [
  [0.3, 0.7, -0.2],
  [-0.6, 0.1, 0.9],
  [0.9, -0.8, 0.4],
]

const withoutVariation = { surfaceVariation: false }
const warpOf = (source, options) => compileWarp(wgslOffset(source, options), withoutVariation)
const normal = [0, 1, 0]

const messageOf = (work) => {
  try {
    work()
  } catch (error) {
    assert.equal(error.name, 'WarpError', error.stack)
    return error.message
  }
  return ''
}

test('a function has the value, the normal and the code of the same GLSL', () => {
  const wgsl = wgslOffset('fn offset(p: vec3f) -> vec3f { return vec3f(sin(p.y), 0, 0); }')
  const glsl = glslOffset('vec3 offset(vec3 p) { return vec3(sin(p.y), 0, 0); }')
  for (const target of ['glsl300', 'glsl100', 'wgsl'])
    assert.equal(compileWarp(wgsl, { target }).code, compileWarp(glsl, { target }).code)
  const [x, y, z] = [0.25, 0.5, -1]
  const { position, normal: warpedNormal } = compileWarp(wgsl).evaluateAt([x, y, z], { normal })
  assert.ok(Math.abs(position[0] - x - Math.sin(y)) < 1e-6, `${position}`)
  assert.deepEqual(Array.from(position.slice(1)), [y, z])
  // The inverse transpose of the Jacobian of (x + sin y, y, z) maps (0, 1, 0) to itself, and (1, 0, 0) to (1, -cos y, 0).
  const step = 1e-3
  const slope = (Math.sin(y + step) - Math.sin(y - step)) / (2 * step)
  assert.ok(Math.abs(warpedNormal[0]) < 1e-6 && warpedNormal[1] > 0.999, `${warpedNormal}`)
  const tilted = compileWarp(wgsl).evaluateAt([x, y, z], { normal: [1, 0, 0] }).normal
  const length = Math.hypot(1, slope)
  assert.ok(Math.abs(tilted[0] - 1 / length) < 1e-5, `${tilted}`)
  assert.ok(Math.abs(tilted[1] + slope / length) < 1e-5, `${tilted}`)
})

/** Matches functions of integers, bits or steps, whose derivatives finite differences cannot estimate. */
const isStairs =
  /bits|pack|integer|unsigned|shifts|bitcast|conversions|steps|parts of floats|remainder/

for (const [name, text] of Object.entries(ownFunctions))
  test(`${name}: the normal agrees with finite differences`, () => {
    const warp = warpOf(text, { function: 'own', maxIterations: 16 })
    assert.ok(warp.code.length > 0)
    if (isStairs.test(name)) return
    const at = (p) => warp.evaluateAt(p, { normal }).position
    for (const p of points) {
      const warpedNormal = warp.evaluateAt(p, { normal }).normal
      if (!warpedNormal.every(Number.isFinite)) continue
      // Warped tangents, from finite differences, are perpendicular to the normal.
      for (const k of [0, 2]) {
        const [before, after] = [-4e-3, 4e-3].map((step) =>
          at(p.map((x, i) => x + (i === k) * step)),
        )
        const tangent = Array.from(after, (x, i) => x - before[i])
        const size = Math.hypot(...tangent)
        if (!(size > 1e-3) || size > 0.5) continue
        const along = tangent.reduce((sum, x, i) => sum + x * warpedNormal[i], 0) / size
        assert.ok(Math.abs(along) < 0.02, `${name} at ${p}, tangent ${k}: ${along}`)
      }
    }
  })

test('uniforms, overrides and elements of storage buffers are inputs by their names in the shader', () => {
  const { uniforms, code } = compileWarp(
    wgslOffset(`
      struct Light { way: vec3f, power: f32 }
      struct Scene { time: f32, unused: mat4x4f, lights: array<Light, 2>, count: i32 }
      @group(0) @binding(0) var<uniform> scene: Scene;
      @group(0) @binding(1) var<storage, read> heights: array<vec4f>;
      var<uniform> amount: f32;
      override scale: f32 = 2;
      fn offset(p: vec3f) -> vec3f {
        let light = &scene.lights[1];
        return p * scene.time + (*light).way * light.power + heights[3].xyz * amount * scale + f32(scene.count);
      }`),
    { target: 'wgsl' },
  )
  assert.deepEqual(uniforms.map(({ name, type }) => `${type} ${name}`).sort(), [
    'float amount',
    'float scale',
    'float scene.lights[1].power',
    'float scene.time',
    'int scene.count',
    'vec3 scene.lights[1].way',
    'vec4 heights[3]',
  ])
  assert.match(code, /heights\[3\]/)
})

test('declared uniforms and inputs have their values', () => {
  const offset = wgslOffset(
    'var<uniform> amount: f32; fn offset(position: vec3f, millis: f32) -> vec3f { return vec3f(position.y * amount, millis, 0); }',
  )
  const warp = compileWarp(offset, { uniforms: { amount: 3 } })
  const { position } = warp.evaluateAt([0, 2, 0], { normal, uniforms: { amount: 5, millis: 7 } })
  assert.deepEqual(Array.from(position), [10, 9, 0])
})

test('textures become images', () => {
  const { code } = compileWarp(
    wgslOffset(`@group(0) @binding(0) var map: texture_2d<f32>; @group(0) @binding(1) var mapSampler: sampler;
      fn read(t: texture_2d<f32>, s: sampler, uv: vec2f) -> f32 { return textureSampleLevel(t, s, uv, 0).x; }
      fn offset(p: vec3f) -> vec3f {
        let size = vec2f(textureDimensions(map));
        return vec3f(0, read(map, mapSampler, p.xz), textureLoad(map, vec2i(p.xz * size), 0).y);
      }`),
    { target: 'wgsl' },
  )
  assert.match(code, /map/)
})

test('differentiate writes WGSL, or GLSL if the option target says so', () => {
  const source = 'fn wave(p: vec2f, t: f32) -> f32 { return sin(p.x * 2 + t) * p.y; }'
  const wgsl = differentiate(source, { language: 'wgsl' })
  assert.match(wgsl, /^fn waveGradient\(p: vec2f, t: f32\) -> vec3f \{/)
  assert.match(
    differentiate(source, { language: 'wgsl', target: 'glsl300' }),
    /^vec3 waveGradient\(vec2 p, float t\) \{/,
  )
  // The derived source can be read again.
  assert.match(
    differentiate(wgsl, { language: 'wgsl', by: 't' }),
    /^fn waveGradientJacobian\(p: vec2f, t: f32\) -> vec3f \{/,
  )
})

test('a continuing block reads the variables of the body, also after a continue', () => {
  // The steps are 1, 2, 3 and 4.
  const text = `fn offset(p: vec3f) -> vec3f {
    var i = 0; var sum = 0.0;
    loop {
      let step = f32(i) + 1.0;
      if step > 1.5 { continue; }
      continuing { sum += step; i++; break if i >= 4; }
    }
    return vec3f(sum, 0.0, 0.0);
  }`
  assert.equal(warpOf(text).evaluateAt([1, 0, 0], { normal }).position[0], 11)
})

test('messages name types of WGSL', () => {
  assert.match(
    messageOf(() => wgslOffset('fn offset(p: vec3f) -> vec3f { return p.x; }')),
    /^wgslOffset: line 1, column \d+: expected this function to return a vec3f, got an f32\./,
  )
  const same = 'fn offset(p: vec3f) -> vec3f { return p; }'
  assert.match(
    messageOf(() => wgslOffset(`const_assert 1; ${same}`)),
    /^wgslOffset: line 1, column 14: expected a constant bool after const_assert, got an abstract int\./,
  )
  for (const kind of ['var<private>', 'override'])
    assert.match(
      messageOf(() => wgslOffset(`${kind} a = 1.0;\nconst_assert a > 0.5; ${same}`)),
      /^wgslOffset: line 2, column 14: expected a constant bool after const_assert, got a bool\./,
    )
  assert.match(
    messageOf(() => wgslOffset('fn offset(p: vec3f) -> f32 { return p.x; }')),
    /^wgslOffset: offset: expected a function that returns a vec3f, the offset of a vertex, got one that returns an f32;/,
  )
  assert.match(
    messageOf(() => wgslOffset('fn offset(uv: vec3f, millis: f32) -> vec3f { return uv; }')),
    /the parameter uv of offset: expected a vec2f, the type of the input uv, got a vec3f\./,
  )
  assert.match(
    messageOf(() => differentiate('fn f(n: i32) -> f32 { return f32(n); }', { language: 'wgsl' })),
    /n is an i32; expected a float or a vector to differentiate by/,
  )
  assert.match(
    messageOf(() => wgslOffset('waves.wgsl')),
    /expected a string of WGSL for the source, got .* this is the name of a file/,
  )
})

test('an element of a storage buffer is read by the counter of a loop', () => {
  const source = (index) => `@group(0) @binding(0) var<storage, read> lifts: array<f32>;
fn at(i: i32) -> f32 { return lifts[i]; }
fn offset(p: vec3f) -> vec3f {
  var height = 0.0;
  for (var i = 0; i < 3; i++) { height += ${index} * sin(p.x * f32(i + 1)); }
  return vec3f(0, height, 0);
}`
  const lifts = [0.25, -0.125, 0.375, 0.0625, 0.5, -0.25]
  for (const [index, indexAt] of [
    ['lifts[i]', (i) => i],
    ['lifts[2 * i + 1]', (i) => 2 * i + 1],
    ['at(i + 2)', (i) => i + 2],
  ]) {
    const warp = warpOf(source(index))
    const uniforms = Object.fromEntries(
      [0, 1, 2].map(indexAt).map((at) => [`lifts[${at}]`, lifts[at]]),
    )
    for (const [x, y, z] of points) {
      const height = [0, 1, 2].reduce(
        (sum, i) => sum + lifts[indexAt(i)] * Math.sin(x * (i + 1)),
        0,
      )
      const slope = [0, 1, 2].reduce(
        (sum, i) => sum + lifts[indexAt(i)] * (i + 1) * Math.cos(x * (i + 1)),
        0,
      )
      const actual = warp.evaluate(
        { positions: Float32Array.of(x, y, z), normals: Float32Array.from(normal) },
        { uniforms },
      )
      assert.ok(Math.abs(actual.positions[1] - y - height) < 1e-6, index)
      const expected = -slope / Math.hypot(1, slope)
      assert.ok(Math.abs(actual.normals[0] - expected) < 1e-5, index)
    }
  }
  assert.match(
    messageOf(() => warpOf(source('lifts[i32(p.x)]'))),
    /^wgslOffset: line 5, column \d+: the index of lifts, an array without a length, must be a constant/,
  )
})
