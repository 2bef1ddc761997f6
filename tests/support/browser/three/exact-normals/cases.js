// Displacements in GLSL as people write them, each with a formula in double precision that moves a point in the same way.
import * as THREE from 'three'
import CustomShaderMaterial from 'three-custom-shader-material/vanilla'
import {
  gerstner,
  glslNoise,
  heightMap,
  noise,
  ridges,
  ripple,
  texels,
  voronoi,
  waves,
} from './formulas.js'

const { sin, cos } = Math
const time = 0.7

/**
 * Adds an `onBeforeCompile` to a material: it puts functions above `main`, and statements after a chunk or, with `replaces`, in its place.
 */
export function changeShader(
  material,
  functions,
  statements,
  { chunk = 'begin_vertex', uniforms = {}, replaces = false } = {},
) {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, { uTime: { value: time }, ...uniforms })
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', `#include <common>\nuniform float uTime;\n${functions}`)
      .replace(`#include <${chunk}>`, replaces ? statements : `#include <${chunk}>\n${statements}`)
    material.userData.shader = shader
  }
  material.customProgramCacheKey = () => functions + statements + chunk
  return material
}

export const standard = () => new THREE.MeshStandardMaterial()

const makeHeightMap = () => {
  const map = new THREE.DataTexture(texels, 8, 8, THREE.RedFormat, THREE.FloatType)
  map.magFilter = map.minFilter = THREE.LinearFilter
  map.needsUpdate = true
  return map
}

const rotate = ([x, y, z], angle) => [
  cos(angle) * x + sin(angle) * z,
  y,
  -sin(angle) * x + cos(angle) * z,
]

/**
 * Materials that change chunks. The oracle `moved(position, normal, uv, instanceMatrix, positionInWorld)` returns the moved position;
 * `movedInView` and `movedInWorld` do the same in view and in world space.
 */
