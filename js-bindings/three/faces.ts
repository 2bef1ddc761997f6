// The outer side of a triangle: where a warp mirrors all of space, the renderer takes it for the back.
import { BackSide, FrontSide, type Material, type Side } from 'three'
import { shaderNames } from '../compile/hosts.js'
import { resolveIncludes } from './shader-source.js'
import type { ThreeWarp } from './three-warp.js'

/** Empty for a warp that never mirrors. */
export const declareOrientation = ({ mirrors }: ThreeWarp): string[] =>
  mirrors === false
    ? []
    : [
        mirrors
          ? `const float ${shaderNames.orientation} = -1.0;`
          : `uniform highp float ${shaderNames.orientation};`,
      ]

const isFront = `( gl_FrontFacing == ( ${shaderNames.orientation} > 0.0 ) )`

/** A fragment shader for WebGLRenderer in which double-sided materials light the side that is seen. */
export function orientFaces(fragmentShader: string, warp: ThreeWarp): string {
  const [declaration] = declareOrientation(warp)
  if (!declaration) return fragmentShader
  const source = resolveIncludes(fragmentShader)
  const oriented = source.replaceAll(/\bgl_FrontFacing\b/g, isFront)
  const readsOrientation = new RegExp(`\\b${shaderNames.orientation}\\b`).test(oriented)
  return readsOrientation ? `${declaration}\n${oriented}` : fragmentShader
}

const others = new Map<Side, Side>([
  [FrontSide, BackSide],
  [BackSide, FrontSide],
])

/** The material for rays where the surface is inside out. */
export function withOtherSide(material: Material | Material[]): Material | Material[] {
  if (Array.isArray(material)) return material.map((each) => withOtherSide(each) as Material)
  const side = others.get(material.side) ?? material.side
  return Object.create(material, { side: { value: side } }) as Material
}
