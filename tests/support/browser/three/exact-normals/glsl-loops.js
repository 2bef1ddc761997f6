// Displacements in GLSL by long loops, each with a formula in double precision that moves a point in the same way.
import { changeShader, standard } from './cases.js'

const { sin, cos } = Math

/** A sum of 1,000 terms at the steepest vertex. */
const series = (x, y, term) => {
  let [sum, reached] = [0, 0]
  for (let i = 0; reached < 700 + 150 * x; i++) {
    reached += 0.85
    sum += term(i, y)
  }
  return sum
}
const wavelet = (i, y) => 0.006 * sin(0.05 * i + 2 * y)

/** Displacements by loops whose end only the shader knows, far beyond 256 iterations. */
export const longLoops = {
  'a break that depends on the position': {
    shape: 'plane',
    material: () =>
      changeShader(
        standard(),
        '',
        `float sum = 0.0, reached = 0.0;
for (float i = 0.0; ; i++) {
  if (reached >= 700.0 + 150.0 * position.x) break;
  reached += 0.85;
  sum += 0.006 * sin(0.05 * i + 2.0 * position.y);
}
transformed.z += sum;`,
      ),
    moved: ([x, y, z]) => [x, y, z + series(x, y, wavelet)],
  },
  'a uniform number of iterations, in nested loops': {
    shape: 'plane',
    material: () =>
      changeShader(
        standard(),
        'uniform float uRows;\nuniform int uColumns;',
        `float sum = 0.0;
for (float i = 0.0; i < uRows; i++)
  for (int j = 0; j < uColumns; j++)
    sum += 0.004 * sin(0.02 * i + 0.05 * float(j) + 3.0 * position.x) * cos(2.0 * position.y);
transformed.z += sum;`,
        { uniforms: { uRows: { value: 300 }, uColumns: { value: 5 } } },
      ),
    moved([x, y, z]) {
      let sum = 0
      for (let i = 0; i < 300; i++)
        for (let j = 0; j < 5; j++) sum += 0.004 * sin(0.02 * i + 0.05 * j + 3 * x) * cos(2 * y)
      return [x, y, z + sum]
    },
  },
  'a hash of 32 bits, and a return': {
    shape: 'plane',
    material: () =>
      changeShader(
        standard(),
        `uniform float uEnd;
float noisySum(vec2 p) {
  uint h = 7u;
  float sum = 0.0;
  for (uint i = 0u; ; i++) {
    if (float(i) > uEnd) return sum;
    h = h * 1664525u + 1013904223u;
    sum += 0.02 * (float(h >> 16u) / 65536.0 - 0.5) * sin(3.0 * p.x + 0.05 * float(i)) * cos(2.0 * p.y);
  }
}`,
        'transformed.z += noisySum(position.xy);',
        { uniforms: { uEnd: { value: 1000 } } },
      ),
    moved([x, y, z]) {
      let [sum, h] = [0, 7]
      for (let i = 0; i <= 1000; i++) {
        h = (Math.imul(h, 1664525) + 1013904223) >>> 0
        sum += 0.02 * ((h >>> 16) / 65536 - 0.5) * sin(3 * x + 0.05 * i) * cos(2 * y)
      }
      return [x, y, z + sum]
    },
  },
}

/** A loop that changes 40 numbers, so that it cannot stay a loop. `moved` takes the number of its iterations. */
export const manyStates = {
  material: () =>
    changeShader(
      standard(),
      'uniform float uEnd;',
      `float heights[40]; float n = 0.0;
for (int i = 0; i < 40; i++) heights[i] = 0.0;
while (n < uEnd) { heights[int(n) % 40] += 0.01 * sin(3.0 * position.x + 0.1 * n); n++; }
transformed.z += heights[3] + heights[7];`,
      { uniforms: { uEnd: { value: 400 } } },
    ),
  shape: 'plane',
  movedBy:
    (iterations) =>
    ([x, y, z]) => {
      let sum = 0
      for (let n = 0; n < iterations; n++)
        if (n % 40 === 3 || n % 40 === 7) sum += 0.01 * sin(3 * x + 0.1 * n)
      return [x, y, z + sum]
    },
}