export const chunks = {
  'sine sea': {
    shape: 'plane',
    material: () =>
      changeShader(
        standard(),
        '',
        'transformed.z += 0.25 * sin(position.x * 3.0 + uTime) * cos(position.y * 2.0);',
      ),
    moved: ([x, y, z]) => [x, y, z + 0.25 * sin(x * 3 + time) * cos(y * 2)],
  },
  'Gerstner waves': {
    shape: 'plane',
    material: () =>
      changeShader(
        new THREE.MeshPhysicalMaterial(),
        `uniform vec4 waves[3];
vec3 gerstnerWave(vec4 wave, vec3 p) {
  vec2 d = normalize(wave.xy);
  float f = wave.w * dot(d, p.xy) - uTime;
  float a = wave.z / wave.w;
  return vec3(d * (a * cos(f)), a * sin(f));
}`,
        `vec3 gridPoint = position;
vec3 p = gridPoint;
for (int i = 0; i < 3; i++) p += gerstnerWave(waves[i], gridPoint);
transformed = p;`,
        { uniforms: { waves: { value: waves.map((wave) => new THREE.Vector4(...wave)) } } },
      ),
    moved: (p) => gerstner(p, time),
  },
  'terrain ridges': {
    shape: 'plane',
    material: () =>
      changeShader(
        new THREE.MeshLambertMaterial(),
        `${glslNoise}
float ridgedNoise(vec2 p) {
  float sum = 0.0, amplitude = 0.4, frequency = 1.3;
  for (int i = 0; i < 4; i++) {
    float ridge = 1.0 - abs(noise(vec3(p * frequency, 0.37)));
    sum += amplitude * ridge * ridge;
    amplitude *= 0.45;
    frequency *= 2.1;
  }
  return sum;
}`,
        'vec3 transformed = vec3(position.xy, position.z + ridgedNoise(position.xy));',
        { replaces: true },
      ),
    moved: ([x, y, z]) => [x, y, z + ridges(x, y)],
  },
  'ripples by distance': {
    shape: 'plane',
    material: () =>
      changeShader(
        new THREE.MeshPhongMaterial(),
        'uniform vec2 center;\nuniform float strength;',
        `float d = distance(transformed.xy, center);
transformed += objectNormal * strength * sin(9.0 * d - uTime) * exp(-1.5 * d);`,
        { uniforms: { center: { value: new THREE.Vector2(0.3, -0.2) }, strength: { value: 0.2 } } },
      ),
    moved: ([x, y, z]) => [x, y, z + ripple([x, y], time)],
  },
  'morph by noise': {
    shape: 'sphere',
    material: () =>
      changeShader(
        standard(),
        glslNoise,
        'transformed += normal * noise(position * 1.7 + vec3(0.0, uTime, 0.0)) * 0.4;',
      ),
    moved: ([x, y, z], n) => {
      const h = 0.4 * noise(x * 1.7, y * 1.7 + time, z * 1.7)
      return [x + n[0] * h, y + n[1] * h, z + n[2] * h]
    },
  },
  'instanced grass': {
    shape: 'blade',
    material: () =>
      changeShader(
        standard(),
        '',
        `#ifdef USE_INSTANCING
float sway = sin(uTime + instanceMatrix[3].x * 2.0) * 0.6;
float bend = pow(clamp(position.y + 0.5, 0.0, 1.0), 2.0) * sway;
transformed.z += bend;
transformed.x += bend * 0.3;
#endif`,
      ),
    moved: ([x, y, z], n, uv, matrix) => {
      const bend = Math.min(Math.max(y + 0.5, 0), 1) ** 2 * sin(time + matrix[12] * 2) * 0.6
      return [x + 0.3 * bend, y, z + bend]
    },
  },
  Voronoi: {
    shape: 'plane',
    material: () =>
      changeShader(
        new THREE.MeshToonMaterial(),
        `${glslNoise}
float voronoi(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  float nearest = 8.0;
  for (int b = -1; b <= 1; b++)
    for (int a = -1; a <= 1; a++) {
      vec2 g = vec2(float(a), float(b));
      float h = cell(vec3(i + g, 3.0));
      vec2 o = g + 0.15 + 0.7 * vec2(mod(h, 17.0) / 17.0, mod(h, 23.0) / 23.0) - f;
      nearest = min(nearest, dot(o, o));
    }
  return sqrt(nearest);
}`,
        'transformed.z += 0.4 * voronoi(position.xy * 2.3);',
      ),
    moved: ([x, y, z]) => [x, y, z + 0.4 * voronoi(x * 2.3, y * 2.3)],
  },
  'twist, with wrong normals by hand': {
    shape: 'plane',
    material: () => {
      const material = changeShader(
        new THREE.MeshMatcapMaterial(),
        `mat2 rotation(float a) { float s = sin(a), c = cos(a); return mat2(c, -s, s, c); }`,
        'transformed.xz = rotation(position.y * 1.4 + uTime) * transformed.xz;',
      )
      const { onBeforeCompile } = material
      material.onBeforeCompile = (shader) => {
        onBeforeCompile(shader)
        shader.vertexShader = shader.vertexShader.replace(
          '#include <beginnormal_vertex>',
          '#include <beginnormal_vertex>\nobjectNormal.xz = rotation(position.y * 1.4 + uTime) * objectNormal.xz;',
        )
      }
      return material
    },
    moved: ([x, y, z]) => rotate([x, y, z], y * 1.4 + time),
  },
  'height map': {
    shape: 'plane',
    material: () =>
      changeShader(
        standard(),
        'uniform sampler2D heightMap;',
        'transformed += normal * texture2D(heightMap, uv).r * 0.5;',
        { uniforms: { heightMap: { value: makeHeightMap() } } },
      ),
    moved: ([x, y, z], n, [u, v]) => [x, y, z + 0.5 * heightMap(u, v)],
  },
  'flag, with normals by differences': {
    shape: 'plane',
    material: () =>
      changeShader(
        new THREE.MeshNormalMaterial(),
        'vec3 wave(vec3 p, vec2 at) { p.z += sin(at.x * 8.0 - uTime) * 0.3 * at.x; p.y += 0.1 * sin(at.x * 3.0); return p; }',
        `vec3 transformed = wave(position, uv);
vec3 right = wave(position + vec3(0.05, 0.0, 0.0), uv + vec2(0.025, 0.0));
vec3 up = wave(position + vec3(0.0, 0.05, 0.0), uv + vec2(0.0, 0.025));
vNormal = normalize(normalMatrix * cross(right - transformed, up - transformed));`,
        { replaces: true },
      ),
    moved: ([x, y, z], n, [u]) => [x, y + 0.1 * sin(u * 3), z + sin(u * 8 - time) * 0.3 * u],
  },
  'a position bent in view space': {
    shape: 'plane',
    material: () =>
      changeShader(
        standard(),
        '',
        `vec4 mvPosition = modelViewMatrix * vec4(transformed, 1.0);
mvPosition.y -= 0.15 * mvPosition.x * mvPosition.x;
gl_Position = projectionMatrix * mvPosition;`,
        { chunk: 'project_vertex', replaces: true },
      ),
    movedInView: ([x, y, z]) => [x, y - 0.15 * x * x, z],
  },
}

