// Tests the messages about invalid GLSL: syntax, control flow, characters, nesting and the preprocessor.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { WarpError } from 'warpjet'
import { glslOffset } from 'warpjet/glsl'
import { body, nest, rejects } from '../support/glsl-errors.js'

rejects([
  // the source ends too early
  ['vec3 offset(vec3 p) {', 1, 'this { has no }'],
  ['vec3 offset(vec3 p', 1, 'expected )'],
  ['vec3 offset', 1, 'expected ; after a declaration, got the end of the source'],
  ['vec3', 1, 'expected a name, got the end of the source'],
  [body('return p'), 3, 'expected ; after return, got "}"'],
  [body('return vec3(1., 2., 3.;'), 2, 'expected ) after the arguments, got ";"'],
  [body('return p['), 3, 'expected a value, got "}"'],
  [body('return p.;'), 2, 'after the point'],
  [body('float x = ;return p;'), 2, 'expected a value'],
  [body('if (p.x > 1. return p;'), 2, 'expected ) after a condition'],
  [body('for (int i = 0; i < 3) {} return p;'), 2, 'expected ;'],
  [body('do { } p.x;'), 2, 'expected while'],
  [body('switch (1) { case 0 return p; }'), 2, 'expected :'],
  ['/* never', 1, 'this comment never ends'],
  ['struct S { float x; }', 1, 'expected a name'],
  ['float x', 1, 'expected ;'],
  // control flow
  ['vec3 offset(vec3 p) { return offset(p); }', 1, 'calls itself'],
  [
    'float b(float x);\nfloat a(float x) { return b(x); }\nfloat b(float x) { return a(x); }\n' +
      body('return vec3(a(p.x));'),
    2,
    'calls itself',
  ],
  [body('for (;;) { } return p;'), 2, 'has not ended after 20000 iterations'],
  [body('while (true) p.x += 1.; return p;'), 2, 'has not ended'],
  [body('while (p.x < 1.) p.x += .1; return p;'), 2, 'is known only when the shader runs'],
  [
    body('for (int i = 0; i < 9000; i++) for (int j = 0; j < 9000; j++) p.x += 1.; return p;'),
    2,
    '250,000 steps',
  ],
  [body('break; return p;'), 2, 'outside of a loop'],
  [body('if (true) continue; return p;'), 2, 'outside of a loop'],
  [body('case 1: return p;'), 2, 'outside of a switch'],
  [
    body('switch (p.x) { case 1: break; } return p;'),
    2,
    'expected an int or uint as the value of this switch, got a float',
  ],
  [body('switch (1) { p.x = 1.; } return p;'), 2, 'expected a case before this, got "p"'],
  [body('switch (1) { case 1.: break; } return p;'), 2, 'expected a constant int after case'],
  [body('switch (1) { default: break; default: break; } return p;'), 2, 'already has a default'],
  [
    body('switch (1) {\n case 2: break;\n case 1 + 1: break; } return p;'),
    4,
    'this switch already has a case 2; remove one',
  ],
  [
    body('switch (1u) { case 4294967295u: break; case 0xffffffffu: break; } return p;'),
    2,
    'already has a case 4294967295',
  ],
  [
    body('switch (1) { case 2:\n } return p;'),
    2,
    'there is no statement after this label; write break; there',
  ],
  [
    body('int i = 1; switch (1) { case i: break; } return p;'),
    2,
    'expected a constant int after case',
  ],
  [body('while (float x = 1.) { } return p;'), 2, 'expected a bool as condition, got "x", a float'],
  [
    body('for (;;) { if (p.x > 1.) break; p.x += 1.; } return p;'),
    2,
    'or set the option maxIterations',
  ],
  [
    body('do { p.x += 1.; if (p.x > 9.) break; } while (true); return p;'),
    2,
    'or set the option maxIterations',
  ],
  [
    body('int n = int(p.x); for (;;) { n = n * 3 ^ 5; if (n > 9) break; } return p;'),
    2,
    'or set the option maxIterations',
  ],
  [body('discard; return p;'), 2, 'discard is for fragments'],
  [
    body('int i = int(p.x) << 3.; return vec3(float(i));'),
    2,
    '"<<" does not take an int and a float',
  ],
  [
    body('uint i = uint(p.x) + 1; return vec3(float(i));'),
    2,
    '"+" does not take a uint and an int',
  ],
  [body('return dFdx(p);'), 2, 'cannot be used in a warp'],
  // characters and numbers
  ['\0', 1, 'shaders do not allow this character (number 0)'],
  [body('return p; \0'), 2, 'shaders do not allow this character'],
  [body('return p @ p;'), 2, 'shaders do not allow this character: "@"'],
  [body('return p * 1.0é;'), 2, 'shaders do not allow this character'],
  [body('return p * 08.0f5;'), 2, 'is not a number'],
  [body('int i = 99999999999; return p;'), 2, 'is not a whole number of 32 bits'],
  [body('int i = 0x; return p;'), 2, 'is not a whole number'],
  [body('"text"; return p;'), 2, 'GLSL has no strings'],
  ['#include "noise.glsl"', 1, 'replace it with the source in the file'],
  // nesting depth
  [body(`return ${nest('(', 'p', ')', 100_000)};`), 2, 'nested more than 128 deep'],
  [body(`return ${'-'.repeat(50_001)}p;`.replaceAll('--', '- -')), 2, 'nested more than 128 deep'],
  [body(nest('{', '', '}', 50_000)), 2, 'nested more than 128 deep'],
  [body(`return ${nest('sin(', 'p', ')', 30_000)};`), 2, 'nested more than 128 deep'],
  [body(`return ${'p.x > 0. ? p : '.repeat(20_000)}p;`), 2, 'nested'],
  [body(`p.x = ${'p.x = '.repeat(20_000)}1.;`), 2, 'nested more than 128 deep'],
  [body(`${'if (p.x > 0.) '.repeat(20_000)} return p;`), 2, 'nested more than 128 deep'],
  [body(`return p${'.xyz'.repeat(20_000)};`), 2, 'nested too deep'],
  // the preprocessor
  ['#if 1\n' + body('return p;'), 1, 'this #if has no #endif'],
  ['#endif', 1, '#endif has no #if before it'],
  ['#if 1\n#else\n#else\n#endif', 3, 'comes after #else'],
  ['#if (1\n#endif', 1, 'expected ) in this #if'],
  ['#if 1 / 0\n#endif', 1, 'divides by zero'],
  [`#if ${nest('(', '1', ')', 5000)}\n#endif`, 1, 'nested more than 200 deep'],
  ['#define', 1, '#define needs a name'],
  ['#define F(1) 2', 1, 'must be names in ( )'],
  ['#define F(x, x) x', 1, '"x" is already a parameter of "F"'],
  [
    '#define WAVES 4\n\n#define WAVES 5',
    3,
    '"WAVES" was defined with another value in line 1; write #undef WAVES before this line, or use another name',
  ],
  ['#define F(x) x\n#define F(y) y', 2, '"F" was defined with another value in line 1'],
  [
    '#define FANCY 1\n#if FANYC\n#endif',
    2,
    'no #define gives "FANYC" a value; define it, or write defined(FANYC); did you mean FANCY?',
  ],
  ['#if 0\n#elif FANCY == 2\n#endif', 2, 'no #define gives "FANCY" a value'],
  ['#if 1 ^^ 0\n#endif', 1, '^^ is not allowed in #if; write !='],
  ['#if 1 << 40\n#endif', 1, 'shifts by less than 0 or more than 31'],
  ['#ifdef A B\n#endif', 1, 'unexpected "B" after #ifdef; put it into a comment'],
  ['#ifdef A\n#endif A', 2, 'unexpected "A" after #endif'],
  ['#ifdef A\n#else B\n#endif', 2, 'unexpected "B" after #else'],
  ['#undef __LINE__', 1, '"__LINE__" cannot be undefined'],
  ['#undef GL_ES', 1, '"GL_ES" cannot be undefined'],
  ['#undef A B', 1, '#undef takes one name'],
  ['#extension GL_OES_standard_derivatives', 1, 'write it as #extension NAME : enable'],
  ['#extension GL_OES_standard_derivatives : on', 1, '"on" is not a behavior of an extension'],
  ['#extension all : enable', 1, '#extension all allows only warn and disable'],
  ['#extension GL_OWN_thing : require', 1, 'WebGL has no extension "GL_OWN_thing"'],
  [
    '#version 300 es\nfloat x;\n#extension GL_EXT_x : enable',
    3,
    'must come before everything but other directives',
  ],
  ['#pragma optimize', 1, 'write #pragma optimize(on) or (off)'],
  ['#line 1 2 3', 1, '#line takes a line number and a file number, and nothing else'],
  ['#define GL_X 1', 1, 'it is predefined'],
  ['#define F(a, b) a\n' + body('return F(p);'), 3, 'takes 2 arguments'],
  ['#error not today', 1, '#error: not today'],
  ['#nonsense', 1, 'there is no directive #nonsense'],
  ['#version 450', 1, 'write #version 300 es or #version 100; WebGL has no other.'],
  ['float x;\n#version 300 es', 2, 'must come before everything else'],
  ['#line x', 1, 'expected a line number after #line, got "x"'],
  [
    Array.from({ length: 30 }, (_, i) => `#define A${i + 1} A${i} A${i}`).join('\n') +
      '\n#define A0 +\nA30',
    32,
    'too long once its macros are expanded',
  ],
])

