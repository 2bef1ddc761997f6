// Tests parts of 'warpjet/three' that need no GPU: what dispose() restores, which materials a renderer draws, and conversions of
// geometries.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import * as THREE from 'three'
import { WarpError, compileWarp } from 'warpjet'
import { glslOffset } from 'warpjet/glsl'
import { bakeWarp } from 'warpjet/mesh'
import { addSurfaceVariation, fromBufferGeometry, toBufferGeometry, warp } from 'warpjet/three'
import { makeSkinnedMesh, plane, wave } from '../support/three-meshes.js'

test('dispose() restores everything, and a second call does nothing', () => {
  for (const mesh of [plane(), makeSkinnedMesh(), new THREE.Points(plane().geometry)])
    for (const share of [false, true]) {
      // Three.js leaves an empty list of listeners.
      const ownProperties = (object) =>
        Object.entries(Object.getOwnPropertyDescriptors(object)).filter(
          ([name]) => name !== '_listeners',
        )
      const [before, materialBefore] = [ownProperties(mesh), ownProperties(mesh.material)]
      const { material } = mesh
      const warped = warp(mesh, wave, { uniforms: { height: 1 }, share })
      assert.notDeepEqual(ownProperties(mesh), before)
      assert.equal(mesh.material, material)
      assert.deepEqual(ownProperties(material), materialBefore)
      warped.dispose()
      warped.dispose()
      assert.deepEqual(ownProperties(mesh), before)
      assert.deepEqual(ownProperties(material), materialBefore)
    }
})

describe('a renderer draws', () => {
  const still = ({ position }) => position
  const mockRenderer = () => {
    const drawn = []
    const renderer = {
      drawn,
      renderBufferDirect: (_camera, _scene, _geometry, material) => drawn.push(material),
      compile() {},
      properties: { get: () => ({}) },
    }
    return renderer
  }
  const draw = (renderer, object, material = object.material) =>
    renderer.renderBufferDirect(null, null, object.geometry, material, object, null)

  test('a warped object with a live view of its current material, and other objects unchanged', (t) => {
    const mesh = plane()
    const warped = warp(mesh, still)
    const renderer = mockRenderer()
    mesh.onBeforeShadow(renderer)
    mesh.onBeforeRender(renderer)
    const override = new THREE.MeshNormalMaterial()
    draw(renderer, mesh)
    draw(renderer, mesh, override)
    draw(renderer, mesh)
    const other = plane()
    draw(renderer, other)
    const [first, second, again, unwarped] = renderer.drawn
    assert.notEqual(first, mesh.material)
    assert.ok(first instanceof THREE.Material)
    assert.equal(first, again)
    assert.equal(second.type, 'MeshNormalMaterial')
    assert.equal(unwarped, other.material)
    mesh.material.color.set('red')
    mesh.material.mine = 1
    assert.equal(first.color.getHex(), 0xff0000)
    assert.equal(first.mine, 1)
    first.side = THREE.BackSide
    assert.equal(mesh.material.side, THREE.BackSide)
    assert.notEqual(first.id, mesh.material.id)
    const freed = t.mock.fn()
    first.addEventListener('dispose', freed)
    warped.dispose()
    assert.equal(freed.mock.callCount(), 1)
    draw(renderer, mesh)
    assert.equal(renderer.drawn.at(-1), mesh.material)
  })

  test('a live view that reads and writes every property of each material', () => {
    const isOfView = (name) => /^(id|uuid|_listeners|type|version|is[A-Z].*)$/.test(name)
    const differentFrom = (value) =>
      typeof value === 'number' ? 0.625 : typeof value === 'boolean' ? !value : {}
    const materials = Object.values(THREE)
      .filter((Type) => Type?.prototype instanceof THREE.Material)
      .map((Type) => new Type())
      .filter((material) => !material.isSpriteMaterial)
    assert.ok(materials.length > 12)
    for (const material of materials) {
      const names = Object.keys(material).map((name) => name.replace(/^_(?=[a-z])/, ''))
      const mesh = new THREE.Mesh(new THREE.PlaneGeometry(), material)
      const warped = warp(mesh, still)
      const renderer = mockRenderer()
      mesh.onBeforeRender(renderer)
      draw(renderer, mesh)
      const [view] = renderer.drawn
      for (const name of names.filter((property) => !isOfView(property))) {
        assert.equal(view[name], material[name], `${material.type}: ${name}`)
        const other = differentFrom(material[name])
        view[name] = other
        assert.equal(material[name], other, `${material.type}: ${name}`)
      }
      warped.dispose()
    }
  })

  test('an object whose material cannot be warped without the warp, and logs one error', (t) => {
    const error = t.mock.method(console, 'error', () => {})
    const mesh = plane()
    mesh.name = 'flag'
    const warped = warp(mesh, still)
    const renderer = mockRenderer()
    mesh.onBeforeRender(renderer)
    mesh.material = new THREE.SpriteMaterial()
    draw(renderer, mesh)
    draw(renderer, mesh)
    assert.deepEqual(renderer.drawn, [mesh.material, mesh.material])
    assert.equal(error.mock.callCount(), 1)
    assert.match(
      error.mock.calls[0].arguments[0],
      /^warp: the SpriteMaterial of the Mesh "flag" is drawn without the warp: a sprite always/,
    )
    warped.dispose()
  })

  test('an unwarped object with less than 0.2 microseconds of overhead', (t) => {
    const mesh = plane()
    const warped = warp(mesh, still)
    const renderer = { renderBufferDirect() {}, compile() {} }
    const measure = (object) => {
      const start = performance.now()
      for (let i = 0; i < 200_000; i++) draw(renderer, object)
      return performance.now() - start
    }
    const other = plane()
    const plainTime = Math.min(...Array.from({ length: 5 }, () => measure(other)))
    mesh.onBeforeRender(renderer)
    const wrappedTime = Math.min(...Array.from({ length: 5 }, () => measure(other)))
    const overhead = (1000 * (wrappedTime - plainTime)) / 200_000
    t.diagnostic(
      `${overhead.toFixed(3)} microseconds more than ${((1000 * plainTime) / 200_000).toFixed(3)}`,
    )
    assert.ok(overhead < 0.2)
    warped.dispose()
  })
})

