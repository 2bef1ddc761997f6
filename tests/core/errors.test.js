// Each mistake throws one clear message, and does not affect the next warp. tests/cpp/builder_errors_test.cpp tests the messages of the C++
// code; this file tests one of them for each way by which messages reach JavaScript.
import assert from 'node:assert/strict'
import { afterEach, test } from 'node:test'
import { inspect } from 'node:util'
import { chain, inSpace, twist } from '../../dist/deformers.js'
import { compile, compileWarp, gen } from '../../dist/warpjet.js'
import { throwWarpErrors, throwsWarpError } from '../support/warp-errors.js'

const zeroOffset = ({ glsl }) => glsl.vec3(0, 0, 0)

afterEach(() => assert.match(compileWarp(zeroOffset).code, /warpedPosition/))

/** Returns a function that compiles an offset function. */
const compileLater = (offset) => () => compileWarp(offset)

test('rejects wrong results of the offset function', () => {
  throwWarpErrors([
    [compileLater(() => undefined), /must return a vec3.*undefined/],
    [compileLater(() => 5), /must return a vec3.*the number 5/],
    [compileLater(({ glsl }) => glsl.vec2(1, 2)), /must return a vec3.*a vec2/],
    [compileLater(({ millis }) => millis), /must return a vec3.*a single number/],
    [compileLater(() => [0, 0, 0]), /must return a vec3.*an array of 3/],
    [compileLater(({ glsl }) => glsl.vec3(NaN, 0, 0)), /vec3: argument 1 is NaN/],
    [compileLater(({ glsl }) => glsl.vec3(0, 1 / 0, 0)), /vec3: argument 2 is Infinity/],
  ])
})

test("rejects JavaScript's operators on expressions", () => {
  throwWarpErrors([
    [
      compileLater(({ position }) => position.x() * 2),
      /own \+ - \* \/ .* do not work on expressions/,
    ],
    [
      compileLater(({ position }) => (position.x() > 0 ? position : position.neg())),
      /do not work on expressions/,
    ],
  ])
})

test('reports expressions that are converted to strings', () => {
  // Messages of other libraries may contain the string; in shader code, it is rejected.
  compile((glsl) => {
    const x = glsl.param('x')
    assert.equal(`${x}`, 'an expression of warpjet')
    // Node's console converts to a string with `inspect`.
    assert.equal(inspect(x), 'an expression of warpjet')
    assert.equal(inspect([glsl.vec2Param('v').y]), '[ an expression of warpjet ]')
    throwsWarpError(() => glsl.param(`${x}`), /param: "an expression of warpjet" cannot be read/)
    throwsWarpError(
      () => glsl.fn({ name: 'f', arity: 1, source: `float f(float a) { return a * ${x}; }` }),
      /^fn: the option "source" of f contains an expression; make it an argument/,
    )
    throwsWarpError(() => x + '', /do not work on expressions/)
    return { result: x }
  })
})

test('rejects expressions of another copy of warpjet', async () => {
  const other = await import('../../dist/warpjet.min.js')
  let foreign
  other.compileWarp(({ position }) => (foreign = position))
  const message = /was made by another copy of warpjet; this page loads two copies, so load all/
  throwWarpErrors([
    [compileLater(() => foreign), message],
    [compileLater(({ position }) => position.add(foreign)), message],
  ])
})

test('rejects values that are not offset functions', () => {
  throwWarpErrors([
    [() => compileWarp(), /expected a function, got undefined/],
    [() => compileWarp('x'), /expected a function, got the text "x"\.$/],
    [
      () => compileWarp('vec3 offset(vec3 p) { return p; }'),
      /got the text ".*"; to pass source in GLSL, convert it to a function by glslOffset\(text\)/,
    ],
    [() => compile(7), /compile: expected a function, got the number 7/],
    [() => gen({}), /gen: expected a function, got an empty object/],
    [() => gen(async () => {}), /gen: the function must be neither async nor a generator/],
    [() => compile(async () => ({})), /compile: the function must return an object of named/],
  ])
})

