// Each mistake throws one clear message, and does not affect the next warp.
import assert from 'node:assert/strict'
import { afterEach, test } from 'node:test'
import { inspect } from 'node:util'
import { chain, inSpace, twist } from '../../dist/deformers.js'
import { compile, compileWarp, gen } from '../../dist/warpjet.js'
import { throwsWarpError } from '../support/warp-errors.js'

const still = ({ glsl }) => glsl.vec3(0, 0, 0)

afterEach(() => assert.match(compileWarp(still).code, /warpedPosition/))

const offset = (callback) => () => compileWarp(callback)

test('rejects wrong results of the offset function', () => {
  throwsWarpError(
    offset(() => undefined),
    /must return a vec3.*undefined/,
  )
  throwsWarpError(
    offset(() => 5),
    /must return a vec3.*the number 5/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.vec2(1, 2)),
    /must return a vec3.*a vec2/,
  )
  throwsWarpError(
    offset(({ millis }) => millis),
    /must return a vec3.*a single number/,
  )
  throwsWarpError(
    offset(() => [0, 0, 0]),
    /must return a vec3.*an array of 3/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.vec3(NaN, 0, 0)),
    /vec3: argument 1 is NaN/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.vec3(0, 1 / 0, 0)),
    /vec3: argument 2 is Infinity/,
  )
})

test("rejects JavaScript's operators on expressions", () => {
  throwsWarpError(
    offset(({ position }) => position.x() * 2),
    /own \+ - \* \/ .* do not work on expressions/,
  )
  throwsWarpError(
    offset(({ position }) => (position.x() > 0 ? position : position.neg())),
    /do not work on expressions/,
  )
})

test('reports expressions that are converted to strings', () => {
  // The string is for messages of other libraries; a shader rejects it.
  compile((glsl) => {
    const x = glsl.param('x')
    assert.equal(`${x}`, 'an expression of warpjet')
    // Node's console calls it.
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
  const sentence = /was made by another copy of warpjet; this page loads two copies, so load all/
  throwsWarpError(
    offset(() => foreign),
    sentence,
  )
  throwsWarpError(
    offset(({ position }) => position.add(foreign)),
    sentence,
  )
})

test('rejects values that are not offset functions', () => {
  throwsWarpError(() => compileWarp(), /expected a function, got undefined/)
  throwsWarpError(() => compileWarp('x'), /expected a function, got the text "x"\.$/)
  throwsWarpError(
    () => compileWarp('vec3 offset(vec3 p) { return p; }'),
    /got the text .*; glslOffset\(text\)/,
  )
  throwsWarpError(() => compile(7), /compile: expected a function, got the number 7/)
  throwsWarpError(() => gen({}), /gen: expected a function, got an empty object/)
  throwsWarpError(
    () => gen(async () => {}),
    /gen: the function must be neither async nor a generator/,
  )
  throwsWarpError(
    () => compile(async () => ({})),
    /compile: the function must return an object of named/,
  )
})

test('rejects invalid operands', () => {
  const with_ = (operand) => offset(({ position }) => position.add(operand))
  throwsWarpError(
    with_(undefined),
    /add: expected a number or an expression for argument 1, got undefined/,
  )
  throwsWarpError(with_('1'), /add: expected .* for argument 1, got the text "1"/)
  throwsWarpError(with_({ x: 1 }), /add: expected .* for argument 1, got an object/)
  throwsWarpError(with_([1, 2]), /add: expected .* for argument 1, got an array of 2/)
  throwsWarpError(with_(NaN), /add: argument 1 is NaN/)
  throwsWarpError(with_(1e-60), /add: argument 1 is 1e-60, too close to zero/)
  throwsWarpError(with_(1e39), /add: argument 1 is 1e\+39, .* 3\.4e38/)
  throwsWarpError(
    offset(({ millis }) => millis.add()),
    /add: expected 1 argument, got 0/,
  )
  throwsWarpError(
    offset(({ millis }) => millis.sin(2)),
    /sin: expected no arguments, got 1/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.sin()),
    /sin: expected 1 argument, got 0/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.sum()),
    /sum: expected 2 arguments, got 0/,
  )
  throwsWarpError(
    offset(({ glsl, millis }) => glsl.max(millis, null)),
    /max: expected .* for argument 2, got null/,
  )
})

