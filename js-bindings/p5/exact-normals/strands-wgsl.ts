/** What p5.strands has written for a WEBGPU canvas in the words of GLSL: its WGSL is as plain as what it writes for WebGL. */
import { WarpError } from '../../errors/errors.js'

const words: readonly (readonly [RegExp, string])[] = [
  [/^@group.*|\bhooks\./gm, ''],
  [/\btextureSampleLevel\((\w+), \w+_sampler, /g, 'textureLod($1, '],
  [/\batan2\b/g, 'atan'],
  [/\bvec(\d)<i32>/g, 'ivec$1'],
  [/<f32>/g, ''],
  [/\bf32\b/g, 'float'],
  [/\bi32\b/g, 'int'],
  [/\((\w+): Vertex\)/g, '(Vertex $1)'],
  [/\bvar(?:<private>)? (\w+): (\w+)/g, '$2 $1'],
  [/\bvar\b/g, 'Vertex'],
]

/** Throws a `WarpError` for what has no word of its own there. */
export function glslOf(wgsl: string): string {
  if (/%|\b(?:fn|let)\b/.test(wgsl))
    throw new WarpError(
      'On a WEBGPU canvas plain WGSL is read, as p5.strands writes it, without noise(), random(), mod() and %; draw it on a WEBGL canvas, or write the motion for createWarp.',
    )
  return words.reduce((text, [word, other]) => text.replace(word, other), wgsl)
}

/** What stands above the hooks of p5's shaders for shapes. */
export const aboveStrands = [
  'struct Vertex { vec3 position; vec3 normal; vec2 texCoord; vec4 color; };',
  'uniform int instanceID;',
  ...['float', 'vec2', 'vec3', 'vec4'].map(
    (type) => `${type} select(${type} a, ${type} b, bool c) { return c ? b : a; }`,
  ),
].join('\n')