test('rejects invalid operands', () => {
  const add = (operand) => compileLater(({ position }) => position.add(operand))
  throwWarpErrors([
    [add(undefined), /add: expected a number or an expression for argument 1, got undefined/],
    [add('1'), /add: expected .* for argument 1, got the text "1"/],
    [add({ x: 1 }), /add: expected .* for argument 1, got an object/],
    [add([1, 2]), /add: expected .* for argument 1, got an array of 2/],
    [add(NaN), /add: argument 1 is NaN/],
    [add(1e-60), /add: argument 1 is 1e-60, too close to zero/],
    [add(1e39), /add: argument 1 is 1e\+39, .* 3\.4e38/],
    [compileLater(({ millis }) => millis.add()), /add: expected 1 argument, got 0/],
    [compileLater(({ glsl }) => glsl.sum()), /sum: expected 2 arguments, got 0/],
    [
      compileLater(({ glsl, millis }) => glsl.max(millis, null)),
      /max: expected .* for argument 2, got null/,
    ],
  ])
})

test('rejects vectors of different sizes', () => {
  throwWarpErrors([
    [compileLater(({ position, uv }) => position.add(uv)), /add: a vec3 and a vec2 do not fit/],
    [compileLater(({ uv }) => uv.z()), /z: a vec2 has no such components/],
    [compileLater(({ uv }) => uv.scale(uv)), /scale: expected a single number as argument 1/],
  ])
})

test('rejects divisions by zero', () => {
  throwsWarpError(
    compileLater(({ position }) => position.div(0)),
    /div: a divisor is zero/,
  )
})

test('rejects expressions of another warp', () => {
  let stolen
  compileWarp(({ glsl, position }) => ((stolen = position), glsl.vec3(0, 0, 0)))
  throwWarpErrors([
    [compileLater(() => stolen), /comes from another warp/],
    [
      compileLater(({ position }) => position.add(stolen)),
      /add: argument 1 comes from another warp/,
    ],
    [() => stolen.add(1), /add: the function that made this expression is over/],
  ])
})

test('rejects invalid options', () => {
  throwWarpErrors([
    [
      () => compileWarp(zeroOffset, { target: 'hlsl' }),
      /expected 'glsl300', 'glsl100' or 'wgsl' for the option "target", got the text "hlsl"/,
    ],
    [() => compileWarp(zeroOffset, { traget: 'glsl300' }), /no option "traget"/],
    [() => compileWarp(zeroOffset, 5), /expected an object of options, got/],
    [
      () => compileWarp(zeroOffset, { normals: 'no' }),
      /expected true, false, 'vertex', 'pixel' or 'auto' for the option "normals", got the text "no"/,
    ],
    [() => compileWarp(zeroOffset, { names: { pos: 'p' } }), /no option "pos"/],
    [
      () => compileWarp(zeroOffset, { names: { position: 5 } }),
      /for the option "names\.position", got the number 5/,
    ],
    [
      () => gen(() => {}, { maxDepthPerVariable: 0 }),
      /expected a number of at least 1 for the option "maxDepthPerVariable"/,
    ],
  ])
})

test('rejects results requested by .output(…) outside of gen', () => {
  const withSlope = (write) =>
    compileLater(({ glsl, millis, position }) => {
      const slope = glsl.fn({
        name: 'slope',
        arity: 1,
        source: 'float slope(float x) { return x; }',
        derivatives: [(x) => void x.output('hack')],
      })
      return write({ glsl, millis, position, slope })
    })
  const message = /^output(Deriv)?: only gen takes results this way; return the expression/
  throwWarpErrors([
    [
      withSlope(({ millis, position }) => {
        millis.sin().output('hack')
        return position
      }),
      message,
    ],
    [
      withSlope(({ millis, position }) => {
        millis.sin().outputDeriv('hack', millis)
        return position
      }),
      message,
    ],
    [withSlope(({ glsl, position, slope }) => glsl.vec3(slope(position.x()), 0, 0)), message],
    [
      () =>
        compile((glsl) => {
          const x = glsl.param('x')
          x.sin().output('hack')
          return { r: x.cos(), s: glsl.val(0) }
        }),
      message,
    ],
  ])
})

