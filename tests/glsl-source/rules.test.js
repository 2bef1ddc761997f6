// Tests name clashes, matrices, blocks of uniforms, loops, limits and compile times. Expected values were computed by hand.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from 'warpjet'
import { differentiate, glslOffset } from 'warpjet/glsl'
import { assertLinear } from '../support/linear-time.js'

const body = (statements, above = '') => `${above}\nvec3 offset(vec3 p) { ${statements} }`
const withoutVariation = { surfaceVariation: false }

const offsetAt = (source, position, options = {}, uniforms = {}) => {
  const warp = compileWarp(glslOffset(source, options), withoutVariation)
  const moved = warp.evaluateAt(position, { normal: [0, 1, 0], uniforms }).position
  return Array.from(moved, (x, i) => x - position[i])
}

const assertNear = (actual, wanted) =>
  wanted.forEach((x, i) =>
    assert.ok(
      Math.abs(actual[i] - x) <= 1e-5 * Math.max(1, Math.abs(x)),
      `${actual}, not ${wanted}`,
    ),
  )

const messageOf = (work) => {
  try {
    work()
  } catch (error) {
    return error.message
  }
  return ''
}

test('a uniform with the name of an input is rejected, in every language and with any type', () => {
  const readExpressions = {
    'uniform int position;': 'float(position)',
    'uniform float position;': 'position',
    'uniform vec3 position;': 'position.x',
    'uniform vec3 normal[4];': 'normal[2].x',
    'uniform mat3 normal;': 'normal[0].x',
    'uniform bool color;': 'float(color)',
    'struct S { float x; }; uniform S uv;': 'uv.x',
    'uniform mat2x3 uv;': 'uv[1].x',
    'uniform int millis;': 'float(millis)',
    'uniform vec2 instance;': 'instance.x',
    'layout(std140) uniform B { float x; } normal;': 'normal.x',
    'uniform B { vec2 normal; };': 'normal.x',
  }
  for (const [above, value] of Object.entries(readExpressions))
    for (const target of ['glsl300', 'glsl100', 'wgsl'])
      assert.match(
        messageOf(() => compileWarp(glslOffset(body(`return vec3(${value});`, above)), { target })),
        /^glslOffset: the uniform (\w+) has the name of an input, \1; rename it in the source, such as my[A-Z]\w+\.$/,
        above,
      )
  const bySource = (names = {}) =>
    compileWarp(
      ({ glsl, position }) =>
        position.mult(glsl.source('uniform int position; float f() { return float(position); }')()),
      { names },
    ).code
  assert.match(
    messageOf(bySource),
    /^source: the uniform position has the name of an input, position/,
  )
  // If the input has another name in the shader, its own name is free.
  assert.match(bySource({ position: 'at' }), /float\(position & 65535\)/)
  assert.match(
    messageOf(() =>
      compileWarp(glslOffset(body('return vec3(at);', 'uniform float at;')), {
        names: { position: 'at' },
      }),
    ),
    /the uniform at has the name of an input, position/,
  )
  // A uniform that the function does not read may have any name.
  assert.ok(compileWarp(glslOffset(body('return p;', 'uniform int position;'))).code)
})

test('a parameter with the name of a uniform does not hide it', () => {
  const text = differentiate(
    'uniform int x[3]; float scale() { return float(x[2]); } float f(vec3 x) { return x.x * scale(); }',
  )
  assert.match(text, /^vec4 fGradient\(vec3 x2\)/)
  assert.match(text, /x\[2\] & 65535/)
  assert.match(text, /x2\.x \* /)
})

test('uniforms that are non-square matrices are read column by column', () => {
  for (const [columns, rows] of [
    [2, 3],
    [2, 4],
    [3, 2],
    [3, 4],
    [4, 2],
    [4, 3],
  ]) {
    const numbers = Array.from({ length: columns * rows }, (_, i) => (i % 5) - 1.5)
    const operand = ['p.xy', 'p', 'vec4(p, 1.0)'][columns - 2]
    const value = ['vec3(m * BY, 0.0)', 'm * BY', '(m * BY).yzw'][rows - 2].replace('BY', operand)
    const source = body(`return ${value};`, `uniform mat${columns}x${rows} m;`)
    const uniforms = Object.fromEntries(
      Array.from({ length: columns }, (_, c) => [
        `m[${c}]`,
        numbers.slice(c * rows, c * rows + rows),
      ]),
    )
    const at = [0.5, -2, 3]
    const vector = [...at, 1].slice(0, columns)
    const product = Array.from({ length: rows }, (_, r) =>
      vector.reduce((sum, x, c) => sum + x * numbers[c * rows + r], 0),
    )
    assertNear(
      offsetAt(source, at, {}, uniforms),
      rows === 2 ? [...product, 0] : product.slice(rows - 3),
    )
    for (const target of ['glsl300', 'wgsl'])
      assert.match(compileWarp(glslOffset(source), { target, ...withoutVariation }).code, /m\[0\]/)
  }
  assert.match(
    differentiate('vec2 f(vec3 p, mat3x2 m) { return m * p; }', { by: 'p', target: 'wgsl' }),
    /m: mat3x2f/,
  )
})