test('rejects vectors of different sizes', () => {
  throwsWarpError(
    offset(({ position, uv }) => position.add(uv)),
    /add: a vec3 and a vec2 do not fit/,
  )
  throwsWarpError(
    offset(({ uv }) => uv.cross(uv)),
    /cross: expected a vec3 as .*, got a vec2/,
  )
  throwsWarpError(
    offset(({ millis, uv }) => uv.dot(millis)),
    /dot: expected a vector as argument 1/,
  )
  throwsWarpError(
    offset(({ uv }) => uv.z()),
    /z: a vec2 has no such components/,
  )
  throwsWarpError(
    offset(({ millis }) => millis.x()),
    /x: a single number has no such components/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.vec3(1, 2)),
    /vec3: expected 3 components, got 2/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.vec3()),
    /vec3: expected 3 components, got 0/,
  )
  throwsWarpError(
    offset(({ uv }) => uv.scale(uv)),
    /scale: expected a single number as argument 1/,
  )
})

test('rejects constants without a finite result', () => {
  throwsWarpError(
    offset(({ glsl }) => glsl.val(1).div(0)),
    /div: it divides by zero/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.val(-1).sqrt()),
    /sqrt: the result/,
  )
  throwsWarpError(
    offset(({ glsl }) => glsl.val(1e30).mult(1e30)),
    /mult: the result/,
  )
})

test('rejects divisions by zero, and wrong sizes inside of a composition', () => {
  throwsWarpError(
    offset(({ position }) => position.div(0)),
    /div: it divides by zero/,
  )
  throwsWarpError(
    offset(({ uv, position }) => uv.dot(position)),
    /dot: a vec2 and a vec3 do not fit/,
  )
})

test('rejects expressions of another warp', () => {
  let stolen
  compileWarp(({ glsl, position }) => ((stolen = position), glsl.vec3(0, 0, 0)))
  throwsWarpError(
    offset(() => stolen),
    /comes from another warp/,
  )
  throwsWarpError(
    offset(({ position }) => position.add(stolen)),
    /add: argument 1 comes from another warp/,
  )
  throwsWarpError(() => stolen.add(1), /add: the function that made this expression is over/)
})

test('rejects invalid options', () => {
  throwsWarpError(
    () => compileWarp(still, { target: 'hlsl' }),
    /expected 'glsl300', 'glsl100' or 'wgsl' for the option "target", got the text "hlsl"/,
  )
  throwsWarpError(() => compileWarp(still, { traget: 'glsl300' }), /no option "traget"/)
  throwsWarpError(() => compileWarp(still, 5), /expected an object of options, got/)
  throwsWarpError(
    () => compileWarp(still, { normals: 'no' }),
    /expected true, false, 'vertex', 'pixel' or 'auto' for the option "normals", got the text "no"/,
  )
  throwsWarpError(() => compileWarp(still, { names: { pos: 'p' } }), /no option "pos"/)
  throwsWarpError(
    () => compileWarp(still, { names: { position: 5 } }),
    /for the option "names\.position", got the number 5/,
  )
  throwsWarpError(
    () => gen(() => {}, { maxDepthPerVariable: 0 }),
    /expected a number of at least 1 for the option "maxDepthPerVariable"/,
  )
})

test('rejects results requested by .output(…) outside of gen', () => {
  const asks = (warp) =>
    offset(({ glsl, millis, position }) => {
      const slope = glsl.fn({
        name: 'slope',
        arity: 1,
        source: 'float slope(float x) { return x; }',
        derivatives: [(x) => void x.output('hack')],
      })
      return warp({ glsl, millis, position, slope })
    })
  const only = /^output(Deriv)?: only gen takes results this way; return the expression/
  throwsWarpError(
    asks(({ millis, position }) => {
      millis.sin().output('hack')
      return position
    }),
    only,
  )
  throwsWarpError(
    asks(({ millis, position }) => {
      millis.sin().outputDeriv('hack', millis)
      return position
    }),
    only,
  )
  throwsWarpError(
    asks(({ glsl, position, slope }) => glsl.vec3(slope(position.x()), 0, 0)),
    only,
  )
  throwsWarpError(
    () =>
      compile((glsl) => {
        const x = glsl.param('x')
        x.sin().output('hack')
        return { r: x.cos(), s: glsl.val(0) }
      }),
    only,
  )
})

