// What --help says.
import { defaultTriangles } from '../wasm/mesh-tables.js'

export const help = `warpjet warps 3D models with a function of their vertices.

  npx warpjet emit warp.js --target glsl300       the warp as shader text
  npx warpjet bake model.glb warp.js -o out.glb   the warped model as a file
  npx warpjet derive scene.glsl --by p            a function of GLSL with its derivatives
  npx warpjet info model.glb                      what is in a model

\`npx warpjet <command> --help\` has the options. Models are .glb, .gltf, .obj or .stl. Compressed ones need the
package meshoptimizer or draco3dgltf installed.

warp.js is an ES module that exports the offset function, the one that createWarp takes too:

  export default ({ glsl, position, millis }) =>
    glsl.vec3(position.y().mult(4).add(millis.div(500)).sin().mult(0.15), 0, 0)

In its place there may be a file of GLSL, waves.glsl, whose function gives a vec3: vec3 offset(vec3 position, float millis) { … }

Values for \`uniforms\` warp.js may export beside that: export const uniforms = { amount: 0.5 }

  --version   prints the version

It ends with 0 if all went well, 1 if a file or the warp is wrong, and 2 if the command line is.`

const commands: Record<string, string> = {
  emit: `npx warpjet emit <warp.js> [options]

Prints shader statements that move a vertex and turn its normal. They declare offset, warpedPosition and warpedNormal;
comments above name what they read, which your shader declares.

  --target <language>   glsl300 for WebGL 2 (default), glsl100 for WebGL 1, wgsl for WebGPU
  --function <name>     of a file of GLSL; offset, or the last, unless given
  --returns position    it gives where a vertex moves to, not how far
  --max-iterations <n>  of a loop whose end depends on data: it runs so often
  --tangents            also turns tangents: declares warpedTangent
  --surface-variation   for an offset that depends on normal or uv: reads how they vary over the surface from attributes,
                        normalXGradient, normalYGradient, normalZGradient, uGradient and vGradient
  -o, --output <file>   writes a file instead`,

  bake: `npx warpjet bake <model> <warp.js> -o <out.glb> [options]

Moves every vertex of the model as the shader would, turns normals and tangents, and writes a GLB file.

  -o, --output <file>       where to, always .glb
  --function <name>         of a file of GLSL; offset, or the last, unless given
  --returns position        it gives where a vertex moves to, not how far
  --max-iterations <n>      of a loop whose end depends on data: it runs so often
  --set <name>=<value>      a uniform that the warp reads: --set millis=1200, --set mouse=10,20; as often as needed; it
                            counts before what warp.js exports
  --subdivide <tolerance>   first gives the model more triangles where the warp bends it: the result is nowhere farther
                            than this from the smooth shape, in units of the model
  --max-triangles <n>       with --subdivide: never makes more than so many (default ${defaultTriangles})
  -q, --quiet               tells nothing on the way`,

  derive: `npx warpjet derive <file> [options]

Prints a function of a file of GLSL as one that gives its derivatives too: of a float its value and gradient as one vector,
of a vector its Jacobian as a matrix.

  --function <name>     which one; offset, or the last, unless given
  --by <parameter>      what to differentiate by; the first parameter unless given
  --name <name>         what the new function is called
  --max-iterations <n>  of a loop whose end depends on data: it runs so often
  --target <language>   glsl300 for WebGL 2 (default), glsl100 for WebGL 1, wgsl for WebGPU
  -o, --output <file>   writes a file instead`,

  info: `npx warpjet info <model>

Prints how many triangles and vertices a model has, how large it is, which attributes its vertices have, its material,
and what is left out when it is loaded.`,
}

export const helpOf = (command: string) => commands[command]!
