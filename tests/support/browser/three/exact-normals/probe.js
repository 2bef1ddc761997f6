// Reads what the shaders of a material compute for each vertex: every vertex is drawn as a point that covers one pixel.
import * as THREE from 'three'

const canvas = document.createElement('canvas')
export const renderer = new THREE.WebGLRenderer({ canvas })
const gl = renderer.getContext()
const width = 64

/** The GLSL expression that fragments output while a material is probed; `undefined` for the output of the material. */
let output
let count = 0
/** 1 if fragments output gl_Position of their vertex instead, otherwise 0. */
let outputsClip = 0

const shaderSource = gl.shaderSource.bind(gl)
gl.shaderSource = (shader, source) =>
  shaderSource(
    shader,
    gl.getShaderParameter(shader, gl.SHADER_TYPE) === gl.VERTEX_SHADER
      ? patchVertexShader(source)
      : patchFragmentShader(source),
  )

const patchVertexShader = (source) => `${source.replace(/\bvoid\s+main\s*\(/, 'void probedMain(')}
uniform vec3 probe;
out vec4 probedClip;
void main() {
  probedMain();
  probedClip = gl_Position;
  int pixel = gl_VertexID + gl_InstanceID * int(probe.z);
  gl_Position = vec4((vec2(pixel % ${width}, pixel / ${width}) + 0.5) / probe.xy * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}`

function patchFragmentShader(source) {
  const end = source.lastIndexOf('}')
  const variable = /\bpc_fragColor\b/.test(source) ? 'pc_fragColor' : 'fragColor'
  const main = source.search(/\bvoid\s+main\s*\(/)
  return `${source.slice(0, main)}in vec4 probedClip;\nuniform float outputsClip;\n${source.slice(main, end)}${output ? `${variable} = ${output};` : ''}\nif (outputsClip > 0.5) ${variable} = probedClip;\n}`
}

let size = [width, 1]
function setUniforms() {
  const program = gl.getParameter(gl.CURRENT_PROGRAM)
  gl.uniform3f(gl.getUniformLocation(program, 'probe'), ...size, count)
  gl.uniform1f(gl.getUniformLocation(program, 'outputsClip'), outputsClip)
}
for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']) {
  const original = gl[name].bind(gl)
  gl[name] = (_, ...others) => {
    setUniforms()
    original(gl.POINTS, ...others)
  }
}

/**
 * Draws a mesh. Returns four floats per vertex and instance: the value of `expression` in its fragment shader, such as `vec4(normal, 1.0)`;
 * default: the color. With `isClip`, `gl_Position`.
 */
export function probe(mesh, camera, expression, isClip = false) {
  output = expression
  outputsClip = Number(isClip)
  count = mesh.geometry.attributes.position.count
  const all = count * (mesh.isInstancedMesh ? mesh.count : 1)
  size = [width, Math.ceil(all / width)]
  const target = new THREE.WebGLRenderTarget(...size, {
    type: THREE.FloatType,
    minFilter: THREE.NearestFilter,
    magFilter: THREE.NearestFilter,
  })
  const scene = new THREE.Scene().add(mesh)
  mesh.frustumCulled = false
  renderer.setRenderTarget(target)
  renderer.setClearColor(0, 0)
  renderer.clear()
  renderer.render(scene, camera)
  const pixels = new Float32Array(4 * size[0] * size[1])
  renderer.readRenderTargetPixels(target, 0, 0, ...size, pixels)
  renderer.setRenderTarget(null)
  target.dispose()
  return pixels.subarray(0, 4 * all)
}
