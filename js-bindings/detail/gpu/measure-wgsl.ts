// The passes that warp the samples of the base, and measure into how many pieces its edges must be divided. src/detail/triangle_needs.cpp
// explains the formulas.
import { groupSize, parameters, stateOf } from './common-wgsl.js'
import { sampleNames, type NamedNumbers, type PackedNumbers } from './warp-wgsl.js'

/** An input of the warp in the buffer of samples, which contains one array per input. */
export interface SampleInput {
  readonly input: keyof typeof sampleNames
  readonly size: number
}

/** The matrices that transform positions and normals of samples into the space of the offset. */
export interface World {
  readonly position: () => readonly number[]
  readonly normal: () => readonly number[]
  /** `true` if normals have length 1 there. */
  readonly hasUnitNormals: boolean
}

/** Names of these matrices in WGSL. */
const worldNames = { position: 'sampleToWorld', normal: 'sampleNormalToWorld' }

export const worldNumbers = ({ position, normal }: World): NamedNumbers[] => [
  { name: worldNames.position, type: 'mat4', read: position },
  { name: worldNames.normal, type: 'mat3', read: normal },
]

interface Warp {
  readonly code: string
  readonly declarations: string
  readonly result: string
}

/** Warps each sample. */
export function evaluatePass(
  warp: Warp,
  numbers: PackedNumbers,
  inputs: readonly SampleInput[],
  world: { readonly hasUnitNormals: boolean } | undefined,
): string {
  let before = 0
  const reads = inputs.map(({ input, size }) => {
    const at = `parameters.samples * ${before}u + i * ${size}u`
    before += size
    const parts = Array.from({ length: size }, (_, k) => `samples[${at} + ${k}u]`)
    return `let ${input}Here = vec${size}f(${parts.join(', ')});`
  })
  const has = (input: string) => inputs.some((each) => each.input === input)
  const { position, normal, uv, color } = sampleNames
  return `${parameters}
@group(0) @binding(1) var<uniform> warpjetInputs: array<vec4f, ${numbers.array.length / 4}>;
@group(0) @binding(2) var<storage, read> samples: array<f32>;
@group(0) @binding(3) var<storage, read_write> warped: array<vec4f>;
${warp.declarations}
@compute @workgroup_size(${groupSize}) fn evaluate(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= parameters.samples) { return; }
  // Keeps the binding in the layout if the warp reads no numbers.
  _ = warpjetInputs[0];
  ${reads.join('\n  ')}
  ${numbers.code}
  ${world ? toWorld(has('normal'), world.hasUnitNormals) : `let ${position} = positionHere;`}
  ${has('normal') && !world ? `let ${normal} = normalHere;` : ''}
  ${has('uv') ? `let ${uv} = uvHere;` : ''}
  ${has('color') ? `let ${color} = colorHere;` : ''}
  ${warp.code}
  warped[i] = vec4f(${warp.result}, 1.0);
}`
}

const toWorld = (hasNormal: boolean, isUnit: boolean) =>
  `let ${sampleNames.position} = (${worldNames.position} * vec4f(positionHere, 1.0)).xyz;${
    hasNormal
      ? `
  let normalThere = ${worldNames.normal} * normalHere;
  let ${sampleNames.normal} = normalThere${isUnit ? ' / max(length(normalThere), 1e-30)' : ''};`
      : ''
  }`

/** Returns the index of a sample of a triangle: see src/detail/samples.hpp. */
const sampleAt = (row: number, i: number) => (row * (row + 1)) / 2 + i

/** Six indices of samples for each cell: its corners, and the middles of its sides. */
const cells = [0, 1, 2].flatMap((row) =>
  Array.from({ length: row + 1 }, (_, i) => [
    ...[sampleAt(row, i), sampleAt(row + 2, i), sampleAt(row + 2, i + 2)],
    ...[sampleAt(row + 1, i), sampleAt(row + 2, i + 1), sampleAt(row + 1, i + 1)],
  ]),
)