const csm = (vertexShader, baseMaterial = THREE.MeshPhysicalMaterial) =>
  new CustomShaderMaterial({ baseMaterial, vertexShader, uniforms: { uTime: { value: time } } })

/** Materials of three-custom-shader-material. */
export const customShaderMaterials = {
  'csm_Position along the normal': {
    shape: 'sphere',
    material: () =>
      csm(`uniform float uTime;
${glslNoise}
void main() { csm_Position = position + normal * noise(position * 1.5 + uTime) * 0.4; }`),
    moved: ([x, y, z], n) => {
      const h = 0.4 * noise(x * 1.5 + time, y * 1.5 + time, z * 1.5 + time)
      return [x + n[0] * h, y + n[1] * h, z + n[2] * h]
    },
  },
  'csm_Position with normals by differences': {
    shape: 'plane',
    material: () =>
      csm(
        `uniform float uTime;
float height(vec2 p) { return 0.3 * sin(3.0 * p.x + uTime) * sin(2.0 * p.y); }
void main() {
  csm_Position = position;
  csm_Position.z += height(position.xy);
  vec3 a = vec3(0.1, 0.0, height(position.xy + vec2(0.1, 0.0)) - csm_Position.z);
  vec3 b = vec3(0.0, 0.1, height(position.xy + vec2(0.0, 0.1)) - csm_Position.z);
  csm_Normal = normalize(cross(a, b));
}`,
        THREE.MeshStandardMaterial,
      ),
    moved: ([x, y, z]) => [x, y, z + 0.3 * sin(3 * x + time) * sin(2 * y)],
  },
}

const showNormal =
  'varying vec3 vNormal;\nvoid main() { gl_FragColor = vec4(normalize(vNormal), 1.0); }'
const makeShaderMaterial = (vertexShader, more = {}, fragmentShader = showNormal) =>
  new THREE.ShaderMaterial({
    uniforms: { uTime: { value: time }, uStrength: { value: 0.3 } },
    vertexShader,
    fragmentShader,
    ...more,
  })

