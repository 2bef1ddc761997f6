// Habits of people who write vertex shaders, besides the displacements in cases.js. Normals are compared with finite differences of
// positions, which the GPU computes for slightly shifted vertices.
import * as THREE from 'three'
import CustomShaderMaterial from 'three-custom-shader-material/vanilla'
import { addSurfaceVariation, exactNormals } from 'warpjet/three'
import { angle, camera, cross } from './measure.js'
import { probe, renderer } from './probe.js'

const uniform = (value) => ({ value })

/**
 * Returns a function that creates a material whose `onBeforeCompile` replaces parts of its vertex shader: `pairs` of [part, replacement].
 */
const withReplacements =
  (pairs, uniforms = {}, Material = THREE.MeshStandardMaterial, options = {}) =>
  () => {
    const material = new Material(options)
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, uniforms)
      for (const [part, replacement] of pairs)
        shader.vertexShader = shader.vertexShader.replace(part, replacement)
    }
    material.customProgramCacheKey = () => JSON.stringify(pairs)
    return material
  }

const showNormal =
  'varying vec3 vNormal;\nvoid main() { gl_FragColor = vec4(normalize(vNormal), 1.0); }'
/** Returns a function that creates a ShaderMaterial. */
const withShaders =
  (vertexShader, uniforms = {}, options = {}, fragmentShader = showNormal) =>
  () =>
    new THREE.ShaderMaterial({ vertexShader, fragmentShader, uniforms, ...options })

