// Messages of warps in three.js.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { WarpError } from 'warpjet'
import { warp, warpMaterial } from 'warpjet/three'
import { plane } from '../support/three-meshes.js'

test('uniforms have a value, as in three.js, and reject invalid values with a message', () => {
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
  const still = ({ position }) => position
  const mesh = plane()
  const { material } = mesh
  const group = new THREE.Group().add(new THREE.Sprite())
  const bare = new THREE.BufferGeometry().setAttribute(
    'position',
    mesh.geometry.getAttribute('position'),
  )
  const cases = {
    'a sprite': [
      () => warp(new THREE.Sprite(), still),
      /^warp: this Sprite always faces the camera/,
    ],
    'a group of sprites': [() => warp(group, still), /^warp: this Sprite /],
    'a detail of 0': [
      () => warp(mesh, still, { detail: 0 }),
      /^warp: .*expected a number of pixels above 0, 'auto', false or \{ tolerance, curved \}.* got the number 0/,
    ],
    'the option detail for a material': [
      () => warpMaterial(material, still, { detail: 1 }),
      /^warpMaterial: the option detail divides meshes/,
    ],
    nothing: [() => warp(undefined, still), /^warp: expected a Mesh, .* got undefined\.$/],
    'an empty group': [
      () => warp(new THREE.Group(), still),
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
      () => warp(mesh, still, { space: 'view' }),
      /^warp: expected 'local', 'rest' or 'world' for the option "space", got the text "view"\.$/,
    ],
    'a geometry': [() => warp(mesh.geometry, still), /got a PlaneGeometry\.$/],
    'an offset along a missing normal': [
      () => warp(new THREE.Mesh(bare, material), ({ normal }) => normal),
      /^warp: the offset reads normal, but the geometry of this Mesh has no attribute "normal"; call geometry\.computeVertexNormals\(\) first\.$/,
    ],
    'an offset that reads missing texture coordinates': [
      () => warp(new THREE.Points(bare), ({ glsl, uv }) => glsl.vec3(uv, 0)),
      /^warp: the offset reads uv, but the geometry of this Points has no attribute "uv"/,
    ],
    'an offset that reads the index of an instance': [
      () => warp(mesh, ({ glsl, instance }) => glsl.vec3(instance, 0, 0)),
      /^warp: the offset reads instance, which three\.js does not have; place instances by their matrices/,
    ],
    'an unknown option': [
      () => warp(mesh, still, { colour: 1 }),
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
          still,
        ),
      /^warpMaterial: the ShaderMaterial cannot be warped: its vertex shader neither reads the attribute "position"/,
    ],
    'a node material of WebGPURenderer': [
      () =>
        warpMaterial(
          Object.assign(new THREE.Material(), { isNodeMaterial: true, type: 'MeshNode' }),
          still,
        ),
      /the MeshNode cannot be warped: only WebGPURenderer draws it; import 'warpjet\/three\/webgpu'\.$/,
    ],
    'a mesh instead of a material': [
      () => warpMaterial(mesh, still),
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

  test('an unsupported object, unless it is in a group: then warp() warns once, and warps the other objects', async (t) => {
    const warn = t.mock.method(console, 'warn', () => {})
    const { LineMaterial } = await import('three/addons/lines/LineMaterial.js')
    const { LineSegments2 } = await import('three/addons/lines/LineSegments2.js')
    const { LineSegmentsGeometry } = await import('three/addons/lines/LineSegmentsGeometry.js')
    const wideLine = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial())
    wideLine.name = 'route'
    const sprite = new THREE.Sprite()
    const group = new THREE.Group().add(plane(), sprite, wideLine)
    const warped = warp(group, ({ glsl }) => glsl.vec3(0, 0, 2))
    assert.deepEqual(warped.skipped, [sprite, wideLine])
    assert.ok(warped.bounds().max.z > 1.9)
    assert.equal(warn.mock.callCount(), 1)
    const [message] = warn.mock.calls[0].arguments
    assert.match(message, /^warp: drawn without the warp: this Sprite always faces the camera/)
    assert.match(
      message,
      /; the LineMaterial of the LineSegments2 "route" cannot be warped: .* use a Line/,
    )
    warped.dispose()
    assert.throws(
      () => warp(wideLine, still),
      /^WarpError: warp: the LineMaterial of the LineSegments2 "route"/,
    )
  })

  test('a mesh that is already warped', () => {
    const warped = warp(mesh, still)
    assert.throws(() => warp(mesh, still), /^WarpError: warp: this Mesh is warped already/)
    warped.dispose()
    warp(mesh, still).dispose()
  })
})

describe('a second warp of the same object throws', () => {
  const still = ({ position }) => position
  const cases = {
    'on a clone of a warped mesh, which is warped, too'(mesh) {
      warp(mesh, still)
      return [
        [() => warp(mesh.clone(), still), /this Mesh is warped already, or a clone of a warped/],
        [() => warp(new THREE.Group().add(mesh.clone()), still), /is warped already/],
      ]
    },
    'after warpMaterial'(mesh) {
      const { material } = warpMaterial(mesh.material, still)
      mesh.material = material
      const message =
        /the MeshBasicMaterial( of this Mesh)? cannot be warped: a call of warpMaterial/
      return [
        [() => warp(mesh, still), message],
        [() => warpMaterial(material, still), message],
      ]
    },
    'after warpMaterial with the option share'(mesh) {
      warpMaterial(mesh.material, still, { share: true })
      return [[() => warp(mesh, still), /a call of warpMaterial/]]
    },
  }
  for (const [name, warpOnce] of Object.entries(cases))
    test(name, () => {
      for (const [warpAgain, message] of warpOnce(plane()))
        assert.throws(warpAgain, (error) => {
          assert.equal(error.name, 'WarpError')
          assert.match(error.message, message)
          return true
        })
    })

  test('unless the first one was disposed of', () => {
    const mesh = plane()
    warp(mesh, still, { share: true }).dispose()
    warp(mesh, still, { share: true }).dispose()
    const warped = warp(mesh, still)
    const clone = mesh.clone()
    warped.dispose()
    warp(clone, still)
  })

  test('unless another object has the same material', () => {
    const mesh = plane()
    warp(mesh, still)
    warp(new THREE.Mesh(mesh.geometry, mesh.material), still)
  })
})

test('messages explain how uniforms are written, if they are written as in three.js', () => {
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
