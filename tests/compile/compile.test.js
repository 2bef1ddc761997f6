// Tests the core API: what it returns, and how much memory is in use after a call.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { Script } from 'node:vm'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { memoryInUse } from '../../dist/memory.js'
import { WarpError, compile, compileWarp, gen, version } from '../../dist/warpjet.js'

const namesOf = (declared) => declared.map(({ name }) => name)

const wave = ({ glsl, position, millis }) =>
  glsl.vec3(0, position.x().mult(4).add(millis.div(1000)).sin().mult(0.15), 0)

test('compileWarp returns statements, the inputs that they read, and statistics', () => {
  const warp = compileWarp(wave)
  assert.match(warp.code, /^vec3 offset, warpedPosition, warpedNormal;\n\{\n/)
  assert.match(warp.code, /offset = vec3\(0\.0, sin\(t0\) \* 0\.15, 0\.0\);/)
  assert.match(warp.code, /warpedPosition = position \+ offset;/)
  assert.equal(warp.declarations, '')
  assert.deepEqual(warp.uniforms, [{ name: 'millis', type: 'float' }])
  assert.deepEqual(warp.attributes, [
    { name: 'position', type: 'vec3' },
    { name: 'normal', type: 'vec3' },
  ])
  assert.deepEqual(Object.keys(warp.stats), ['nodes', 'operations', 'temporaries', 'vectors'])
  assert.ok(warp.stats.nodes > warp.stats.operations)
})

test('the caller can choose names of inputs and outputs', () => {
  const { code, uniforms, attributes } = compileWarp(wave, {
    names: { position: 'aPosition', normal: 'inputs.normal', millis: 'uTime' },
    outputs: { position: 'p', normal: 'n', offset: 'f' },
  })
  assert.match(code, /^vec3 f, p, n;/)
  assert.match(code, /aPosition\.x \* 4\.0 \+ uTime \/ 1000\.0/)
  assert.match(code, /p = aPosition \+ f;/)
  assert.match(code, /inputs\.normal\.y/)
  assert.deepEqual(namesOf(uniforms), ['millis'])
  assert.deepEqual(namesOf(attributes), ['position', 'normal'])
})

test('normals can be left out', () => {
  const { code, attributes } = compileWarp(wave, { normals: false })
  assert.doesNotMatch(code, /warpedNormal|cos/)
  assert.deepEqual(namesOf(attributes), ['position'])
})

test('parameters are listed with the uniforms', () => {
  const { uniforms } = compileWarp(({ glsl, mouseX }) =>
    glsl.vec3Param('uCenter').mult(glsl.param('uAmount')).mult(mouseX),
  )
  assert.deepEqual(uniforms, [
    { name: 'mouse', type: 'vec2' },
    { name: 'uCenter', type: 'vec3' },
    { name: 'uAmount', type: 'float' },
  ])
})

test('the code does not read unused inputs', () => {
  const { uniforms, attributes } = compileWarp(({ glsl }) => glsl.vec3(0, 1, 0), {
    normals: false,
  })
  assert.deepEqual([uniforms, namesOf(attributes)], [[], ['position']])
})

test('a temporary never takes a name that the shader uses', () => {
  const names = { position: 't0', normal: 't1', millis: 't3' }
  const { code } = compileWarp(wave, { names, outputs: { offset: 't2' } })
  for (const name of ['t0', 't1', 't2', 't3'])
    assert.doesNotMatch(code, new RegExp(`float ${name} =`))
})

test('compile returns any named expressions and their derivatives', () => {
  const { code, uniforms } = compile((glsl) => {
    const x = glsl.param('x')
    const y = x.mult(x).mult(3)
    return { y, slope: glsl.derivative(y, x), below: y.lt(1), both: glsl.vec2(x, y) }
  })
  assert.equal(
    code,
    'float y, slope;\nbool below;\nvec2 both;\n{\n' +
      '  y = x * x * 3.0;\n' +
      '  slope = x * 6.0;\n' +
      '  below = y < 1.0;\n' +
      '  both = vec2(x, y);\n}\n',
  )
  assert.deepEqual(uniforms, [{ name: 'x', type: 'float' }])
})

test('gen has the outputs and derivatives of glsl-autodiff', () => {
  const code = gen((ad) => {
    const x = ad.param('x')
    const y = ad.param('y')
    const z = ad.sin(ad.sum(x.mult(2), y))
    z.output('z')
    z.outputDeriv('dzdx', x)
    z.outputDeriv('dzdy', y)
  })
  assert.equal(
    code,
    'float z, dzdx, dzdy;\n{\n' +
      '  float t0 = x * 2.0 + y;\n' +
      '  dzdy = cos(t0);\n' +
      '  z = sin(t0);\n' +
      '  dzdx = dzdy * 2.0;\n}\n',
  )
})

test('gen transforms normals', () => {
  const code = gen((ad) => {
    const position = ad.vec3Param('position')
    const offset = ad.vec3(0, 0, position.x().sin())
    offset.adjustNormal(ad.vec3Param('normal'), position).output('warped')
  })
  assert.match(code, /^vec3 warped;/)
  assert.match(code, /cos\(position\.x\)/)
})

test('gen limits the depth of expressions', () => {
  const chain = (ad) => {
    let v = ad.param('x')
    for (let i = 0; i < 8; i++) v = v.sin()
    v.output('y')
  }
  const countTemporaries = (settings) => gen(chain, settings).match(/float t\d+ =/g)?.length ?? 0
  assert.equal(countTemporaries({ maxDepthPerVariable: 1 }), 7)
  assert.equal(countTemporaries({ maxDepthPerVariable: 4 }), 1)
  assert.equal(countTemporaries({ maxDepthPerVariable: Infinity }), 0)
})

test('debug names the line of the user’s code', () => {
  const code = gen(
    (ad) => {
      ad.param('x').sin().mult(2).output('y')
    },
    { debug: true },
  )
  assert.match(code, /\/\/ From .*compile\.test\.js:\d+:\d+/)
})

test('debug finds the file if the name of a function ends in “at”', (t) => {
  const warn = t.mock.method(console, 'warn', () => {})
  const format = new Script(
    `(function format({ glsl, position }) {
       if (position.x().lessThan(0)) glsl.vec3(1)
       return glsl.vec3(0)
     })`,
    { filename: 'sketch-of-format.js' },
  ).runInThisContext()
  compileWarp(format)
  const [{ arguments: [message] } = { arguments: [] }] = warn.mock.calls
  assert.match(message, / \(sketch-of-format\.js, line 2\):/)
})

test('a warp without features of GLSL ES 3.00 has the same code in GLSL ES 1.00', () => {
  assert.equal(compileWarp(wave, { target: 'glsl100' }).code, compileWarp(wave).code)
})

test('inputs have the sizes that p5.warp documents', () => {
  const sizeOf = (x) => [...'xyzw'].filter((letter) => has(x, letter)).length || 1
  const has = (x, letter) => {
    try {
      return Boolean(x[letter]())
    } catch (error) {
      assert.match(error.message, /has no such components/)
      return false
    }
  }
  compileWarp(({ glsl, position, normal, uv, color, mouse, size, width, height, mouseX }) => {
    assert.deepEqual(
      [position, normal, uv, color, mouse, size, width, height, mouseX].map(sizeOf),
      [3, 3, 2, 4, 2, 2, 1, 1, 1],
    )
    return glsl.vec3(0, 0, 0)
  })
})

test('components can be selected in any order, by any of their letters', () => {
  const { code } = compile((glsl) => {
    const [v, uv] = [glsl.vec4Param('v'), glsl.vec2Param('uv')]
    return { a: v.zyx(), b: v.aa(), c: uv.ts(), d: v.q(), e: uv.xyyx() }
  })
  assert.match(code, /a = v\.zyx;/)
  assert.match(code, /b = vec2\(v\.w\)/)
  assert.match(code, /c = uv\.yx;/)
  assert.match(code, /d = v\.w/)
  assert.match(code, /e = uv\.xyyx;/)
})

test('a scalar applies to all components of a vector, as either operand', () => {
  const { code } = compile((glsl) => {
    const v = glsl.vec3Param('v')
    return { a: v.add(1), b: glsl.val(2).mult(v), c: v.mix(glsl.vec3(0, 0, 0), 0.5).neg() }
  })
  assert.match(code, /a = v \+ 1\.0;/)
  assert.match(code, /b = v \* 2\.0;/)
})

test('functions of the builder can be destructured', () => {
  const { code } = compileWarp(({ glsl: { vec3, sin }, millis }) => vec3(sin(millis), 0, 0))
  assert.match(code, /sin\(millis\)/)
})

test('a parameter named like a component reads that component', () => {
  const { code } = compileWarp(({ glsl }) => glsl.vec3(0, glsl.param('position.x').sin(), 0))
  assert.match(code, /cos\(position\.x\)/)
})

test('normalize of zero is zero', () => {
  const { code } = compile((glsl) => ({ n: glsl.vec3(0, 0, 0).normalize() }))
  assert.match(code, /n = vec3\(0\.0\)/)
})

test('a condition in an offset counts as 0 or 1', () => {
  const { code } = compileWarp(({ position }) => position.gt(0))
  assert.match(code, /^vec3 offset/)
  assert.match(code, /offset = vec3\(float\(position\.x > 0\.0\)/)
})

test('the code has no adjacent signs, and preserves the sign of a zero', () => {
  const { code } = compile((glsl) => {
    const x = glsl.param('x')
    return { a: glsl.val(-2).div(x).neg(), b: glsl.val(-0).add(glsl.val(0).atan(x)) }
  })
  assert.match(code, /a = - -2\.0 \/ x;/)
  assert.match(code, /atan\(0\.0, x\)/)
})

test('a result whose name is undefined has its default name', () => {
  const { code } = compileWarp(wave, { outputs: { offset: undefined, position: 'moved' } })
  assert.match(code, /^vec3 offset, moved, warpedNormal;/)
})

test('literals in the code are exact', () => {
  for (const [number, text] of [
    [1e21, '1e21'],
    [1e-5, '1e-5'],
    [-0.00049, '-0.00049'],
    [1e-30, '1e-30'],
    [98765.4321, '98765.43'],
  ]) {
    const { code } = compile((glsl) => ({ y: glsl.param('x').mult(number) }))
    assert.ok(code.includes(`x * ${text};`), code)
    assert.equal(Math.fround(Number(text)), Math.fround(number))
  }
})

const warpCount = isRun('thousands of warps') ? 10_000 : 1_000

test(`${warpCount} warps leave no memory behind, also if the callback throws`, () => {
  const failing = () => {
    throw new Error('from the sketch')
  }
  const round = () => {
    compileWarp(wave)
    assert.throws(() => compileWarp(failing), /from the sketch/)
    assert.throws(() => compileWarp(() => undefined), WarpError)
  }
  for (let i = 0; i < 100; i++) round()
  const before = memoryInUse()
  for (let i = 0; i < warpCount; i++) round()
  assert.equal(memoryInUse(), before)
})

test('repeated squaring has few nodes, and a chain of 100,000 operations compiles', () => {
  const compileWithSlope = (build) =>
    compile((glsl) => {
      const x = glsl.param('x')
      const y = build(x)
      return { y, slope: glsl.derivative(y, x) }
    })
  const squared = compileWithSlope((x) => {
    let v = x
    for (let i = 0; i < 40; i++) v = v.mult(v).add(v)
    return v
  })
  assert.ok(squared.stats.nodes < 300)
  const chain = compileWithSlope((x) => {
    let v = x
    for (let i = 0; i < 100_000; i++) v = v.sin()
    return v
  })
  assert.equal(chain.stats.nodes, 300_000)
})

test('version equals the version of the package', () => {
  const { version: packaged } = JSON.parse(
    readFileSync(new URL('../../package.json', import.meta.url)),
  )
  assert.equal(version, packaged)
})