test('rejects a class instead of a function', () => {
  class Offset {}
  const isClass = /expected a function, got a class\./
  for (const run of [compileWarp, compile, gen]) throwsWarpError(() => run(Offset), isClass)
  throwsWarpError(() => compileWarp(Map), isClass)
  throwsWarpError(
    () => compileWarp(still, { uniforms: { reach: Offset } }),
    /^compileWarp: expected a number, .*, for the uniform "reach", got a class\./,
  )
  const slope = (glsl) =>
    glsl.fn({
      name: 'slope',
      arity: 1,
      source: 'float slope(float x) { return x; }',
      derivatives: [Offset],
    })
  throwsWarpError(
    offset(({ glsl, position }) => glsl.vec3(slope(glsl)(position.x()), 0, 0)),
    /^slope: expected a number or an expression for derivative 1, got a class/,
  )
  throwsWarpError(
    () => chain(twist({ angle: 1 }), Offset),
    /expected an offset function, .* for argument 2, got a class/,
  )
  throwsWarpError(() => twist({ angle: Offset }), /expected .* for the option "angle", got a class/)
  throwsWarpError(() => inSpace(Offset, still), /for the matrix, got a class/)
})

test('rejects invalid names of results', () => {
  const withOutputs = (outputs) => () => compileWarp(still, { outputs })
  throwsWarpError(withOutputs({ position: '2x' }), /"2x" cannot name a result/)
  throwsWarpError(withOutputs({ position: 'vec3' }), /"vec3" cannot name a result/)
  throwsWarpError(withOutputs({ position: 'gl_Position' }), /"gl_Position" cannot name a result/)
  throwsWarpError(withOutputs({ position: 'a', normal: 'a' }), /two results named "a"/)
  throwsWarpError(
    withOutputs({ position: 7 }),
    /expected the name of a shader variable for the option "outputs\.position", got the number 7/,
  )
  throwsWarpError(withOutputs({ offset: 'position' }), /"position" has the name of a variable/)
  throwsWarpError(() => compile((glsl) => ({ 'a b': glsl.val(1) })), /"a b" cannot name a result/)
  throwsWarpError(() => compile(() => 5), /must return an object of named expressions/)
  throwsWarpError(
    () => compile(() => []),
    /must return an object of named expressions.*an array of 0/,
  )
  throwsWarpError(
    () => compile((glsl) => ({ cos: glsl.param('x').cos() })),
    /"cos" cannot name a result/,
  )
  throwsWarpError(
    () => gen((ad) => ad.param('z').sin().output('z')),
    /"z" has the name of a variable/,
  )
})

test('rejects invalid names of parameters', () => {
  const param = (name) => offset(({ glsl }) => glsl.vec3(glsl.param(name), 0, 0))
  throwsWarpError(
    param('for'),
    /"for" cannot be read in a shader: "for" is a reserved word of GLSL/,
  )
  throwsWarpError(param('gl_Foo'), /gl_ or webgl_ are reserved in GLSL/)
  throwsWarpError(param('a__b'), /two consecutive underscores/)
  throwsWarpError(param('x; y'), /";" is not allowed in it/)
  throwsWarpError(param('x +'), /an operand is missing/)
  throwsWarpError(param('(x'), /"\)" is missing/)
  throwsWarpError(param(''), /it is empty/)
  throwsWarpError(param('sin'), /"sin" is a function of GLSL/)
  throwsWarpError(param('float'), /"float" is a reserved word of GLSL/)
  throwsWarpError(
    offset(({ glsl }) => glsl.vec3Param('a').mult(glsl.param('a'))),
    /"a" was read as a vec3 before, and now as a single number/,
  )
  throwsWarpError(param('é'), /only ASCII characters/)
  throwsWarpError(param('a'.repeat(300)), /longer than 256 characters/)
  throwsWarpError(param(undefined), /expected the name of a shader variable, got undefined/)
})

