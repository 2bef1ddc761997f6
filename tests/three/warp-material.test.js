// Materials that warpMaterial of 'warpjet/three/webgpu' accepts, and its messages for others.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { vec4 } from 'three/tsl'
import * as THREE from 'three/webgpu'
import { warpMaterial } from 'warpjet/three/webgpu'

const none = ({ position }) => position

test('a node material is cloned, or shared, and can be warped once', () => {
  const material = new THREE.MeshStandardNodeMaterial()
  assert.notEqual(warpMaterial(material, none).material, material)
  assert.equal(warpMaterial(material, none, { share: true }).material, material)
  assert.throws(
    () => warpMaterial(material, none),
    /^WarpError: warpMaterial: .* has warped it already; /,
  )
})

test('a material that a warp cannot move has a message', () => {
  const own = new THREE.MeshBasicNodeMaterial({ name: 'own' })
  own.vertexNode = vec4(0)
  const refusals = [
    [undefined, /^WarpError: warpMaterial: .* got undefined\.$/],
    [own, /^WarpError: warpMaterial: the vertexNode of the MeshBasicNodeMaterial "own" replaces /],
    [new THREE.ShaderMaterial(), /^WarpError: warpMaterial: WebGPURenderer does not draw this Sh/],
    [new THREE.SpriteNodeMaterial(), /^WarpError: warpMaterial: .*a sprite/],
  ]
  for (const [material, message] of refusals)
    assert.throws(() => warpMaterial(material, none), message)
})
