// Reads what the shaders of a material make of each vertex: every vertex is drawn as a point on a pixel of its own.
import * as THREE from 'three'

const canvas = document.createElement('canvas')
export const renderer = new THREE.WebGLRenderer({ canvas })
const gl = renderer.getContext()
const width = 64

/** What fragments show while a material is probed: an expression of GLSL, or `undefined` for what they show anyway. */
let shown
let count = 0
/** 1 if the position on the screen is shown instead. */
let part = 0

const shaderSource = gl.shaderSource.bind(gl)
gl.shaderSource = (shader, source) =>
  shaderSource(
    shader,
    gl.getShaderParameter(shader, gl.SHADER_TYPE) === gl.VERTEX_SHADER
      ? vertexOf(source)
      : fragmentOf(source),
  )

const vertexOf = (source) => `${source.replace(/\bvoid\s+main\s*\(/, 'void probedMain(')}
uniform vec3 probe;
out vec4 probedClip;
void main() {
  probedMain();
  probedClip = gl_Position;
  int place = gl_VertexID + gl_InstanceID * int(probe.z);
  gl_Position = vec4((vec2(place % ${width}, place / ${width}) + 0.5) / probe.xy * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}`

function fragmentOf(source) {
  const end = source.lastIndexOf('}')
  const output = /\bpc_fragColor\b/.test(source) ? 'pc_fragColor' : 'fragColor'
  const main = source.search(/\bvoid\s+main\s*\(/)
  return `${source.slice(0, main)}in vec4 probedClip;\nuniform float probedPart;\n${source.slice(main, end)}${shown ? `${output} = ${shown};` : ''}\nif (probedPart > 0.5) ${output} = probedClip;\n}`
}

let size = [width, 1]
function setUniforms() {
  const program = gl.getParameter(gl.CURRENT_PROGRAM)
  gl.uniform3f(gl.getUniformLocation(program, 'probe'), ...size, count)
  gl.uniform1f(gl.getUniformLocation(program, 'probedPart'), part)
}
for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']) {
  const own = gl[name].bind(gl)
  gl[name] = (_, ...others) => {
    setUniforms()
    own(gl.POINTS, ...others)
  }
}

/**
 * Draws a mesh → four floats per vertex and instance: the expression `shows` of its fragment shader, such as `vec4(normal, 1.0)`, or
 * what it shows anyway; with `isClip`, `gl_Position`.
 */
export function probe(mesh, camera, shows, isClip = false) {
  shown = shows
  part = Number(isClip)
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
