// Mistakes that are common in first sketches, each with its complete message.

const operatorMessage =
  "JavaScript's own + - * / < > and Math functions do not work on expressions; write x.add(1), x.mult(2), x.gt(0).ifElse(a, b), x.sin(), or add the script warpjet.operators.min.js or import 'warpjet/operators', with which they do."

/** Maps the body of an offset function → the message. A body is an expression to return or, in braces, statements. */
export const offsets = {
  5: 'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned the number 5.',
  'glsl.vec3(position.sine(), 0, 0)': 'sine: an expression has no such method; did you mean sin?',
  'position.rotateY(1)':
    'rotateY: a rotation is a matrix, and its product with a vertex is the new position, not the offset; write glsl.rotateY(angle).mult(v).sub(v).',
  'glsl.vec3(position.y.squareRoot(), 0, 0)':
    'squareRoot: an expression has no such method; did you mean sqrt?',
  'position.multply(2)': 'multply: an expression has no such method; did you mean multiply?',
  'position.normalise()': 'normalise: an expression has no such method; did you mean normalize?',
  'glsl.vec3(position.y.smoothStep(0, 1), 0, 0)':
    'smoothStep: an expression has no such method; did you mean glsl.smoothstep(low, high, x)?',
  'glsl.vec3(position.x.toFixed(2), 0, 0)':
    'toFixed: an expression has no such method; did you mean round?',
  'position.map((x) => x)':
    'map: an expression has no such method; did you mean x.sub(low).div(high - low).mult(newHigh - newLow).add(newLow)?',
  'glsl.vec33(1, 2, 3)': 'glsl.vec33: there is no such function; did you mean vec3?',
  'glsl.Vec3(1, 2, 3)': 'glsl.Vec3: there is no such function; did you mean vec3?',
  'glsl.vector(1, 2, 3)': 'glsl.vector: there is no such function; did you mean vec3?',
  'glsl.rotate_y(1)': 'glsl.rotate_y: there is no such function; did you mean rotateY?',
  'glsl.time':
    'glsl.time: there is no such function; did you mean millis, as in ({ glsl, millis }) => …?',
  '(({ postion }) => postion)(inputs)':
    'An offset function gets no "postion"; did you mean position?',
  '(({ normals }) => normals)(inputs)':
    'An offset function gets no "normals"; did you mean normal?',
  '(({ time }) => time)(inputs)': 'An offset function gets no "time"; did you mean millis?',
  '(({ texCoord }) => texCoord)(inputs)': 'An offset function gets no "texCoord"; did you mean uv?',
  'glsl.vec3(inputs.uniforms.amount, 0, 0)':
    'createWarp: the offset reads uniforms.amount, which nothing declares; add the option { uniforms: { amount: 0.5 } }.',
  'glsl.vec3(position.y * 4, 0, 0)': operatorMessage,
  'glsl.vec3(position.y + 1, 0, 0)': operatorMessage,
  'glsl.vec3(-position.y, 0, 0)': operatorMessage,
  'glsl.vec3(position.y > 0 ? 1 : 0, 0, 0)': operatorMessage,
  'glsl.vec3(position.y ** 2, 0, 0)': operatorMessage,
  '{ let x = position.x; x += 1; return glsl.vec3(x, 0, 0) }': operatorMessage,
  '{ position.x = 3; return position }':
    'x: a component cannot be changed; make a new vector, as in glsl.vec3(x, y, z).',
  '{ for (let i = 0; i < position.x; i++) {} return position }': operatorMessage,
  'glsl.vec3(Math.sin(position.y), 0, 0)':
    'Math.sin works on numbers, not on expressions of a warp; write x.sin().',
  'glsl.vec3(Math.max(position.y, 0), 0, 0)':
    'Math.max works on numbers, not on expressions of a warp; write glsl.max(x, y).',
  'glsl.vec3(Math.PI * position.y, 0, 0)': operatorMessage,
  'glsl.vec3(sin(position.y), 0, 0)': `p5's sin works on numbers, not on expressions of a warp; write x.sin().`,
  'glsl.vec3(noise(position.x, position.y), 0, 0)': `p5's noise works on numbers, not on expressions of a warp; write position.mult(3).noise(), or glsl.vec3(x, y, z).noise().`,
  'glsl.vec3(map(position.y, -1, 1, 0, 10), 0, 0)': `p5's map works on numbers, not on expressions of a warp; write x.sub(low).div(high - low).mult(newHigh - newLow).add(newLow).`,
  'glsl.vec3(lerp(0, 10, position.y), 0, 0)': `p5's lerp works on numbers, not on expressions of a warp; write glsl.mix(from, to, amount).`,
  'glsl.vec3(constrain(position.y, 0, 1), 0, 0)': `p5's constrain works on numbers, not on expressions of a warp; write glsl.clamp(x, low, high).`,
  'glsl.vec3(dist(0, 0, position.x, position.y), 0, 0)': `p5's dist works on numbers, not on expressions of a warp; write a.dist(b) of two vectors, such as glsl.vec2(x, y).`,
  'glsl.vec3(atan2(position.y, position.x), 0, 0)': `p5's atan2 works on numbers, not on expressions of a warp; write glsl.atan(y, x).`,
  'glsl.vec3(pow(position.y, 2), 0, 0)': `p5's pow works on numbers, not on expressions of a warp; write glsl.pow(x, 2).`,
  'createVector(position.x, 0, 0)': `p5's createVector works on numbers, not on expressions of a warp; write glsl.vec3(x, y, z).`,
  'glsl.noise(position.x, position.y, position.z)':
    'noise: it takes one point; write glsl.vec3(x, y, z).noise().',
  'glsl.vec3(position.x.noise(position.y), 0, 0)':
    'noise: it takes one point; write glsl.vec2(x, y).noise().',
  '{ position.mult(2) }':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned undefined (is its "return" missing?).',
  'position.y':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned a single number.',
  'glsl.vec2(1, 2)':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned a vec2.',
  '[position.x, 0, 0]':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned an array of 3.',
  'createVector(1, 0, 0)':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned a vector of numbers.',
  '`${position.x}`':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned the text "an expression of warpjet".',
  '`${position.x()}`':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned the text "an expression of warpjet".',
  'glsl.vec3(`${position.x()}`, 0, 0)':
    'vec3: expected a number or an expression for argument 1, got the text "an expression of warpjet".',
  '(async () => position)()':
    'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned a promise (leave its "async" out).',
  null: 'createWarp: the offset function must return a vec3, such as glsl.vec3(x, y, z), but returned null.',
  'glsl.vec3([1, 2, 3])':
    'vec3: expected a number or an expression for argument 1, got an array of 3; write glsl.vec3(x, y, z) for a vector.',
  'glsl.vec3("1", 0, 0)':
    'vec3: expected a number or an expression for argument 1, got the text "1".',
  'glsl.vec3(NaN, 0, 0)':
    'vec3: argument 1 is NaN, but a shader can only hold numbers between -3.4e38 and 3.4e38.',
  'glsl.vec3(undefined, 0, 0)':
    'vec3: expected a number or an expression for argument 1, got undefined.',
  'position.add(glsl.vec2(1, 2))':
    'add: a vec3 and a vec2 do not fit together; use vectors of the same size, or numbers.',
  'position.add([1, 0, 0])':
    'add: expected a number or an expression for argument 1, got an array of 3; write glsl.vec3(x, y, z) for a vector.',
  'position.add(createVector(1, 0, 0))':
    'add: expected a number or an expression for argument 1, got a vector of numbers; write glsl.vec3(x, y, z) for a vector.',
  'glsl.vec3(position.x(1), 0, 0)': 'x: it takes fewer arguments; the number 1 is too many.',
  'glsl.vec3(glsl.param("amount"), 0, 0)':
    'createWarp: the warp reads "amount", which nothing declares; add the option { defs: "uniform float amount;" }.',
}

