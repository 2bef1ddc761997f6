// Tests GLSL source as offset functions: compares CPU results with values computed by hand, and checks the generated code.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile, compileWarp } from 'warpjet'
import { chain } from 'warpjet/deformers'
import { differentiate, glslOffset } from 'warpjet/glsl'

/** Returns the warped position and normal of a vertex. */
const evaluateAt = (source, position, options = {}, warpOptions = {}) =>
  compileWarp(glslOffset(source, options), { surfaceVariation: false, ...warpOptions }).evaluateAt(
    position,
    { normal: [0, 1, 0] },
  )

const assertNear = (actual, expected, tolerance = 1e-5) =>
  Array.from(expected).forEach((value, i) =>
    assert.ok(Math.abs(actual[i] - value) <= tolerance, `${Array.from(actual)}, not ${expected}`),
  )

/** Returns the offset of this function body at a point. */
const offsetOf = (body, position = [1, 2, 3], above = '') => {
  const { position: moved } = evaluateAt(`${above}\nvec3 offset(vec3 p) { ${body} }`, position)
  return Array.from(moved, (x, i) => x - position[i])
}

test('source is an offset function', () => {
  const { position, normal } = evaluateAt(
    'vec3 offset(vec3 p) { return vec3(0., sin(p.x), 0.); }',
    [1, 0, 0],
  )
  assertNear(position, [1, Math.sin(1), 0])
  const slope = Math.cos(1)
  assertNear(normal, [-slope / Math.hypot(1, slope), 1 / Math.hypot(1, slope), 0])
})

test('GLSL source is translated to every language', () => {
  const offset = glslOffset('vec3 offset(vec3 p) { return vec3(0., sin(p.x), 0.); }')
  for (const target of ['glsl300', 'glsl100', 'wgsl'])
    assert.match(compileWarp(offset, { target }).code, /sin\(position\.x\)/)
})

test('statements have the values computed by hand', () => {
  assertNear(
    offsetOf('float s = 0.; for (int i = 0; i < 4; i++) s += float(i); return vec3(s);'),
    [6, 6, 6],
  )
  assertNear(offsetOf('vec3 q = p; q.zx = q.xz + 1.; q.y *= 2.; return q;'), [4, 4, 2])
  assertNear(offsetOf('if (p.x > 2.) return vec3(1.); return vec3(2.);'), [2, 2, 2])
  assertNear(offsetOf('if (p.x < 2.) return vec3(1.); return vec3(2.);'), [1, 1, 1])
  assertNear(
    offsetOf(
      'int n = 0; for (int i = 0; i < 10; i++) { if (i == 2) continue; if (float(i) > p.z) break; n += i; } return vec3(n);',
    ),
    [4, 4, 4],
  )
  assertNear(offsetOf('int i = 0; do { i++; } while (i < 5); return vec3(i);'), [5, 5, 5])
  assertNear(
    offsetOf(
      'int k = int(p.y); float x = 0.; switch (k) { case 1: x = 1.; case 2: x += 2.; case 3: x += 3.; break; default: x = 9.; } return vec3(x);',
    ),
    [5, 5, 5],
  )
  for (const declared of ['float a = 1.0; float b = 2.0;', 'float a = 1.0, b = 2.0;'])
    assertNear(
      offsetOf(
        `float x = 0.0; switch (int(p.y)) { case 2: ${declared} x = a + b; break; case 3: a = 9.0; x = a; } return vec3(x, p.zz);`,
      ),
      [3, 3, 3],
    )
  assertNear(
    offsetOf(
      'float x = 0.; for (int i = 0; i < 3; i++) switch (int(p.x) + i) { case 1: float a = p.y; case 2: a = p.z; x += a; break; default: { float b = 4.; x += b; } } return vec3(x);',
    ),
    [10, 10, 10],
  )
  assertNear(
    offsetOf('float t[3] = float[](5., 6., 7.); t[int(p.x)] = 1.; return vec3(t[0], t[1], t[2]);'),
    [5, 1, 7],
  )
})

