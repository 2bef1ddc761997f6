import * as THREE from 'three'
import CSM from 'three-custom-shader-material/vanilla'
import { exactNormals, addSurfaceVariation } from 'warpjet/three'
import { probe } from './probe.js'
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50)
camera.position.set(0.4, 1.2, 5)
camera.lookAt(0, 0, 0)
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const angle = (a, b) => (Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)) * 180) / Math.PI
const ob =
  (f, M = THREE.MeshStandardMaterial, o) =>
  () => {
    const m = new M(o)
    m.onBeforeCompile = f
    m.customProgramCacheKey = () => f.toString()
    return m
  }
const rep = (pairs, uniforms = {}) =>
  ob((s) => {
    Object.assign(s.uniforms, uniforms)
    for (const [a, b] of pairs) s.vertexShader = s.vertexShader.replace(a, b)
  })
const repK = (pairs, uniforms, M, o) => () => {
  const m = new (M ?? THREE.MeshStandardMaterial)(o)
  m.onBeforeCompile = (s) => {
    Object.assign(s.uniforms, uniforms ?? {})
    for (const [a, b] of pairs) s.vertexShader = s.vertexShader.replace(a, b)
  }
  m.customProgramCacheKey = () => JSON.stringify(pairs)
  return m
}
const sm =
  (
    v,
    uniforms = {},
    o = {},
    f = 'varying vec3 vNormal;\nvoid main() { gl_FragColor = vec4(normalize(vNormal), 1.0); }',
  ) =>
  () =>
    new THREE.ShaderMaterial({ vertexShader: v, fragmentShader: f, uniforms, ...o })
