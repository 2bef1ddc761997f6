// Tests the messages of glslOffset and differentiate about arguments that are not source, and about wrong options.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from 'warpjet'
import { differentiate, glslOffset } from 'warpjet/glsl'

test('rejects arguments that are not source, and wrong options', () => {
  const validSource = 'vec3 offset(vec3 p) { return p; }'
  assert.throws(
    () => glslOffset(5),
    /^WarpError: glslOffset: expected a string of GLSL for the source, got the number 5/,
  )
  assert.throws(
    () => glslOffset('shaders/waves.glsl'),
    /expected a string of GLSL .* is the name of a file; read the file first/,
  )
  assert.throws(() => glslOffset(''), /the source has no function/)
  assert.throws(
    () => glslOffset(validSource, { function: 'other' }),
    /no function "other"; it has offset/,
  )
  assert.throws(
    () => glslOffset(validSource, { returns: 'colour' }),
    /expected 'offset' or 'position' for the option "returns", got the text "colour"/,
  )
  assert.throws(
    () => glslOffset(validSource, { maxIterations: 0 }),
    /expected a whole number from 1 to 4096 for the option "maxIterations"/,
  )
  assert.throws(() => glslOffset(validSource, { depth: 1 }), /there is no option "depth"/)
  assert.throws(
    () => glslOffset('float offset(vec3 p) { return 1.; }'),
    /expected a function that returns a vec3, .* got one that returns a float/,
  )
  assert.throws(
    () => glslOffset('vec3 offset(float speed) { return vec3(speed); }'),
    /the parameter speed of offset has no value/,
  )
  assert.throws(
    () => glslOffset('vec3 offset(vec3 position, float time) { return position; }'),
    /the parameter time of offset has no value; call it millis\.$/,
  )
  assert.throws(
    () => glslOffset('vec3 offset(vec3 uv) { return uv; }'),
    /uv of offset: expected a vec2, .* got a vec3/,
  )
  assert.throws(
    () => glslOffset('vec3 offset(out vec3 p) { p = vec3(1.); return p; }'),
    /is an out or inout parameter/,
  )
  assert.throws(
    () => differentiate('float f(vec3 p) { return p.x; }', { by: 'q' }),
    /expected a parameter of f, one of p, for the option "by", got the text "q"/,
  )
  assert.throws(() => differentiate('float f(vec4 p) { return p.x; }'), /five numbers/)
  assert.throws(
    () => differentiate('float f(int i) { return 1.; }'),
    /expected a float or a vector/,
  )
  assert.throws(
    () => differentiate('int f(out float x) { return 1; }'),
    /x of f is an out parameter/,
  )
  assert.throws(
    () => differentiate('float f(float x, out int i) { while (x < 1.) x++; return x; }'),
    /i of f is an out parameter/,
  )
  assert.throws(
    () => glslOffset('vec3 offset(int uv) { return vec3(1.); }'),
    /uv of offset: expected a vec2, .* got an int/,
  )
  assert.throws(
    () => differentiate('int f(float p) { return 1; }'),
    /f returns an int; expected a float or a vector/,
  )
  assert.ok(
    differentiate(
      'uniform float result, outcome, derivatives; float f(float x) { return x * result * outcome * derivatives; }',
    ).includes('return result2;'),
  )
  const warp = compileWarp(
    glslOffset('uniform vec2 amount; vec3 offset(vec3 p) { return vec3(amount, 0.); }'),
    { uniforms: { amount: [1, 2] } },
  )
  assert.ok(warp.code)
  assert.throws(
    () =>
      compileWarp(
        glslOffset('uniform vec2 amount; vec3 offset(vec3 p) { return vec3(amount, 0.); }'),
        { uniforms: { amount: 1 } },
      ),
    /amount: expected a vec2, .* got a single number/,
  )
})