test('functions, overloads and out parameters work', () => {
  const above = `
    float twice(float x) { return 2. * x; }
    vec2 twice(vec2 x) { return 2. * x; }
    void swap(inout float a, inout float b) { float c = a; a = b; b = c; }
    void split(vec3 v, out float low, out float high) { low = min(v.x, v.y); high = max(v.x, v.y); }
    struct Wave { float height; vec2 way; };
    Wave wave(float h) { return Wave(h, vec2(1., 2.)); }`
  assertNear(offsetOf('return vec3(twice(p.x), twice(p.yz));', [1, 2, 3], above), [2, 4, 6])
  assertNear(offsetOf('swap(p.x, p.z); return p;', [1, 2, 3], above), [3, 2, 1])
  assertNear(
    offsetOf('float a, b; split(p, a, b); return vec3(a, b, 0.);', [4, 2, 3], above),
    [2, 4, 0],
  )
  assertNear(
    offsetOf('Wave w = wave(p.x); w.way.y += 1.; return vec3(w.height, w.way);', [7, 0, 0], above),
    [7, 1, 3],
  )
})

test('uniforms and inputs are found by name', () => {
  const source = `uniform float amount; uniform vec2 way;
    vec3 offset(vec3 position, float millis) { return vec3(way * amount, millis); }`
  const warp = compileWarp(glslOffset(source), { uniforms: { amount: 0.5, way: [1, 2] } })
  const { position } = warp.evaluateAt([0, 0, 0], {
    normal: [0, 1, 0],
    uniforms: { millis: 3, amount: 2 },
  })
  assertNear(position, [2, 4, 3])
  assert.deepEqual(
    compileWarp(glslOffset(source)).uniforms.map(({ name, type }) => `${type} ${name}`),
    ['float millis', 'float amount', 'vec2 way'],
  )
})

test('the function may return the moved position', () => {
  const { position } = evaluateAt('vec3 moved(vec3 p) { return p * 2.; }', [1, 2, 3], {
    returns: 'position',
  })
  assertNear(position, [2, 4, 6])
})

test('glsl.source in an expression equals the same expression by hand', () => {
  const warp = (offset) =>
    compileWarp(offset, { surfaceVariation: false }).evaluateAt([0.3, 0.5, 0.7], {
      normal: [0, 1, 0],
      uniforms: { millis: 2 },
    })
  const text = 'float ripple(vec2 p, float t) { return sin(3. * length(p) - t); }'
  const ours = warp(({ glsl, position, millis }) =>
    glsl.vec3(0, glsl.source(text)(position.xy(), millis), 0),
  )
  const byHand = warp(({ glsl, position, millis }) =>
    glsl.vec3(0, position.xy().length().mult(3).sub(millis).sin(), 0),
  )
  assertNear(ours.position, byHand.position)
  assertNear(ours.normal, byHand.normal)
})

test('a function of glsl.source checks its arguments', () => {
  const call = (...operands) =>
    compileWarp(({ glsl, position }) => {
      const f = glsl.source('float f(vec2 p, float x) { return x; }')
      return glsl.vec3(
        f(...operands.map((operand) => (operand === 'p' ? position : operand))),
        0,
        0,
      )
    })
  assert.throws(() => call(1), /f: expected 2 arguments \(vec2, float\), got 1/)
  assert.throws(() => call('p', 1), /f: expected a vec2 for argument 1, got a vec3/)
  assert.throws(() => call(1, 2), /f: expected a vec2 for argument 1, got a single number/)
})

