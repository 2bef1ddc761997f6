// Valid and invalid names: reserved, long and others.
import { makeCases, withBody, withLines, withTop } from './sources.js'

/** Names that GLSL reserves, and some that it does not. `words` of versions.js has others. */
export const reserved = `
  asm packed hvec2 hvec3 hvec4 dvec2 dvec3 dvec4 fvec2 fvec3 fvec4 sampler1D sampler1DShadow sampler2DRect sampler3DRect
  sampler2DRectShadow coherent restrict readonly writeonly resource atomic_uint noperspective patch sample subroutine common
  partition active filter image1D iimage1D uimage1D image2D iimage2D uimage2D image3D iimage3D uimage3D imageCube iimageCube
  uimageCube iimageBuffer uimageBuffer image1DArray iimage1DArray uimage1DArray image2DArray iimage2DArray uimage2DArray
  imageBuffer image1DShadow image2DShadow image1DArrayShadow image2DArrayShadow sampler1DArray sampler1DArrayShadow
  isampler1D isampler1DArray usampler1D usampler1DArray isampler2DRect usampler2DRect samplerBuffer isamplerBuffer
  usamplerBuffer sampler2DMS isampler2DMS usampler2DMS sampler2DMSArray isampler2DMSArray usampler2DMSArray isampler3D
  isamplerCube isampler2DArray usampler3D usamplerCube usampler2DArray samplerCubeShadow sampler2DArrayShadow
  gl_own gl_Position __own own__ ow__n _own webgl_own _webgl_own std140 shared row_major main offset sin vec5 mat5 discard1 precise
  binding buffer string vector matrix color time uv normal scale self null
`
  .trim()
  .split(/\s+/)

/** Each returns source that declares something with the given name. */
export const declarers = {
  local: (word) => withBody(`float ${word} = p.x; ${word} += 1.0;`),
  global: (word) => withTop(`float ${word};`),
  parameter: (word) => withTop(`float f(float ${word}) { return ${word}; }`),
  field: (word) => withTop(`struct S { float ${word}; };`),
  structure: (word) => withTop(`struct ${word} { float x; };`),
  function: (word) => withTop(`float ${word}(float x, int y, float z) { return x; }`),
  macro: (word) => withLines(`#define ${word} 1.0`),
}

export const longNames = makeCases(
  'a name with this many letters',
  [100, 256, 257, 1000, 1024, 1025],
  (count) => withTop(`float ${'a'.repeat(count)};`),
)
