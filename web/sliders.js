/**
 * The sliders of the examples' pages. Each changes a number in the sketch's source, which is found by the text around it, with # in place
 * of the number. So the sketches need no code for sliders.
 */
const ranges = {
  'airplane-twist': { Twist: ['.mult(x).mult(#)', 0, 0.04] },
  'sine-sphere': {
    Waves: ['x.mult(#).add(time, phase)', 0, 15],
    Height: ['.sin().mult(#)', 0, 0.3],
  },
  'sine-cube': { Waves: ['x.mult(#)', 0, 0.08], Height: ['.sin().mult(#)', 0, 50] },
  bunny: { Twist: ['y.mult(#)', 0, 0.04] },
  genie: { Length: ['.dist(spout).div(#)', 200, 900] },
  'coarse-and-fine': { Twist: ['y.mult(#)', 0, 0.03] },
  'one-edge-per-side': { Waves: ['y.mult(#)', 0, 15], Twist: ['.sin().mult(#)', 0, 1.5] },
  lotus: { Width: ['position.x().mult(#)', 0.1, 0.7], Curl: ['x.mult(x).mult(#)', -1, 4] },
  spoon: { Bend: ['.sin().mult(#)', 0, 0.03] },
  fingers: { Waves: ['position.x().mult(#)', 0, 0.1], Height: ['.mult(wave).mult(#)', 0, 150] },
  'text-bulge': { Bulge: ['near.mult(#)', 0, 200], Wave: ['.sin().mult(#)', 0, 40] },
  carousel: { Ripples: ['.mult(down).mult(#)', 0, 40] },
  'displaced-plane': { Ripples: ['ripples.mult(#)', 0, 0.15], Swell: ['swell.mult(#)', 0, 0.15] },
  'tangent-plane': { Waves: ['x.mult(#)', 0, 0.08], Height: ['.sin().mult(#)', 0, 30] },
  'domain-warping-2d': {
    Warped: ['p.add(q.mult(#))', 0, 8],
    'Warped again': ['p.add(r.mult(#))', 0, 8],
  },
  'domain-warping-colours': {
    Warped: ['p.add(q.mult(#))', 0, 8],
    'Warped again': ['p.add(r.mult(#))', 0, 8],
  },
  'domain-warping-lit': {
    Warped: ['p.add(q.mult(#))', 0, 8],
    'Warped again': ['p.add(r.mult(#))', 0, 8],
  },
  'domain-warping-3d': {
    Size: ['position.mult(#)', 0.1, 1.5],
    Height: ['.sub(0.5).mult(#)', 0, 2],
  },
  'deformer-twist': { Length: ['length: #', 80, 500], Angle: ['.mult(#)', 0, 7] },
  'deformer-bend': { Angle: ['.mult(#)', 0, 4] },
  'deformer-taper': { Length: ['length: #', 80, 400], Amount: ['.mult(#)', -1, 1] },
  'deformer-stretch': { Amount: ['.mult(#)', 0, 0.8] },
  'deformer-bulge': { Radius: ['radius: #', 40, 250], Amount: ['amount: #', -0.9, 1.5] },
  'deformer-wave': { Amount: ['amount: #', 0, 60], Wavelength: ['wavelength: #', 80, 600] },
  'deformer-ripple': { Amount: ['amount: #', 0, 40], Wavelength: ['wavelength: #', 30, 200] },
  'deformer-melt': { Height: ['height: #', 20, 150], Amount: ['.mult(#)', 0, 0.5] },
  'deformer-inflate': { Amount: ['.mult(#)', 0, 12] },
  'deformer-genie': { Length: ['length: #', 200, 600], Neck: ['neck: #', 0, 0.5] },
  'deformer-spherify': { Radius: ['radius: #', 40, 120] },
  'deformer-shear': { Amount: ['.mult(#)', 0, 1.5] },
  'deformer-noise': { Amount: ['amount: #', 0, 120], Scale: ['scale: #', 30, 200] },
  composition: { Twist: ['oscillate(#)', 0, 5] },
  'along-the-normal': { Waves: ['x.mult(#)', 0, 0.2], Height: ['wave(z)).mult(#)', 0, 10] },
  'glsl-terrain': { Height: ['0.0, # * h', 0.01, 0.25], Roughness: ['size *= #', 0.2, 0.6] },
  'glsl-noise': { Height: ['(# * snoise(p)', 0.05, 0.35] },
  'glsl-waves': { Choppiness: ['choppiness: #', 0, 1] },
  'strands-exact-normals': { Bend: ['+ time) * #', 0.05, 0.45], Ripples: ['(# / i)', 0.01, 0.2] },
  'ray-marched-field': {
    Blend: ['- 0.22, #)', 0.05, 0.5],
    Distance: ['vec3 c = #', 0.3, 0.95],
    Bumps: ['d + #', 0.005, 0.05],
  },
  'shadow-map': { Sway: ['.mult(#)\n  }', 0, 0.8] },
  'raked-sand': { Depth: ['height.mult(#)', 0, 30] },
  'marbled-paper': { Stirred: ['r.mult(#)', 0, 1] },
  // These sketches have their own panel; the sliders here add to it.
  'three-sea': {
    'Longest wave': ['length: #', 2, 8],
    Steepness: ['steepness: #', 0, 0.8],
    Haze: ['14, #)', 18, 60],
  },
  'three-raging-sea': { Waves: ['place.x.mul(#)', 1, 8], Noise: ['.mul(#).mul(i)', 0.5, 4] },
  'three-grass': { Flutter: ['.mult(#)\n    const bend', 0, 0.2], Stiffness: ['.pow(#)', 1.2, 4] },
  'three-terrain': { Plain: ['.add(#)\n  const ridges', 0, 0.6] },
  'three-corridor': { Hills: ['position.z().mult(#).sin()', 0.1, 1] },
  'three-glass': { Flutes: ['height.mult(#).min', 0.1, 1.5] },
  'three-lanterns': { Rings: ['far.mult(#)', 0.2, 2] },
}

const numberPattern = String.raw`(-?\d+(?:\.\d+)?)`
const escape = (text) => text.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&')

/** Finds an example's sliders. Returns [{ label, value, from, to, at, length }], where `at` is the index of the number in the sketch. */
export function findSliders(name, sketch) {
  return Object.entries(ranges[name] ?? {}).map(([label, [text, from, to]]) => {
    const pattern = new RegExp(escape(text).replace('#', numberPattern), 'd')
    const match = pattern.exec(sketch)
    if (!match) throw new Error(`expected “${text}” in examples/${name}/sketch.js, got no match.`)
    const [at, end] = match.indices[1]
    return { label, value: Number(match[1]), from, to, at, length: end - at }
  })
}
