/** Normals at each pixel in GLSL, for both versions of p5; see pixel-code.ts. */
import type { Modifications, Shader } from '../host.js'
import { facingInGlsl } from './facing.js'
import { normalVarying, normalWithLength, varyingOfInput } from './pixel-code.js'
import { glslDeclarations, type PixelCode, type WarpCode } from './styles.js'

/** The transformation of normals from the space of the offset to view space. `matrix` is absent if the offset is in view space. */
export interface ToView {
  matrix?: readonly [type: 'mat3' | 'mat4', name: string]
  transform: (normal: string) => string
  /** True if p5's vertex shader declares the matrix above `precision highp float`; then the fragment shader must do so too. */
  isAbovePrecision?: boolean
}

const lightHook = 'Inputs getPixelInputs'
const colorHook = 'vec4 getFinalColor'

/** The varying for the position in view space, for shaders of p5 that do not pass that position to the fragment stage. */
const ownViewPosition = 'warpjetPixelViewPosition'

const isLit = ({ hooks }: Shader) => lightHook in hooks.fragment

/** Returns whether the shader lights normals or shows them as colours. */
export const readsNormals = (base: Shader) =>
  isLit(base) || base.fragSrc().includes('vVertexNormal')

/** Returns the declarations that the vertex shader needs; `false` if normals are not computed at pixels. */
export const pixelDeclarations = (pixel: PixelCode | undefined, base: Shader) =>
  !!pixel && declare('OUT', pixel, base)

function declare(direction: 'IN' | 'OUT', { varyings }: PixelCode, base: Shader) {
  const all = varyings.map(({ name, type, input }) =>
    input === 'instance'
      ? `flat ${direction} highp ${type} ${name};`
      : `${direction} highp ${type} ${name};`,
  )
  if (!isLit(base)) all.push(`${direction} highp vec3 ${ownViewPosition};`)
  return all.join('\n')
}

/** Returns a statement that passes the position in view space, if pixels need it and p5 does not pass it. */
export const passViewPosition = (pixel: PixelCode | undefined, base: Shader, position: string) =>
  pixel && !isLit(base) ? `  ${ownViewPosition} = ${position};\n` : ''

/** Returns the hooks and declarations that the fragment shader needs. */
export function pixelHooks(
  warpCode: WarpCode,
  pixel: PixelCode,
  base: Shader,
  toView: ToView,
): Modifications {
  const { matrix: [type, name] = [], isAbovePrecision, transform } = toView
  const isDeclared = !name || new RegExp(`uniform[^;]*\\b${name}\\b`).test(base.fragSrc())
  const matrix = !isDeclared && `uniform ${type} ${name};`
  const body = `  vec3 warpjetFacingNormal = warpjetFacing(${isLit(base) ? 'vViewPosition' : ownViewPosition});
${readNormal(pixel)}${pixel.text.code}
  vec3 warpjetShownNormal = warpjetNormal == vec3(0.0) ? warpjetFacingNormal : normalize(${transform('warpjetNormal')});`
  const [parameters] = /\([^)]*\)/.exec(base.hooks.fragment[colorHook] ?? '()')!
  return {
    fragmentDeclarations: glslDeclarations(
      { ...warpCode, text: pixel.text, uniforms: pixel.uniforms },
      isAbovePrecision && matrix,
      'precision highp float;',
      !isAbovePrecision && matrix,
      declare('IN', pixel, base),
      facingInGlsl(warpCode.target),
    ),
    ...(isLit(base)
      ? {
          [lightHook]: `(Inputs inputs) {
${body}
  inputs.normal = warpjetShownNormal;
  return inputs;
}`,
        }
      : { [colorHook]: `${parameters} {\n${body}\n  return vec4(warpjetShownNormal, 1.0);\n}` }),
  }
}

/** Returns statements that restore the length of the normal, which interpolation shortens. */
function readNormal({ varyings }: PixelCode): string {
  if (!varyings.some(({ name }) => name === normalVarying)) return ''
  return `  vec3 ${varyingOfInput('normal')} = ${normalWithLength};\n`
}
