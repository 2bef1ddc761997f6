/** Shaders with hooks of a sketch, as p5's `modify` makes them. */

/** A shader that p5's `modify` made. */
export interface ModifiedShader {
  readonly hooks: {
    readonly vertex: Readonly<Record<string, string>>
    readonly helpers: Readonly<Record<string, string>>
    readonly uniforms: Readonly<Record<string, unknown>>
    /** On WEBGPU. */
    readonly storageUniforms?: Readonly<Record<string, unknown>>
    readonly fragment?: Readonly<Record<string, string>>
    readonly declarations?: string
    readonly varyingVariables?: readonly string[]
    readonly modified: { readonly vertex: Readonly<Record<string, boolean>> }
  }
  /** As p5 has it, with the places of hooks. */
  _vertSrc: string
  modify(hooks: Record<string, string>): ModifiedShader
}

/** Whether the shader is of a WEBGPU canvas. */
export const isWgsl = ({ _vertSrc }: ModifiedShader) => /\bfn main\b/.test(_vertSrc)
