// The offset function is called once; shader code for any language and any host can be emitted from the recording.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile, compileWarp, targets } from 'warpjet'
import { memoryInUse } from '../../dist/memory.js'
import { throwsWarpError } from '../support/warp-errors.js'

const bumpy = ({ glsl, position, normal, uv, millis }) =>
  normal.mult(glsl.noise(position.mult(3)).add(millis.sin()).mult(0.1)).add(glsl.vec3(uv, 0))

describe('emit', () => {
  for (const options of [{}, { tangents: true }, { surfaceVariation: true }, { normals: false }])
    test(`equals the result of compileWarp: ${JSON.stringify(options)}`, () => {
      const warp = compileWarp(bumpy, { surfaceVariation: false, ...options })
      for (const target of targets) {
        const compiled = compileWarp(bumpy, { surfaceVariation: false, ...options, target })
        for (const key of ['code', 'declarations', 'uniforms', 'attributes', 'stats'])
          assert.deepEqual(warp.emit(target)[key], compiled[key], `${key} ${target}`)
      }
    })

  test('does not call the offset function again, so that its random number is the same in every language', () => {
    let calls = 0
    const warp = compileWarp(({ glsl, position }) => {
      calls++
      return glsl.vec3(position.x().mult(Math.random()).sin(), 0, 0)
    })
    const factorIn = (code) => code.match(/\* (\d+\.\d+)/)[1]
    for (const target of targets)
      assert.equal(factorIn(warp.emit(target).code), factorIn(warp.code), target)
    const [moved] = warp.evaluateAt([2, 0, 0]).position
    assert.ok(Math.abs(moved - 2 - Math.sin(2 * Number(factorIn(warp.code)))) < 1e-6)
    assert.equal(calls, 1)
  })

  test('accepts new names of inputs and results', () => {
    const warp = compileWarp(bumpy, {
      names: { position: 'aPosition' },
      outputs: { position: 'moved' },
      surfaceVariation: false,
    })
    const { code, attributes } = warp.emit('wgsl', {
      names: { position: 'in.place', millis: 'u.time' },
      outputs: { normal: 'bent' },
    })
    assert.match(code, /var moved: vec3f;\nvar bent: vec3f;/)
    assert.match(code, /moved = in\.place \+ offset;/)
    assert.match(code, /u\.time/)
    assert.doesNotMatch(code, /aPosition|millis/)
    assert.deepEqual(attributes[0], { name: 'position', type: 'vec3' })
  })

  test('throws for wrong arguments', () => {
    const warp = compileWarp(({ glsl, position }) => position.mult(glsl.param('aPlace')))
    throwsWarpError(
      () => warp.emit('hlsl'),
      /emit: expected 'glsl300', 'glsl100' or 'wgsl' for the target, got the text "hlsl"/,
    )
    throwsWarpError(() => warp.emit('wgsl', { name: {} }), /emit: there is no option "name"/)
    throwsWarpError(
      () => warp.emit('wgsl', { names: { place: 'p' } }),
      /emit: there is no option "place" in the option "names"/,
    )
    throwsWarpError(
      () => warp.emit('wgsl', { outputs: { offset: 3 } }),
      /expected the name of a shader variable for the option "outputs\.offset", got the number 3/,
    )
    throwsWarpError(
      () => warp.emit('wgsl', { names: { position: 'fn' } }),
      /"fn" is a reserved word of WGSL/,
    )
    throwsWarpError(
      () => warp.emit('glsl300', { names: { position: 'aPlace' } }),
      /names\.position: "aPlace" is already the name of another input/,
    )
    const call = compileWarp(({ glsl, position }) =>
      glsl.fn({ name: 'f', source: 'float f(float x) { return x; }', arity: 1, derivatives: [1] })(
        position,
      ),
    )
    throwsWarpError(
      () => call.emit('wgsl'),
      /"source" of f must be a source in WGSL for the target wgsl/,
    )
    assert.match(call.emit('glsl100').declarations, /float f\(float x\)/)
  })

  test('two inputs with one name are one input, and cannot be separated later', () => {
    const warp = compileWarp(({ normal }) => normal.mult(0.1), {
      names: { position: 'p', normal: 'p' },
    })
    assert.match(warp.emit('glsl100').code, /warpedPosition = p \+ offset/)
    assert.match(
      warp.emit('wgsl', { names: { position: 'q', normal: 'q' } }).code,
      /warpedPosition = q \+ offset/,
    )
    throwsWarpError(
      () => warp.emit('wgsl', { names: { position: 'q' } }),
      /emit: position and normal were one input, "p", when the offset was compiled/,
    )
  })

  test('leaves no memory behind', () => {
    const warp = compileWarp(bumpy, { surfaceVariation: false })
    warp.emit('wgsl')
    const before = memoryInUse()
    for (let i = 0; i < 200; i++) warp.emit(targets[i % 3])
    assert.equal(memoryInUse(), before)
  })
})

