// One uniform of a warp, by its name in the shader.
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import type { Shape } from '../core/expression/shapes.js'

export interface BabylonUniform {
  label: string
  shape: Shape
  numbers: () => number[]
  /** If it is one. */
  image?: () => BaseTexture
}
