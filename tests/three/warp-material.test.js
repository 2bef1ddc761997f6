// Tests which materials warpMaterial of 'warpjet/three/webgpu' accepts, and its messages for others.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { vec4 } from 'three/tsl'
import * as THREE from 'three/webgpu'
import { warpMaterial } from 'warpjet/three/webgpu'

const still = ({ position }) => position

test('a node material is cloned, or shared, and can be warped once', () => {
  const material = new THREE.MeshStandardNodeMaterial()
  assert.notEqual(warpMaterial(material, still).material, material)
  assert.equal(warpMaterial(material, still, { share: true }).material, material)
  assert.throws(
    () => warpMaterial(material, still),
    /^WarpError: warpMaterial: .* has warped it already; /,
  )
})

test('a material that cannot be warped throws a message', () => {
  const withVertexNode = new THREE.MeshBasicNodeMaterial({ name: 'own' })
  withVertexNode.vertexNode = vec4(0)
  const rejected = [
    [undefined, /^WarpError: warpMaterial: .* got undefined\.$/],
    [
      withVertexNode,
      /^WarpError: warpMaterial: the vertexNode of the MeshBasicNodeMaterial "own" replaces /,
    ],
    [new THREE.ShaderMaterial(), /^WarpError: warpMaterial: WebGPURenderer does not draw this Sh/],
    [new THREE.SpriteNodeMaterial(), /^WarpError: warpMaterial: .*a sprite/],
  ]
  for (const [material, message] of rejected)
    assert.throws(() => warpMaterial(material, still), message)
})
