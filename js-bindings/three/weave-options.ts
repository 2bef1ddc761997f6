// Properties of a shader that decide how a warp is put into it.

export interface WeaveOptions {
  /** `true` if some geometries that are drawn have tangents that the material reads. */
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
