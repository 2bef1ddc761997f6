/** The type of shaders that p5's `modify` makes. */

/** A shader that p5's `modify` made. */
export interface ModifiedShader {
  readonly hooks: {
    readonly vertex: Readonly<Record<string, string>>
    readonly helpers: Readonly<Record<string, string>>
    readonly uniforms: Readonly<Record<string, unknown>>
    /** WEBGPU only. */
    readonly storageUniforms?: Readonly<Record<string, unknown>>
    readonly fragment?: Readonly<Record<string, string>>
    readonly declarations?: string
    readonly varyingVariables?: readonly string[]
    readonly modified: { readonly vertex: Readonly<Record<string, boolean>> }
  }
  /** p5's vertex source, with placeholders for the hooks. */
  _vertSrc: string
  modify(hooks: Record<string, string>): ModifiedShader
}

/** Returns whether the shader belongs to a WEBGPU canvas. */
export const isWgsl = ({ _vertSrc }: ModifiedShader) => /\bfn main\b/.test(_vertSrc)