test('a long line is cut only on the long side of the error', () => {
  const comment = ` // ${'x'.repeat(300)}`
  assert.throws(() => glslOffset(`float x = y;${comment}`), /\n {2}float x = y; \/\/ x+\n {12}\^$/)
  assert.throws(() => glslOffset(`/*${'x'.repeat(300)}*/ float x = y;`), /\n {2}…x+.* y;\n +\^$/)
})

test('#line changes the reported line number, but not the line that is shown', () => {
  assert.throws(
    () => glslOffset('#line 70\nfloat x = y;'),
    /line 70, column 11: "y" is not declared\.\n {2}float x = y;\n {12}\^/,
  )
})

test('random bytes and random tokens end in a message or a warp', () => {
  let state = 12345
  const random = (n) => (state = (state * 1103515245 + 12345) % 2147483648) % n
  const pieces =
    'vec3 offset ( ) { } return p ; . x float int = + - * / if else for while [ ] , 1.0 1 < # define \n struct const uniform switch case : ? mat3 sin out'.split(
      ' ',
    )
  for (let i = 0; i < 1500; i++) {
    const text = Array.from({ length: random(40) }, () => pieces[random(pieces.length)]).join(' ')
    try {
      glslOffset(i % 2 ? text : body(text))
    } catch (error) {
      if (!(error instanceof WarpError)) throw new Error(`${error.stack}\n${text}`)
    }
  }
})
