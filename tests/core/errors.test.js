// Each mistake throws one clear sentence, and the next warp works as if nothing had happened.
import assert from 'node:assert/strict'
import { afterEach, test } from 'node:test'
import { inspect } from 'node:util'
import { chain, inSpace, twist } from '../../dist/deformers.js'
import { compile, compileWarp, gen, WarpError } from '../../dist/warpjet.js'

const still = ({ glsl }) => glsl.vec3(0, 0, 0)

afterEach(() => assert.match(compileWarp(still).code, /warpedPosition/))

function refuses(work, pattern) {
  assert.throws(work, (error) => {
    assert.ok(error instanceof WarpError, String(error))
    assert.match(error.message, pattern)
    assert.doesNotMatch(error.message, /\n/)
    return true
  })
}

const offset = (callback) => () => compileWarp(callback)

test('wrong results of the offset function', () => {
  refuses(
    offset(() => undefined),
    /must return a vec3.*undefined/,
  )
  refuses(
    offset(() => 5),
    /must return a vec3.*the number 5/,
  )
  refuses(
    offset(({ glsl }) => glsl.vec2(1, 2)),
    /must return a vec3.*a vec2/,
  )
  refuses(
    offset(({ millis }) => millis),
    /must return a vec3.*a single number/,
  )
  refuses(
    offset(() => [0, 0, 0]),
    /must return a vec3.*an array of 3/,
  )
  refuses(
    offset(({ glsl }) => glsl.vec3(NaN, 0, 0)),
    /vec3: argument 1 is NaN/,
  )
  refuses(
    offset(({ glsl }) => glsl.vec3(0, 1 / 0, 0)),
    /vec3: argument 2 is Infinity/,
  )
})

test("JavaScript's operators", () => {
  refuses(
    offset(({ position }) => position.x() * 2),
    /own \+ - \* \/ .* do not work on expressions/,
  )
  refuses(
    offset(({ position }) => (position.x() > 0 ? position : position.neg())),
    /do not work on expressions/,
  )
})

test('expressions converted to strings', () => {
  // The string is for messages of other libraries; a shader rejects it.
  compile((glsl) => {
    const x = glsl.param('x')
    assert.equal(`${x}`, 'an expression of warpjet')
    // Node's console calls it.
    assert.equal(inspect(x), 'an expression of warpjet')
    assert.equal(inspect([glsl.vec2Param('v').y]), '[ an expression of warpjet ]')
    refuses(() => glsl.param(`${x}`), /param: "an expression of warpjet" cannot be read/)
    refuses(
      () => glsl.fn({ name: 'f', arity: 1, source: `float f(float a) { return a * ${x}; }` }),
      /^fn: the option "source" of f contains an expression; make it an argument/,
    )
    refuses(() => x + '', /do not work on expressions/)
    return { result: x }
  })
})

test('expressions of another copy of warpjet', async () => {
  const other = await import('../../dist/warpjet.min.js')
  let foreign
  other.compileWarp(({ position }) => (foreign = position))
  const sentence = /was made by another copy of warpjet; this page loads two copies, so load all/
  refuses(
    offset(() => foreign),
    sentence,
  )
  refuses(
    offset(({ position }) => position.add(foreign)),
    sentence,
  )
})

test('values that are not offset functions', () => {
  refuses(() => compileWarp(), /expected a function, got undefined/)
  refuses(() => compileWarp('x'), /expected a function, got the text "x"\.$/)
  refuses(
    () => compileWarp('vec3 offset(vec3 p) { return p; }'),
    /got the text .*; glslOffset\(text\)/,
  )
  refuses(() => compile(7), /compile: expected a function, got the number 7/)
  refuses(() => gen({}), /gen: expected a function, got an empty object/)
  refuses(() => gen(async () => {}), /gen: the function must be neither async nor a generator/)
  refuses(() => compile(async () => ({})), /compile: the function must return an object of named/)
})