/** ShaderMaterials. `space` is the space of the normal's varying; default: 'view'. */
export const shaderMaterials = {
  'noise along the normal': {
    shape: 'sphere',
    material: () =>
      makeShaderMaterial(`uniform float uTime; // seconds
uniform float uStrength;
varying vec3 vNormal;
varying float vHeight;
${glslNoise}
void main() {
  vHeight = noise(position * 1.6 + uTime);
  vec3 newPosition = position + normal * vHeight * uStrength;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(newPosition, 1.0);
}`),
    moved: ([x, y, z], n) => {
      const h = 0.3 * noise(x * 1.6 + time, y * 1.6 + time, z * 1.6 + time)
      return [x + n[0] * h, y + n[1] * h, z + n[2] * h]
    },
  },
  'a sea in world space': {
    shape: 'plane',
    space: 'world',
    material: () =>
      makeShaderMaterial(`uniform float uTime;
varying vec3 vNormal;
varying float vElevation;
float waveElevation(vec3 position) {
  float elevation = sin(position.x * 2.0 + uTime) * sin(position.z * 1.5 + uTime) * 0.3;
  for (float i = 1.0; i <= 3.0; i++) elevation -= sin(position.x * i * 1.3 - position.z * i) * 0.08 / i;
  return elevation;
}
void main() {
  vec4 modelPosition = modelMatrix * vec4(position, 1.0);
  float elevation = waveElevation(modelPosition.xyz);
  modelPosition.y += elevation;
  vec4 viewPosition = viewMatrix * modelPosition;
  gl_Position = projectionMatrix * viewPosition;
  vElevation = elevation;
  vNormal = (modelMatrix * vec4(normal, 0.0)).xyz;
}`),
    movedInWorld: ([x, y, z]) => {
      let h = sin(x * 2 + time) * sin(z * 1.5 + time) * 0.3
      for (let i = 1; i <= 3; i++) h -= (sin(x * i * 1.3 - z * i) * 0.08) / i
      return [x, y + h, z]
    },
  },
  'a wave in view space': {
    shape: 'plane',
    material: () =>
      makeShaderMaterial(`uniform float uTime;
varying vec3 vNormal;
void main() {
  vNormal = normalize(normalMatrix * normal);
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  mvPosition.y += 0.2 * sin(mvPosition.x * 3.0 + uTime);
  gl_Position = projectionMatrix * mvPosition;
}`),
    movedInView: ([x, y, z]) => [x, y + 0.2 * sin(x * 3 + time), z],
  },
  'a normal that position and light share': {
    shape: 'sphere',
    material: () =>
      makeShaderMaterial(`uniform float uTime;
uniform float uStrength;
varying vec3 vNormal, vEye;
void main() {
  vec3 n = normalize(normal);
  vec3 p = position;
  if (p.y > -2.0) {
    p += n * sin(p.x * 4.0 + uTime) * uStrength * 0.5;
  }
  vec4 eye = modelViewMatrix * vec4(p, 1.0);
  vEye = -eye.xyz;
  /* light */
  vNormal = normalMatrix * n;
  gl_Position = projectionMatrix * eye;
}`),
    moved: ([x, y, z], n) => {
      const h = 0.15 * sin(x * 4 + time)
      return [x + n[0] * h, y + n[1] * h, z + n[2] * h]
    },
  },
  'a varying of the normal that also moves the vertex': {
    shape: 'sphere',
    material: () =>
      makeShaderMaterial(`uniform float uTime;
varying vec3 vNormal;
void main() {
  vNormal = normalize(normal);
  vec3 p = position + vNormal * 0.2 * cos(position.y * 5.0 + uTime);
  vNormal = normalMatrix * vNormal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}`),
    moved: ([x, y, z], n) => {
      const h = 0.2 * cos(y * 5 + time)
      return [x + n[0] * h, y + n[1] * h, z + n[2] * h]
    },
  },
  'a RawShaderMaterial': {
    shape: 'plane',
    material: () =>
      new THREE.RawShaderMaterial({
        glslVersion: THREE.GLSL3,
        uniforms: { uTime: { value: time } },
        vertexShader: `precision highp float;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform mat3 normalMatrix;
uniform float uTime;
in vec3 position;
in vec3 normal;
out vec3 vNormal;
void main() {
  vec3 p = position;
  p.z += 0.3 * sin(p.x * 2.0 + uTime) * p.y;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}`,
        fragmentShader: `precision highp float;
in vec3 vNormal;
out vec4 fragColor;
void main() { fragColor = vec4(normalize(vNormal), 1.0); }`,
      }),
    moved: ([x, y, z]) => [x, y, z + 0.3 * sin(x * 2 + time) * y],
  },
}

const makeWavy = (chunk, material = standard()) =>
  changeShader(
    material,
    '',
    'transformed += vec3(0.1 * sin(4.0 * transformed.y), 0.0, 0.2 * sin(3.0 * transformed.x + uTime));',
    { chunk },
  )
const moveWavy = ([x, y, z]) => [x + 0.1 * sin(4 * y), y, z + 0.2 * sin(3 * x + time)]

