// Messages of warps in three.js.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { WarpError } from 'warpjet'
import { warp, warpMaterial } from 'warpjet/three'
import { plane } from '../support/three-meshes.js'

test('uniforms have the form of those of three.js, and reject invalid values with a message', () => {
  const { uniforms, dispose } = warp(
    plane(),
    ({ uniforms }) =>
      uniforms.tint
        .mult(uniforms.place.x())
        .add(uniforms.turn.mult(uniforms.shift))
        .mult(uniforms.follow),
    {
      uniforms: {
        tint: new THREE.Color(1, 0, 0),
        place: new THREE.Vector2(1, 2),
        turn: new THREE.Matrix3(),
        shift: [1, 2, 3],
        follow: () => 2,
      },
    },
  )
  uniforms.shift.value = new THREE.Vector3(4, 5, 6)
  uniforms.shift.value.x = 7
  uniforms.follow.value = 3
  assert.throws(() => (uniforms.shift.value = 3), {
    name: 'WarpError',
    message: `warp: expected an array of 3 finite numbers for the uniform "shift", got the number 3.`,
  })
  assert.throws(() => (uniforms.follow.value = NaN), WarpError)
  assert.equal(uniforms.follow.value, 3)
  assert.throws(() => uniforms.heigth.value, {
    message: 'warp: the warp has no uniform "heigth"; it has tint, place, turn, shift, follow.',
  })
  dispose()
})

describe('warp throws a message, and changes nothing, for', () => {
  const none = ({ position }) => position
  const mesh = plane()
  const { material } = mesh
  const group = new THREE.Group().add(new THREE.Sprite())
  const bare = new THREE.BufferGeometry().setAttribute(
    'position',
    mesh.geometry.getAttribute('position'),
  )
  const cases = {
    'a sprite': [
      () => warp(new THREE.Sprite(), none),
      /^warp: this Sprite always faces the camera/,
    ],
    'a group of sprites': [() => warp(group, none), /^warp: this Sprite /],
    'a detail of 0': [
      () => warp(mesh, none, { detail: 0 }),
      /^warp: .*expected a number of pixels above 0, 'auto', false or \{ tolerance, curved \}.* got the number 0/,
    ],
    'a detail of a material': [
      () => warpMaterial(material, none, { detail: 1 }),
      /^warpMaterial: the option detail divides meshes/,
    ],
    nothing: [() => warp(undefined, none), /^warp: expected a Mesh, .* got undefined\.$/],
    'an empty group': [
      () => warp(new THREE.Group(), none),
      /^warp: there is nothing to draw in this Group/,
    ],
    'a value that is not an offset function': [
      () => warp(mesh, 5),
      /^warp: expected a function, got the number 5/,
    ],
    'an offset function that returns a number': [
      () => warp(mesh, () => 5),
      /^warp: the offset function must return a vec3/,
    ],
    'an unknown space': [
      () => warp(mesh, none, { space: 'view' }),
      /^warp: expected 'local', 'rest' or 'world' for the option "space", got the text "view"\.$/,
    ],
    'a geometry': [() => warp(mesh.geometry, none), /got a PlaneGeometry\.$/],
    'an offset along a missing normal': [
      () => warp(new THREE.Mesh(bare, material), ({ normal }) => normal),
      /^warp: the offset reads normal, but the geometry of this Mesh has no attribute "normal"; call geometry\.computeVertexNormals\(\) first\.$/,
    ],
    'an offset that reads missing texture coordinates': [
      () => warp(new THREE.Points(bare), ({ glsl, uv }) => glsl.vec3(uv, 0)),
      /^warp: the offset reads uv, but the geometry of this Points has no attribute "uv"/,
    ],
    'an offset that reads the number of an instance': [
      () => warp(mesh, ({ glsl, instance }) => glsl.vec3(instance, 0, 0)),
      /^warp: the offset reads instance, which three\.js does not have; place instances by their matrices/,
    ],
    'an unknown option': [
      () => warp(mesh, none, { colour: 1 }),
      /^warp: there is no option "colour"/,
    ],
    'an offset that reads the mouse': [
      () => warp(mesh, ({ glsl, mouse }) => glsl.vec3(mouse, 0)),
      /^warp: the offset reads mouse, which three\.js does not have/,
    ],
    'an offset with an undeclared parameter': [
      () => warp(mesh, ({ glsl }) => glsl.vec3(glsl.param('wind'), 0, 0)),
      /^warp: the offset reads "wind" by glsl\.param/,
    ],
    'a shader that does not read positions': [
      () =>
        warpMaterial(
          new THREE.ShaderMaterial({ vertexShader: 'void main() { gl_Position = vec4( 1.0 ); }' }),
          none,
        ),
      /^warpMaterial: the ShaderMaterial cannot be warped: its vertex shader neither reads the attribute position/,
    ],
    'a material of WebGPURenderer': [
      () =>
        warpMaterial(
          Object.assign(new THREE.Material(), { isNodeMaterial: true, type: 'MeshNode' }),
          none,
        ),
      /the MeshNode cannot be warped: only WebGPURenderer draws it; import 'warpjet\/three\/webgpu'\.$/,
    ],
    'a mesh instead of a material': [
      () => warpMaterial(mesh, none),
      /^warpMaterial: expected a material of three\.js, got a Mesh\.$/,
    ],
  }
  for (const [name, [work, message]] of Object.entries(cases))
    test(name, () => {
      assert.throws(work, (error) => {
        assert.equal(error.name, 'WarpError')
        assert.match(error.message, message)
        return true
      })
      assert.equal(mesh.material, material)
      assert.equal(Object.hasOwn(mesh, 'raycast'), false)
    })

  test('an unsupported object alone; in a group, it warns once and warps the others', async (t) => {
    const said = t.mock.method(console, 'warn', () => {})
    const { LineMaterial } = await import('three/addons/lines/LineMaterial.js')
    const { LineSegments2 } = await import('three/addons/lines/LineSegments2.js')
    const { LineSegmentsGeometry } = await import('three/addons/lines/LineSegmentsGeometry.js')
    const wide = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial())
    wide.name = 'route'
    const sprite = new THREE.Sprite()
    const part = plane()
    const parts = new THREE.Group().add(part, sprite, wide)
    const warped = warp(parts, ({ glsl }) => glsl.vec3(0, 0, 2))
    assert.deepEqual(warped.skipped, [sprite, wide])
    assert.ok(warped.bounds().max.z > 1.9)
    assert.equal(said.mock.callCount(), 1)
    const [message] = said.mock.calls[0].arguments
    assert.match(message, /^warp: drawn without the warp: this Sprite always faces the camera/)
    assert.match(
      message,
      /; the LineMaterial of the LineSegments2 "route" cannot be warped: .* use a Line/,
    )
    warped.dispose()
    assert.throws(
      () => warp(wide, none),
      /^WarpError: warp: the LineMaterial of the LineSegments2 "route"/,
    )
  })

  test('a mesh that is already warped', () => {
    const warped = warp(mesh, none)
    assert.throws(() => warp(mesh, none), /^WarpError: warp: this Mesh is warped already/)
    warped.dispose()
    warp(mesh, none).dispose()
  })
})