test('operands', () => {
  const with_ = (operand) => offset(({ position }) => position.add(operand))
  refuses(with_(undefined), /add: expected a number or an expression for argument 1, got undefined/)
  refuses(with_('1'), /add: expected .* for argument 1, got the text "1"/)
  refuses(with_({ x: 1 }), /add: expected .* for argument 1, got an object/)
  refuses(with_([1, 2]), /add: expected .* for argument 1, got an array of 2/)
  refuses(with_(NaN), /add: argument 1 is NaN/)
  refuses(with_(1e-60), /add: argument 1 is 1e-60, too close to zero/)
  refuses(with_(1e39), /add: argument 1 is 1e\+39, .* 3\.4e38/)
  refuses(
    offset(({ millis }) => millis.add()),
    /add: expected 1 argument, got 0/,
  )
  refuses(
    offset(({ millis }) => millis.sin(2)),
    /sin: expected no arguments, got 1/,
  )
  refuses(
    offset(({ glsl }) => glsl.sin()),
    /sin: expected 1 argument, got 0/,
  )
  refuses(
    offset(({ glsl }) => glsl.sum()),
    /sum: expected 2 arguments, got 0/,
  )
  refuses(
    offset(({ glsl, millis }) => glsl.max(millis, null)),
    /max: expected .* for argument 2, got null/,
  )
})

test('sizes', () => {
  refuses(
    offset(({ position, uv }) => position.add(uv)),
    /add: a vec3 and a vec2 do not fit/,
  )
  refuses(
    offset(({ uv }) => uv.cross(uv)),
    /cross: .* must be a vec3, but is a vec2/,
  )
  refuses(
    offset(({ millis, uv }) => uv.dot(millis)),
    /dot: argument 1 must be a vector/,
  )
  refuses(
    offset(({ uv }) => uv.z()),
    /z: a vec2 has no such components/,
  )
  refuses(
    offset(({ millis }) => millis.x()),
    /x: a single number has no such components/,
  )
  refuses(
    offset(({ glsl }) => glsl.vec3(1, 2)),
    /vec3: expected 3 components, got 2/,
  )
  refuses(
    offset(({ glsl }) => glsl.vec3()),
    /vec3: expected 3 components, got 0/,
  )
  refuses(
    offset(({ uv }) => uv.scale(uv)),
    /scale: argument 1 must be a single number/,
  )
})

test('constants without a finite result', () => {
  refuses(
    offset(({ glsl }) => glsl.val(1).div(0)),
    /div: it divides by zero/,
  )
  refuses(
    offset(({ glsl }) => glsl.val(-1).sqrt()),
    /sqrt: the result/,
  )
  refuses(
    offset(({ glsl }) => glsl.val(1e30).mult(1e30)),
    /mult: the result/,
  )
})

test('divisions by zero, and sizes inside of a composition', () => {
  refuses(
    offset(({ position }) => position.div(0)),
    /div: it divides by zero/,
  )
  refuses(
    offset(({ uv, position }) => uv.dot(position)),
    /dot: a vec2 and a vec3 do not fit/,
  )
})

test('expressions of another warp', () => {
  let stolen
  compileWarp(({ glsl, position }) => ((stolen = position), glsl.vec3(0, 0, 0)))
  refuses(
    offset(() => stolen),
    /comes from another warp/,
  )
  refuses(
    offset(({ position }) => position.add(stolen)),
    /add: argument 1 comes from another warp/,
  )
  refuses(() => stolen.add(1), /add: the function that made this expression is over/)
})

test('options', () => {
  refuses(
    () => compileWarp(still, { target: 'hlsl' }),
    /expected 'glsl300', 'glsl100' or 'wgsl' for the option "target", got the text "hlsl"/,
  )
  refuses(() => compileWarp(still, { traget: 'glsl300' }), /no option "traget"/)
  refuses(() => compileWarp(still, 5), /expected an object of options, got/)
  refuses(
    () => compileWarp(still, { normals: 'no' }),
    /expected true or false for the option "normals", got the text "no"/,
  )
  refuses(() => compileWarp(still, { names: { pos: 'p' } }), /no option "pos"/)
  refuses(
    () => compileWarp(still, { names: { position: 5 } }),
    /for the option "names\.position", got the number 5/,
  )
  refuses(
    () => gen(() => {}, { maxDepthPerVariable: 0 }),
    /expected a number of at least 1 for the option "maxDepthPerVariable"/,
  )
})