test('a function of glsl.source checks its uniforms', () => {
  const warp = (uniforms, name = 'amount') =>
    compileWarp(
      ({ glsl, position }) =>
        glsl.vec3(
          glsl.source(`uniform float ${name}; float f(float x) { return ${name} * x; }`, {
            uniforms,
          })(position.y()),
          0,
          0,
        ),
      { surfaceVariation: false },
    )
  const { position } = warp({ amount: 0.5 }).evaluateAt([1, 2, 3], { normal: [0, 1, 0] })
  assertNear(position, [2, 2, 3])
  assert.throws(
    () => warp({ amount: [1, 2] }),
    /source: expected a number or an expression for the uniform amount, got an array of 2\.$/,
  )
  assert.throws(
    () => warp({ amount: undefined }),
    /expected a number .* for the uniform amount, got undefined/,
  )
  assert.throws(() => warp({ amount: 'sky' }), /amount: expected a float, .* got an image/)
  assert.throws(() => warp(5), /expected an object .* for the option "uniforms", got the number 5/)
  assert.throws(() => warp(null), /expected an object .* for the option "uniforms", got null/)
  for (const name of ['constructor', 'toString']) assert.ok(warp({ amount: 1 }, name).code)
})

test('loops with a dynamic condition run up to maxIterations times', () => {
  const source = 'vec3 offset(vec3 p) { float x = p.x; while (x < 10.) x *= 2.; return vec3(x); }'
  const { position } = evaluateAt(source, [1, 0, 0], { maxIterations: 16 })
  assertNear(position, [17, 16, 16])
})

test('offsets in GLSL can be chained, and have bounds, like other offsets', () => {
  const wave = glslOffset('vec3 offset(vec3 p) { return vec3(0., sin(p.x), 0.); }')
  const lift = glslOffset('vec3 offset(vec3 p) { return vec3(0., 0., p.y); }')
  const { position } = compileWarp(chain(wave, lift)).evaluateAt([1, 0, 0], { normal: [0, 1, 0] })
  assertNear(position, [1, Math.sin(1), Math.sin(1)])
  const { min, max } = compileWarp(wave).bounds({ min: [-1, 0, 0], max: [1, 0, 0] })
  assert.ok(min[1] <= -Math.sin(1) && max[1] >= Math.sin(1))
})

