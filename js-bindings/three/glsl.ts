// Parts of GLSL that the vertex and the fragment shader of a warp have in common.
import { shaderNames, type HostText } from '../compile/hosts.js'
import type { ThreeWarp } from './three-warp.js'

/** Declares the uniforms that the texts read, in both stages with the same precision. */
export function uniformsInGlsl(warp: ThreeWarp, texts: readonly HostText[]): string[] {
  const frame = new Set(texts.flatMap(({ frame }) => frame))
  return [
    `uniform highp float ${shaderNames.millis};`,
    ...warp.uniforms.inShader.map(({ label, type }) => `uniform highp ${type} ${label};`),
    ...[...frame].map((name) => `uniform highp vec4 ${name};`),
  ]
}

/** Returns a part of the only text. If there are two, the first is for geometries with tangents, and a macro chooses between their parts. */
export const choosePartByTangent = (
  texts: readonly HostText[],
  part: (text: HostText) => string,
) =>
  texts.length === 1
    ? part(texts[0]!)
    : `#ifdef USE_TANGENT\n${part(texts[0]!)}\n#else\n${part(texts[1]!)}\n#endif`