test('results requested by .output(…) outside of gen', () => {
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
  refuses(
    asks(({ millis, position }) => {
      millis.sin().output('hack')
      return position
    }),
    only,
  )
  refuses(
    asks(({ millis, position }) => {
      millis.sin().outputDeriv('hack', millis)
      return position
    }),
    only,
  )
  refuses(
    asks(({ glsl, position, slope }) => glsl.vec3(slope(position.x()), 0, 0)),
    only,
  )
  refuses(
    () =>
      compile((glsl) => {
        const x = glsl.param('x')
        x.sin().output('hack')
        return { r: x.cos(), s: glsl.val(0) }
      }),
    only,
  )
})

test('a class in the place of a function', () => {
  class Offset {}
  const isClass = /expected a function, got a class\./
  for (const run of [compileWarp, compile, gen]) refuses(() => run(Offset), isClass)
  refuses(() => compileWarp(Map), isClass)
  refuses(
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
  refuses(
    offset(({ glsl, position }) => glsl.vec3(slope(glsl)(position.x()), 0, 0)),
    /^slope: expected a number or an expression for derivative 1, got a class/,
  )
  refuses(
    () => chain(twist({ angle: 1 }), Offset),
    /expected an offset function, .* for argument 2, got a class/,
  )
  refuses(() => twist({ angle: Offset }), /expected .* for the option "angle", got a class/)
  refuses(() => inSpace(Offset, still), /for the matrix, got a class/)
})

test('names of results', () => {
  const withOutputs = (outputs) => () => compileWarp(still, { outputs })
  refuses(withOutputs({ position: '2x' }), /"2x" cannot name a result/)
  refuses(withOutputs({ position: 'vec3' }), /"vec3" cannot name a result/)
  refuses(withOutputs({ position: 'gl_Position' }), /"gl_Position" cannot name a result/)
  refuses(withOutputs({ position: 'a', normal: 'a' }), /two results named "a"/)
  refuses(
    withOutputs({ position: 7 }),
    /expected the name of a shader variable for the option "outputs\.position", got the number 7/,
  )
  refuses(withOutputs({ offset: 'position' }), /"position" has the name of a variable/)
  refuses(() => compile((glsl) => ({ 'a b': glsl.val(1) })), /"a b" cannot name a result/)
  refuses(() => compile(() => 5), /must return an object of named expressions/)
  refuses(() => compile(() => []), /must return an object of named expressions.*an array of 0/)
  refuses(() => compile((glsl) => ({ cos: glsl.param('x').cos() })), /"cos" cannot name a result/)
  refuses(() => gen((ad) => ad.param('z').sin().output('z')), /"z" has the name of a variable/)
})

test('names of parameters', () => {
  const param = (name) => offset(({ glsl }) => glsl.vec3(glsl.param(name), 0, 0))
  refuses(param('for'), /"for" cannot be read in a shader: "for" is a word of GLSL/)
  refuses(param('gl_Foo'), /gl_ or webgl_ are reserved in GLSL/)
  refuses(param('a__b'), /two underscores/)
  refuses(param('x; y'), /";" is not allowed in it/)
  refuses(param('x +'), /an operand is missing/)
  refuses(param('(x'), /"\)" is missing/)
  refuses(param(''), /it is empty/)
  refuses(param('sin'), /"sin" is a function of GLSL/)
  refuses(param('float'), /"float" is a word of GLSL/)
  refuses(
    offset(({ glsl }) => glsl.vec3Param('a').mult(glsl.param('a'))),
    /"a" was read as a vec3 before, and now as a single number/,
  )
  refuses(param('é'), /only letters from a to z/)
  refuses(param('a'.repeat(300)), /longer than 256 letters/)
  refuses(param(undefined), /expected the name of a shader variable, got undefined/)
})

test('derivatives', () => {
  const by = (choose) => () =>
    compile((glsl) => {
      const v = glsl.vec3Param('v')
      return { d: glsl.derivative(v.x().sin(), choose(v)) }
    })
  refuses(
    by((v) => v),
    /derivative: argument 2 must be a single input, such as position\.x\(\), but is a vec3/,
  )
  refuses(
    by((v) => v.x().mult(2)),
    /derivative: argument 2 must be an input such as millis .* not something computed/,
  )
  refuses(
    by(() => 3),
    /must be an input/,
  )
})

test('two spellings of one variable', () => {
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
  refuses(
    () => compile((glsl) => ({ r: glsl.param('p.x').mult(glsl.vec3Param('p')) })),
    /vec3Param: "p\.x" was read before "p", whose part it is; read the vector first/,
  )
})

test('vectors of inputs', () => {
  const of = (callback) => () =>
    compile((glsl) => ({ d: callback(glsl, glsl.vec3Param('v'), glsl.vec2Param('u')) }))
  refuses(
    of((glsl, v) => glsl.gradient(v, v)),
    /gradient: expected a single number as argument 1, got a vec3/,
  )
  refuses(
    of((glsl, v) => glsl.gradient(v.x(), v.mult(2))),
    /argument 2 must be an input such as .* not something computed/,
  )
  refuses(
    of((glsl, v) => glsl.jacobian(v, v.xxy())),
    /jacobian: argument 2 must have different components/,
  )
  refuses(
    of((glsl, v) => glsl.jacobian(v, v.x())),
    /expected a vector of inputs, such as position as argument 2, got a single number/,
  )
  refuses(
    of((glsl, v, u) => glsl.adjustNormal(v, v, u)),
    /adjustNormal: expected a vec3 of inputs, such as position as argument 3, got a vec2/,
  )
})

test('matrices', () => {
  const of = (callback) => () => compile((glsl) => ({ r: callback(glsl, glsl.mat3Param('m')) }))
  refuses(
    of((glsl, m) => m.sin()),
    /sin: it does not work on matrices/,
  )
  refuses(
    of((glsl, m) => m.mult(glsl.vec2(1, 2))),
    /mult: a mat3 and a vec2 do not fit together/,
  )
  refuses(
    of((glsl, m) => glsl.val(1).div(m)),
    /div: a matrix cannot divide; multiply by its inverse/,
  )
  refuses(
    of((glsl) => glsl.mat2(1, 2, 2, 4).inverse()),
    /inverse: the determinant of this matrix is 0/,
  )
  refuses(
    of((glsl) => glsl.rotate(glsl.vec3(0, 0, 0), 1)),
    /rotate: the axis is zero/,
  )
  refuses(
    of((glsl, m) => m.column(3)),
    /column: argument 1 must be a whole number from 0 to 2/,
  )
  refuses(
    of((glsl) => glsl.mat2(1, 2, 3)),
    /mat2: expected 4 components, got 3/,
  )
  refuses(
    of((glsl) => glsl.mat2(glsl.vec3(1), glsl.vec2(1, 2))),
    /mat2: expected 2 columns of 2 components, got a vec3/,
  )
  refuses(
    of((glsl, m) => glsl.mat3Rows(m)),
    /mat3Rows: expected a vector or a number as argument 1, got a mat3/,
  )
  refuses(
    of((glsl, m) => m.x()),
    /x: a mat3 has no such components/,
  )
  refuses(
    () =>
      compile((glsl) => ({ j: glsl.jacobian(glsl.vec2Param('u'), glsl.vec3Param('v')) }), {
        target: 'glsl100',
      }),
    /the result "j" is a matrix of 3 columns and 2 rows, but WebGL 1 has only/,
  )
})

test('singular constants', () => {
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
    refuses(of(callback), new RegExp(`^${name}: `))
})

test('functions of the shader', () => {
  const a = { name: 'a', source: 'float a(float x) { return x; }', arity: 1 }
  const of =
    (options, use = (f, x) => f(x), target) =>
    () =>
      compile((glsl) => ({ r: use(glsl.fn(options), glsl.param('x'), glsl) }), { target })
  const differentiated = (f, x, glsl) => glsl.derivative(f(x), x)
  refuses(
    of(undefined),
    /fn: expected an object \{ name, source, arity, derivatives \}, got undefined/,
  )
  refuses(of({ nam: 'a' }), /fn: there is no option "nam"/)
  refuses(of({ ...a, name: 5 }), /expected a text for the option "name", got the number 5/)
  refuses(of({ ...a, name: 'sin' }), /"sin" cannot name a function: "sin" is a function of GLSL/)
  refuses(of({ ...a, name: 'b' }), /"b" is not in the source/)
  refuses(
    of({ ...a, arity: 0 }),
    /expected a whole number from 1 to 16 for the option "arity" of a/,
  )
  refuses(
    of({ ...a, source: { wgsl: '' } }),
    /expected GLSL source for the target glsl300, or an object \{ glsl: … \} with it, for the option "source" of a/,
  )
  refuses(
    of({ ...a, derivatives: [] }),
    /expected an array of 1, one for each argument, for the option "derivatives" of a/,
  )
  refuses(
    of(a, (f) => f(1, 2)),
    /a: expected 1 argument, got 2/,
  )
  refuses(
    of(a, (f, x, glsl) => f(glsl.mat2(1))),
    /a: expected a number or a vector as argument 1, got a mat2/,
  )
  refuses(of(a, differentiated), /a: its derivatives are needed here/)
  refuses(
    of({ ...a, derivatives: [() => undefined] }, differentiated),
    /a: expected a number or an expression for derivative 1, got undefined/,
  )
  refuses(
    of({ ...a, derivatives: [(x) => x.add(1).mult(0.5).sin().neg().add(x).gt(0)] }, (f, x, glsl) =>
      glsl.derivative(f(glsl.vec2(x, 1)), x).dot(glsl.vec3(1, 1, 1)),
    ),
    /dot: a vec2 and a vec3/,
  )
  refuses(
    of(a, (f, x, glsl) => glsl.fn({ ...a, source: 'float a(float x) { return -x; }' })(f(x))),
    /"a" is the name of another function already/,
  )
  refuses(
    () => compile((glsl) => ({ a: glsl.fn(a)(glsl.param('x')) })),
    /The result "a" has the name of a variable or function that is read for it/,
  )
  refuses(
    () => compile((glsl) => ({ r: glsl.fn(a)(glsl.param('x')) })).evaluate({ x: 1 }),
    /evaluate: only the GPU can call a function of glsl\.fn/,
  )
})

test('numbers for evaluate', () => {
  const { evaluate } = compile((glsl) => ({ r: glsl.vec2Param('v').x().add(glsl.param('x')) }))
  assert.deepEqual(evaluate({ v: [1, 2], x: 3 }), { r: 4 })
  refuses(
    () => evaluate(),
    /evaluate: expected an array of 2 finite numbers for "v", got undefined/,
  )
  refuses(
    () => evaluate({ v: [1], x: 1 }),
    /expected an array of 2 finite numbers for "v", got an array of 1/,
  )
  refuses(
    () => evaluate({ v: [1, 2], x: '1' }),
    /expected a finite number for "x", got the text "1"/,
  )
})

test('constants that only a derivative combines', () => {
  refuses(
    () =>
      compile((glsl) => {
        const x = glsl.param('x')
        return { d: glsl.derivative(x.mult(1e30).mult(1e30), x) }
      }),
    /derivative: the result of these constants is not a finite number/,
  )
})

test('an endless loop throws a sentence', { timeout: 60_000 }, () => {
  refuses(
    offset(({ millis }) => {
      for (let v = millis; ;) v = v.sin().add(1)
    }),
    /more than four million operations; does a loop never end/,
  )
})
