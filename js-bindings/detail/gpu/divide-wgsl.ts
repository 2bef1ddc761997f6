// The passes that choose the pieces of the edges and count the vertices and triangles, in the order of src/detail/division.cpp.
import { blockSize, groupSize, levelOf, parameters, stateOf } from './common-wgsl.js'

/** Chooses the level of each edge, an index of `pieceCounts`, and clears its need. */
export const choosePass = (constants: string) => `${parameters}
${constants}
${stateOf('atomic<u32>')}
@group(0) @binding(1) var<storage, read_write> needs: array<u32>;
@group(0) @binding(2) var<storage, read_write> pieces: array<u32>;
@group(0) @binding(3) var<storage, read_write> state: State;

fn roundUp(need: f32) -> u32 {
  for (var i = 0u; i < levels; i++) { if (f32(pieceCounts[i]) >= need) { return i; } }
  return levels - 1;
}

@compute @workgroup_size(${groupSize}) fn choose(@builtin(global_invocation_id) id: vec3u) {
  let edge = id.x;
  if (edge >= parameters.edges) { return; }
  let need = sqrt(bitcast<f32>(needs[edge]));
  needs[edge] = 0;
  let now = pieces[edge];
  let next = clamp(now, roundUp(need), roundUp(need * hysteresis));
  if (next == now) { return; }
  pieces[edge] = next;
  atomicStore(&state.isStale, 1);
}`

/** Sums up vertices and triangles within blocks of items. */
export const placePass = (constants: string) => `${parameters}
${constants}
@group(0) @binding(1) var<storage, read> topology: array<u32>;
@group(0) @binding(2) var<storage, read> pieces: array<u32>;
@group(0) @binding(3) var<storage, read> table: array<u32>;
@group(0) @binding(4) var<storage, read_write> sums: array<vec2u>;

${levelOf}

fn countOf(item: u32) -> vec2u {
  if (item < parameters.sides) { return vec2u(pieceCounts[levelOf(item)] - 1, 0); }
  if (item >= parameters.sides + parameters.triangles) { return vec2u(0); }
  let words = table[2 * tessellationOf(item - parameters.sides) + 1];
  return vec2u(words >> 21, words & 0x7ff);
}

${sumOfBlock}

@compute @workgroup_size(${blockSize}) fn place(
  @builtin(global_invocation_id) id: vec3u,
  @builtin(local_invocation_index) local: u32,
  @builtin(workgroup_id) block: vec3u,
) {
  let items = parameters.sides + parameters.triangles;
  let count = countOf(id.x);
  let sum = sumUp(local, count);
  if (id.x < items) { sums[id.x] = sum - count; }
  if (local == ${blockSize - 1}) { sums[items + block.x] = sum; }
}`

/** Sums up the blocks, and decides whether the mesh is written. If there is too little room, the mesh of the frame before stays. */
export const totalPass = () => `${parameters}
${stateOf('u32')}
@group(0) @binding(1) var<storage, read_write> sums: array<vec2u>;
@group(0) @binding(2) var<storage, read_write> state: State;
@group(0) @binding(3) var<storage, read_write> drawn: array<u32>;

${sumOfBlock}

@compute @workgroup_size(${blockSize}) fn total(@builtin(local_invocation_index) local: u32) {
  let items = parameters.sides + parameters.triangles;
  let blocks = (items + ${blockSize - 1}) / ${blockSize};
  let share = (blocks + ${blockSize - 1}) / ${blockSize};
  let first = items + min(local * share, blocks);
  let end = items + min((local + 1) * share, blocks);
  var sum = vec2u(0);
  for (var i = first; i < end; i++) { sum += sums[i]; }
  let upTo = sumUp(local, sum);
  var before = upTo - sum;
  for (var i = first; i < end; i++) {
    let count = sums[i];
    sums[i] = before;
    before += count;
  }
  if (local != ${blockSize - 1}) { return; }
  let count = upTo + vec2u(parameters.vertices, 0);
  let fits = count.x <= parameters.maxVertices && count.y <= parameters.maxTriangles;
  state.isWritten = select(0u, state.isStale, fits);
  state.vertices = count.x;
  state.triangles = count.y;
  drawn[1] = parameters.instances;
  if (state.isWritten == 0) { return; }
  state.isStale = 0;
  drawn[0] = 3 * count.y;
}`

/** Returns the sum of the counts of all invocations of a workgroup up to this one. */
const sumOfBlock = `var<workgroup> sumsOfBlock: array<vec2u, ${blockSize}>;
fn sumUp(local: u32, count: vec2u) -> vec2u {
  sumsOfBlock[local] = count;
  workgroupBarrier();
  for (var step = 1u; step < ${blockSize}; step *= 2) {
    var sum = sumsOfBlock[local];
    if (local >= step) { sum += sumsOfBlock[local - step]; }
    workgroupBarrier();
    sumsOfBlock[local] = sum;
    workgroupBarrier();
  }
  return sumsOfBlock[local];
}`
