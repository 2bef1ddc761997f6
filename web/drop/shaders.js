/** The shaders of the picture: the warped model (lit, as normals, as wireframe) and the unwarped lines of the bounding box. */

const head = '#version 300 es\nprecision highp float;'

/** @param warp the result of `compileWarp` */
export const modelVertex = (warp) => `${head}
in vec3 position, normal;
in vec2 uv;
in vec4 color;
uniform mat4 matrix;
uniform vec3 center;
uniform float unit, amount, time;
/** Moves the depth towards the viewer, so that lines on the surface are visible. */
uniform float nearer;
out vec3 vPosition, vNormal;
out vec2 vUv;
out vec4 vColor;
${warp.declarations}
void main() {
${warp.code}
  vPosition = warpedPosition;
  vNormal = warpedNormal;
  vUv = uv;
  vColor = color;
  gl_Position = matrix * vec4(warpedPosition, 1.0);
  gl_Position.z -= nearer * gl_Position.w;
}`

/** Two lights and a sky, in linear colour. Back faces use the opposite normal. */
export const litFragment = `${head}
in vec3 vPosition, vNormal;
in vec2 vUv;
in vec4 vColor;
uniform vec3 eye, key, rim;
uniform vec4 baseColor;
uniform sampler2D picture;
uniform bool showNormals;
out vec4 result;
void main() {
  float size = length(vNormal);
  vec3 toEye = normalize(eye - vPosition);
  vec3 n = size > 0.0 ? vNormal / size : toEye;
  if (showNormals) {
    result = vec4(0.5 + 0.5 * n, 1.0);
    return;
  }
  if (!gl_FrontFacing) n = -n;
  vec3 albedo = baseColor.rgb * vColor.rgb * texture(picture, vUv).rgb;
  float sky = 0.5 + 0.5 * n.y;
  vec3 light = mix(vec3(0.05, 0.045, 0.07), vec3(0.16, 0.18, 0.25), sky);
  light += vec3(1.0, 0.92, 0.82) * 0.8 * max(dot(n, key), 0.0);
  light += vec3(0.30, 0.42, 0.95) * 0.5 * max(dot(n, rim), 0.0);
  float shine = pow(max(dot(n, normalize(key + toEye)), 0.0), 60.0);
  vec3 linear = albedo * light + vec3(0.22) * shine;
  result = vec4(pow(linear, vec3(1.0 / 2.2)), 1.0);
}`

export const lineFragment = `${head}
uniform vec4 lineColor;
out vec4 result;
void main() { result = lineColor; }`

export const boxVertex = `${head}
in vec3 position;
uniform mat4 matrix;
uniform vec3 low, high;
void main() { gl_Position = matrix * vec4(mix(low, high, position), 1.0); }`
