// Tests glsl.texture in Node: the names in the generated code, shared calls, and errors.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { Mesh, MeshBasicMaterial, PlaneGeometry, Texture } from 'three'
import { glslOffset } from '../../dist/glsl.js'
import { warp } from '../../dist/three.js'
import { compile, compileWarp, targets } from '../../dist/warpjet.js'
import { throwWarpErrors, throwsWarpError } from '../support/warp-errors.js'

const displace = ({ glsl, position }) =>
  glsl.vec3(0, 0, glsl.texture('heightMap', position.xy().add(0.5)).r())

const count = (text, word) => text.split(word).length - 1

test('the image is listed as a uniform, and so is its size if the language cannot query it', () => {
  for (const target of targets) {
    const { uniforms, attributes } = compileWarp(displace, { target })
    const image = { name: 'heightMap', type: 'sampler2D' }
    const size = { name: 'heightMapSize', type: 'vec2' }
    assert.deepEqual(uniforms, target === 'glsl100' ? [image, size] : [image], target)
    assert.deepEqual(attributes, [
      { name: 'position', type: 'vec3' },
      { name: 'normal', type: 'vec3' },
    ])
  }
})

test('an image whose color cancels out is not read', () => {
  const { uniforms, declarations, evaluate } = compile((glsl) => ({
    r: glsl.texture('map', glsl.vec2(0.1, 0.2)).r().mult(0).add(glsl.param('x')),
  }))
  assert.deepEqual(uniforms, [{ name: 'x', type: 'float' }])
  assert.equal(declarations, '')
  assert.deepEqual(evaluate({ x: 7 }), { r: 7 })
})

test('all images share one function, and equal calls are one call', () => {
  const { code, declarations } = compile((glsl) => {
    const uv = glsl.vec2Param('uv')
    const color = glsl.texture('first', uv).add(glsl.texture('second', uv))
    return {
      color,
      again: glsl.texture('first', uv, { filter: 'bilinear', wrap: 'clamp' }).g(),
    }
  })
  assert.equal(count(declarations, 'vec4 warpjetBilinearClamp('), 1)
  assert.equal(count(declarations, 'vec4 warpjetTexel('), 1)
  assert.equal(count(code, 'warpjetBilinearClamp('), 2)
})

test('value and gradient are one call, and a value alone computes no gradient', () => {
  const textOf = (...results) =>
    compile((glsl) => {
      const uv = glsl.vec2Param('uv')
      const red = glsl.texture('map', uv, { filter: 'bspline', wrap: 'repeat' }).r()
      const all = { red, slope: glsl.gradient(red, uv) }
      return Object.fromEntries(results.map((name) => [name, all[name]]))
    })
  const valueAndSlope = textOf('red', 'slope')
  assert.equal(count(valueAndSlope.code, 'warpjetBsplineRepeatGradient('), 1)
  assert.equal(count(valueAndSlope.declarations, 'warpjetTexel('), 17)
  assert.doesNotMatch(textOf('red').declarations, /Gradient/)
})

test('rejects invalid arguments', () => {
  const compileTexture =
    (...args) =>
    () =>
      compile((glsl) => ({
        r: glsl.texture(...args.map((arg) => (typeof arg === 'function' ? arg(glsl) : arg))),
      }))
  const uv = (glsl) => glsl.vec2Param('uv')
  throwWarpErrors([
    [
      compileTexture(),
      /texture: expected the name of a sampler2D, such as "heightMap", for argument 1, got undefined/,
    ],
    [compileTexture(5, uv), /texture: expected the name of .* for argument 1, got the number 5/],
    [
      compileTexture('a b', uv),
      /texture: expected the name of .* for argument 1, got the text "a b"/,
    ],
    [compileTexture('maps[0]', uv), /texture: expected the name of .* for argument 1/],
    [compileTexture('sampler2D', uv), /texture: "sampler2D" cannot be read in a shader/],
    [
      compileTexture('map'),
      /texture: expected a number or an expression for argument 2, got undefined/,
    ],
    [compileTexture('map', [0, 1]), /texture: expected .* for argument 2, got an array of 2/],
    [compileTexture('map', 0.5), /texture: expected a vec2 for argument 2, got a single number/],
    [
      compileTexture('map', (glsl) => glsl.vec3Param('p')),
      /texture: expected a vec2 for argument 2, got a vec3/,
    ],
    [compileTexture('map', uv, { filtre: 'x' }), /texture: there is no option "filtre"/],
    [
      compileTexture('map', uv, 'bicubic'),
      /texture: expected an object of options, got the text "bicubic"/,
    ],
    [
      compileTexture('map', uv, { filter: 'linear' }),
      /texture: expected one of bilinear, bicubic, bspline, nearest for the option "filter", got the text "linear"/,
    ],
    [
      compileTexture('map', uv, { wrap: 3 }),
      /texture: expected one of clamp, repeat, mirror, sampler for the option "wrap", got the number 3/,
    ],
    [
      compileTexture('map', uv, {}, 1),
      /texture: it takes a name, a vec2 and options; the number 1/,
    ],
  ])
})

