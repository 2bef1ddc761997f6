// p5 shaders that draw the normal n that lights use as the color n / 2 + 0.5.

const makeWebGLHooks = (parameters) => ({
  fragmentDeclarations: 'vec3 shown;',
  'Inputs getPixelInputs': '(Inputs inputs) { shown = inputs.normal; return inputs; }',
  'vec4 getFinalColor': `(${parameters}) { return vec4(shown * 0.5 + 0.5, 1.0); }`,
})

const webgpuHooks = {
  fragmentDeclarations: 'var<private> shown: vec3<f32>;',
  'Inputs getPixelInputs': '(inputs: Inputs) { shown = inputs.normal; return inputs; }',
  'vec4f getFinalColor':
    '(color: vec4<f32>, texCoord: vec2<f32>) { return vec4<f32>(shown * 0.5 + 0.5, 1.0); }',
}

/** Returns the source of an expression that makes the shader, for a version and a renderer of p5. */
export function shaderOfNormals(version, renderer) {
  // Texture coordinates are a second parameter in p5 2.x.
  const hooks = makeWebGLHooks(version === '1.11' ? 'vec4 color' : 'vec4 color, vec2 texCoord')
  return `baseMaterialShader().modify(${JSON.stringify(renderer === 'WEBGPU' ? webgpuHooks : hooks)})`
}

/** Code of a sketch that looks at the plane z = 0 from afar: a unit is a pixel. */
export const lookFromAfar = (size) => `perspective(2 * atan(${size / 2 / 1000}), 1, 100, 5000)
  camera(0, 0, 1000, 0, 0, 0, 0, 1, 0)`
