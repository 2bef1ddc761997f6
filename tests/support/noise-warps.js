// A cube with a side of 180 units, and warps that move its points by up to 20 units along z by each kind of noise. A few samples do not
// show where such surfaces bend.
import { compileWarp } from 'warpjet'
import { box } from './coarse-meshes.js'

export const cube = box([90, 90, 90])

const octaves = { octaves: 3 }

/** Maps a name → warp that computes no normals. The last three have creases. */
export const noiseWarps = Object.fromEntries(
  Object.entries({
    noise: (glsl, p) => glsl.noise(p),
    simplex: (glsl, p) => glsl.simplex(p),
    valueNoise: (glsl, p) => glsl.valueNoise(p),
    fbm: (glsl, p) => glsl.fbm(p, { octaves: 4 }),
    worley: (glsl, p) => glsl.worley(p).x(),
    ridged: (glsl, p) => glsl.ridged(p, octaves),
    turbulence: (glsl, p) => glsl.turbulence(p, octaves),
  }).map(([name, height]) => {
    const offset = ({ glsl, position }) => glsl.vec3(0, 0, height(glsl, position.div(60)).mult(20))
    return [name, compileWarp(offset, { normals: false })]
  }),
)