const u = (x) => ({ value: x })
export const cases = {
  'before main': [
    repK(
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
      { size: u(3), mouse: u(new THREE.Vector2(0, 0.3)) },
    ),
  ],
  'int and bool uniforms': [
    repK(
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
      { octaves: u(3), isOn: u(true), k: u([2, 3.5, 5]) },
    ),
  ],
  'struct uniforms': [
    repK(
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
        ws: u([
          { d: new THREE.Vector2(2, 1), a: 0.2 },
          { d: new THREE.Vector2(-1, 3), a: 0.1 },
        ]),
      },
    ),
  ],
  'vec3 array flat': [
    repK(
      [
        ['#include <common>', '#include <common>\nuniform vec3 pts[2];'],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n for (int i = 0; i < 2; i++) transformed.z += 0.3 * exp(-2.0 * distance(position, pts[i]));',
        ],
      ],
      { pts: u(new Float32Array([0.11, 0.21, 0.1, -0.3, -0.43, 0.2])) },
    ),
  ],
  'vec3 array flat pixel': [
    repK(
      [
        ['#include <common>', '#include <common>\nuniform vec3 pts[2];//p'],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n for (int i = 0; i < 2; i++) transformed.z += 0.3 * exp(-2.0 * distance(position, pts[i]));',
        ],
      ],
      { pts: u(new Float32Array([0.11, 0.21, 0.1, -0.3, -0.43, 0.2])) },
    ),
    { normals: 'pixel' },
  ],
  'matrix uniform': [
    repK(
      [
        ['#include <common>', '#include <common>\nuniform mat4 bend; uniform mat3 rot;'],
        [
          '#include <begin_vertex>',
          'vec3 transformed = rot * (bend * vec4(position, 1.0)).xyz; transformed.z += 0.2 * sin(4.0 * transformed.x);',
        ],
      ],
      {
        bend: u(new THREE.Matrix4().makeRotationX(0.4)),
        rot: u(new THREE.Matrix3().set(1, 0.2, 0, 0, 1.3, 0, 0.1, 0, 0.7)),
      },
    ),
  ],
  'color uniform, inputs names': [
    repK(
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
      { color: u(new THREE.Color(0.3, 0.5, 0.6)), width: u(3), time: u(1), instance: u(0.2) },
    ),
  ],
  'after project': [
    repK([
      [
        '#include <project_vertex>',
        '#include <project_vertex>\n gl_Position.y += 0.2 * gl_Position.x * gl_Position.x / 25.0;',
      ],
    ]),
  ],
  'mv after project': [
    repK([
      [
        '#include <project_vertex>',
        '#include <project_vertex>\n mvPosition.y += 0.1 * sin(3.0 * mvPosition.x); gl_Position = projectionMatrix * mvPosition;',
      ],
    ]),
  ],
  'instances wind after': [
    repK([
      [
        '#include <project_vertex>',
        'vec4 mvPosition = vec4(transformed, 1.0);\n#ifdef USE_INSTANCING\nmvPosition = instanceMatrix * mvPosition;\n#endif\nvec4 wp = modelMatrix * mvPosition; wp.x += 0.3 * sin(wp.y * 3.0) ; mvPosition = viewMatrix * wp; gl_Position = projectionMatrix * mvPosition;',
      ],
    ]),
    { instances: true },
  ],
  'mv after project, instances': [
    repK([
      [
        '#include <project_vertex>',
        '#include <project_vertex>\n mvPosition.y += 0.1 * sin(3.0 * mvPosition.x); gl_Position = projectionMatrix * mvPosition; //i',
      ],
    ]),
    { instances: true },
  ],
  'clip var': [
    sm(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * normal; vec4 clip = projectionMatrix * modelViewMatrix * vec4(p, 1.0); clip.xy = floor(clip.xy * 90.0) / 90.0; gl_Position = clip; }',
    ),
  ],
  tangent: [
    repK([
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n#ifdef USE_TANGENT\n transformed += tangent.xyz * 0.2 * sin(position.x * 3.0);\n#endif\ntransformed.z += 0.2 * sin(4.0 * position.x);',
      ],
    ]),
  ],
  gl_VertexID: [
    repK([
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n transformed.z += 0.01 * float(gl_VertexID % 2);',
      ],
    ]),
  ],
  'attribute per vertex': [
    repK([
      ['#include <common>', '#include <common>\nattribute float aHeight;'],
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n transformed.z += aHeight * sin(position.x);',
      ],
    ]),
    { attribute: true },
  ],
  macro: [
    repK([
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
    repK([
      [
        '#include <common>',
        '#include <common>\nvoid displace(inout vec3 p, out float h) { h = 0.3 * sin(p.x * 3.0); p.z += h; }\nvarying float vH;',
      ],
      ['#include <begin_vertex>', '#include <begin_vertex>\n displace(transformed, vH);'],
    ]),
  ],
  'while and hash': [
    repK([
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n float f = 1.0; int n = 0; while (n < 3) { transformed.z += sin(position.y * f * 2.0) / f * 0.2; f *= 2.0; n++; }',
      ],
    ]),
  ],
  'fract sin hash noise': [
    repK([
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
    repK(
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
    repK(
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
    repK(
      [
        ['#include <common>', '#include <common>\nuniform highp sampler2D tx;'],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n vec4 q = texelFetch(tx, ivec2(1, 0), 0); transformed.z += q.r * sin(position.x * 3.0);',
        ],
      ],
      {
        tx: u(
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
    repK(
      [
        ['#include <common>', '#include <common>\nuniform sampler2D tx;'],
        [
          '#include <begin_vertex>',
          '#include <begin_vertex>\n transformed.z += texture2D(tx, uv).r + sin(position.x * 3.0) * 0.2;',
        ],
      ],
      { tx: u(null) },
    ),
  ],
  'distance to camera': [
    repK([
      [
        '#include <begin_vertex>',
        '#include <begin_vertex>\n vec4 ww = modelMatrix * vec4(transformed, 1.0); float dd = distance(ww.xyz, cameraPosition); transformed.z += 0.2 * sin(dd * 5.0);',
      ],
    ]),
  ],
  'phong chunk shader material': [
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
  'sm fresnel': [
    sm(
      'varying vec3 vNormal; varying float vF; uniform float t;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0 + t); vec4 world = modelMatrix * vec4(p, 1.0); vec3 wn = normalize(mat3(modelMatrix) * normal); vF = dot(wn, normalize(cameraPosition - world.xyz)); vNormal = normalMatrix * normal; gl_Position = projectionMatrix * viewMatrix * world; }',
      { t: u(1) },
    ),
  ],
  'sm instanced': [
    sm(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * mat3(instanceMatrix) * normal; gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(p, 1.0); }',
    ),
    { instances: true },
  ],
  'sm ifdef': [
    sm(
      'varying vec3 vNormal;\nvoid main() {\n vec3 p = position;\n#ifdef WAVE\n p.z += 0.3 * sin(p.x * AMOUNT);\n#endif\n vNormal = normalMatrix * normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
      {},
      { defines: { WAVE: '', AMOUNT: '3.0' } },
    ),
  ],
  'sm fog chunk': [
    sm(
      'varying vec3 vNormal;\n#include <common>\n#include <fog_pars_vertex>\nvoid main() {\n vec3 p = position; p.z += 0.3 * sin(p.x * 3.0);\n vec4 mvPosition = modelViewMatrix * vec4(p, 1.0);\n vNormal = normalMatrix * normal; gl_Position = projectionMatrix * mvPosition;\n#include <fog_vertex>\n }',
    ),
  ],
  'sm transposed inverse': [
    sm(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position + normal * 0.3 * sin(position.x * 3.0); mat3 nm = transpose(inverse(mat3(modelViewMatrix))); vNormal = normalize(nm * normal); gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
    ),
  ],
  'sm glsl3': [
    sm(
      'out vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
      {},
      { glslVersion: THREE.GLSL3 },
      'in vec3 vNormal;\nout vec4 fragColor;\nvoid main() { fragColor = vec4(normalize(vNormal), 1.0); }',
    ),
  ],
  'sm function sets varying': [
    sm(
      'varying vec3 vNormal;\nvoid light() { vNormal = normalMatrix * normal; }\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); light(); gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
    ),
  ],
  'sm helper takes normal': [
    sm(
      'varying vec3 vNormal;\nvec3 toView(vec3 n) { return normalMatrix * n; }\nvec3 displaced(vec3 p, vec3 n) { return p + n * 0.3 * sin(p.x * 3.0); }\nvoid main() { vNormal = toView(normal); gl_Position = projectionMatrix * modelViewMatrix * vec4(displaced(position, normal), 1.0); }',
    ),
  ],
  'sm position in if': [
    sm(
      'varying vec3 vNormal; uniform float k;\nvoid main() { vec3 p = position; if (k > 0.5) { p.z += 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * normal; } else { vNormal = normalMatrix * normal; } gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
      { k: u(1) },
    ),
  ],
  'sm matrix mult order': [
    sm(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); mat4 mvp = projectionMatrix * modelViewMatrix; vNormal = normalMatrix * normal; gl_Position = mvp * vec4(p, 1.0); }',
    ),
  ],
  'sm compound': [
    sm(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position; p.z += 0.3 * sin(p.x * 3.0); vNormal = normal; vNormal = normalMatrix * vNormal; vNormal *= 2.0; gl_Position = projectionMatrix * (modelViewMatrix * vec4(p, 1.0)); }',
    ),
  ],
  'sm two declared': [
    sm(
      'varying vec3 vNormal;\nvoid main() { vec3 p = position, n = normal; p += n * 0.3 * sin(p.x * 3.0); vNormal = normalMatrix * n; gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0); }',
    ),
  ],
  'csm FD and varyings': [
    () =>
      new CSM({
        baseMaterial: THREE.MeshPhongMaterial,
        vertexShader:
          'varying float vE; uniform float uT; void main() { vE = sin(position.x * 3.0 + uT) * 0.3; vec3 q = position; q.z += vE; csm_Position = q; }',
        uniforms: { uT: u(0.5) },
      }),
    { chunks: true },
  ],
  'csm raw': [
    () =>
      new CSM({
        baseMaterial: THREE.MeshPhongMaterial,
        vertexShader:
          'void main() { vec3 q = position; q.z += 0.3 * sin(3.0 * q.x); csm_PositionRaw = projectionMatrix * modelViewMatrix * vec4(q, 1.0); }',
      }),
    { chunks: true },
  ],
}
const bump = (dx, dy) => {
  const g = new THREE.PlaneGeometry(2, 2, 20, 20)
  const { position, uv } = g.attributes
  for (let i = 0; i < position.count; i++) {
    position.setXY(i, position.getX(i) + dx, position.getY(i) + dy)
    uv.setXY(i, uv.getX(i) + dx / 2, uv.getY(i) + dy / 2)
  }
  return g
}
globalThis.adhoc = {
  names: Object.keys(cases),
  async run(name, normals) {
    const [make, { instances, attribute, colors, chunks, normals: wanted } = {}] = cases[name]
    const prepare = async (g) => {
      const n = g.attributes.position.count
      if (attribute)
        g.setAttribute(
          'aHeight',
          new THREE.BufferAttribute(
            Float32Array.from({ length: n }, (_, i) => (i % 7) / 20),
            1,
          ),
        )
      if (colors)
        g.setAttribute(
          'color',
          new THREE.BufferAttribute(
            Float32Array.from({ length: 3 * n }, () => 0.3),
            3,
          ),
        )
      await addSurfaceVariation(g)
      return g
    }
    const mesh = (g, m) => {
      const o = instances ? new THREE.InstancedMesh(g, m, 3) : new THREE.Mesh(g, m)
      if (instances)
        for (let i = 0; i < 3; i++)
          o.setMatrixAt(i, new THREE.Matrix4().makeRotationY(i).setPosition(i * 0.4 - 1, 0, 0))
      o.rotation.set(0.4, 0.5, 0.1)
      o.scale.set(1.2, 0.8, 1)
      o.updateMatrixWorld()
      return o
    }
    const plain = make()
    const isChunks = chunks || !plain.isShaderMaterial
    const shows = isChunks ? 'vec4(normal, 1.0)' : undefined
    const own = probe(mesh(await prepare(bump(0, 0)), plain), camera, shows)
    const m = make()
    if (normals) exactNormals(m, { normals: wanted ?? normals })
    const g = await prepare(bump(0, 0))
    const o = mesh(g, m)
    const shown = probe(o, camera, shows)
    const clip = probe(o, camera, shows, true)
    const e = 2e-3
    const sides = []
    const at = plain
    for (const [dx, dy] of [
      [e, 0],
      [-e, 0],
      [0, e],
      [0, -e],
      [0, 0],
    ]) {
      const gg = await prepare(bump(dx, dy))
      sides.push([...probe(mesh(gg, at), camera, shows, true)])
    }
    const back = camera.projectionMatrixInverse
    const view = (a, i) => {
      const v = new THREE.Vector4(...a.slice(4 * i, 4 * i + 4)).applyMatrix4(back)
      return [v.x / v.w, v.y / v.w, v.z / v.w]
    }
    const errors = [],
      before = []
    let far = 0
    for (let i = 0; i < shown.length / 4; i++) {
      const [a, b, c, d] = sides.slice(0, 4).map((s) => view(s, i))
      const n = cross(
        a.map((x, k) => x - b[k]),
        c.map((x, k) => x - d[k]),
      )
      errors.push(angle(n, [...shown.subarray(4 * i, 4 * i + 3)]))
      before.push(angle(n, [...own.subarray(4 * i, 4 * i + 3)]))
      for (let k = 0; k < 4; k++)
        far = Math.max(far, Math.abs(clip[4 * i + k] - sides[4][4 * i + k]))
    }
    errors.sort((a, b) => a - b)
    before.sort((a, b) => a - b)
    const q = (l, t) => +l[Math.min(l.length - 1, Math.floor(l.length * t))].toFixed(3)
    return {
      median: q(errors, 0.5),
      p95: q(errors, 0.95),
      worst: q(errors, 1),
      before: q(before, 0.5),
      far,
    }
  },
}
document.title = 'ready'