test('differentiate generates a function with its derivatives, in each language', () => {
  const field = 'float map(vec3 p) { return p.x * p.x + p.y * p.z; }'
  assert.match(differentiate(field), /^vec4 mapGradient\(vec3 p\) \{\n {2}vec4 result;/)
  assert.match(differentiate(field, { target: 'wgsl' }), /^fn mapGradient\(p: vec3f\) -> vec4f \{/)
  assert.match(
    differentiate(field, { name: 'slope', target: 'glsl100' }),
    /vec4 slope\(vec3 p\)[^]*return result;\n\}\n$/,
  )
  assert.match(
    differentiate('vec2 turn(vec2 result, float a) { return result * a; }', { by: 'result' }),
    /mat2 turnJacobian\(vec2 result, float a\) \{\n {2}mat2 outcome;/,
  )
  assert.match(differentiate('float f(float x) { return x * x; }'), /vec2 fGradient\(float x\)/)
  assert.match(
    differentiate('vec2 f(vec3 p) { return p.xy; }', { target: 'glsl300' }),
    /mat3x2 fJacobian/,
  )
  assert.throws(
    () => differentiate('vec2 f(vec3 p) { return p.xy; }', { target: 'glsl100' }),
    /glsl100 has no matrix/,
  )
  assert.throws(
    () =>
      differentiate('float f(vec2 x, mat2x3 m) { return m[0].x * x.y; }', { target: 'glsl100' }),
    /glsl100 lacks mat2x3, the type of the parameter m; use glsl300 or wgsl\.$/,
  )
  const mixed =
    'float f(vec3 p, int n, bool b, ivec2 k) { return b ? p.x * float(n) : float(k.x); }'
  assert.throws(() => differentiate(mixed), /the parameter k of f is an ivec2/)
  const withIntegers =
    'uniform int many; uniform ivec3 way; vec3 f(vec3 p, int n, bool b) { return b ? p * float(n + many) * vec3(way) : p; }'
  const wgsl = differentiate(withIntegers, { target: 'wgsl' })
  assert.match(wgsl, /f32\(n & 65535\)/)
  assert.match(wgsl, /f32\(b\)/)
  assert.match(wgsl, /f32\(many >> 16u\)/)
  assert.match(wgsl, /vec3f\(way & vec3i\(65535\)\)/)
  assert.doesNotMatch(wgsl, /\bfloat\(|\bvec3\(/)
  const glsl = differentiate(withIntegers)
  assert.match(glsl, /float\(n >> 16\)/)
  assert.match(glsl, /vec3\(way & 65535\)/)
})

test('an array of thousands of elements can be indexed by a constant', () => {
  assertNear(
    offsetOf(
      'float a[4096]; for (int i = 0; i < 4096; i++) a[i] = 0.; for (int i = 0; i < 8000; i++) a[i % 4096] += p.x; return vec3(a[0], a[4095], a[2615]);',
    ),
    [2, 1, 2],
  )
  assertNear(
    offsetOf(
      'vec3 a[3]; for (int i = 0; i < 3; i++) { a[i] = p; a[i].zx *= 2.; a[i][1] += float(i); } return a[1] + vec3(a[2].y, a[int(p.x)].x, a[1].zz[0]);',
    ),
    [6, 5, 12],
  )
})

test('the length of an array can be computed by atan of one and of two numbers', () => {
  // atan(1, -1) is 3π/4 = 2.36, and 2 atan(1) is π/2 = 1.57.
  assertNear(
    offsetOf(
      'float a[int(atan(1., -1.))]; float b[int(2. * atan(1.))]; return vec3(a.length(), b.length(), 0.);',
    ),
    [2, 1, 0],
  )
})

test('the length of an array can be computed by % of unsigned integers', () => {
  assertNear(
    offsetOf(
      'float a[int(11u % 4u)]; float b[int(7u % 1u) + 2]; return vec3(a.length(), b.length(), 0.);',
    ),
    [3, 2, 0],
  )
})

test('the length of an array can be a determinant of any size', () => {
  // The first is 1 · 9 - 2 · 3; the second the product of the diagonal, since zeros are above it; the third, expanded along the row 0 0 0
  // 1, is -(0 - 1 (2 · 2 - 3 · 0)).
  const lengths = [
    'determinant(mat2(1., 2., 3., 9.))',
    'determinant(mat3(2., 0., 0., 7., 1., 0., 5., 4., 3.))',
    'determinant(mat4(0., 2., 0., 0., 1., 1., 0., 0., 0., 3., 0., 2., 5., 0., 1., 1.))',
  ]
  const arrays = lengths.map((length, i) => `float a${i}[int(${length} + 0.1)];`)
  assertNear(
    offsetOf(`${arrays.join(' ')} return vec3(a0.length(), a1.length(), a2.length());`),
    [3, 6, 4],
  )
})

test('integer operations have the values computed by hand', () => {
  assertNear(offsetOf('int i = int(p.z) << 3; return vec3(i, i ^ 5, ~i);'), [24, 29, -25])
  assertNear(
    offsetOf('int i = int(p.z) * 715827883; return vec3(i / 65536, i & 255, i + i);'),
    [-32767, 1, 2],
  )
  assertNear(
    offsetOf('uint u = uint(p.x) - 2u; return vec3(u >> 31, u % 10u, u / 3000000000u);'),
    [1, 5, 1],
  )
  assertNear(offsetOf('return vec3(int(p.x) / 0, int(p.x) % 0, int(p.x) << 33);'), [1, 0, 2])
  assertNear(
    offsetOf('uint h = floatBitsToUint(p.y); return vec3(h >> 23, h & 7u, uintBitsToFloat(h));'),
    [128, 0, 2],
  )
})

test('packHalf2x16 and unpackHalf2x16 use the bits that IEEE 754 defines', () => {
  const halfFloats = [
    ['1.0', 0x3c00, 1],
    ['-2.5', 0xc100, -2.5],
    ['0.1', 0x2e66, 0.0999755859375],
    ['65504.0', 0x7bff, 65504],
    ['70000.0', 0x7c00, 65536],
    ['1e-6', 17, 17 / 2 ** 24],
    ['6.2e-5', 0x0410, 0x410 / 2 ** 24],
    ['2049.0', 0x6800, 2048],
    ['0.0', 0, 0],
  ]
  for (const [number, bits, half] of halfFloats)
    for (const times of ['', ' * p.x']) {
      const pair = `packHalf2x16(vec2(1.0, ${number}${times}))`
      // Adding the position, which is up to 3, would round tiny offsets away.
      const scale = Math.abs(half) < 0.01 ? 2 ** 24 : 1
      const value = `unpackHalf2x16(h).y * ${scale}.0`
      assertNear(
        offsetOf(`uint h = ${pair}; return vec3(h & 0xffffu, h >> 16, ${value});`),
        [0x3c00, bits, half * scale],
        Math.abs(half * scale) * 1e-6,
      )
    }
})

test('only bit operations are unsupported in GLSL 1.00, and the message names them', () => {
  const text = (value) => glslOffset(`vec3 offset(vec3 p) { return vec3(${value}); }`)
  const write = (value) => compileWarp(text(value), { target: 'glsl100' }).code
  assert.match(write('int(p.x) % 3'), /highp int/)
  for (const [value, name] of [
    ['int(p.x) & 3', 'x & y'],
    ['int(p.x) << 3', 'x << y'],
    ['floatBitsToInt(p.x)', 'floatBitsToInt(x)'],
  ])
    assert.throws(() => write(value), {
      name: 'WarpError',
      message: `compileWarp: glsl100 has no "${name}", an operation on the bits of whole numbers; use glsl300 or wgsl.`,
    })
})

test('emit names an integer of the host that GLSL 1.00 cannot read in halves', () => {
  const warpOf = (declaration, value, options) =>
    compileWarp(
      glslOffset(`${declaration} vec3 offset(vec3 p) { return p.x * vec3(${value}); }`),
      options,
    )
  const remedy =
    "this code reads its bits, which glsl100 cannot do; compile the warp with { target: 'glsl100' }, or use glsl300 or wgsl."
  const missing = 'which glsl100 lacks; use glsl300 or wgsl.'
  for (const [declaration, value, message] of [
    ['uniform int n;', 'n', `the variable "n" is an int, and ${remedy}`],
    ['uniform ivec3 way;', 'way', `the variable "way" is an ivec3, and ${remedy}`],
    [
      'struct Light { int kind; }; uniform Light lights[2];',
      'lights[1].kind',
      `the variable "lights[0].kind" is an int, and ${remedy}`,
    ],
    ['uniform uint n;', 'n', `the variable "n" is a uint, ${missing}`],
    ['uniform uvec3 way;', 'way', `the variable "way" is a uvec3, ${missing}`],
  ]) {
    const warp = warpOf(declaration, value)
    for (const method of ['emit', 'emitFragment'])
      assert.throws(() => warp[method]('glsl100'), {
        name: 'WarpError',
        message: `${method}: ${message}`,
      })
    if (message.endsWith(remedy))
      assert.match(warpOf(declaration, value, { target: 'glsl100' }).code, /float\(|vec3\(way\)/)
    assert.match(warp.emit('wgsl').code, />> /)
  }
})

test('integers of the host that no float can represent are passed in two halves', () => {
  const source =
    'uniform int n; vec3 offset(vec3 p) { return vec3(n % 1000, n > 0 ? 1 : 2, n / 7); }'
  const at = (n) =>
    compileWarp(glslOffset(source), { normals: false }).evaluateAt([0, 0, 0], { uniforms: { n } })
      .position
  assertNear(at(20000001), [1, 1, 2857143])
  assertNear(at(-20000001), [-1, 2, -2857143])
  assertNear(at(5), [5, 1, 0])
  const { code } = compileWarp(glslOffset(source), { normals: false, target: 'wgsl' })
  assert.match(code, /f32\(n & 65535\)/)
  assert.match(code, /f32\(n >> 16u\)/)
  const unsigned = 'uniform uvec2 n; vec3 offset(vec3 p) { return vec3(n % 1000u, 0.); }'
  assert.match(compileWarp(glslOffset(unsigned), { normals: false }).code, /vec2\(n >> 16u\)/)
})

test('host variables of other types keep their names and types, in every language', () => {
  const source = `uniform int n; uniform uint u; uniform ivec3 way; uniform bool on; uniform float f;
    vec3 offset(vec3 p) { return on ? vec3(n % 1000, u / 1000u, f) + vec3(way) : p; }`
  const warp = compileWarp(glslOffset(source), { normals: false })
  const types = ({ uniforms }) => uniforms.map(({ name, type }) => `${type} ${name}`).sort()
  const all = ['bool on', 'float f', 'int n', 'ivec3 way', 'uint u']
  assert.deepEqual(types(warp), all)
  const wgsl = warp.emit('wgsl')
  assert.deepEqual(types(wgsl), all)
  assert.match(wgsl.code, /f32\(on\)/)
  assert.match(wgsl.code, /vec3f\(way >> vec3u\(16\)\)/)
  assert.doesNotMatch(wgsl.code, /\bfloat\(/)
  const expressions = compile((glsl) => ({
    x: glsl.source('uniform int n; float f() { return float(n / 7); }')(),
  }))
  assert.deepEqual(types(expressions), ['int n'])
  assertNear([expressions.evaluate({ n: 20000001 }).x], [2857143])

  const uniforms = { n: -20000001, u: 4294967295, way: [70000, -70000, 1], on: 1, f: 0.5 }
  const at = (changes) =>
    warp.evaluateAt([0, 0, 0], { uniforms: { ...uniforms, ...changes } }).position
  assertNear(at({}), [69999, 4294967 - 70000, 1.5])
  assertNear(at({ on: 0 }), [0, 0, 0])
  assert.throws(
    () => at({ n: 0.5 }),
    /expected a whole number .*, as an int of the shader is, for the uniform "n", got 0\.5/,
  )
  assert.throws(
    () => at({ u: -1 }),
    /expected a whole number from 0 to 4294967295, as a uint of the shader is, for the uniform "u"/,
  )
  for (const n of [-2147483649, 2147483648])
    assert.throws(
      () => at({ n }),
      /expected a whole number from -2147483648 to 2147483647, as an int of the shader is, for the uniform "n"/,
    )
  assert.throws(
    () => at({ on: 2 }),
    /expected a whole number from 0 to 1, as a bool of the shader is, for the uniform "on", got /,
  )
})

test('integers of a sketch are exact, or rejected with a message', () => {
  const source = 'uniform int n; vec3 offset(vec3 p) { return vec3(n % 1000, n, 0.); }'
  const warp = (n) => compileWarp(glslOffset(source), { normals: false, uniforms: { n } })
  assertNear(warp(2 ** 24).evaluateAt([0, 0, 0]).position, [216, 2 ** 24, 0])
  assertNear(warp(-7).evaluateAt([0, 0, 0]).position, [-7, -7, 0])
  const tooLarge =
    /expected a number from -16777216 to 16777216 for the uniform "n", got 20000001; the shader reads it as a whole number\.$/
  assert.throws(() => warp(20000001), tooLarge)
  const small = warp(1)
  assert.throws(
    () => small.evaluateAt([0, 0, 0], { uniforms: { n: 20000001 } }),
    /^WarpError: evaluateAt: expected a number from -16777216 .* for the uniform "n", got 20000001; /,
  )
  let now = 1
  const changing = warp(() => now)
  assertNear(changing.evaluateAt([0, 0, 0]).position, [1, 1, 0])
  now = 20000001
  assert.throws(() => changing.evaluateAt([0, 0, 0]), tooLarge)
  // A float may have any size.
  const float = source.replace('int n', 'float n').replace('n % 1000', 'mod(n, 1000.)')
  assert.ok(compileWarp(glslOffset(float), { normals: false, uniforms: { n: 2e7 } }).code)
  // Constants in the source, or returned by a call, are fully known.
  const offset = ({ glsl, position }) => {
    const f = glsl.source('float f(int n, float x) { return float(n % 1000) + x; }')
    return glsl.vec3(f(20000001, position.x()), f(-20000001, 0), 0)
  }
  assertNear(compileWarp(offset, { normals: false }).evaluateAt([5, 0, 0]).position, [11, -1, 0])
})