test('rejects derivatives with respect to anything but an input', () => {
  const by = (choose) => () =>
    compile((glsl) => {
      const v = glsl.vec3Param('v')
      return { d: glsl.derivative(v.x().sin(), choose(v)) }
    })
  throwsWarpError(
    by((v) => v),
    /derivative: expected a single input \(such as position\.x\(\)\) as argument 2, got a vec3/,
  )
  throwsWarpError(
    by((v) => v.x().mult(2)),
    /derivative: argument 2 must be an input such as millis .* not something computed/,
  )
  throwsWarpError(
    by(() => 3),
    /must be an input/,
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
    /vec3Param: "p\.x" was read before "p", whose part it is; read the vector first/,
  )
})

test('rejects invalid uses of vector inputs', () => {
  const of = (callback) => () =>
    compile((glsl) => ({ d: callback(glsl, glsl.vec3Param('v'), glsl.vec2Param('u')) }))
  throwsWarpError(
    of((glsl, v) => glsl.gradient(v, v)),
    /gradient: expected a single number as argument 1, got a vec3/,
  )
  throwsWarpError(
    of((glsl, v) => glsl.gradient(v.x(), v.mult(2))),
    /argument 2 must be an input such as .* not something computed/,
  )
  throwsWarpError(
    of((glsl, v) => glsl.jacobian(v, v.xxy())),
    /jacobian: argument 2 must have different components/,
  )
  throwsWarpError(
    of((glsl, v) => glsl.jacobian(v, v.x())),
    /expected a vector of inputs \(such as position\) as argument 2, got a single number/,
  )
  throwsWarpError(
    of((glsl, v, u) => glsl.adjustNormal(v, v, u)),
    /adjustNormal: expected a vec3 of inputs \(such as position\) as argument 3, got a vec2/,
  )
})

test('rejects invalid uses of matrices', () => {
  const of = (callback) => () => compile((glsl) => ({ r: callback(glsl, glsl.mat3Param('m')) }))
  throwsWarpError(
    of((glsl, m) => m.sin()),
    /sin: it does not work on matrices/,
  )
  throwsWarpError(
    of((glsl, m) => m.mult(glsl.vec2(1, 2))),
    /mult: a mat3 and a vec2 do not fit together/,
  )
  throwsWarpError(
    of((glsl, m) => glsl.val(1).div(m)),
    /div: a matrix cannot divide; multiply by its inverse/,
  )
  throwsWarpError(
    of((glsl) => glsl.mat2(1, 2, 2, 4).inverse()),
    /inverse: the determinant of this matrix is 0/,
  )
  throwsWarpError(
    of((glsl) => glsl.rotate(glsl.vec3(0, 0, 0), 1)),
    /rotate: the axis is zero/,
  )
  throwsWarpError(
    of((glsl, m) => m.column(3)),
    /column: argument 1 must be a whole number from 0 to 2/,
  )
  throwsWarpError(
    of((glsl) => glsl.mat2(1, 2, 3)),
    /mat2: expected 4 components, got 3/,
  )
  throwsWarpError(
    of((glsl) => glsl.mat2(glsl.vec3(1), glsl.vec2(1, 2))),
    /mat2: expected 2 columns of 2 components, got a vec3/,
  )
  throwsWarpError(
    of((glsl, m) => glsl.mat3Rows(m)),
    /mat3Rows: expected a vector or a number as argument 1, got a mat3/,
  )
  throwsWarpError(
    of((glsl, m) => m.x()),
    /x: a mat3 has no such components/,
  )
  throwsWarpError(
    () =>
      compile((glsl) => ({ j: glsl.jacobian(glsl.vec2Param('u'), glsl.vec3Param('v')) }), {
        target: 'glsl100',
      }),
    /the result "j" is a matrix of 3 columns and 2 rows, but WebGL 1 has only/,
  )
})

test('rejects inverses of singular constants', () => {
  const of = (callback) => () => compile((glsl) => ({ r: callback(glsl) }))
  for (const [name, callback] of Object.entries({
    atan: (glsl) => glsl.atan(0, 0),
    acosh: (glsl) => glsl.val(0.5).acosh(),
    atanh: (glsl) => glsl.val(1).atanh(),
    log2: (glsl) => glsl.val(0).log2(),
    asin: (glsl) => glsl.val(2).asin(),
    pow: (glsl) => glsl.val(-1).pow(0.5),
    mod: (glsl) => glsl.param('x').mod(0),
    smoothstep: (glsl) => glsl.smoothstep(1, 1, glsl.param('x')),
  }))
    throwsWarpError(of(callback), new RegExp(`^${name}: `))
})