/** Maps what is particular to a shader → [function that creates the material, options of the mesh]. */
export const habits = {
  'a factor that depends on the normal': [
    withShaders(`varying vec3 vNormal;
void main() {
  float k = 0.5;
  k *= sin(normal.x * 4.0) + 2.0;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position + vec3(0.0, 0.0, k * 0.4 * sin(position.x * 3.0)), 1.0);
}`),
  ],
  'a function with an inout parameter and the normal': [
    withShaders(`varying vec3 vNormal;
void push(inout vec3 p, vec3 n) { p += n * 0.3 * sin(p.x * 3.0); }
void main() {
  vNormal = normalMatrix * normal;
  vec3 p = position;
  push(p, normal);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}`),
  ],
  'a varying of the height': [
    withShaders(`varying vec3 vNormal; varying float vHeight;
void main() {
  vNormal = normalMatrix * normal;
  vHeight = 0.3 * sin(position.x * 3.0);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position + normal * vHeight, 1.0);
}`),
  ],
  'statements after an #include on the same line': [
    withReplacements([
      [
        '#include <project_vertex>',
        '#include <project_vertex> mvPosition.y += 0.3 * sin(3.0 * mvPosition.x); gl_Position = projectionMatrix * mvPosition;',
      ],
    ]),
  ],
  'a branch without braces that changes gl_Position': [
    withShaders(
      `varying vec3 vNormal; uniform float isNear;
void main() {
  vec3 p = position + normal * 0.3 * sin(position.x * 3.0);
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
  if (isNear > 0.5) gl_Position.z -= 0.01;
  else gl_Position.z += 0.01;
}`,
      { isNear: uniform(0) },
    ),
  ],
  'tangents of the geometry': [
    withReplacements(
      [
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n#ifdef USE_TANGENT\n transformed.z += tangent.x * 0.3 * sin(position.x * 3.0);\n#endif',
        ],
      ],
      {},
      THREE.MeshPhysicalMaterial,
      { anisotropy: 0.5 },
    ),
    { tangents: true },
  ],
  'an interleaved attribute per instance': [
    withReplacements([
      ['#include <common>', '#include <common>\nattribute float aLift;'],
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n transformed.z += aLift * sin(position.x * 3.0);',
      ],
    ]),
    { instances: true, interleaved: true },
  ],
  'an attribute per instance, compiled before it is drawn': [
    withReplacements([
      ['#include <common>', '#include <common>\nattribute float aLift; //c'],
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n transformed.z += aLift * sin(position.x * 3.0);',
      ],
    ]),
    { instances: true, interleaved: true, isCompiledFirst: true },
  ],
  'functions above main, and uniforms with names of inputs': [
    withReplacements(
      [
        [
          'void main() {',
          'uniform float size; uniform vec2 mouse;\nfloat wave(float x) { return sin(x * size) * mouse.y; }\nvoid main() {',
        ],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n transformed.z += wave(transformed.x);',
        ],
      ],
      { size: uniform(3), mouse: uniform(new THREE.Vector2(0, 0.3)) },
    ),
  ],
  'int and bool uniforms': [
    withReplacements(
      [
        [
          '#include <common>',
          '#include <common>\nuniform int octaves; uniform bool isOn; uniform float k[3];',
        ],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n if (isOn) { float a = 0.3; for (int i = 0; i < 8; i++) { if (i >= octaves) break; transformed.z += a * sin(position.x * k[i % 3]); a *= 0.5; } }',
        ],
      ],
      { octaves: uniform(3), isOn: uniform(true), k: uniform([2, 3.5, 5]) },
    ),
  ],
  'struct uniforms': [
    withReplacements(
      [
        [
          '#include <common>',
          '#include <common>\nstruct Wave { vec2 d; float a; }; uniform Wave ws[2];',
        ],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n for (int i = 0; i < 2; i++) transformed.z += ws[i].a * sin(dot(ws[i].d, position.xy));',
        ],
      ],
      {
        ws: uniform([
          { d: new THREE.Vector2(2, 1), a: 0.2 },
          { d: new THREE.Vector2(-1, 3), a: 0.1 },
        ]),
      },
    ),
  ],
  'an array of vec3 set by a Float32Array': [
    withReplacements(
      [
        ['#include <common>', '#include <common>\nuniform vec3 pts[2];'],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n for (int i = 0; i < 2; i++) transformed.z += 0.3 * exp(-2.0 * distance(position, pts[i]));',
        ],
      ],
      { pts: uniform(new Float32Array([0.11, 0.21, 0.1, -0.3, -0.43, 0.2])) },
    ),
  ],
  'an array of vec3 set by a Float32Array, with normals at pixels': [
    withReplacements(
      [
        ['#include <common>', '#include <common>\nuniform vec3 pts[2];//p'],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n for (int i = 0; i < 2; i++) transformed.z += 0.3 * exp(-2.0 * distance(position, pts[i]));',
        ],
      ],
      { pts: uniform(new Float32Array([0.11, 0.21, 0.1, -0.3, -0.43, 0.2])) },
    ),
    { normals: 'pixel' },
  ],
  'matrix uniforms': [
    withReplacements(
      [
        ['#include <common>', '#include <common>\nuniform mat4 bend; uniform mat3 rot;'],
        [
          '#include <begin_vertex>',
          'vec3 transformed = rot * (bend * vec4(position, 1.0)).xyz; transformed.z += 0.2 * sin(4.0 * transformed.x);',
        ],
      ],
      {
        bend: uniform(new THREE.Matrix4().makeRotationX(0.4)),
        rot: uniform(new THREE.Matrix3().set(1, 0.2, 0, 0, 1.3, 0, 0.1, 0, 0.7)),
      },
    ),
  ],
  'more uniforms with names of inputs': [
    withReplacements(
      [
        [
          '#include <common>',
          '#include <common>\nuniform vec3 color; uniform float width; uniform float time; uniform float instance;',
        ],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n transformed.z += color.r * sin(width * position.x + time) + instance;',
        ],
      ],
      {
        color: uniform(new THREE.Color(0.3, 0.5, 0.6)),
        width: uniform(3),
        time: uniform(1),
        instance: uniform(0.2),
      },
    ),
  ],
  'gl_Position changes after the projection': [
    withReplacements([
      [
        '#include <project_vertex>',
        '#include <project_vertex>\n gl_Position.y += 0.2 * gl_Position.x * gl_Position.x / 25.0;',
      ],
    ]),
  ],
  'mvPosition changes': [
    withReplacements([
      [
        '#include <project_vertex>',
        '#include <project_vertex>\n mvPosition.y += 0.1 * sin(3.0 * mvPosition.x); gl_Position = projectionMatrix * mvPosition;',
      ],
    ]),
  ],
  'instances that bend in world space': [
    withReplacements([
      [
        '#include <project_vertex>',
        'vec4 mvPosition = vec4(transformed, 1.0);\n#ifdef USE_INSTANCING\nmvPosition = instanceMatrix * mvPosition;\n#endif\nvec4 wp = modelMatrix * mvPosition; wp.x += 0.3 * sin(wp.y * 3.0) ; mvPosition = viewMatrix * wp; gl_Position = projectionMatrix * mvPosition;',
      ],
    ]),
    { instances: true },
  ],
  'mvPosition changes, with instances': [
    withReplacements([
      [
        '#include <project_vertex>',
        '#include <project_vertex>\n mvPosition.y += 0.1 * sin(3.0 * mvPosition.x); gl_Position = projectionMatrix * mvPosition; //i',
      ],
    ]),
    { instances: true },
  ],
  'a position snapped to pixels': [
    withShaders(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * normal; vec4 clip = projectionMatrix * modelViewMatrix * vec4(p, 1.0); clip.xy = floor(clip.xy * 90.0) / 90.0; gl_Position = clip; }',
    ),
  ],
  tangent: [
    withReplacements([
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n#ifdef USE_TANGENT\n transformed += tangent.xyz * 0.2 * sin(position.x * 3.0);\n#endif\ntransformed.z += 0.2 * sin(4.0 * position.x);',
      ],
    ]),
  ],
  gl_VertexID: [
    withReplacements([
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n transformed.z += 0.01 * float(gl_VertexID % 2);',
      ],
    ]),
  ],
  'attribute per vertex': [
    withReplacements([
      ['#include <common>', '#include <common>\nattribute float aHeight;'],
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n transformed.z += aHeight * sin(position.x);',
      ],
    ]),
    { attribute: true },
  ],
  macros: [
    withReplacements([
      [
        '#include <common>',
        '#include <common>\n#define WAVE(x, k) (0.2 * sin((x) * (k)))\n#define AXES xy\n#if 1\nconst float A = 1.5;\n#else\n broken\n#endif',
      ],
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n transformed.z += A * WAVE(transformed.AXES.x, 3.0);',
      ],
    ]),
  ],
  'out parameters': [
    withReplacements([
      [
        '#include <common>',
        '#include <common>\nvoid displace(inout vec3 p, out float h) { h = 0.3 * sin(p.x * 3.0); p.z += h; }\nvarying float vH;',
      ],
      ['#include <begin_vertex>', '#include <begin_vertex>\n displace(transformed, vH);'],
    ]),
  ],
  'a while loop': [
    withReplacements([
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n float f = 1.0; int n = 0; while (n < 3) { transformed.z += sin(position.y * f * 2.0) / f * 0.2; f *= 2.0; n++; }',
      ],
    ]),
  ],
  'value noise with a hash of fract and sin': [
    withReplacements([
      [
        '#include <common>',
        '#include <common>\nfloat hsh(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453123); }\nfloat vn(vec2 p) { vec2 i = floor(p), f = fract(p); vec2 u = f * f * (3.0 - 2.0 * f); return mix(mix(hsh(i), hsh(i + vec2(1, 0)), u.x), mix(hsh(i + vec2(0, 1)), hsh(i + vec2(1, 1)), u.x), u.y); }',
      ],
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n transformed.z += 0.4 * vn(position.xy * 2.7 + 0.3);',
      ],
    ]),
  ],
  vertexColors: [
    withReplacements(
      [
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n transformed.z += color.r * sin(position.x * 3.0);',
        ],
      ],
      {},
      undefined,
      { vertexColors: true },
    ),
    { colors: true },
  ],
  vUv: [
    withReplacements(
      [
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n transformed.z += 0.3 * sin(vMapUv.x * 9.0);',
        ],
      ],
      {},
      undefined,
      { map: new THREE.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1) },
    ),
  ],
  texelFetch: [
    withReplacements(
      [
        ['#include <common>', '#include <common>\nuniform highp sampler2D tx;'],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n vec4 q = texelFetch(tx, ivec2(1, 0), 0); transformed.z += q.r * sin(position.x * 3.0);',
        ],
      ],
      {
        tx: uniform(
          (() => {
            const t = new THREE.DataTexture(
              new Float32Array([1, 0, 0, 1, 0.3, 0, 0, 1]),
              2,
              1,
              THREE.RGBAFormat,
              THREE.FloatType,
            )
            t.needsUpdate = true
            return t
          })(),
        ),
      },
    ),
  ],
  'null texture': [
    withReplacements(
      [
        ['#include <common>', '#include <common>\nuniform sampler2D tx;'],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n transformed.z += texture2D(tx, uv).r + sin(position.x * 3.0) * 0.2;',
        ],
      ],
      { tx: uniform(null) },
    ),
  ],
  'distance to camera': [
    withReplacements([
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n vec4 ww = modelMatrix * vec4(transformed, 1.0); float dd = distance(ww.xyz, cameraPosition); transformed.z += 0.2 * sin(dd * 5.0);',
      ],
    ]),
  ],
  'a ShaderMaterial of chunks': [
    () =>
      new THREE.ShaderMaterial({
        vertexShader: THREE.ShaderLib.phong.vertexShader.replace(
          '#include <begin_vertex>',
          'vec3 transformed = position + normal * 0.3 * sin(position.x * 4.0);',
        ),
        fragmentShader: THREE.ShaderLib.phong.fragmentShader,
        uniforms: THREE.UniformsUtils.clone(THREE.ShaderLib.phong.uniforms),
        lights: true,
      }),
    { chunks: true },
  ],
  'a Fresnel term': [
    withShaders(
      'varying vec3 vNormal; varying float vF; uniform float t;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0 + t); vec4 world = modelMatrix * vec4(p, 1.0); vec3 wn = normalize(mat3(modelMatrix) * normal); vF = dot(wn, normalize(cameraPosition - world.xyz)); vNormal = normalMatrix * normal; gl_Position = projectionMatrix * viewMatrix * world; }',
      { t: uniform(1) },
    ),
  ],
  'instances in a ShaderMaterial': [
    withShaders(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * mat3(instanceMatrix) * normal; gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(p, 1.0); }',
    ),
    { instances: true },
  ],
  defines: [
    withShaders(
      'varying vec3 vNormal;\nvoid main() {\n vec3 p = position;\n#ifdef WAVE\n p.z += 0.3 * sin(p.x * AMOUNT);\n#endif\n vNormal = normalMatrix * normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
      {},
      { defines: { WAVE: '', AMOUNT: '3.0' } },
    ),
  ],
  fog: [
    withShaders(
      'varying vec3 vNormal;\n#include <common>\n#include <fog_pars_vertex>\nvoid main() {\n vec3 p = position; p.z += 0.3 * sin(p.x * 3.0);\n vec4 mvPosition = modelViewMatrix * vec4(p, 1.0);\n vNormal = normalMatrix * normal; gl_Position = projectionMatrix * mvPosition;\n#include <fog_vertex>\n }',
    ),
  ],
  'a normal matrix by hand': [
    withShaders(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position + normal * 0.3 * sin(position.x * 3.0); mat3 nm = transpose(inverse(mat3(modelViewMatrix))); vNormal = normalize(nm * normal); gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
    ),
  ],
  'GLSL ES 3.00': [
    withShaders(
      'out vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
      {},
      { glslVersion: THREE.GLSL3 },
      'in vec3 vNormal;\nout vec4 fragColor;\nvoid main() { fragColor = vec4(normalize(vNormal), 1.0); }',
    ),
  ],
  'a function that sets the varying': [
    withShaders(
      'varying vec3 vNormal;\nvoid light() { vNormal = normalMatrix * normal; }\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); light(); gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
    ),
  ],
  'functions that take the normal': [
    withShaders(
      'varying vec3 vNormal;\nvec3 toView(vec3 n) { return normalMatrix * n; }\nvec3 displaced(vec3 p, vec3 n) { return p + n * 0.3 * sin(p.x * 3.0); }\nvoid main() { vNormal = toView(normal); gl_Position = projectionMatrix * modelViewMatrix * vec4(displaced(position, normal), 1.0); }',
    ),
  ],
  'position and light in one branch': [
    withShaders(
      'varying vec3 vNormal; uniform float k;\nvoid main() { vec3 p = position; if (k > 0.5) { p.z += 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * normal; } else { vNormal = normalMatrix * normal; } gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
      { k: uniform(1) },
    ),
  ],
  'a product of matrices': [
    withShaders(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); mat4 mvp = projectionMatrix * modelViewMatrix; vNormal = normalMatrix * normal; gl_Position = mvp * vec4(p, 1.0); }',
    ),
  ],
  'a varying that changes': [
    withShaders(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); vNormal = normal; vNormal = normalMatrix * vNormal; vNormal *= 2.0; gl_Position = projectionMatrix * (modelViewMatrix * vec4(p, 1.0)); }',
    ),
  ],
  'two variables in one declaration': [
    withShaders(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position, n = normal; p += n * 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * n; gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
    ),
  ],
  'csm_Position and a varying': [
    () =>
      new CustomShaderMaterial({
        baseMaterial: THREE.MeshPhongMaterial,
        vertexShader:
          'varying float vE; uniform float uT; void main() { vE = sin(position.x * 3.0 + uT) * 0.3; vec3 q = position; q.z += vE; csm_Position = q; }',
        uniforms: { uT: uniform(0.5) },
      }),
    { chunks: true },
  ],
  csm_PositionRaw: [
    () =>
      new CustomShaderMaterial({
        baseMaterial: THREE.MeshPhongMaterial,
        vertexShader:
          'void main() { vec3 q = position; q.z += 0.3 * sin(3.0 * q.x); csm_PositionRaw = projectionMatrix * modelViewMatrix * vec4(q, 1.0); }',
      }),
    { chunks: true },
  ],
}