/** Measures what the edges of each triangle need. */
export const measurePass = (constants: string) => `${parameters}
${constants}
${stateOf('u32')}
struct View {
  clip: mat4x4f,
  halfSize: vec2f,
  facing: f32,
}
@group(0) @binding(1) var<storage, read> views: array<View>;
@group(0) @binding(2) var<storage, read> topology: array<u32>;
@group(0) @binding(3) var<storage, read> base: array<f32>;
@group(0) @binding(4) var<storage, read> warped: array<vec4f>;
@group(0) @binding(5) var<storage, read_write> needs: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> state: State;

alias Samples = array<vec3f, 15>;
alias Clips = array<vec4f, 15>;
const cells = array<array<u32, 6>, 6>(${cells.map((cell) => `array<u32, 6>(${cell.join(', ')})`).join(', ')});

fn samplesOf(triangle: u32) -> Samples {
  var found: Samples;
  let first = 6 * triangle;
  found[0] = warped[topology[first]].xyz;
  found[${sampleAt(4, 0)}] = warped[topology[first + 1]].xyz;
  found[${sampleAt(4, 4)}] = warped[topology[first + 2]].xyz;
  for (var k = 1u; k < 4; k++) {
    let row = 4 - k;
    let places = array<u32, 3>(k * (k + 1) / 2, ${sampleAt(4, 0)} + k, row * (row + 1) / 2 + row);
    for (var i = 0u; i < 3; i++) {
      let side = topology[first + 3 + i];
      let indexOnSide = select(3 - k, k - 1, (side & 1) == 1);
      found[places[i]] = warped[parameters.vertices + 3 * (side >> 1) + indexOnSide].xyz;
    }
  }
  let inside = parameters.vertices + 3 * (parameters.sides + triangle);
  found[${sampleAt(2, 1)}] = warped[inside].xyz;
  found[${sampleAt(3, 1)}] = warped[inside + 1].xyz;
  found[${sampleAt(3, 2)}] = warped[inside + 2].xyz;
  return found;
}

fn facesAway(clips: ptr<function, Clips>, halfSize: vec2f, facing: f32) -> bool {
  for (var i = 0; i < 6; i++) {
    let cell = cells[i];
    let a = (*clips)[cell[0]];
    let b = (*clips)[cell[1]];
    let c = (*clips)[cell[2]];
    if (a.w <= 0 || b.w <= 0 || c.w <= 0) { return false; }
    let corner = halfSize * a.xy / a.w;
    let u = halfSize * b.xy / b.w - corner;
    let v = halfSize * c.xy / c.w - corner;
    if (!(facing * (u.x * v.y - u.y * v.x) < -away * length(u) * length(v))) { return false; }
  }
  return true;
}

fn isVisible(clips: ptr<function, Clips>, view: View) -> bool {
  var areOutside = array<bool, 5>(true, true, true, true, true);
  for (var i = 0; i < 15; i++) {
    let clip = (*clips)[i];
    let limit = margin * abs(clip.w);
    areOutside[0] &= clip.x > limit;
    areOutside[1] &= -clip.x > limit;
    areOutside[2] &= clip.y > limit;
    areOutside[3] &= -clip.y > limit;
    areOutside[4] &= clip.w <= 0;
  }
  for (var i = 0; i < 5; i++) { if (areOutside[i]) { return false; } }
  return view.facing == 0 || !facesAway(clips, view.halfSize, view.facing);
}

/** Samples on the screen: see src/detail/triangles_on_screen.hpp. */
struct Places {
  depth: f32,
  places: array<vec2f, 15>,
}

fn placesOf(clips: ptr<function, Clips>) -> Places {
  var found: Places;
  let a = (*clips)[0].w;
  let b = (*clips)[${sampleAt(4, 0)}].w;
  let c = (*clips)[${sampleAt(4, 4)}].w;
  let minDepth = nearest * max(max(abs(a), abs(b)), abs(c));
  found.depth = a;
  for (var i = 0; i < 15; i++) {
    let clip = (*clips)[i];
    found.depth = min(found.depth, clip.w);
    found.places[i] = clamp(clip.xy / max(clip.w, minDepth), vec2f(-aside), vec2f(aside));
  }
  found.depth = max(found.depth, minDepth);
  return found;
}

fn toPixels(halfSize: vec2f, change: vec4f, place: vec2f, depth: f32) -> vec2f {
  return halfSize * (change.xy - place * change.w) / depth;
}

fn flatError(changes: ptr<function, Clips>, screen: ptr<function, Places>, halfSize: vec2f) -> f32 {
  let toFirst = (*changes)[${sampleAt(4, 0)}] / 4;
  let toSecond = (*changes)[${sampleAt(4, 4)}] / 4;
  var square = 0.0;
  for (var row = 1u; row <= 4; row++) {
    for (var i = 0u; i <= row; i++) {
      let sample = row * (row + 1) / 2 + i;
      let flat = f32(row - i) * toFirst + f32(i) * toSecond;
      let distance = toPixels(halfSize, (*changes)[sample] - flat, (*screen).places[sample], (*screen).depth);
      square = max(square, dot(distance, distance));
    }
  }
  return sqrt(square);
}

/** Returns xx, xy and yy of the bend. */
fn bendOf(width: f32, apex: vec2f, first: vec2f, second: vec2f, third: vec2f) -> vec3f {
  let mixed = 0.5 * (first + third - second);
  let xx = first / (width * width);
  let xy = (mixed - xx * width * apex.x) / (width * apex.y);
  let yy = (third - xx * apex.x * apex.x - 2 * xy * apex.x * apex.y) / (apex.y * apex.y);
  let sum = vec3f(dot(xx, xx) + dot(xy, xy), dot(xy, xx + yy), dot(xy, xy) + dot(yy, yy));
  let root = sqrt(max(0, sum.x * sum.z - sum.y * sum.y));
  return vec3f(sum.x + root, sum.y, sum.z + root) / sqrt(sum.x + sum.z + 2 * root);
}

fn along(bend: vec3f, v: vec2f) -> f32 {
  return bend.x * v.x * v.x + 2 * bend.y * v.x * v.y + bend.z * v.y * v.y;
}

fn placeOf(vertex: u32) -> vec3f {
  return vec3f(base[3 * vertex], base[3 * vertex + 1], base[3 * vertex + 2]);
}

fn isFinite(x: f32) -> bool { return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u; }

@compute @workgroup_size(${groupSize}) fn measure(@builtin(global_invocation_id) id: vec3u) {
  let triangle = id.x;
  if (triangle >= parameters.triangles) { return; }
  let first = 6 * triangle;
  let a = placeOf(topology[first]);
  let u = placeOf(topology[first + 1]) - a;
  let v = placeOf(topology[first + 2]) - a;
  let shortest = minLength * sqrt(dot(u, u) + dot(v, v));
  let width = max(shortest, length(u));
  let x = dot(u, v) / width;
  let apex = vec2f(x, max(shortest, sqrt(max(0, dot(v, v) - x * x))));
  var samples = samplesOf(triangle);
  var squares = vec3f(0);
  var bentSides = vec3f(0);
  for (var k = 0u; k < parameters.views; k++) {
    let view = views[k];
    var changes: Clips;
    var clips: Clips;
    let start = view.clip * vec4f(samples[0], 1);
    for (var i = 0; i < 15; i++) {
      changes[i] = view.clip * vec4f(samples[i] - samples[0], 0);
      clips[i] = start + changes[i];
    }
    if (!isVisible(&clips, view)) { continue; }
    var screen = placesOf(&clips);
    let flat = flatError(&changes, &screen, view.halfSize) * beyondFlat / (aim * parameters.tolerance);
    if (flat <= 1) {
      squares = max(squares, vec3f(flat));
      continue;
    }
    var byBends = vec3f(0);
    for (var i = 0; i < 6; i++) {
      let cell = cells[i];
      var bends: array<vec2f, 3>;
      for (var j = 0u; j < 3; j++) {
        let change = changes[cell[j]] + changes[cell[(j + 1) % 3]] - 2 * changes[cell[j + 3]];
        bends[j] = 16 * toPixels(view.halfSize, change, screen.places[cell[j + 3]], screen.depth);
      }
      let bend = bendOf(width, apex, bends[0], bends[1], bends[2]);
      let here = vec3f(along(bend, vec2f(width, 0)), along(bend, apex - vec2f(width, 0)), along(bend, apex));
      if (!isFinite(here.x + here.y + here.z)) { continue; }
      byBends = max(byBends, error * here);
    }
    bentSides = max(bentSides, byBends);
    squares = max(squares, byBends / (aim * parameters.tolerance));
  }
  for (var i = 0u; i < 3; i++) { state.bentSides[3 * triangle + i] = bentSides[i]; }
  for (var i = 0u; i < 3; i++) {
    let side = topology[first + 3 + i] >> 1;
    let edge = topology[6 * parameters.triangles + 3 * side + 2];
    atomicMax(&needs[edge], bitcast<u32>(squares[i]));
  }
}`
