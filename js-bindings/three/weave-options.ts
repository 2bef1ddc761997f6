// Properties of a shader that determine how a warp is added to it.

export interface WeaveOptions {
  /** True if the shader may draw geometries with tangents that the material reads. */
  mayHaveTangents: boolean
  /** `true` if the geometries have colors. */
  hasColors: boolean
  /** `true` for a ShaderMaterial and a RawShaderMaterial. */
  isShaderMaterial: boolean
  /** `true` for a RawShaderMaterial, which declares everything by itself. */
  isRaw: boolean
  /** `true` for a RawShaderMaterial in GLSL ES 1.00. */
  isGlsl100: boolean
}
