// Displacements in WGSL as people write them, each with the same offset in JavaScript, in double precision.
const { sin, cos, floor, exp, hypot, min, abs, sqrt, pow, PI } = Math
const mod = (x, y) => x - y * floor(x / y)
const mix = (a, b, t) => a + (b - a) * t

/** A hash of integers, all of which float32 represents exactly. */
const scramble = (x) => mod((x * 34 + 1) * x, 289)
const cell = (x, y, z) => scramble(scramble(scramble(mod(x, 289)) + mod(y, 289)) + mod(z, 289))

/** Value noise with a quintic fade. */
function noise(x, y, z) {
  const [i, j, k] = [floor(x), floor(y), floor(z)]
  const fade = (t) => t * t * t * (t * (t * 6 - 15) + 10)
  const [a, b, c] = [fade(x - i), fade(y - j), fade(z - k)]
  const at = (u, v, w) => cell(i + u, j + v, k + w) / 144.5 - 1
  const edge = (v, w) => mix(at(0, v, w), at(1, v, w), a)
  return mix(mix(edge(0, 0), edge(1, 0), b), mix(edge(0, 1), edge(1, 1), b), c)
}

const wgslNoise = `
fn modulo(x: f32, y: f32) -> f32 { return x - y * floor(x / y); }
fn scramble(x: f32) -> f32 { return modulo((x * 34.0 + 1.0) * x, 289.0); }
fn cell(p: vec3f) -> f32 {
  return scramble(scramble(scramble(modulo(p.x, 289.0)) + modulo(p.y, 289.0)) + modulo(p.z, 289.0)) / 144.5 - 1.0;
}
fn noise(p: vec3f) -> f32 {
  let i = floor(p);
  let f = fract(p);
  let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  let y0 = mix(mix(cell(i), cell(i + vec3f(1, 0, 0)), u.x), mix(cell(i + vec3f(0, 1, 0)), cell(i + vec3f(1, 1, 0)), u.x), u.y);
  let y1 = mix(mix(cell(i + vec3f(0, 0, 1)), cell(i + vec3f(1, 0, 1)), u.x), mix(cell(i + vec3f(0, 1, 1)), cell(i + vec3f(1, 1, 1)), u.x), u.y);
  return mix(y0, y1, u.z);
}
`

const time = 0.7
const waves = [
  [1, 0.4, 0.25, 1.7],
  [-0.5, 1, 0.18, 2.6],
  [0.3, -1, 0.1, 4.3],
]
const heights = [0.3, 0.9, 0.1, 0.6, 0.8, 0.2, 0.7, 0.4, 0.5]

/**
 * Maps a title → the WGSL source, the values of its uniforms by their names in the shader, and `offset`, the same function in JavaScript.
 */