test('rejects invalid shader functions', () => {
  const a = { name: 'a', source: 'float a(float x) { return x; }', arity: 1 }
  const of =
    (options, use = (f, x) => f(x), target) =>
    () =>
      compile((glsl) => ({ r: use(glsl.fn(options), glsl.param('x'), glsl) }), { target })
  const differentiated = (f, x, glsl) => glsl.derivative(f(x), x)
  throwsWarpError(
    of(undefined),
    /fn: expected an object \{ name, source, arity, derivatives \}, got undefined/,
  )
  throwsWarpError(of({ nam: 'a' }), /fn: there is no option "nam"/)
  throwsWarpError(of({ ...a, name: 5 }), /expected a text for the option "name", got the number 5/)
  throwsWarpError(
    of({ ...a, name: 'sin' }),
    /"sin" cannot name a function: "sin" is a function of GLSL/,
  )
  throwsWarpError(of({ ...a, name: 'b' }), /"b" is not in the source/)
  throwsWarpError(
    of({ ...a, arity: 0 }),
    /expected a whole number from 1 to 16 for the option "arity" of a/,
  )
  throwsWarpError(
    of({ ...a, source: { wgsl: '' } }),
    /expected GLSL source for the target glsl300, or an object \{ glsl: … \} with it, for the option "source" of a/,
  )
  throwsWarpError(
    of({ ...a, derivatives: [] }),
    /expected an array of 1, one for each argument, for the option "derivatives" of a/,
  )
  throwsWarpError(
    of(a, (f) => f(1, 2)),
    /a: expected 1 argument, got 2/,
  )
  throwsWarpError(
    of(a, (f, x, glsl) => f(glsl.mat2(1))),
    /a: expected a number or a vector as argument 1, got a mat2/,
  )
  throwsWarpError(of(a, differentiated), /a: its derivatives are needed here/)
  throwsWarpError(
    of({ ...a, derivatives: [() => undefined] }, differentiated),
    /a: expected a number or an expression for derivative 1, got undefined/,
  )
  throwsWarpError(
    of({ ...a, derivatives: [(x) => x.add(1).mult(0.5).sin().neg().add(x).gt(0)] }, (f, x, glsl) =>
      glsl.derivative(f(glsl.vec2(x, 1)), x).dot(glsl.vec3(1, 1, 1)),
    ),
    /dot: a vec2 and a vec3/,
  )
  throwsWarpError(
    of(a, (f, x, glsl) => glsl.fn({ ...a, source: 'float a(float x) { return -x; }' })(f(x))),
    /"a" is already the name of another function/,
  )
  throwsWarpError(
    () => compile((glsl) => ({ a: glsl.fn(a)(glsl.param('x')) })),
    /The result "a" has the name of a variable or function that its code reads/,
  )
  throwsWarpError(
    () => compile((glsl) => ({ r: glsl.fn(a)(glsl.param('x')) })).evaluate({ x: 1 }),
    /evaluate: only the GPU can call a function of glsl\.fn/,
  )
})

test('rejects invalid numbers passed to evaluate', () => {
  const { evaluate } = compile((glsl) => ({ r: glsl.vec2Param('v').x().add(glsl.param('x')) }))
  assert.deepEqual(evaluate({ v: [1, 2], x: 3 }), { r: 4 })
  throwsWarpError(
    () => evaluate(),
    /evaluate: expected an array of 2 finite numbers for "v", got undefined/,
  )
  throwsWarpError(
    () => evaluate({ v: [1], x: 1 }),
    /expected an array of 2 finite numbers for "v", got an array of 1/,
  )
  throwsWarpError(
    () => evaluate({ v: [1, 2], x: '1' }),
    /expected a finite number for "x", got the text "1"/,
  )
})

test('reports constants that only a derivative combines to an infinite result', () => {
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
    offset(({ millis }) => {
      for (let v = millis; ;) v = v.sin().add(1)
    }),
    /more than four million operations; does a loop never end/,
  )
})
