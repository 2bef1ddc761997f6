/** Three chains of 24 nested sines, z into x, x into y and y into z: few outputs, and each sine depends on the previous one. */
const LENGTH = 24
const AMPLITUDE = 30

/** The argument of the i-th sine of a chain is frequency · v + speed · seconds. */
const links = Array.from({ length: LENGTH }, (_, i) => ({
  frequency: i === 0 ? 0.03 : 1.8 + 0.01 * i,
  speed: 0.1 + 0.02 * i,
}))
const axes = ['x', 'y', 'z']
const sources = [2, 0, 1]

const floatLiteral = (number) => String(Number.isInteger(number) ? `${number}.0` : number)

export const nestedSines = {
  warp({ glsl, position, millis }) {
    const seconds = millis.div(1000)
    const start = [position.x(), position.y(), position.z()]
    const chain = (axis) =>
      links.reduce(
        (v, { frequency, speed }) => v.mult(frequency).add(seconds.mult(speed)).sin(),
        start[sources[axis]],
      )
    return glsl.vec3(chain(0), chain(1), chain(2)).mult(AMPLITUDE)
  },

  offset(p, { millis }) {
    const chain = (axis) =>
      links.reduce(
        (v, { frequency, speed }) => Math.sin(frequency * v + (speed * millis) / 1000),
        p[sources[axis]],
      )
    return [AMPLITUDE * chain(0), AMPLITUDE * chain(1), AMPLITUDE * chain(2)]
  },

  /** Computes all three chains and their slopes together, as vec3. */
  handwritten: `
  float seconds = millis / 1000.0;
  vec3 v = position.${sources.map((source) => axes[source]).join('')}, slope = vec3(${floatLiteral(AMPLITUDE)}), angle;
${links
  .map(
    ({
      frequency,
      speed,
    }) => `  angle = v * ${floatLiteral(frequency)} + seconds * ${floatLiteral(speed)};
  v = sin(angle);
  slope *= cos(angle) * ${floatLiteral(frequency)};`,
  )
  .join('\n')}
  vec3 offset = v * ${floatLiteral(AMPLITUDE)};
  vec3 dx = vec3(0.0, slope.y, 0.0), dy = vec3(0.0, 0.0, slope.z), dz = vec3(slope.x, 0.0, 0.0);`,
}
