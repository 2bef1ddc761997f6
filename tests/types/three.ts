// What the types of 'warpjet/three' and 'warpjet/react' must allow and refuse; only checked, never run.
import { Color, Group, Mesh, MeshStandardMaterial, Raycaster, Texture, Vector3 } from 'three'
import { createElement } from 'react'
import { Warp } from '../../js-bindings/react.js'
import { type WarpOptions, warp, warpMaterial } from '../../js-bindings/three.js'
import { warpNode } from '../../js-bindings/three.webgpu.js'

const warped = warp(
  new Mesh(),
  ({ position, uniforms, uv, glsl }) =>
    position.mult(uniforms.amount).add(uniforms.center).add(glsl.texture(uniforms.map, uv).xyz()),
  { uniforms: { amount: 0.5, center: new Vector3(), map: new Texture(), tint: new Color() } },
)
warped.uniforms.amount.value = 2
warped.uniforms.center.value.x = 3
warped.uniforms.amount.value = () => 5
warped.update(performance.now())
warped.raycast(new Raycaster(), [])
export const height: number = warped.bounds().max.y
// @ts-expect-error there is no such uniform
warped.uniforms.amuont
// @ts-expect-error a number is no vector
warped.uniforms.center.value = 3
// @ts-expect-error the option has three words
warp(new Group(), ({ position }) => position, { space: 'view' })
// @ts-expect-error three.js has no mouse
warp(new Group(), ({ mouse, glsl }) => glsl.vec3(mouse, 0).x())
// @ts-expect-error an offset is a vec3
warp(new Group(), ({ position }) => position.x())

const made = warpMaterial(new MeshStandardMaterial(), ({ position }) => position, { share: true })
made.material.roughness = 1
export const options: WarpOptions = { space: 'world', surfaceVariation: false }
export const node = warpNode(({ position }) => position.mult(2)).node

createElement(Warp, { offset: ({ position }) => position, space: 'rest' })
// @ts-expect-error there must be an offset
createElement(Warp, {})
