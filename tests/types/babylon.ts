// Checks which uses the types of 'warpjet/babylon' allow and reject. Compiled only, never run.
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { BabylonWarp } from '../../js-bindings/babylon.js'

const warp = new BabylonWarp(
  new StandardMaterial('standard'),
  ({ position, uniforms }) => position.mult(uniforms.height).add(uniforms.center),
  { uniforms: { height: 0.5, center: new Vector3() }, normals: 'auto' },
)
export const stage: 'vertex' | 'pixel' = warp.normals
// @ts-expect-error read-only
warp.normals = 'pixel'
warp.values.height = 0.7
warp.values.height = () => 0.7
warp.values.center = new Vector3(1, 2, 3)
warp.values.center = [1, 2, 3]
// @ts-expect-error the value of height is a number
warp.values.height = 'high'
// @ts-expect-error there is no such uniform
warp.values.hieght
new BabylonWarp(new StandardMaterial('other'), ({ position }) => position, { normals: 'vertex' })
new BabylonWarp(new StandardMaterial('other'), ({ position }) => position, {
  // @ts-expect-error not a stage
  normals: 'pixels',
})
new BabylonWarp(new StandardMaterial('other'), ({ position }) => position, {
  // @ts-expect-error normals cannot be left out
  normals: false,
})
