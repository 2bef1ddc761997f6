// Checks which uses the types of 'warpjet/three' and 'warpjet/react' allow and reject. Compiled only, never run.
import { createElement } from 'react'
import {
  Color,
  Group,
  Matrix3,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  Raycaster,
  Texture,
  Vector2,
  Vector3,
  Vector4,
} from 'three'
import { MeshStandardNodeMaterial } from 'three/webgpu'
import { Warp } from '../../js-bindings/react.js'
import { exactNormals, warp, warpMaterial, type WarpOptions } from '../../js-bindings/three.js'
import {
  exactNormals as exactNodeNormals,
  tslOffset,
  warpNode,
} from '../../js-bindings/three.webgpu.js'

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
warp(
  new Mesh(),
  ({ glsl, position, uniforms: { two, three, four, turn, tint, small, large } }) =>
    glsl
      .vec3(two.y(), three.z(), four.w())
      .add(turn.xyz(), tint.xyz(), small.mult(position))
      .add(large.mult(glsl.vec4(position, 1)).xyz()),
  {
    uniforms: {
      two: new Vector2(),
      three: new Vector3(),
      four: new Vector4(),
      turn: new Quaternion(),
      tint: new Color(),
      small: new Matrix3(),
      large: () => new Matrix4(),
    },
  },
)
// @ts-expect-error a Vector2 has no third component
warp(new Mesh(), ({ glsl, uniforms: { two } }) => glsl.vec3(two.z()), {
  uniforms: { two: new Vector2() },
})
// @ts-expect-error the option has three values
warp(new Group(), ({ position }) => position, { space: 'view' })
const stage: 'vertex' | 'pixel' = warp(new Mesh(), ({ position }) => position, {
  normals: 'pixel',
}).normals
warpMaterial(new MeshStandardMaterial(), ({ position }) => position, { normals: 'auto' })
  .normals === stage
// @ts-expect-error the option has three values
warp(new Group(), ({ position }) => position, { normals: true })
// @ts-expect-error three.js has no mouse
warp(new Group(), ({ mouse, glsl }) => glsl.vec3(mouse, 0))
// @ts-expect-error the same with the mouse's components
warp(new Group(), ({ mouseX, glsl }) => glsl.vec3(mouseX, 0, 0))
// @ts-expect-error instances are placed by matrices
warp(new Group(), ({ instance, glsl }) => glsl.vec3(instance, 0, 0))
// @ts-expect-error an offset must be a vec3
warp(new Group(), ({ position }) => position.x())

const warpedMaterial = warpMaterial(new MeshStandardMaterial(), ({ position }) => position, {
  share: true,
})
warpedMaterial.material.roughness = 1
export const options: WarpOptions = { space: 'world', surfaceVariation: false }
new MeshStandardNodeMaterial().positionNode = warpNode(({ position }) => position.mult(2)).node

createElement(Warp, { offset: ({ position }) => position, space: 'rest', normals: 'vertex' })
// @ts-expect-error an offset is required
createElement(Warp, {})

// exactNormals returns the type of its argument.
const exactMaterial: MeshStandardMaterial = exactNormals(new MeshStandardMaterial(), {
  normals: 'pixel',
  surfaceVariation: false,
  maxIterations: 1000,
})
const exactMesh: Mesh = exactNormals(new Mesh(undefined, exactMaterial))
// @ts-expect-error exactNormals takes a material or a mesh
exactNormals(new Vector3())
// @ts-expect-error there is no such stage
exactNormals(exactMesh, { normals: 'face' })
// @ts-expect-error maxIterations is a number
exactNormals(exactMesh, { maxIterations: '8' })

const nodeMaterial: MeshStandardNodeMaterial = exactNodeNormals(new MeshStandardNodeMaterial(), {
  normals: 'pixel',
})
// @ts-expect-error there is no such stage
exactNodeNormals(nodeMaterial, { normals: 'pixels' })

const tslWave = tslOffset((position) => position.mul(2), { returns: 'position' })
warp(new Mesh(), tslWave, { uniforms: tslWave.uniforms })
warp(new Mesh(), tslWave)
// @ts-expect-error the function must return a node
tslOffset(() => 3)