/** Maps a statement of a sketch → the message. */
export const calls = {
  'createWarp()': 'createWarp: expected a function, got undefined.',
  'createWarp("twist")': 'createWarp: expected a function, got the text "twist".',
  [`createWarp(still, 'world')`]:
    'createWarp: expected an object of options, got the text "world".',
  [`createWarp(still, { spaces: 'world' })`]:
    'createWarp: there is no option "spaces"; did you mean space? The options are uniforms, type, space, defs, normals, fadeNoise, detail, surfaceVariation, stroke, returns, shader, hooks, scope.',
  [`createWarp(still, { space: 'wold' })`]: `createWarp: expected 'local', 'world' or 'camera' for the option "space", got the text "wold".`,
  [`createWarp(still, { detail: 0 })`]: `createWarp: expected a number of pixels above 0, 'auto', false or { tolerance, curved } for the option "detail", got the number 0.`,
  [`createWarp(still, { type: 'phong' })`]: `createWarp: expected 'specular' or 'normal' for the option "type", got the text "phong".`,
  [`createWarp(still, { stroke: 'red' })`]:
    'createWarp: expected true or false for the option "stroke", got the text "red".',
  [`createWarp(still, { returns: 'normal' })`]: `createWarp: expected 'offset' or 'position' for the option "returns", got the text "normal".`,
  [`createWarp(still, { uniforms: { amount: 'big' } })`]:
    'createWarp: expected a number, true or false, an array of 2, 3, 4, 9 or 16 numbers, a vector or colour of p5 or three.js, an image, or a function that returns one of them, for the uniform "amount", got the text "big".',
  'createWarp(warpjet.compilWarp)':
    'warpjet.compilWarp: there is no such function; did you mean compileWarp?',
  'createWarp(warpjet.twist)':
    'warpjet.twist: no script of this page has it; add the script warpjet.deformers.min.js after p5.warpjet.min.js.',
  [`createWarp(still, { defs: 'float a = 1.0;\\nfloat twice(float x) { return 2.0 * y; }' })`]: `createWarp: the option "defs" has a mistake in its line 2, "float twice(float x) { return 2.0 * y; }": 'y' : undeclared identifier.`,
  [`createWarp(still, { defs: 'uniform float size' })`]: `createWarp: the option "defs" has a mistake in its line 1, "uniform float size": 'void' : syntax error.`,
  'flat.createWarp(still)':
    'createWarp: a warp needs a 3D canvas; call createCanvas(width, height, WEBGL) first.',
  'warp(3)':
    'The function that createWarp returned: expected an object of uniforms, such as { size: 0.5 }, got the number 3.',
  'warp({ amount: 1 })': `The warp has no uniform "amount"; createWarp's option "uniforms" must declare it: { uniforms: { amount: 0.5 } }.`,
}

