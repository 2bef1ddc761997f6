// The pass that writes the divided mesh, after the passes of divide-wgsl.ts.
import { blockSize, lanes, levelOf, parameters, stateOf } from './common-wgsl.js'
import type { VertexLayout } from './vertex-layout.js'

/** Writes vertices and triangles. The vertices of the base are there already. */
export const writePass = (constants: string, layout: VertexLayout) => `${parameters}
${constants}
${stateOf('u32')}
@group(0) @binding(1) var<storage, read> topology: array<u32>;
@group(0) @binding(2) var<storage, read> pieces: array<u32>;
@group(0) @binding(3) var<storage, read> table: array<u32>;
@group(0) @binding(4) var<storage, read> sums: array<vec2u>;
@group(0) @binding(5) var<storage, read> state: State;
@group(0) @binding(6) var<storage, read> base: array<f32>;
@group(0) @binding(7) var<storage, read_write> vertices: array<f32>;
@group(0) @binding(8) var<storage, read_write> indices: array<u32>;

${levelOf}
${startOf}
${blendOf(layout)}

fn writeSide(side: u32, lane: u32) {
  let count = pieceCounts[levelOf(side)];
  let first = parameters.vertices + startOf(side).x;
  let at = 6 * parameters.triangles + 3 * side;
  let ends = vec3u(topology[at], topology[at + 1], topology[at]);
  let scale = 1 / f32(count);
  for (var i = 1 + lane; i < count; i += ${lanes}) {
    blend(first + i - 1, ends, vec3f(f32(count - i) * scale, f32(i) * scale, 0));
  }
}

var<private> corners: vec3u;
var<private> sidesOf: vec3u;
var<private> counts: vec3u;
var<private> firsts: vec3u;

/** Returns the vertex of a point of the tessellation: see \`Tessellation\`. */
fn vertexOf(point: u32, inner: u32) -> u32 {
  var k = point;
  for (var i = 0; i < 3; i++) {
    let count = counts[i];
    if (k < count) {
      if (k == 0) { return corners[i]; }
      return firsts[i] + select(count - 1 - k, k - 1, (sidesOf[i] & 1) == 1);
    }
    k -= count;
  }
  return inner + k;
}

fn pointsAt(place: u32) -> vec3u { return (vec3u(table[place]) >> vec3u(0, 10, 20)) & vec3u(0x3ff); }

fn numbersAt(place: u32) -> vec3f {
  return vec3f(bitcast<f32>(table[place]), bitcast<f32>(table[place + 1]), bitcast<f32>(table[place + 2]));
}

fn bentSidesOf(triangle: u32) -> vec3f {
  let at = 3 * triangle;
  return vec3f(state.bentSides[at], state.bentSides[at + 1], state.bentSides[at + 2]);
}

/** See \`Flip::isShorter\`. */
fn isShorter(terms: vec3f) -> bool { return dot(terms, vec3f(1)) < -minGain * dot(abs(terms), vec3f(1)); }

/** Writes the triangles with the diagonals that src/detail/flips.hpp explains. */
fn writeTriangle(triangle: u32, lane: u32) {
  for (var i = 0u; i < 3; i++) {
    corners[i] = topology[6 * triangle + i];
    sidesOf[i] = topology[6 * triangle + 3 + i];
    let side = sidesOf[i] >> 1;
    counts[i] = pieceCounts[levelOf(side)];
    firsts[i] = parameters.vertices + startOf(side).x;
  }
  let number = tessellationOf(triangle);
  let data = table[2 * number];
  let words = table[2 * number + 1];
  let innerCount = words >> 21;
  let flipCount = (words >> 11) & 0x3ff;
  let count = words & 0x7ff;
  let start = startOf(parameters.sides + triangle);
  let inner = parameters.vertices + start.x;
  for (var i = lane; i < innerCount; i += ${lanes}) {
    blend(inner + i, corners, numbersAt(data + 3 * i));
  }
  let triangles = data + 3 * innerCount;
  let squares = bentSidesOf(triangle);
  for (var i = lane; i < count; i += ${lanes}) {
    var points = pointsAt(triangles + i);
    let flip = triangles + count + 3 * (i / 2);
    if (i / 2 < flipCount && isShorter(numbersAt(flip) * squares)) {
      points = vec3u(points.zx, pointsAt(triangles + (i ^ 1)).z);
    }
    let to = 3 * (start.y + i);
    for (var k = 0u; k < 3; k++) { indices[to + k] = vertexOf(points[k], inner); }
  }
}

@compute @workgroup_size(${blockSize}) fn write(@builtin(global_invocation_id) id: vec3u) {
  let item = id.x / ${lanes};
  let lane = id.x % ${lanes};
  if (state.isWritten == 0 || item >= parameters.sides + parameters.triangles) { return; }
  if (item < parameters.sides) { writeSide(item, lane); } else { writeTriangle(item - parameters.sides, lane); }
}`

/** Finds the sum of the counts before an item. Items are the sides of the base, followed by its triangles. */
const startOf = `fn startOf(item: u32) -> vec2u {
  return sums[item] + sums[parameters.sides + parameters.triangles + item / ${blockSize}u];
}`

/** Declares a function that writes a weighted sum of vertices of the base. */
function blendOf(layout: VertexLayout) {
  const parts = layout.attributes.map(({ size, isUnit }, attribute) => {
    const at = layout.before[attribute]!
    const start = layout.isPlanar ? `${at}u * parameters.maxVertices` : `${at}u`
    const place = `${start} + ${layout.stepOf(attribute)}u * vertex`
    const numbers = Array.from({ length: size }, (_, i) => {
      const weigh = (corner: string) =>
        `weights.${corner} * base[${at}u * parameters.vertices + ${size}u * ends.${corner} + ${i}u]`
      return `var number${at + i} = ${['x', 'y', 'z'].map(weigh).join(' + ')};`
    })
    const names = Array.from({ length: size }, (_, i) => `number${at + i}`)
    const squares = names.map((name) => `${name} * ${name}`).join(' + ')
    return [
      ...numbers,
      ...(isUnit
        ? [
            `let scale${at} = unitScaleOf(${squares});`,
            ...names.map((name) => `${name} *= scale${at};`),
          ]
        : []),
      ...names.map((name, i) => `vertices[${place} + ${i}u] = ${name};`),
    ].join('\n  ')
  })
  return `/** Zero vectors and those that are not finite stay as they are. */
fn unitScaleOf(square: f32) -> f32 {
  let scale = inverseSqrt(square);
  return select(1, scale, scale > 0 && (bitcast<u32>(scale) & 0x7f800000u) != 0x7f800000u);
}
fn blend(vertex: u32, ends: vec3u, weights: vec3f) {
  ${parts.join('\n  ')}
}`
}