test('members of uniform blocks are uniforms of the warp, with the names that the source uses', () => {
  const above = `struct Light { vec4 way; float power; };
layout(std140) uniform Camera { mat4 view; vec2 size_; };
layout(std140) uniform Scene { Light lights[2]; int count; } scene;`
  const source = body(
    'return (view * vec4(p, 1.0)).xyz + scene.lights[1].way.xyz * scene.lights[1].power + float(scene.count);',
    above,
  )
  const { uniforms, code } = compileWarp(glslOffset(source))
  assert.deepEqual(uniforms.map(({ name, type }) => `${type} ${name}`).sort(), [
    'float scene.lights[1].power',
    'int scene.count',
    'mat4 view',
    'vec4 scene.lights[1].way',
  ])
  for (const name of ['view', 'scene.lights[1].power', 'scene.count & 65535'])
    assert.ok(code.includes(name), name)
})

test('a loop that only a break ends runs up to maxIterations times', () => {
  const loops = [
    'do { x += 1.0; i++; if (i >= n) break; } while (true);',
    'for (;;) { x += 1.0; i++; if (i >= n) break; }',
    'while (true) { x += 1.0; i = i * 3 % 7 + 1; if (float(n) < x) break; }',
    'for (;;) { x += 1.0; h = h * 1664525u + 1013904223u; if (x > float(n) + float(h & 0u)) break; }',
  ]
  for (const loop of loops) {
    const source = body(
      `float x = 0.0; int n = int(p.y), i = 0; uint h = uint(p.x); ${loop} return vec3(x);`,
    )
    const expected = loop.includes('i >= n') ? 5 : 6
    assertNear(offsetAt(source, [1, 5, 0], { maxIterations: 20 }), [expected, expected, expected])
    assertNear(offsetAt(source, [1, 50, 0], { maxIterations: 8 }), [8, 8, 8])
    assert.match(
      messageOf(() => glslOffset(source)),
      /is known only when the shader runs; .* or set the option maxIterations/,
    )
  }
})

test('a do loop stays a loop, with about the code of a for loop', () => {
  const length = (loop, options) =>
    compileWarp(
      glslOffset(body(`float x = p.x; int n = int(p.y); ${loop} return vec3(x);`), options),
      withoutVariation,
    ).code.length
  const limit = { maxIterations: 64 }
  const nested = length(
    'int i = 0; do { int j = 0; do { x = x * 0.5 + sin(x); j++; } while (j < n); i++; } while (i < n);',
    limit,
  )
  const asFor = length(
    'for (int i = 0; i < n; i++) { for (int j = 0; j < n; j++) { x = x * 0.5 + sin(x); } }',
    limit,
  )
  assert.ok(nested < 2 * asFor && asFor < 3000, `${nested} and ${asFor} characters`)
  assert.ok(length('int i = 0; do { x = x * 0.5 + sin(x); } while (++i < 500);') < 1200)
})

test('images can be read with projective coordinates or texel offsets', () => {
  const code = (expression) =>
    compileWarp(
      glslOffset(body(`return ${expression}.xyz;`, 'uniform sampler2D image;')),
      withoutVariation,
    ).code
  const equivalents = [
    ['texture2DProj(image, p)', 'texture2D(image, p.xy / p.z)'],
    ['texture2DProj(image, vec4(p, 2.0))', 'texture2D(image, p.xy / 2.0)'],
    ['texture2DProjLod(image, p, 0.0)', 'texture2D(image, p.xy / p.z)'],
    ['textureProj(image, p)', 'texture(image, p.xy / p.z)'],
    ['textureProjLod(image, vec4(p, p.x), 0.0)', 'texture(image, p.xy / p.x)'],
    [
      'textureOffset(image, p.xy, ivec2(1, -2))',
      'texture(image, p.xy + vec2(1.0, -2.0) / vec2(textureSize(image, 0)))',
    ],
    [
      'texelFetchOffset(image, ivec2(p.xy), 0, ivec2(1, -2))',
      'texelFetch(image, ivec2(p.xy) + ivec2(1, -2), 0)',
    ],
  ]
  const plain = (text) => text.replaceAll(/\s+/g, ' ')
  for (const [text, wanted] of equivalents.slice(0, 5))
    assert.equal(plain(code(text)), plain(code(wanted)), text)
  for (const [text] of equivalents.slice(5)) assert.ok(code(text).includes('image'), text)
  assert.match(
    messageOf(() =>
      glslOffset(
        body('return textureOffset(image, p.xy, ivec2(9)).xyz;', 'uniform sampler2D image;'),
      ),
    ),
    /the offset of textureOffset must be a constant with whole numbers from -8 to 7/,
  )
})

