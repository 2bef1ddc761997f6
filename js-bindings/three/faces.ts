// Corrects which side of a triangle is the front: where a warp mirrors all of space, the renderer takes the outer side for the back.
import { BackSide, FrontSide, type Material, type Side } from 'three'
import { shaderNames } from '../compile/hosts.js'
import { resolveIncludes } from './shader-source.js'
import type { ThreeWarp } from './three-warp.js'

/** Returns the declaration of the warp's orientation; empty for a warp that never mirrors. */
export const declareOrientation = ({ mirrors }: ThreeWarp): string[] =>
  mirrors === false
    ? []
    : [
        mirrors
          ? `const float ${shaderNames.orientation} = -1.0;`
          : `uniform highp float ${shaderNames.orientation};`,
      ]

const isFront = `( gl_FrontFacing == ( ${shaderNames.orientation} > 0.0 ) )`

/** Returns a fragment shader for WebGLRenderer in which double-sided materials light the visible side. */
export function orientFaces(fragmentShader: string, warp: ThreeWarp): string {
  const [declaration] = declareOrientation(warp)
  if (!declaration) return fragmentShader
  const source = resolveIncludes(fragmentShader)
  const oriented = source.replaceAll(/\bgl_FrontFacing\b/g, isFront)
  const readsOrientation = new RegExp(`\\b${shaderNames.orientation}\\b`).test(oriented)
  return readsOrientation ? `${declaration}\n${oriented}` : fragmentShader
}

const oppositeSides = new Map<Side, Side>([
  [FrontSide, BackSide],
  [BackSide, FrontSide],
])

/** Returns a material with the opposite side, for rays where the surface is inside out. */
export function withOtherSide(material: Material | Material[]): Material | Material[] {
  if (Array.isArray(material)) return material.map((each) => withOtherSide(each) as Material)
  const side = oppositeSides.get(material.side) ?? material.side
  return Object.create(material, { side: { value: side } }) as Material
}
