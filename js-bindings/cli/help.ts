// The texts of --help.
import { defaultTriangles } from '../wasm/mesh-tables.js'

export const help = `warpjet warps 3D models with a function of their vertices.

  npx warpjet emit warp.js --target glsl300       prints the warp as shader code
  npx warpjet bake model.glb warp.js -o out.glb   writes the warped model to a file
  npx warpjet derive scene.glsl --by p            prints a function with the derivatives of one in GLSL or WGSL
  npx warpjet info model.glb                      describes a model

\`npx warpjet <command> --help\` lists the options. Models are .glb, .gltf, .obj or .stl. Compressed models need the
package meshoptimizer or draco3dgltf.

warp.js is an ES module that exports an offset function, as for createWarp:

  export default ({ glsl, position, millis }) =>
    glsl.vec3(position.y().mult(4).add(millis.div(500)).sin().mult(0.15), 0, 0)

Instead of warp.js you can pass a GLSL or WGSL file with a function that returns a vec3: vec3 offset(vec3 position, float millis) { … }

warp.js can also export values for \`uniforms\`: export const uniforms = { amount: 0.5 }

  --version   prints the version

The exit code is 0 on success, 1 for an error in a file or the warp, and 2 for an error in the command line.`

const commands: Record<string, string> = {
  emit: `npx warpjet emit <warp.js> [options]

Prints shader statements that compute the warped position and normal of a vertex. They declare offset, warpedPosition and
warpedNormal; comments above list the uniforms and attributes, which your shader must declare.

  --target <language>   glsl300 for WebGL 2 (default), glsl100 for WebGL 1, wgsl for WebGPU
  --function <name>     function in a GLSL or WGSL file (default: offset, or else the last one)
  --returns position    the function returns the new position instead of the offset
  --max-iterations <n>  max number of iterations of a loop whose end depends on data
  --tangents            also transforms tangents: declares warpedTangent
  --surface-variation   for an offset that depends on normal or uv: reads their gradients over the surface from the
                        attributes normalXGradient, normalYGradient, normalZGradient, uGradient and vGradient
  -o, --output <file>   writes to a file instead`,

  bake: `npx warpjet bake <model> <warp.js> -o <out.glb> [options]

Moves every vertex of the model like the shader, transforms normals and tangents, and writes a GLB file.

  -o, --output <file>       output file, always .glb
  --function <name>         function in a GLSL or WGSL file (default: offset, or else the last one)
  --returns position        the function returns the new position instead of the offset
  --max-iterations <n>      max number of iterations of a loop whose end depends on data
  --set <name>=<value>      sets a uniform of the warp: --set millis=1200, --set mouse=10,20; can be repeated, and
                            overrides the exports of warp.js
  --subdivide <tolerance>   first splits triangles where the warp bends them, until the warped triangles are within this
                            distance of the smooth warped surface, in units of the model
  --max-triangles <n>       max number of triangles with --subdivide (default: ${defaultTriangles})
  --normal-map <size>       also writes the normals between the vertices, as a normal map of this many texels square, such
                            as 1024, so that a coarse model is lit like a fine one; needs uvs that do not overlap
  --frames <kind>           with --normal-map, how the program that draws the model interpolates tangent frames: normalized
                            like three.js (default), or mikktspace like Blender
  -q, --quiet               prints no progress`,

  derive: `npx warpjet derive <file> [options]

Prints a function that returns the derivatives of a function in a GLSL or WGSL file: for a float, its value and gradient as one
vector; for a vector, its Jacobian as a matrix.

  --function <name>     function to differentiate (default: offset, or else the last one)
  --by <parameter>      parameter to differentiate by (default: the first one)
  --name <name>         name of the new function
  --max-iterations <n>  max number of iterations of a loop whose end depends on data
  --target <language>   glsl300 for WebGL 2 (default), glsl100 for WebGL 1, wgsl for WebGPU
  -o, --output <file>   writes to a file instead`,

  info: `npx warpjet info <model>

Prints the number of triangles and vertices of a model, its size, the attributes of its vertices, its material, and the
parts that are left out when it is loaded.`,
}

export const helpOf = (command: string) => commands[command]!