export const displacements = {
  'sine sea': {
    uniforms: { 'scene.time': time, 'scene.height': 0.3 },
    text: `struct Scene { time: f32, height: f32 }
@group(0) @binding(0) var<uniform> scene: Scene;
fn offset(position: vec3f) -> vec3f {
  return vec3f(0, scene.height * sin(position.x * 3 + scene.time) * cos(2 * position.z), 0);
}`,
    offset: ([x, , z]) => [0, 0.3 * sin(x * 3 + time) * cos(2 * z), 0],
  },
  'Gerstner waves': {
    uniforms: { time },
    text: `@group(0) @binding(0) var<uniform> time: f32;
struct Wave { direction: vec2f, steepness: f32, number: f32 }
const waves = array<Wave, 3>(
  Wave(vec2f(1.0, 0.4), 0.25, 1.7), Wave(vec2f(-0.5, 1.0), 0.18, 2.6), Wave(vec2f(0.3, -1.0), 0.1, 4.3));
fn gerstner(wave: Wave, p: vec3f) -> vec3f {
  let d = normalize(wave.direction);
  let phase = wave.number * dot(d, p.xz) - time;
  let a = wave.steepness / wave.number;
  return vec3f(d.x * a * cos(phase), a * sin(phase), d.y * a * cos(phase));
}
fn offset(position: vec3f) -> vec3f {
  var sum = vec3f();
  for (var i = 0u; i < 3u; i++) { sum += gerstner(waves[i], position); }
  return sum;
}`,
    offset([x, , z]) {
      const sum = [0, 0, 0]
      for (const [dx, dz, steepness, k] of waves) {
        const [a, b] = [dx / hypot(dx, dz), dz / hypot(dx, dz)]
        const phase = k * (a * x + b * z) - time
        sum[0] += ((a * steepness) / k) * cos(phase)
        sum[1] += (steepness / k) * sin(phase)
        sum[2] += ((b * steepness) / k) * cos(phase)
      }
      return sum
    },
  },
  'terrain ridges': {
    uniforms: {},
    text: `${wgslNoise}
fn ridges(at: vec2<f32>) -> f32 {
  var sum: f32 = 0.0;
  var amplitude = 0.4;
  var frequency = 1.3;
  for (var i: i32 = 0; i < 4; i = i + 1) {
    let ridge = 1.0 - abs(noise(vec3<f32>(at * frequency, 0.37)));
    sum = sum + amplitude * ridge * ridge;
    amplitude *= 0.45;
    frequency *= 2.1;
  }
  return sum;
}
fn offset(position: vec3<f32>) -> vec3<f32> { return vec3<f32>(0.0, 0.0, ridges(position.xy)); }`,
    offset([x, y]) {
      let [sum, amplitude, frequency] = [0, 0.4, 1.3]
      for (let i = 0; i < 4; i++) {
        const ridge = 1 - abs(noise(x * frequency, y * frequency, 0.37))
        sum += amplitude * ridge * ridge
        amplitude *= 0.45
        frequency *= 2.1
      }
      return [0, 0, sum]
    },
  },
  'ripples by distance': {
    uniforms: { center: [0.31, -0.22], time },
    text: `var<uniform> center: vec2f;
var<uniform> time: f32;
fn offset(position: vec3f) -> vec3f {
  let d = distance(position.xz, center);
  if (d > 3.0) { return vec3f(0.0); }
  return vec3f(0.0, 0.2 * sin(9.0 * d - time) * exp(-1.5 * d), 0.0);
}`,
    offset([x, , z]) {
      const d = hypot(x - 0.31, z + 0.22)
      return [0, d > 3 ? 0 : 0.2 * sin(9 * d - time) * exp(-1.5 * d), 0]
    },
  },
  'morph by noise': {
    uniforms: { time },
    text: `var<uniform> time: f32;
${wgslNoise}
fn fbm(start: vec3f) -> f32 {
  var p = start;
  var sum = 0.0;
  var weight = 0.5;
  var octave = 0;
  loop {
    if octave >= 3 { break; }
    sum += weight * noise(p);
    p = p * 2.03 + vec3f(1.7, 9.2, 3.1);
    weight *= 0.5;
    continuing { octave++; }
  }
  return sum;
}
fn offset(position: vec3f) -> vec3f { return normalize(position) * fbm(position * 1.5 + time) * 0.4; }`,
    offset(p) {
      let q = p.map((x) => x * 1.5 + time)
      let [sum, weight] = [0, 0.5]
      for (let i = 0; i < 3; i++) {
        sum += weight * noise(...q)
        q = q.map((x, k) => x * 2.03 + [1.7, 9.2, 3.1][k])
        weight *= 0.5
      }
      return p.map((x) => (x / hypot(...p)) * sum * 0.4)
    },
  },
  'grass that bends': {
    uniforms: { time, place: [0.4, 0, -1.3] },
    text: `var<uniform> time: f32;
var<uniform> place: vec3f;
fn sway(t: f32, at: vec3f) -> f32 { return sin(t + at.x * 2.0) * 0.6 + 0.2 * sin(3.1 * t + at.z); }
fn offset(position: vec3f) -> vec3f {
  let up = saturate(position.y + 0.5);
  let bend = pow(up, 2.0) * sway(time, place);
  return vec3f(bend, select(0.0, -0.3 * bend * bend, up > 0.0), bend * 0.3);
}`,
    offset([, y]) {
      const up = min(1, Math.max(0, y + 0.5))
      const bend = pow(up, 2) * (sin(time + 0.8) * 0.6 + 0.2 * sin(3.1 * time - 1.3))
      return [bend, up > 0 ? -0.3 * bend * bend : 0, bend * 0.3]
    },
  },
  Voronoi: {
    uniforms: {},
    text: `${wgslNoise}
fn voronoi(p: vec2f) -> f32 {
  let i = floor(p);
  let f = fract(p);
  var nearest = 8.0;
  for (var b = -1; b <= 1; b++) {
    for (var a = -1; a <= 1; a++) {
      let g = vec2f(f32(a), f32(b));
      let h = (cell(vec3f(i + g, 3.0)) + 1.0) * 144.5;
      let o = g + 0.15 + 0.7 * vec2f(modulo(round(h), 17.0) / 17.0, modulo(round(h), 23.0) / 23.0) - f;
      nearest = min(nearest, dot(o, o));
    }
  }
  return sqrt(nearest);
}
fn offset(position: vec3f) -> vec3f { return vec3f(0, 0, 0.4 * voronoi(position.xy * 2.3)); }`,
    offset([px, py]) {
      const [x, y] = [px * 2.3, py * 2.3]
      const [i, j] = [floor(x), floor(y)]
      let nearest = 8
      for (let b = -1; b <= 1; b++)
        for (let a = -1; a <= 1; a++) {
          const h = cell(i + a, j + b, 3)
          const u = a + 0.15 + (0.7 * mod(h, 17)) / 17 - (x - i)
          const v = b + 0.15 + (0.7 * mod(h, 23)) / 23 - (y - j)
          nearest = min(nearest, u * u + v * v)
        }
      return [0, 0, 0.4 * sqrt(nearest)]
    },
  },
  'twist, through a pointer': {
    uniforms: { strength: 1.4, turns: 1 },
    text: `override turns: f32 = 1.0;
var<uniform> strength: f32;
fn rotate(p: ptr<function, vec3f>, angle: f32) {
  let s = sin(angle);
  let c = cos(angle);
  let m = mat2x2f(c, s, -s, c);
  let q = m * vec2f((*p).x, (*p).z);
  (*p).x = q.x;
  (*p).z = q.y;
}
fn offset(position: vec3f) -> vec3f {
  var p = position;
  rotate(&p, position.y * strength * turns);
  return p - position;
}`,
    offset([x, y, z]) {
      const [c, s] = [cos(1.4 * y), sin(1.4 * y)]
      return [c * x - s * z - x, 0, s * x + c * z - z]
    },
  },
  'a height map with a bilinear fetch': {
    uniforms: Object.fromEntries(heights.map((height, i) => [`heights[${i}]`, height])),
    text: `@group(0) @binding(1) var<storage, read> heights: array<f32>;
fn at(x: f32, z: f32) -> f32 {
  // The three nearest rows and columns of a table in storage.
  var sum = 0.0;
  for (var j = 0; j < 3; j++) {
    let row = max(0.0, 1.0 - abs(z - f32(j)));
    sum += row * max(0.0, 1.0 - abs(x)) * heights0(j * 3);
    sum += row * max(0.0, 1.0 - abs(x - 1.0)) * heights0(j * 3 + 1);
    sum += row * max(0.0, 1.0 - abs(x - 2.0)) * heights0(j * 3 + 2);
  }
  return sum;
}
fn heights0(i: i32) -> f32 {
  switch i {
    case 0 { return heights[0]; }
    case 1 { return heights[1]; }
    case 2 { return heights[2]; }
    case 3 { return heights[3]; }
    case 4 { return heights[4]; }
    case 5 { return heights[5]; }
    case 6 { return heights[6]; }
    case 7 { return heights[7]; }
    default { return heights[8]; }
  }
}
fn offset(position: vec3f) -> vec3f {
  return vec3f(0, at(clamp(position.x + 1.0, 0.0, 2.0), clamp(position.z + 1.0, 0.0, 2.0)), 0);
}`,
    offset([px, , pz]) {
      const clamp = (x) => min(2, Math.max(0, x))
      const [x, z] = [clamp(px + 1), clamp(pz + 1)]
      let sum = 0
      heights.forEach((height, k) => {
        const tent = (t) => Math.max(0, 1 - abs(t))
        sum += height * tent(x - (k % 3)) * tent(z - floor(k / 3))
      })
      return [0, sum, 0]
    },
  },
  flag: {
    uniforms: { 'u.time': time, 'u.wind': [1.2, 0.4, 0.1] },
    text: `struct Uniforms { time: f32, @align(16) wind: vec3<f32> }
@group(1) @binding(0) var<uniform> u: Uniforms;
const TAU: f32 = 6.283185307179586;
alias Point = vec3<f32>;
fn offset(position: Point) -> vec3<f32> {
  let along: f32 = clamp(position.x * 0.5 + 0.5, 0.0, 1.0);
  let strength = length(u.wind);
  let phase = along * TAU * 1.3 - u.time * strength;
  var moved = Point(0.0, -0.1 * along * along, 0.0);
  moved.z = sin(phase + position.y) * 0.3 * along;
  moved.x -= 0.05 * along * (1.0 - cos(phase));
  return moved;
}`,
    offset([x, y]) {
      const along = min(1, Math.max(0, x * 0.5 + 0.5))
      const phase = along * 2 * PI * 1.3 - time * hypot(1.2, 0.4, 0.1)
      return [-0.05 * along * (1 - cos(phase)), -0.1 * along * along, sin(phase + y) * 0.3 * along]
    },
  },
}