test('rejects a class instead of a function', () => {
  class Offset {}
  const classMessage = /expected a function, got a class\./
  for (const run of [compileWarp, compile, gen]) throwsWarpError(() => run(Offset), classMessage)
  throwWarpErrors([
    [() => compileWarp(Map), classMessage],
    [
      () => compileWarp(zeroOffset, { uniforms: { reach: Offset } }),
      /^compileWarp: expected a number, .*, for the uniform "reach", got a class\./,
    ],
  ])
  const slope = (glsl) =>
    glsl.fn({
      name: 'slope',
      arity: 1,
      source: 'float slope(float x) { return x; }',
      derivatives: [Offset],
    })
  throwWarpErrors([
    [
      compileLater(({ glsl, position }) => glsl.vec3(slope(glsl)(position.x()), 0, 0)),
      /^slope: expected a number or an expression for derivative 1, got a class/,
    ],
    [
      () => chain(twist({ angle: 1 }), Offset),
      /expected an offset function, .* for argument 2, got a class/,
    ],
    [() => twist({ angle: Offset }), /expected .* for the option "angle", got a class/],
    [() => inSpace(Offset, zeroOffset), /for the matrix, got a class/],
  ])
})

test('rejects invalid names of results', () => {
  const withOutputs = (outputs) => () => compileWarp(zeroOffset, { outputs })
  throwWarpErrors([
    [withOutputs({ position: '2x' }), /"2x" cannot name a result/],
    [withOutputs({ position: 'vec3' }), /"vec3" cannot name a result/],
    [withOutputs({ position: 'gl_Position' }), /"gl_Position" cannot name a result/],
    [withOutputs({ position: 'a', normal: 'a' }), /two results named "a"/],
    [
      withOutputs({ position: 7 }),
      /expected the name of a shader variable for the option "outputs\.position", got the number 7/,
    ],
    [withOutputs({ offset: 'position' }), /"position" has the name of a variable/],
    [() => compile((glsl) => ({ 'a b': glsl.val(1) })), /"a b" cannot name a result/],
    [() => compile(() => 5), /must return an object of named expressions/],
    [() => compile(() => []), /must return an object of named expressions.*an array of 0/],
    [() => compile((glsl) => ({ cos: glsl.param('x').cos() })), /"cos" cannot name a result/],
    [() => gen((ad) => ad.param('z').sin().output('z')), /"z" has the name of a variable/],
  ])
})

test('rejects invalid names of parameters', () => {
  const param = (name) => compileLater(({ glsl }) => glsl.vec3(glsl.param(name), 0, 0))
  throwWarpErrors([
    [param('for'), /"for" cannot be read in a shader: "for" is a reserved word of GLSL/],
    [param('gl_Foo'), /gl_ or webgl_ are reserved in GLSL/],
    [param('a__b'), /two consecutive underscores/],
    [param('x; y'), /";" is not allowed in it/],
    [param('(x'), /"\)" is missing/],
    [param('sin'), /"sin" is a function of GLSL/],
    [param('float'), /"float" is a reserved word of GLSL/],
    [param('a'.repeat(300)), /longer than 256 characters/],
    [param(undefined), /expected the name of a shader variable, got undefined/],
  ])
})

test('rejects derivatives with respect to anything but an input', () => {
  const differentiateBy = (choose) => () =>
    compile((glsl) => {
      const v = glsl.vec3Param('v')
      return { d: glsl.derivative(v.x().sin(), choose(v)) }
    })
  throwsWarpError(
    differentiateBy((v) => v),
    /derivative: expected a single input \(such as position\.x\(\)\) as argument 2, got a vec3/,
  )
})

test('treats two spellings of one variable as the same, or rejects them', () => {
  const { code } = compile((glsl) => {
    const p = glsl.vec3Param('p')
    const square = (x) => glsl.derivative(x.mult(x), p.z())
    return {
      a: square(glsl.param('p.b')),
      b: square(glsl.param('p[2]')),
      c: glsl.vec2Param('p.zx'),
    }
  })
  assert.match(code, /a = p\.z \* 2\.0;\s+b = a;\s+c = p\.zx;/)
  throwsWarpError(
    () => compile((glsl) => ({ r: glsl.param('p.x').mult(glsl.vec3Param('p')) })),
    /vec3Param: "p\.x" was read before "p", of which it is a part; read the vector first/,
  )
})

