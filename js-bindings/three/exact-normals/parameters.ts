// Variables of the vertex shader that normals at pixels need in the fragment shader.
import type { Displacement } from './displacement.js'

/** Maps uniforms that three.js sets for every program → types. */
const types: Record<string, string> = {
  modelMatrix: 'mat4',
  modelViewMatrix: 'mat4',
  projectionMatrix: 'mat4',
  viewMatrix: 'mat4',
  cameraPosition: 'vec3',
}
/** The names in `types` that three.js also declares in fragment shaders. */
const declared = new Set(['viewMatrix', 'cameraPosition'])

/** Returns why normals cannot be computed in the fragment shader; `undefined` if they can. */
export function obstacleInParameters({ parameters }: Displacement): string | undefined {
  const found = parameters.find(({ name }) => !(name in types))
  if (!found) return undefined
  return found.isAttribute
    ? `it moves vertices by the attribute ${found.name}, which pixels do not have`
    : `it moves vertices by the uniform ${found.name}, whose value is unknown on the CPU`
}

/** Declares the parameters of a displacement in a fragment shader that does not declare them. */
export const declareParameters = (fragmentShader: string, { parameters }: Displacement): string =>
  parameters
    .filter(
      ({ name }) =>
        !declared.has(name) &&
        !new RegExp(`\\buniform\\b[^;]*\\b${name}\\s*;`).test(fragmentShader),
    )
    .map(({ name }) => `uniform highp ${types[name]} ${name};\n`)
    .join('') + fragmentShader