test('a callback assigned while an object is warped is preserved, and may call the previous one', () => {
  const mesh = plane()
  const calls = []
  mesh.onBeforeRender = () => calls.push('first')
  const warped = warp(mesh, ({ position }) => position)
  const renderer = () => ({ renderBufferDirect() {}, compile() {} })
  const { onBeforeRender } = mesh
  const second = (mesh.onBeforeRender = (...args) => {
    calls.push('second')
    onBeforeRender.call(mesh, ...args)
  })
  mesh.onBeforeRender(renderer())
  assert.deepEqual(calls, ['second', 'first'])
  warped.dispose()
  assert.equal(mesh.onBeforeRender, second)
  const material = new THREE.MeshBasicMaterial()
  const again = warp(mesh, ({ position }) => position)
  mesh.material = material
  again.dispose()
  assert.equal(mesh.material, material)
})

test('toBufferGeometry restores what a baked mesh cannot hold, such as groups and further attributes', () => {
  const { geometry } = plane()
  geometry.setAttribute('uv1', geometry.attributes.uv.clone())
  geometry.setAttribute(
    'color',
    new THREE.Uint8BufferAttribute(
      new Uint8Array(3 * geometry.attributes.position.count).fill(255),
      3,
      true,
    ),
  )
  geometry.addGroup(0, 30, 1)
  const baked = bakeWarp(
    fromBufferGeometry(geometry),
    compileWarp(({ glsl }) => glsl.vec3(0, 0, 1)),
  )
  const result = toBufferGeometry(baked, geometry)
  assert.equal(result.attributes.position.getZ(5), 1)
  assert.equal(result.index.count, geometry.index.count)
  assert.deepEqual([...result.attributes.uv1.array], [...geometry.attributes.uv1.array])
  assert.deepEqual(result.attributes.color.array.slice(0, 4), new Float32Array([1, 1, 1, 1]))
  assert.deepEqual(result.groups, geometry.groups)
  assert.throws(() => toBufferGeometry(baked, new THREE.BoxGeometry()), WarpError)
  assert.throws(() => fromBufferGeometry(new THREE.BufferGeometry()), WarpError)
  assert.throws(() => fromBufferGeometry(3), WarpError)
})

test('addSurfaceVariation adds the gradients of the normals to a geometry', async () => {
  const geometry = await addSurfaceVariation(new THREE.SphereGeometry(2, 40, 30))
  const { position, aWarpjet_normalXGradient: gradient } = geometry.attributes
  // The normal of a sphere is position / radius. So its gradients are the axes, projected onto the surface, divided by the radius.
  for (const i of [300, 500, 700]) {
    const normal = new THREE.Vector3().fromBufferAttribute(position, i).normalize()
    const expected = new THREE.Vector3(1, 0, 0).addScaledVector(normal, -normal.x).divideScalar(2)
    assert.ok(new THREE.Vector3().fromBufferAttribute(gradient, i).distanceTo(expected) < 0.02)
  }
  await assert.rejects(addSurfaceVariation(5), WarpError)
})

test('a glslOffset can be the offset', () => {
  const mesh = plane()
  const warped = warp(
    mesh,
    glslOffset('vec3 offset(vec3 p) { return vec3(0.0, 0.0, 2.0 + sin(p.x)); }'),
  )
  const ray = new THREE.Raycaster(new THREE.Vector3(0, 0.2, 9), new THREE.Vector3(0, 0, -1))
  const [hit] = ray.intersectObject(mesh)
  assert.ok(Math.abs(hit.point.z - 2) < 1e-4)
  warped.dispose()
})
