// Tests #version and the code outside of functions: the language of the source, features that it lacks, and headers of whole shaders.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from 'warpjet'
import { glslOffset } from 'warpjet/glsl'
import { versions } from '../glsl/versions.js'

const heads = { 100: '#version 100', 300: '#version 300 es' }

function problemOf(text) {
  try {
    glslOffset(text, { maxIterations: 8 })
    return undefined
  } catch (error) {
    assert.equal(error.name, 'WarpError', error.stack)
    return error.message
  }
}

test('source without #version may have features of either language', () => {
  for (const [name, text] of Object.entries(versions))
    assert.equal(problemOf(text), undefined, name)
})

// tests/glsl-source/versions.browser.test.js checks these cases in a browser.
test('features of the other language are rejected with line, column and a caret', () => {
  for (const head of Object.values(heads)) {
    const problems = Object.values(versions).map((text) => problemOf(`${head}\n${text}`))
    for (const message of problems.filter(Boolean)) {
      const [first, line, caret] = message.split('\n')
      assert.match(
        first,
        /^glslOffset: line [2-9], column \d+: (?:"[^"]*"|[^."])*GLSL ES [13]\.00, the /,
      )
      assert.ok(first.includes(`the language of ${head}; `) && first.endsWith('.'), first)
      const column = Number(/column (\d+)/.exec(first)[1])
      // Long lines are shown from the middle on.
      if (!line.includes('…')) assert.equal(caret.indexOf('^') - 2, column - 1, message)
    }
  }
})