/**
 * Messages that differ on WEBGPU; null if there is none: there, defs are WGSL, which is compiled on first use (see webgpu.browser.test.js).
 */
export const onWebGPU = {
  'glsl.vec3(glsl.param("amount"), 0, 0)':
    'createWarp: the warp reads "amount", which nothing declares; give it a value by the option { uniforms: { amount: 0.5 } }, and read it as uniforms.amount.',
  ...Object.fromEntries(
    Object.keys(calls)
      .filter((code) => /has a mistake in its line/.test(calls[code]))
      .map((code) => [code, null]),
  ),
}

/** Maps a statement whose error is not caught → the message that p5's friendly errors show. */
export const uncaught = {
  'createWarp(({ position }) => position.sine())':
    'sine: an expression has no such method; did you mean sin?',
  'createWarp(twist())':
    'twist is not defined: add the script warpjet.deformers.min.js after p5.warpjet.min.js, and write warpjet.twist.',
  'createWarp(glslOffset(""))':
    'glslOffset is not defined: add the script warpjet.glsl.min.js after p5.warpjet.min.js, and write warpjet.glslOffset.',
  'exactNormals(baseMaterialShader())':
    'exactNormals is not defined: add the script warpjet.glsl.min.js after p5.warpjet.min.js.',
  'compileWarp(still)':
    'compileWarp is not defined: write warpjet.compileWarp, or before it const { compileWarp } = warpjet.',
  'createWarp(({ glsl }) => position.mult(2))':
    'position is not defined: it is an argument of the offset function, as in ({ position }) => ….',
}