/**
 * Materials on meshes with bones or morph targets, and others. If `isPosedFirst`, bones and morph targets apply before the displacement.
 */
export const objects = {
  'bones after the displacement': {
    shape: 'plane',
    kind: 'skin',
    material: () => makeWavy('begin_vertex'),
    moved: moveWavy,
  },
  'bones before the displacement': {
    shape: 'plane',
    kind: 'skin',
    isPosedFirst: true,
    material: () => makeWavy('skinning_vertex'),
    moved: moveWavy,
  },
  'morph targets after the displacement': {
    shape: 'plane',
    kind: 'morph',
    material: () => makeWavy('begin_vertex'),
    moved: moveWavy,
  },
  'morph targets before the displacement': {
    shape: 'plane',
    kind: 'morph',
    isPosedFirst: true,
    material: () => makeWavy('displacementmap_vertex'),
    moved: moveWavy,
  },
  'the back of a material': {
    shape: 'plane',
    isBack: true,
    material: () =>
      makeWavy('begin_vertex', new THREE.MeshStandardMaterial({ side: THREE.BackSide })),
    moved: moveWavy,
  },
  'a displacementMap of three.js': {
    shape: 'plane',
    material: () =>
      new THREE.MeshStandardMaterial({ displacementMap: makeHeightMap(), displacementScale: 0.5 }),
    moved: ([x, y, z], n, [u, v]) => [x, y, z + 0.5 * heightMap(u, v)],
  },
  'a noise of the position in the world': {
    shape: 'sphere',
    material: () =>
      changeShader(
        standard(),
        glslNoise,
        'vec4 inWorld = modelMatrix * vec4(transformed, 1.0);\ntransformed += 0.3 * normal * noise(inWorld.xyz * 1.5);',
      ),
    moved: ([x, y, z], n, uv, instance, world) => {
      const h = 0.3 * noise(...world.map((each) => each * 1.5))
      return [x + n[0] * h, y + n[1] * h, z + n[2] * h]
    },
  },
}

/** Unsupported shaders, which stay as they are, each with a part of the message. */
export const unsupported = {
  'mvPosition on a mesh with bones': {
    kind: 'skin',
    message: /moves mvPosition on a mesh with bones or morph targets/,
    material: () =>
      changeShader(
        standard(),
        '',
        'mvPosition.y += 0.1 * sin(3.0 * mvPosition.x); gl_Position = projectionMatrix * mvPosition;',
        { chunk: 'project_vertex' },
      ),
  },
  'a normal by differences in a ShaderMaterial': {
    message: /writes no varying that depends on the attribute normal/,
    material: () =>
      makeShaderMaterial(`uniform float uTime;
varying vec3 vNormal;
float h(vec2 p) { return 0.3 * sin(p.x * 3.0 + uTime); }
void main() {
  vec3 p = position;
  p.z += h(p.xy);
  float e = 0.01;
  vNormal = normalMatrix * normalize(vec3(h(position.xy - vec2(e, 0.0)) - h(position.xy + vec2(e, 0.0)), 0.0, 2.0 * e));
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}`),
  },
  'a normal from neighbors along a tangent': {
    message:
      /line 7, column 3: the statement "vec3 neighbor = .*" computes a value from both normal and position/,
    material: () =>
      makeShaderMaterial(`uniform float uTime;
varying vec3 vNormal;
vec3 displaced(vec3 p, vec3 n) { return p + n * 0.2 * sin(p.y * 4.0 + uTime); }
void main() {
  vec3 p = displaced(position, normal);
  vec3 tangent = normalize(cross(normal, vec3(0.0, 1.0, 0.01)));
  vec3 neighbor = displaced(position + tangent * 0.01, normal);
  vec3 other = displaced(position + cross(normal, tangent) * 0.01, normal);
  vNormal = normalMatrix * cross(neighbor - p, other - p);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}`),
  },
  'a function that is missing': {
    message: /line 4, column 10: there is no function "wobble"/,
    isBroken: true,
    material: () =>
      makeShaderMaterial(`varying vec3 vNormal;
void main() {
  vec3 p = position;
  p.z += wobble(p.x);
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}`),
  },
}
