// Tests the names of inputs in GLSL source: parameters of an offset function, and uniforms with the name of an input.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp, targets } from 'warpjet'
import { glslOffset } from 'warpjet/glsl'

// These values are passed for the inputs. `parts` has components of the vectors in `frame`.
const vertex = { normal: [0, 0.6, 0.8], uv: [0.25, 0.75], color: [0.1, 0.2, 0.3, 0.4] }
const frame = { millis: 1200, mouse: [30, 40], size: [640, 480], pixelDensity: 2, instance: 3 }
const parts = { mouseX: 30, mouseY: 40, width: 640, height: 480 }
const position = [1, 2, 3]

const numbersOf = (value) => [value].flat()
const typeOf = (value) => ['float', 'vec2', 'vec3', 'vec4'][numbersOf(value).length - 1]

/** Returns the body of an offset function whose result differs if any component of the input does. */
const bodyOf = (name, value) => {
  const size = numbersOf(value).length
  const factors = [0.5, 0.25, 0.125, 0.0625].slice(0, size)
  const sum =
    size === 1 ? `${name} * ${factors[0]}` : `dot(${name}, vec${size}(${factors.join(', ')}))`
  return `return vec3(${sum}, 0.0, ${size === 1 ? name : `${name}.x`});`
}
const expectedOf = (value) => {
  const numbers = numbersOf(value)
  const sum = numbers.reduce((total, number, i) => total + number / 2 ** (i + 1), 0)
  return [sum, 0, numbers[0]]
}

function assertMovedBy(source, expected) {
  const warp = compileWarp(glslOffset(source), { surfaceVariation: false })
  const moved = warp.evaluateAt(position, { ...vertex, uniforms: frame }).position
  expected.forEach((number, i) => {
    const difference = Math.abs(moved[i] - position[i] - number)
    assert.ok(
      difference <= 1e-5 * Math.max(1, Math.abs(number)),
      `${moved}, not ${position} moved by ${expected}`,
    )
  })
}

for (const [name, value] of Object.entries({ position, ...vertex, ...frame, ...parts }))
  test(`the parameter ${typeOf(value)} ${name} is the input ${name}`, () => {
    const source = `vec3 offset(${typeOf(value)} ${name}) { ${bodyOf(name, value)} }`
    assertMovedBy(source, expectedOf(value))
    for (const target of targets) assert.ok(compileWarp(glslOffset(source), { target }).code)
    const other = typeOf(value) === 'vec2' ? 'float' : 'vec2'
    assert.throws(
      () => glslOffset(`vec3 offset(${other} ${name}) { return vec3(1.0); }`),
      new RegExp(
        `${name} of offset: expected a ${typeOf(value)}, the type of the input ${name}, got a ${other}\\.`,
      ),
    )
  })

test('an offset may have several of these parameters, in any order', () => {
  assertMovedBy(
    `vec3 offset(float millis, vec4 color, vec2 uv, vec3 normal, vec2 mouse, vec2 size, float pixelDensity,
      vec3 position, float width, float instance) {
      return vec3(millis + color.a + uv.y, normal.z + mouse.y + size.x, pixelDensity + position.z + width + instance);
    }`,
    [1200 + 0.4 + 0.75, 0.8 + 40 + 640, 2 + 3 + 640 + 3],
  )
})

for (const [name, value] of Object.entries(frame))
  test(`the uniform ${typeOf(value)} ${name} is the input of that name, without being declared in the options`, () => {
    const source = `uniform ${typeOf(value)} ${name};\nvec3 offset(vec3 p) { ${bodyOf(name, value)} }`
    assertMovedBy(source, expectedOf(value))
    assert.throws(
      () => compileWarp(glslOffset(source), { uniforms: { [name]: value } }),
      new RegExp(`the uniform "${name}" has the name of an input`),
    )
  })

test('gl_InstanceID is the current instance', () => {
  assertMovedBy(
    '#version 300 es\nvec3 offset(vec3 p) { return vec3(gl_InstanceID * 2, gl_InstanceID % 2, 0); }',
    [6, 1, 0],
  )
})

test('a single vec3 is the position, whatever its name; with two, each needs a known name', () => {
  for (const name of ['p', 'position', 'x', 'vertex'])
    assertMovedBy(`vec3 offset(vec3 ${name}) { return ${name} * 2.0; }`, [2, 4, 6])
  assert.throws(
    () => glslOffset('vec3 offset(vec3 p, vec3 normal) { return p; }'),
    /the parameter p of offset has no value; call it position\.$/,
  )
  assert.throws(
    () => glslOffset('vec3 offset(vec3 position, vec4 tangent) { return position; }'),
    /the parameter tangent of offset has no value; rename it to one of position, normal, uv, color, millis, mouse, size, pixelDensity, instance, mouseX, mouseY, width, height, or make it a uniform of the source\.$/,
  )
})