/** Makes a plane whose vertices are shifted within the plane. */
async function makePlane([dx, dy], { attribute, colors, tangents, interleaved }) {
  const geometry = new THREE.PlaneGeometry(2, 2, 20, 20)
  const { position, uv } = geometry.attributes
  for (let i = 0; i < position.count; i++) {
    position.setXY(i, position.getX(i) + dx, position.getY(i) + dy)
    uv.setXY(i, uv.getX(i) + dx / 2, uv.getY(i) + dy / 2)
  }
  const addAttribute = (name, size, valueAt) =>
    geometry.setAttribute(
      name,
      new THREE.BufferAttribute(
        Float32Array.from({ length: size * position.count }, (_, i) => valueAt(i)),
        size,
      ),
    )
  if (attribute) addAttribute('aHeight', 1, (i) => (i % 7) / 20)
  if (colors) addAttribute('color', 3, () => 0.3)
  if (tangents) addAttribute('tangent', 4, (i) => Number(i % 4 === 0 || i % 4 === 3))
  if (interleaved) {
    const lifts = new THREE.InstancedInterleavedBuffer(new Float32Array([0.2, 0.3, 0.4]), 1)
    geometry.setAttribute('aLift', new THREE.InterleavedBufferAttribute(lifts, 1, 0))
  }
  await addSurfaceVariation(geometry)
  return geometry
}