describe('a second warp of the same object throws', () => {
  const none = ({ position }) => position
  const cases = {
    'on a clone of a warped mesh, which is warped, too'(mesh) {
      warp(mesh, none)
      return [
        [() => warp(mesh.clone(), none), /this Mesh is warped already, or a clone of a warped/],
        [() => warp(new THREE.Group().add(mesh.clone()), none), /is warped already/],
      ]
    },
    'after warpMaterial'(mesh) {
      const { material } = warpMaterial(mesh.material, none)
      mesh.material = material
      const message =
        /the MeshBasicMaterial( of this Mesh)? cannot be warped: a call of warpMaterial/
      return [
        [() => warp(mesh, none), message],
        [() => warpMaterial(material, none), message],
      ]
    },
    'after warpMaterial with the option share'(mesh) {
      warpMaterial(mesh.material, none, { share: true })
      return [[() => warp(mesh, none), /a call of warpMaterial/]]
    },
  }
  for (const [name, make] of Object.entries(cases))
    test(name, () => {
      for (const [again, message] of make(plane()))
        assert.throws(again, (error) => {
          assert.equal(error.name, 'WarpError')
          assert.match(error.message, message)
          return true
        })
    })

  test('unless the first one was disposed of', () => {
    const mesh = plane()
    warp(mesh, none, { share: true }).dispose()
    warp(mesh, none, { share: true }).dispose()
    const warped = warp(mesh, none)
    const clone = mesh.clone()
    warped.dispose()
    warp(clone, none)
  })

  test('unless the objects only share their material', () => {
    const mesh = plane()
    warp(mesh, none)
    warp(new THREE.Mesh(mesh.geometry, mesh.material), none)
  })
})

test("messages explain the difference from three.js's own notation of uniforms", () => {
  const offset = ({ glsl, uniforms }) => glsl.vec3(uniforms.a, 0, 0)
  const expectError = (work, message) => assert.throws(work, { name: 'WarpError', message })
  expectError(
    () => warp(plane(), offset, { uniforms: { a: { value: 1 } } }),
    /; pass its value itself\.$/,
  )
  const warped = warp(plane(), offset, { uniforms: { a: 1 } })
  expectError(() => (warped.uniforms.a = 2), /set its value, as in uniforms\.a\.value = 0\.5/)
  warped.dispose()
})
