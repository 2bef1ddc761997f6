// Rows of the company tests for materials with the user's own shaders.
import * as THREE from 'three'
import { checker, makeRow, mesh, torus } from './lib.js'

const fragmentShader = `uniform float tint;
uniform sampler2D map;
varying vec3 vN;
varying vec2 vUv;
void main() { gl_FragColor = vec4( tint, normalize( vN ).z, texture2D( map, vUv ).b, 1.0 ); }`

const makeMaterial = (vertexShader) =>
  new THREE.ShaderMaterial({
    uniforms: { tint: { value: 0.2 }, map: { value: checker() } },
    vertexShader: `varying vec3 vN;\nvarying vec2 vUv;\n${vertexShader}`,
    fragmentShader,
  })

const makeWithoutChunks = () =>
  makeMaterial(`struct Bend { vec3 position; };
uniform mat3 unused;
void main() {
  vUv = uv;
  vN = normalMatrix * normal;
  Bend bend;
  bend.position = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4( bend.position, 1.0 );
}`)

const makeWithChunks = () =>
  makeMaterial(`#include <common>
void main() {
  vUv = uv;
  vN = normalMatrix * normal;
  #include <begin_vertex>
  #include <project_vertex>
}`)

const makeRaw = (glslVersion) => {
  const [attribute, varying, read, out] = glslVersion
    ? ['in', 'out', 'in', 'out vec4 color;']
    : ['attribute', 'varying', 'varying', '']
  return new THREE.RawShaderMaterial({
    glslVersion,
    vertexShader: `precision highp float;
uniform mat4 projectionMatrix, modelViewMatrix;
uniform mat3 normalMatrix;
${attribute} vec3 position;
${attribute} vec3 normal;
${varying} vec3 n;
void main() {
  n = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,
    fragmentShader: `precision highp float;
${read} vec3 n;
${out}
void main() { ${glslVersion ? 'color' : 'gl_FragColor'} = vec4( normalize( n ) * 0.5 + 0.5, 1.0 ); }`,
  })
}

/** Makes two meshes that share a material. Each sets a uniform of the material before it is drawn. */
function makePair() {
  const material = makeWithoutChunks()
  const group = new THREE.Group()
  for (const i of [0, 1]) {
    const made = new THREE.Mesh(torus(), material)
    made.scale.setScalar(0.6)
    made.position.x = 1.4 * i - 0.7
    made.onBeforeRender = () => {
      material.uniforms.tint.value = i
      material.uniformsNeedUpdate = true
    }
    group.add(made)
  }
  return group
}

export const rows = {
  'a ShaderMaterial without chunks, whose uniforms change': makeRow(
    () => mesh(makeWithoutChunks()),
    {
      then: ({ object }) => (object.material.uniforms.tint.value = 0.9),
    },
  ),
  'a ShaderMaterial with chunks and its own normal': makeRow(() => mesh(makeWithChunks())),
  'a RawShaderMaterial': makeRow(() => mesh(makeRaw(THREE.GLSL3))),
  'a RawShaderMaterial in GLSL ES 1.00': makeRow(() => mesh(makeRaw(null))),
  'two meshes that set a shared uniform with uniformsNeedUpdate': makeRow(makePair),
}
