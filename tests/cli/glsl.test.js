// Tests the commands of `npx warpjet` that read GLSL files: emit, bake and derive.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, test } from 'node:test'
import { differentiate } from 'warpjet/glsl'
import { loadMesh } from 'warpjet/mesh'
import { folder, warpjet, works, write } from '../support/cli-tests.js'

describe('GLSL on the command line', () => {
  write(
    'waves.glsl',
    `uniform float height;
vec3 offset(vec3 position) { return vec3(0.0, height * sin(position.x), 0.0); }
vec3 up(vec3 p) { return p + vec3(0.0, 1.0, 0.0); }
float map(vec3 p) { return dot(p, p); }
`,
  )
  write(
    'uniforms.glsl',
    `#version 300 es
struct Wave { float length; };
uniform float height, heights[2];
uniform vec3 way;
uniform int many;
uniform uint bits;
uniform bool isOn;
uniform mat2 turn;
uniform Wave waves[1];
vec3 offset(vec3 position, float millis) {
  vec3 p = vec3(height * sin(position.x * waves[0].length), heights[1] * position.y, float(bits & 4u));
  return p + way + vec3(turn * position.xy, 0.0) + vec3(0, many / 2, isOn ? millis / 1000.0 : 0.0) + vec3(0, 0, 10);
}
`,
  )
  write(
    'spiral.glsl',
    `vec2 spiral(vec2 p, float t, int n, bool isOn) {
  vec2 q = p;
  for (int i = 0; i < n; i++) q += sin(q.yx * t);
  return isOn ? q : p * t;
}
`,
  )
  write(
    'waves.wgsl',
    `var<uniform> height: f32;
fn offset(position: vec3f) -> vec3f { return vec3f(0, height * sin(position.x), 0); }
fn wave(p: vec3f, t: f32) -> f32 { return dot(p, p) * t; }
`,
  )
  write('bad.frag', 'vec3 offset(vec3 p) {\n  return q;\n}\n')

  test('emit accepts GLSL instead of a warp.js', async () => {
    const { code, stdout } = await warpjet('emit', 'waves.glsl', '--target', 'wgsl')
    assert.equal(code, 0)
    assert.match(stdout, /uniforms: float height/)
    assert.match(stdout, /offset = vec3f\(0\.0f, height \* sin\(position\.x\), 0\.0f\);/)
  })

  test('a .wgsl file is read as WGSL, and its derivatives are in WGSL by default', async () => {
    const emitted = await warpjet('emit', 'waves.wgsl', '--target', 'glsl300')
    assert.equal(emitted.code, 0, emitted.stderr)
    assert.match(emitted.stdout, /offset = vec3\(0\.0, height \* sin\(position\.x\), 0\.0\);/)
    const source = readFileSync(join(folder, 'waves.wgsl'), 'utf8')
    const derived = await warpjet('derive', 'waves.wgsl', '--function', 'wave')
    assert.equal(derived.code, 0, derived.stderr)
    assert.equal(derived.stdout, differentiate(source, { language: 'wgsl', function: 'wave' }))
    assert.match(derived.stdout, /^fn waveGradient\(p: vec3f, t: f32\) -> vec4f \{/)
    const inGlsl = await warpjet(
      'derive',
      'waves.wgsl',
      '--function',
      'wave',
      '--target',
      'glsl100',
    )
    assert.match(inGlsl.stdout, /^vec4 waveGradient\(vec3 p, float t\) \{/)
  })

  test('bake accepts GLSL; --function selects any function of the file', async () => {
    const args = ['--function', 'up', '--returns', 'position', '-o', 'up.glb']
    const { code, stderr } = await warpjet('bake', 'model.glb', 'waves.glsl', ...args)
    assert.equal(code, 0, stderr)
    const [before, after] = await Promise.all(
      ['model.glb', 'up.glb'].map((file) => loadMesh(join(folder, file))),
    )
    assert.ok(Math.abs(after.positions[1] - before.positions[1] - 1) < 1e-6)
    assert.equal(after.positions[0], before.positions[0])
    const missing = await warpjet(
      'bake',
      'model.glb',
      'waves.glsl',
      '-o',
      'up.glb',
      '--function',
      'offset',
    )
    assert.equal(missing.code, 1)
    assert.match(missing.stderr, /reads height; add --set height=/)
  })

  test('bake reads uniforms of every type from --set', async () => {
    const settings = ['height=0.25', 'way=1,2,3', 'many=-3', 'bits=5', 'isOn=1', 'turn=0,1,-1,0']
    const others = ['heights[1]=0.5', 'waves[0].length=2', 'millis=2000']
    const all = [...settings, ...others]
    const toOptions = (assignments) => assignments.flatMap((assignment) => ['--set', assignment])
    const set = toOptions(all)
    const result = await works('bake', 'model.glb', 'uniforms.glsl', ...set, '-o', 'set.glb')
    assert.equal(result.code, 0, result.stderr)
    const [before, after] = await Promise.all(
      ['model.glb', 'set.glb'].map((file) => loadMesh(join(folder, file))),
    )
    for (let i = 0; i < before.positions.length; i += 3) {
      const [x, y, z] = before.positions.subarray(i, i + 3)
      // By a quarter turn, (x, y) maps to (-y, x).
      const expected = [
        x + 0.25 * Math.sin(x * 2) + 1 - y,
        y + 0.5 * y + 2 + x - 1,
        z + 3 + (5 & 4) + 2 + 10,
      ]
      expected.forEach((number, k) =>
        assert.ok(Math.abs(after.positions[i + k] - number) < 1e-5, `${number} at ${i}`),
      )
    }
    const missing = await warpjet('bake', 'model.glb', 'uniforms.glsl', '-o', 'set.glb')
    assert.match(missing.stderr, /uniforms\.glsl reads \w+; add --set \w+=<number>/)
    const rest = toOptions(all.filter((assignment) => !assignment.startsWith('many')))
    const withoutMany = await warpjet(
      'bake',
      'model.glb',
      'uniforms.glsl',
      ...rest,
      '-o',
      'set.glb',
    )
    assert.match(withoutMany.stderr, /uniforms\.glsl reads many; add --set many=/)
    const wrong = await warpjet(
      'bake',
      'model.glb',
      'uniforms.glsl',
      ...set,
      '--set',
      'way=1',
      '-o',
      'set.glb',
    )
    assert.match(
      wrong.stderr,
      /the uniform way: expected a vec3, as declared in the source, got a single number/,
    )
  })

  test('derive prints a function with its gradient', async () => {
    const { code, stdout } = await warpjet('derive', 'waves.glsl', '--function', 'map', '--by', 'p')
    assert.equal(code, 0)
    assert.match(stdout, /^vec4 mapGradient\(vec3 p\) \{/)
  })

  test('derive prints or writes the result of differentiate, with each of its options', async () => {
    const source = readFileSync(join(folder, 'spiral.glsl'), 'utf8')
    const expected = differentiate(source, {
      function: 'spiral',
      by: 't',
      target: 'wgsl',
      name: 'along',
      maxIterations: 5,
    })
    const args = ['--function', 'spiral', '--by', 't', '--target', 'wgsl', '--name', 'along']
    const { stdout } = await works('derive', 'spiral.glsl', ...args, '--max-iterations', '5')
    assert.equal(stdout, expected)
    assert.match(stdout, /^fn along\(p: vec2f, t: f32, n: i32, isOn: bool\) -> vec2f \{/)
    const output = await works(
      'derive',
      'spiral.glsl',
      '--max-iterations',
      '5',
      '-o',
      'jacobian.glsl',
    )
    assert.equal(output.stdout, '')
    assert.equal(
      readFileSync(join(folder, 'jacobian.glsl'), 'utf8'),
      differentiate(source, { maxIterations: 5 }),
    )
    const wrong = await warpjet('derive', 'spiral.glsl', '--by', 'q')
    assert.equal(wrong.code, 1)
    assert.match(
      wrong.stderr,
      /expected a parameter of spiral, one of p, t, n, isOn, for --by, got the text "q"/,
    )
  })

  test('errors in the GLSL are reported with their line', async () => {
    const { code, stderr } = await warpjet('emit', 'bad.frag')
    assert.equal(code, 1)
    assert.match(stderr, /line 2, column 10: "q" is not declared/)
    assert.equal((await warpjet('emit', 'none.glsl')).code, 1)
    assert.equal((await warpjet('derive', 'waves.glsl', '--target', 'msl')).code, 2)
  })
})