test('built-in limits have the minimum values that WebGL guarantees', () => {
  const value = (name, head) => offsetAt(`${head}\n${body(`return vec3(${name});`)}`, [0, 0, 0])[0]
  const limits = {
    gl_MaxVertexAttribs: [8, 16],
    gl_MaxVertexUniformVectors: [128, 256],
    gl_MaxVaryingVectors: [8],
    gl_MaxVertexOutputVectors: [undefined, 16],
    gl_MaxFragmentInputVectors: [undefined, 15],
    gl_MaxVertexTextureImageUnits: [0, 16],
    gl_MaxCombinedTextureImageUnits: [8, 32],
    gl_MaxTextureImageUnits: [8, 16],
    gl_MaxFragmentUniformVectors: [16, 224],
    gl_MaxDrawBuffers: [1, 4],
    gl_MinProgramTexelOffset: [undefined, -8],
    gl_MaxProgramTexelOffset: [undefined, 7],
  }
  for (const [name, [in100, in300]] of Object.entries(limits)) {
    for (const [head, wanted] of [
      ['#version 100', in100],
      ['#version 300 es', in300],
      ['', in100 ?? in300],
    ])
      if (wanted === undefined) assert.throws(() => value(name, head), /not in GLSL ES/)
      else assert.equal(value(name, head), wanted, `${name} ${head}`)
  }
})

test('source without #version has the __VERSION__ of a browser', () => {
  assertNear(offsetAt(body('return vec3(__VERSION__);'), [0, 0, 0]), [100, 100, 100])
  assertNear(
    offsetAt(`#version 300 es\n${body('return vec3(__VERSION__);')}`, [0, 0, 0]),
    [300, 300, 300],
  )
})

test('a carriage return alone ends a line', () => {
  assert.match(
    messageOf(() => glslOffset('float a;\rfloat b = c;\r')),
    /line 2, column 11: "c" is not declared\.\n {2}float b = c;\n {12}\^/,
  )
})

test('messages use the right article before names of types', () => {
  assert.match(
    messageOf(() => glslOffset(body('ivec3 n = 1; return p;'))),
    /expected an ivec3 as the value of "n", got an int/,
  )
  assert.match(
    messageOf(() => glslOffset(body('return p + uvec2(1u);'))),
    /a vec3 and a uvec2/,
  )
})

const repeat = (count, make) => Array.from({ length: count }, (_, i) => make(i)).join(' ')

const makers = {
  fields: (n) => body('S s; return p;', `struct S { ${repeat(n, (i) => `float a${i};`)} };`),
  locals: (n) => body(`${repeat(n, (i) => `float a${i} = p.x;`)} return vec3(a1);`),
  globals: (n) =>
    body(
      'return p;',
      repeat(n, (i) => `float a${i} = 1.0;`),
    ),
  constants: (n) =>
    body(
      'return p;',
      repeat(n, (i) => `const float a${i} = 1.0;`),
    ),
  functions: (n) =>
    body(
      'return p;',
      repeat(n, (i) => `float f${i}(float x) { return x; }`),
    ),
  macros: (n) => body('return p;', `${repeat(n, (i) => `#define A${i} ${i}\n`)}`),
}
for (const [name, make] of Object.entries(makers))
  test(`the time for ${name} is proportional to their number`, () =>
    assertLinear((count) => glslOffset(make(count))))

test('functions that call each other twice, twenty levels deep, compile quickly', () => {
  const calls = (first, next, value) =>
    `${first}\n${repeat(20, (i) => `${next(`f${i + 1}`, `f${i}`)}\n`)}${body(value.includes(';') ? value : `return ${value};`)}`
  const start = performance.now()
  assertNear(
    offsetAt(
      calls(
        'float f0(float x) { return x; }',
        (f, g) => `float ${f}(float x) { return ${g}(${g}(x)); }`,
        'vec3(f20(p.x))',
      ),
      [0.5, 0, 0],
    ),
    [0.5, 0.5, 0.5],
  )
  assertNear(
    offsetAt(
      calls(
        'int f0(int x) { return x; }',
        (f, g) => `int ${f}(int x) { return ${g}(x) + ${g}(x + 1); }`,
        'vec3(f20(int(p.x)))',
      ),
      [1, 0, 0],
    ),
    [11534336, 11534336, 11534336],
  )
  assertNear(
    offsetAt(
      calls(
        'float f0(float x) { return x * 0.5; }',
        (f, g) => `float ${f}(float x) { return 0.5 * (${g}(x) + ${g}(x)); }`,
        'p * f20(4.0)',
      ),
      [1, 2, 3],
    ),
    [2, 4, 6],
  )
  // If each call needs code of its own, the length is proportional to the number of calls, which is limited.
  for (const [first, next, value] of [
    [
      'float g; float f0(float x) { g += x; return g; }',
      (f, g) => `float ${f}(float x) { return ${g}(x) + ${g}(x); }`,
      'vec3(f20(p.x))',
    ],
    [
      'void f0(inout float a[4096]) { a[0] += 1.0; }',
      (f, g) => `void ${f}(inout float a[4096]) { ${g}(a); ${g}(a); }`,
      'float a[4096]; a[0] = p.x; f20(a); return vec3(a[0]);',
    ],
  ])
    assert.match(
      messageOf(() => glslOffset(calls(first, next, value))),
      /more than 250,000 steps/,
    )
  assert.ok(performance.now() - start < 8000)
})
