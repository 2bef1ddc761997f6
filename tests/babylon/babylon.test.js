// The parts of 'warpjet/babylon' that need no rendering.
import assert from 'node:assert/strict'
import { after, test } from 'node:test'
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js'
import { ShaderMaterial } from '@babylonjs/core/Materials/shaderMaterial.js'
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { Scene } from '@babylonjs/core/scene.js'
import { BabylonWarp } from 'warpjet/babylon'

const engine = new NullEngine()
const scene = new Scene(engine)
after(() => engine.dispose())

const warpWith = (offset) => new BabylonWarp(new StandardMaterial('warped', scene), offset)

test('without normals, the shader declares a zero normal of the right type', () => {
  const code = warpWith(({ position }) => position).getCustomCode('vertex')
  assert.match(
    code.CUSTOM_VERTEX_UPDATE_NORMAL,
    /#ifndef NORMAL\s+vec3 normalUpdated = vec3\(0\.0\);\s+#endif/,
  )
})

test('isReady() of a ShaderMaterial works without a mesh on a page with warps', () => {
  warpWith(({ position }) => position)
  const material = new ShaderMaterial('other', scene, {
    vertexSource: 'void main() { gl_Position = vec4(0.0); }',
    fragmentSource: 'void main() { gl_FragColor = vec4(1.0); }',
  })
  assert.equal(typeof material.isReady(), 'boolean')
})
