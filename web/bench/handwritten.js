/**
 * Handwritten derivatives, as an expert of calculus and GLSL would write them in an afternoon: statements that compute, from `position`
 * and `millis`, `vec3 offset` and the columns `vec3 dx, dy, dz` of its Jacobian.
 */

const floatLiteral = (number) => (Number.isInteger(number) ? `${number}.0` : String(number))
const axes = ['x', 'y', 'z']

/** The waves of tests/warps/stress.js: per wave one line for the angle, one for the sum and one for the slope. */
export const stackedSines = (waves) => `
  vec3 offset = vec3(0.0), dx = vec3(0.0), dy = vec3(0.0), dz = vec3(0.0);
  float angle;
${waves
  .map(({ component, coordinate, frequency, speed, amplitude }) => {
    const [to, from] = [axes[component], axes[coordinate]]
    const scale = amplitude / waves.length
    return `  angle = position.${from} * ${floatLiteral(frequency)} + millis * ${floatLiteral(speed)};
  offset.${to} += sin(angle) * ${floatLiteral(scale)};
  d${from}.${to} += cos(angle) * ${floatLiteral(scale * frequency)};`
  })
  .join('\n')}`

export const airplaneTwist = `
  float rate = 0.015 * sin(millis / 1200.0);
  float angle = rate * position.x, c = cos(angle), s = sin(angle);
  vec3 warped = vec3(position.x, position.y * c - position.z * s, position.y * s + position.z * c);
  vec3 offset = warped - position;
  vec3 dx = rate * vec3(0.0, -warped.z, warped.y);
  vec3 dy = vec3(0.0, c - 1.0, s), dz = vec3(0.0, -s, c - 1.0);`

/**
 * Rotates about the axis through (0, 0, -500) along x. The derivative of a rotated point is the rotated derivative of the point, plus a
 * term from the derivative of the angle.
 */
export const wobble = `
  float t = millis / 1000.0, x = position.x, y = position.y, z = position.z;
  float a = 2.0 * t + 0.03 * y, b = 1.3 * t + 0.025 * z, d = t - 0.04 * x, e = 1.7 * t + 0.02 * x;
  vec3 p = position + vec3(8.0 * sin(a), 8.0 * sin(b) + 4.0 * sin(d), 8.0 * sin(e));
  vec3 mx = vec3(1.0, -0.16 * cos(d), 0.16 * cos(e));
  vec3 my = vec3(0.24 * cos(a), 1.0, 0.0);
  vec3 mz = vec3(0.0, 0.2 * cos(b), 1.0);

  float strength = mix(0.004, 0.008, 0.5 * sin(t) + 0.5);
  float wanted = p.x * strength, angle = clamp(wanted, -0.5, 0.6);
  float rate = wanted == angle ? strength : 0.0;
  float c = cos(angle), s = sin(angle);
  vec2 q = vec2(p.y * c - (p.z + 500.0) * s, p.y * s + (p.z + 500.0) * c);
  vec2 across = rate * vec2(-q.y, q.x);
  vec2 qx = vec2(mx.y * c - mx.z * s, mx.y * s + mx.z * c) + across;
  vec2 qy = vec2(c, s) + across * my.x;
  vec2 qz = vec2(mz.y * c - s, mz.y * s + c);

  wanted = 0.001 * y + 0.3 * sin(0.7 * t);
  angle = clamp(wanted, -0.3, 0.35);
  rate = wanted == angle ? 0.001 : 0.0;
  c = cos(angle);
  s = sin(angle);
  vec2 r = vec2(q.x * c - q.y * s, q.x * s + q.y * c);
  vec2 rx = vec2(qx.x * c - qx.y * s, qx.x * s + qx.y * c);
  vec2 ry = vec2(qy.x * c - qy.y * s, qy.x * s + qy.y * c) + rate * vec2(-r.y, r.x);
  vec2 rz = vec2(qz.x * c - qz.y * s, qz.x * s + qz.y * c);
  vec3 offset = vec3(p.x, r.x, r.y - 500.0) - position;
  vec3 dx = vec3(0.0, rx), dy = vec3(my.x, ry - vec2(1.0, 0.0)), dz = vec3(0.0, rz - vec2(0.0, 1.0));`