test('the sources of a function in both languages are recorded', () => {
  const f = {
    name: 'f',
    source: { glsl: 'float f(float x) { return x; }', wgsl: 'fn f(x: f32) -> f32 { return x; }' },
    arity: 1,
    derivatives: [1],
  }
  const warp = compileWarp(({ glsl, position }) => glsl.fn(f)(position))
  assert.match(warp.declarations, /^float f/)
  assert.match(warp.emit('wgsl').declarations, /^fn f/)
})

describe('labels in different spellings are one variable', () => {
  /** Returns the code of the derivative of a product: 2 p.x if both factors are the same variable. */
  const derivativeCode = (make, by) => {
    const { code } = compile((glsl) => {
      const [first, second] = make(glsl)
      return { d: glsl.derivative(first.mult(second), by?.(glsl) ?? first) }
    })
    return code.match(/d = (.*);/)[1]
  }

  test('with spaces after a vector', () => {
    assert.equal(
      derivativeCode((glsl) => [glsl.vec3Param('p').x(), glsl.param('p .x')]),
      'p.x * 2.0',
    )
  })
  test('with spaces around a number', () => {
    assert.equal(
      derivativeCode((glsl) => [glsl.param(' p'), glsl.param('p')]),
      'p * 2.0',
    )
  })
  test('with parentheses', () => {
    assert.equal(
      derivativeCode((glsl) => [glsl.vec3Param('p').x(), glsl.param('(p).x')]),
      'p.x * 2.0',
    )
    assert.equal(
      derivativeCode((glsl) => [glsl.param('p.x'), glsl.param('(p).x')]),
      'p.x * 2.0',
    )
  })
  test('for parts of a matrix', () => {
    for (const part of ['m[0].x', 'm[0][0]', '( m ) [0].r'])
      assert.equal(
        derivativeCode((glsl) => [glsl.mat3Param('m').column(0).x(), glsl.param(part)]),
        'm[0].x * 2.0',
      )
    assert.equal(
      derivativeCode((glsl) => [glsl.mat3Param('m').column(1).y(), glsl.vec3Param('m[1]').y()]),
      'm[1].y * 2.0',
    )
  })
  test('unless they are ambiguous, which throws', () => {
    const compileBoth = (first, second) => () =>
      compile((glsl) => ({ a: first(glsl), b: second(glsl) }))
    throwsWarpError(
      compileBoth(
        (glsl) => glsl.vec2Param('p.xy'),
        (glsl) => glsl.vec2Param('p.yz'),
      ),
      /vec2Param: "p\.xy" was read before "p\.yz", which may have the same components; read the whole vector first/,
    )
    throwsWarpError(
      compileBoth(
        (glsl) => glsl.param('m[0].x'),
        (glsl) => glsl.mat3Param('m'),
      ),
      /"m\[0\]\.x" was read before "m", of which it is a part; read the matrix first/,
    )
  })
})