function makeMesh(geometry, material, { instances }) {
  const mesh = instances
    ? new THREE.InstancedMesh(geometry, material, 3)
    : new THREE.Mesh(geometry, material)
  for (let i = 0; instances && i < 3; i++)
    mesh.setMatrixAt(i, new THREE.Matrix4().makeRotationY(i).setPosition(i * 0.4 - 1, 0, 0))
  mesh.rotation.set(0.4, 0.5, 0.1)
  mesh.scale.set(1.2, 0.8, 1)
  mesh.updateMatrixWorld()
  return mesh
}

const step = 2e-3
const shifts = [
  [step, 0],
  [-step, 0],
  [0, step],
  [0, -step],
]

/**
 * Returns `own`, the 95th percentile of the errors of a material's normals, in degrees; `exact`, the same with `exactNormals`; and whether
 * positions stay the same.
 */
export async function measureHabit(name) {
  const [create, needs = {}] = habits[name]
  const plain = create()
  const output = needs.chunks || !plain.isShaderMaterial ? 'vec4(normal, 1.0)' : undefined
  const draw = async (material, shift, isClip) =>
    probe(makeMesh(await makePlane(shift, needs), material, needs), camera, output, isClip)
  const material = exactNormals(create(), { normals: needs.normals })
  if (needs.isCompiledFirst)
    renderer.compile(
      new THREE.Scene().add(makeMesh(await makePlane([0, 0], needs), material, needs)),
      camera,
    )
  const own = await draw(plain, [0, 0])
  const exact = await draw(material, [0, 0])
  const clips = [await draw(plain, [0, 0], true), await draw(material, [0, 0], true)]
  const shifted = []
  for (const shift of shifts) shifted.push(await draw(plain, shift, true))
  const toView = (clip, i) => {
    const { x, y, z, w } = new THREE.Vector4(...clip.subarray(4 * i, 4 * i + 4)).applyMatrix4(
      camera.projectionMatrixInverse,
    )
    return [x / w, y / w, z / w]
  }
  const percentileOfErrors = (normals) => {
    const errors = Array.from({ length: normals.length / 4 }, (_, i) => {
      const [a, b, c, d] = shifted.map((clip) => toView(clip, i))
      const normal = cross(
        a.map((x, k) => x - b[k]),
        c.map((x, k) => x - d[k]),
      )
      return angle(normal, [...normals.subarray(4 * i, 4 * i + 3)])
    }).sort((a, b) => a - b)
    return errors[Math.floor(0.95 * errors.length)]
  }
  return {
    own: percentileOfErrors(own),
    exact: percentileOfErrors(exact),
    hasSamePositions: clips[0].every((number, i) => Object.is(number, clips[1][i])),
  }
}