test('rejects invalid uses of vector inputs', () => {
  const compileWith = (callback) => () =>
    compile((glsl) => ({ d: callback(glsl, glsl.vec3Param('v'), glsl.vec2Param('u')) }))
  throwsWarpError(
    compileWith((glsl, v, u) => glsl.adjustNormal(v, v, u)),
    /adjustNormal: expected a vec3 of inputs \(such as position\) as argument 3, got a vec2/,
  )
})

test('rejects invalid uses of matrices', () => {
  const compileWith = (callback) => () =>
    compile((glsl) => ({ r: callback(glsl, glsl.mat3Param('m')) }))
  throwWarpErrors([
    [
      compileWith((glsl, m) => m.mult(glsl.vec2(1, 2))),
      /mult: a mat3 and a vec2 do not fit together/,
    ],
    [
      () =>
        compile((glsl) => ({ j: glsl.jacobian(glsl.vec2Param('u'), glsl.vec3Param('v')) }), {
          target: 'glsl100',
        }),
      /the result "j" is a matrix of 3 columns and 2 rows, but WebGL 1 has only/,
    ],
  ])
})

test('rejects invalid shader functions', () => {
  const a = { name: 'a', source: 'float a(float x) { return x; }', arity: 1 }
  const compileCall =
    (options, use = (f, x) => f(x), target) =>
    () =>
      compile((glsl) => ({ r: use(glsl.fn(options), glsl.param('x'), glsl) }), { target })
  const differentiated = (f, x, glsl) => glsl.derivative(f(x), x)
  throwWarpErrors([
    [
      compileCall(undefined),
      /fn: expected an object \{ name, source, arity, derivatives \}, got undefined/,
    ],
    [compileCall({ nam: 'a' }), /fn: there is no option "nam"/],
    [compileCall({ ...a, name: 5 }), /expected a text for the option "name", got the number 5/],
    [
      compileCall({ ...a, arity: 0 }),
      /expected a whole number from 1 to 16 for the option "arity" of a/,
    ],
    [
      compileCall({ ...a, source: { wgsl: '' } }),
      /expected GLSL source for the target glsl300, or an object \{ glsl: … \} with it, for the option "source" of a/,
    ],
    [
      compileCall({ ...a, derivatives: [] }),
      /expected an array of 1, one for each argument, for the option "derivatives" of a/,
    ],
    [compileCall(a, differentiated), /a: its derivatives are needed here/],
    [
      compileCall({ ...a, derivatives: [() => undefined] }, differentiated),
      /a: expected a number or an expression for derivative 1, got undefined/,
    ],
    [
      compileCall(
        { ...a, derivatives: [(x) => x.add(1).mult(0.5).sin().neg().add(x).gt(0)] },
        (f, x, glsl) => glsl.derivative(f(glsl.vec2(x, 1)), x).dot(glsl.vec3(1, 1, 1)),
      ),
      /dot: a vec2 and a vec3/,
    ],
    [
      () => compile((glsl) => ({ r: glsl.fn(a)(glsl.param('x')) })).evaluate({ x: 1 }),
      /evaluate: only the GPU can call a function of glsl\.fn/,
    ],
  ])
})

test('rejects invalid numbers passed to evaluate', () => {
  const { evaluate } = compile((glsl) => ({ r: glsl.vec2Param('v').x().add(glsl.param('x')) }))
  assert.deepEqual(evaluate({ v: [1, 2], x: 3 }), { r: 4 })
  throwWarpErrors([
    [() => evaluate(), /evaluate: expected an array of 2 finite numbers for "v", got undefined/],
    [
      () => evaluate({ v: [1], x: 1 }),
      /expected an array of 2 finite numbers for "v", got an array of 1/,
    ],
    [() => evaluate({ v: [1, 2], x: '1' }), /expected a finite number for "x", got the text "1"/],
  ])
})

test('reports constants whose product, which only the derivative computes, is infinite', () => {
  throwsWarpError(
    () =>
      compile((glsl) => {
        const x = glsl.param('x')
        return { d: glsl.derivative(x.mult(1e30).mult(1e30), x) }
      }),
    /derivative: the result of these constants is not a finite float32 number/,
  )
})

test('stops an endless loop with a message', { timeout: 60_000 }, () => {
  throwsWarpError(
    compileLater(({ millis }) => {
      for (let v = millis; ;) v = v.sin().add(1)
    }),
    /more than four million operations; check for an endless loop/,
  )
})
