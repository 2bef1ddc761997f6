// The shader that `onBeforeCompile` of a material receives.
import type { IUniform } from 'three'

/** A shader, with those parameters of its program that determine its source. Older versions of three.js have fewer parameters. */
export interface ExactShader {
  vertexShader: string
  fragmentShader: string
  uniforms: Record<string, IUniform>
  defines?: Record<string, unknown>
  instancing?: boolean
  instancingColor?: boolean
  skinning?: boolean
  morphTargets?: boolean
  vertexColors?: boolean
  vertexAlphas?: boolean
  vertexUv1s?: boolean
  vertexUv2s?: boolean
  vertexUv3s?: boolean
  vertexTangents?: boolean
  precision?: string
}