const rejected = {
  'vec3 offset(vec3 p) { return vec3(int(p.x) << 2); }': [
    100,
    'line 2, column 44: "<<" is not in GLSL ES 1.00, the language of #version 100; multiply by a power of two, or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) { return vec3(int(p.x) >> 2); }': [
    100,
    'line 2, column 44: ">>" is not in GLSL ES 1.00, the language of #version 100; divide by a power of two and use floor(), or begin the source with #version 300 es.',
  ],
  'in float x; vec3 offset(vec3 p) { return p; }': [
    100,
    'line 2, column 1: in before a global variable is not in GLSL ES 1.00, the language of #version 100; write attribute, or begin the source with #version 300 es.',
  ],
  'out float x; vec3 offset(vec3 p) { return p; }': [
    100,
    'line 2, column 1: out before a global variable is not in GLSL ES 1.00, the language of #version 100; write varying, or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) { return vec3(~int(p.x)); }': [
    100,
    'line 2, column 35: "~" is not in GLSL ES 1.00, the language of #version 100; use floor() and mod(), or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) { return vec3(floatBitsToInt(p.x)); }': [
    100,
    'line 2, column 35: "floatBitsToInt" is not in GLSL ES 1.00, the language of #version 100; begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) { return roundEven(p); }': [
    100,
    'line 2, column 30: "roundEven" is not in GLSL ES 1.00, the language of #version 100; write floor(x + 0.5), which rounds halves up, or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) { for (int i = 0; 4 > i; i++) p.x += 1.0; return p; }': [
    100,
    'line 2, column 23: a for whose counter does not start, end and step by constants is not in GLSL ES 1.00, the language of #version 100; write it as for (int i = 0; i < 8; i++), with the counter on the left, or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) { for (int i = 0; i < 4; i++) i += 1; return p; }': [
    100,
    "line 2, column 53: changing a loop's counter in its body is not in GLSL ES 1.00, the language of #version 100; change another variable, or begin the source with #version 300 es.",
  ],
  'vec3 offset(vec3 p) { return vec3(p[int(p.x)]); }': [
    100,
    'line 2, column 36: an index that is not constant is not in GLSL ES 1.00, the language of #version 100; use a constant, or the counter of a loop, or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) { float a[2]; return vec3(a.length()); }': [
    100,
    'line 2, column 48: ".length()" is not in GLSL ES 1.00, the language of #version 100; write the number, or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) { return packHalf2x16(p.xy) == 0 ? p : -p; }': [
    100,
    'line 2, column 30: "packHalf2x16" is not in GLSL ES 1.00, the language of #version 100; begin the source with #version 300 es.',
  ],
  'uniform sampler2D s;\nvec3 offset(vec3 p) { return texelFetch(s, ivec2(p.xy), 0).xyz; }': [
    100,
    'line 3, column 30: "texelFetch" is not in GLSL ES 1.00, the language of #version 100; write texture2D(image, (vec2(ij) + 0.5) / size), or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) {\n  return vec3(int(p.x) % 3);\n}': [
    100,
    'line 3, column 24: "%" is not in GLSL ES 1.00, the language of #version 100; use mod(x, y) of floats, or begin the source with #version 300 es.',
  ],
  'vec3 offset(vec3 p) {\n  while (p.x < 3.0) p.x += 1.0;\n  return p;\n}': [
    100,
    'line 3, column 3: "while" is not in GLSL ES 1.00, the language of #version 100; count up to a constant, as in for (int i = 0; i < 8; i++), or begin the source with #version 300 es.',
  ],
  'uniform sampler2D s;\nvec3 offset(vec3 p) { return texture2D(s, p.xy).xyz; }': [
    300,
    'line 3, column 30: "texture2D" is not in GLSL ES 3.00, the language of #version 300 es; write texture.',
  ],
  'attribute vec3 aPosition;\nvec3 offset(vec3 p) { return p; }': [
    300,
    'line 2, column 1: "attribute" is not in GLSL ES 3.00, the language of #version 300 es; write "in".',
  ],
  'float[2] f(float x) { return float[2](x, x); }\nvec3 offset(vec3 p) { return vec3(f(p.x)[0]); }':
    [
      100,
      'line 2, column 10: an array returned by a function is not in GLSL ES 1.00, the language of #version 100; return it by an out parameter, or begin the source with #version 300 es.',
    ],
  'vec3 offset(vec3 p) { return vec3(abs(int(p.x))); }': [
    100,
    'line 2, column 35: abs, sign, min, max or clamp of whole numbers is not in GLSL ES 1.00, the language of #version 100; use floats, or begin the source with #version 300 es.',
  ],
}
for (const [text, [version, message]] of Object.entries(rejected))
  test(message, () => {
    assert.equal(problemOf(`${heads[version]}\n${text}`).split('\n')[0], `glslOffset: ${message}`)
  })

test('a keyword that only 3.00 has is a valid name under #version 100', () => {
  const text = `float smin(float a, float b, float smooth) {
  float layout = max(smooth - abs(a - b), 0.0) / smooth;
  layout *= layout;
  return min(a, b) - 0.25 * layout * smooth;
}
vec3 offset(vec3 p) { float uint = smin(p.x, p.y, 0.5); uint += 1.0; return vec3(uint); }`
  const renamed = text
    .replace(/smooth/g, 'width')
    .replace(/layout/g, 'h')
    .replace(/uint/g, 'd')
  const code = (source) => compileWarp(glslOffset(source)).code
  assert.equal(code(`#version 100\n${text}`), code(`#version 100\n${renamed}`))
  assert.match(problemOf(text), /"smooth" cannot be a name: it is a keyword/)
  assert.match(
    problemOf(`#version 100\nuint f() { return 1; }\n${text}`),
    /"uint" is not in GLSL ES 1\.00, .*; use int, or/,
  )
})

test('a #version that WebGL lacks, or that follows other code, is rejected', () => {
  const after = (head) => problemOf(`${head}\nvec3 offset(vec3 p) { return p; }`)
  for (const head of [
    '#version 300',
    '#version 100 es',
    '#version 310 es',
    '#version 300 core',
    '#version',
  ])
    assert.match(
      after(head),
      /line 1, column 2: write #version 300 es or #version 100; WebGL has no other\./,
      head,
    )
  assert.match(after('#define A\n#version 300 es'), /line 2, .* must come before everything else/)
  assert.equal(after('// by whom\n\n#version 300 es'), undefined)
})

const offsetSource = 'vec3 offset(vec3 p) { return vec3(0.0, amount * sin(p.x), 0.0); }'

/** Whole shaders, as in hosts. */
const shaders = {
  'WebGL 2': `#version 300 es
#extension GL_EXT_clip_cull_distance : enable
#pragma optimize(on)
precision highp float;
precision highp int;
precision highp sampler2DArray;
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
in vec2 aTexCoord;
in mediump vec4 aColor;
uniform mat4 uModelViewMatrix, uProjectionMatrix;
uniform highp mat3 uNormalMatrix;
uniform float amount;
out vec3 vNormal;
flat out highp int vInstance;
centroid out vec2 vUv;
smooth out vec4 vColor;
invariant gl_Position;
const float weights[3] = float[](0.25, 0.5, 0.25);
${offsetSource}
void main() {
  vec3 moved = aPosition + offset(aPosition);
  vNormal = uNormalMatrix * aNormal;
  vUv = aTexCoord;
  vColor = aColor * weights[1];
  vInstance = gl_InstanceID + gl_VertexID;
  gl_PointSize = 2.0;
  gl_Position = uProjectionMatrix * uModelViewMatrix * vec4(moved, 1.0);
}`,
  'WebGL 1': `#version 100
#extension GL_OES_standard_derivatives : enable
#ifdef GL_ES
precision highp float;
precision mediump int;
#endif
attribute vec3 aPosition;
attribute vec3 aNormal;
attribute highp vec2 aTexCoord;
uniform mat4 uModelViewMatrix;
uniform mat4 uProjectionMatrix;
uniform mat3 uNormalMatrix;
uniform float amount;
varying vec3 vNormal;
varying mediump vec2 vUv;
invariant varying vec4 vColor;
invariant gl_Position;
${offsetSource}
void main(void) {
  vNormal = uNormalMatrix * aNormal;
  vUv = aTexCoord;
  vColor = vec4(1.0);
  gl_Position = uProjectionMatrix * uModelViewMatrix * vec4(aPosition + offset(aPosition), 1.0);
}`,
}
for (const [name, text] of Object.entries(shaders))
  test(`a whole shader of ${name} can be passed: its function is the offset, and its header is ignored`, () => {
    const expected = compileWarp(glslOffset(`uniform float amount;\n${offsetSource}`))
    assert.equal(compileWarp(glslOffset(text)).code, expected.code)
  })

test('a whole fragment shader may read gl_FragCoord if its offset does not', () => {
  const text = `precision highp float;
uniform float amount;
${offsetSource}
void main() { gl_FragColor = vec4(offset(gl_FragCoord.xyz), gl_FragCoord[3]); }`
  const expected = compileWarp(glslOffset(`uniform float amount;\n${offsetSource}`))
  assert.equal(compileWarp(glslOffset(text)).code, expected.code)
})

test("a warp cannot read the host's attributes", () => {
  const text = `#version 300 es\nin float aSize;\nvec3 offset(vec3 p) { return p * aSize; }`
  assert.throws(
    () => compileWarp(glslOffset(text)),
    /the attribute aSize has no value; a warp knows position, normal, uv, color and gl_InstanceID\.$/,
  )
})