test('a name cannot be an image and a number', () => {
  const readAs = (first, second) => () =>
    compile((glsl) => {
      const reads = {
        image: () => glsl.texture('map', glsl.vec2(0, 0)).r(),
        number: () => glsl.param('map'),
      }
      return { r: reads[first]().add(reads[second]()) }
    })
  throwWarpErrors([
    [readAs('image', 'number'), /"map" was read as an image before, and now as a single number/],
    [readAs('number', 'image'), /"map" was read as a single number before, and now as an image/],
    [
      () => compile((glsl) => ({ map: glsl.texture('map', glsl.vec2(0, 0)).r() })),
      /The result "map" has the name of a variable/,
    ],
  ])
})

test('the CPU cannot read images yet', () => {
  throwsWarpError(
    () => compile((glsl) => ({ r: glsl.texture('map', glsl.vec2(0, 0)).r() })).evaluate({ map: 1 }),
    /evaluate: only the GPU can .* read an image by glsl\.texture/,
  )
  const warp = compileWarp(displace)
  throwsWarpError(() => warp.evaluate({ positions: [0, 0, 0] }), /reads an image by glsl\.texture/)
  throwsWarpError(
    () => warp.bounds({ min: [0, 0, 0], max: [1, 1, 1] }),
    /bounds: .*reads an image by glsl\.texture/,
  )
})

test('texture() in GLSL uses the wrapping of the shader’s own sampler, except in WGSL, which has none there', () => {
  const source =
    'uniform sampler2D map; vec3 offset(vec3 position, vec2 uv) { return texture(map, uv).rgb; }'
  const offset = glslOffset(`#version 300 es\n${source}`)
  const declarationsFor = (target) => compileWarp(offset, { target }).declarations
  assert.match(declarationsFor('glsl300'), /textureLod\(image, vec2\(\(x \+ 0\.5\) \/ width, /)
  assert.match(declarationsFor('glsl100'), /texture2D\(image, vec2\(\(x \+ 0\.5\) \/ width, /)
  assert.match(declarationsFor('wgsl'), /textureLoad\(image, vec2i\(clamp\(/)
})

const fetched = `uniform sampler2D map;
vec3 offset(vec3 position, vec2 uv) { return texelFetch(map, ivec2(uv * 8.0), 0).rgb; }`
const sized = `uniform sampler2D map;
vec3 offset(vec3 position) { return position / vec3(textureSize(map, 0), 1); }`

test('source that reads the size of an image lists the image, whose size only the GPU knows', () => {
  for (const target of targets) {
    const { uniforms } = compileWarp(glslOffset(sized), { target })
    const isNamed = target === 'glsl100'
    const expected = isNamed
      ? { name: 'mapSize', type: 'vec2' }
      : { name: 'map', type: 'sampler2D' }
    assert.deepEqual(uniforms, [expected], target)
  }
  for (const text of [fetched, sized])
    throwsWarpError(
      () => compileWarp(glslOffset(text)).evaluate({ positions: [0, 0, 0], uvs: [0, 0] }),
      /evaluate: .*reads an image/,
    )
})

test('three.js warps by source that reads texels or the size of an image', () => {
  for (const text of [fetched, sized]) {
    const mesh = new Mesh(new PlaneGeometry(), new MeshBasicMaterial())
    assert.equal(
      warp(mesh, glslOffset(text), { uniforms: { map: new Texture() } }).normals,
      'vertex',
    )
  }
})
