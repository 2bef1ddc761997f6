/** Complete shaders around a method's code. All methods share these, so that frames differ by the method alone. */

let lastNumber = Math.floor(Math.random() * 2 ** 16)

/** Returns a number that makes a shader's source unique in this visit and, most likely, among those of earlier visits. */
export const nextNumber = () => ++lastNumber

/**
 * @param parts `{ declarations?, body }`: see methods.js
 * @param unique a number from `nextNumber`: a source that was never compiled before cannot come from a cache
 */
export const vertexShader = ({ declarations = '', body }, unique = 1) => `#version 300 es
precision highp float;
in vec3 position, normal;
uniform mat4 camera;
uniform float millis;
out vec3 restPosition, restNormal, point, surfaceNormal;
${declarations}
void main() {
${body}
  restPosition = position;
  restNormal = normal;
  point = moved;
  surfaceNormal = turned;
  gl_PointSize = ${unique.toFixed(1)};
  gl_Position = camera * vec4(moved, 1.0);
}`

const smooth = 'normalize(surfaceNormal)'
/** The normal of the flat triangle, from the screen-space derivatives of the point. */
const flat = 'normalize(cross(dFdx(point), dFdy(point)))'

/** Two lights and a highlight: about p5's work per pixel. @param unique as above; it does not change the picture */
export const fragmentShader = (isFlat, unique = 1) => `#version 300 es
precision highp float;
in vec3 point, surfaceNormal;
uniform vec3 eye;
out vec4 color;
void main() {
  vec3 n = ${isFlat ? flat : smooth};
  vec3 toEye = normalize(eye - point);
  const vec3 key = vec3(0.39, 0.62, 0.68), fill = vec3(-0.78, 0.17, -0.6);
  float highlight = pow(max(dot(n, normalize(key + toEye)), 0.0), ${(60 + (unique % 65536) / 65536).toFixed(6)});
  vec3 light = 0.12 + max(dot(n, key), 0.0) * vec3(1.0, 0.94, 0.87) + max(dot(n, fill), 0.0) * vec3(0.27, 0.39, 0.84);
  color = vec4(vec3(1.0, 0.54, 0.36) * light + 0.5 * highlight, 1.0);
}`

/** Writes a pixel's normal, rest position and rest normal for the oracle instead of a colour. */
export const probeShader = (isFlat) => `#version 300 es
precision highp float;
in vec3 restPosition, restNormal, point, surfaceNormal;
layout(location = 0) out vec4 foundNormal;
layout(location = 1) out vec4 foundPosition;
layout(location = 2) out vec4 foundRestNormal;
void main() {
  foundNormal = vec4(${isFlat ? flat : smooth}, 1.0);
  foundPosition = vec4(restPosition, 1.0);
  foundRestNormal = vec4(restNormal, 1.0);
}`
