// Noise that is finer than a pixel fades: a picture of normals on each renderer, against the mean of 64 exact normals per pixel.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { lookFromAfar, shaderOfNormals } from '../support/browser/p5-shown-normals.js'
import { drawScenes, openHosts, p5HostsInThisRun } from '../support/browser/sketch.js'

const size = 120
/** The length of the plane's edges, in pixels. Waves of the coarsest octave are 3.7 pixels long, those of the finest a quarter of one. */
const edge = 80

const offset = ({ glsl, position }) => glsl.vec3(0, 0, glsl.fbm(position.mult(30)).mult(0.02))

/** Pixels of the plane without those near its edges. */
const pixels = Array.from({ length: size * size }, (_, i) => [
  i % size,
  Math.floor(i / size),
]).filter((pixel) => pixel.every((x) => Math.abs(x + 0.5 - size / 2) < edge / 2 - 2))

const restOf = (x) => (x - size / 2) / edge

/** Returns the sum of 64 normals for each pixel: only its direction matters. */
function meanNormals() {
  const positions = pixels.flatMap(([x, y]) =>
    Array.from({ length: 64 }, (_, i) => [
      restOf(x + ((i % 8) + 0.5) / 8),
      restOf(y + (Math.floor(i / 8) + 0.5) / 8),
      0,
    ]).flat(),
  )
  const normals = Float32Array.from(positions, (_, i) => (i % 3 === 2 ? 1 : 0))
  const warped = compileWarp(offset).evaluate({ positions: Float32Array.from(positions), normals })
  return pixels.map((_, pixel) => {
    const sum = [0, 0, 0]
    for (let i = 0; i < 3 * 64; i++) sum[i % 3] += warped.normals[3 * 64 * pixel + i]
    return sum
  })
}

function degreesBetween(a, b) {
  const dot = a.reduce((sum, x, i) => sum + x * b[i], 0)
  return (Math.acos(Math.min(1, dot / (Math.hypot(...a) * Math.hypot(...b)))) * 180) / Math.PI
}

const { browsers, server } = await openHosts(p5HostsInThisRun)

for (const [version, renderer, scripts] of p5HostsInThisRun)
  test(`p5 ${version} on ${renderer}: noise finer than a pixel fades to its mean`, async (t) => {
    const shader = shaderOfNormals(version, renderer)
    const draw = (name) => `background(0); warps.${name}(); noStroke()
      ${lookFromAfar(size)}
      scale(${edge}); plane(1, 1)`
    const images = await drawScenes(
      browsers[renderer],
      server,
      [...scripts, '/dist/p5.warpjet.min.js'],
      {
        size,
        renderer,
        setup: `warps.fading = createWarp(${offset}, { shader: ${shader}, normals: 'pixel' })
        warps.keeping = createWarp(${offset}, { shader: ${shader}, normals: 'pixel', fadeNoise: false })`,
        scenes: { fading: draw('fading'), keeping: draw('keeping') },
      },
    )
    const means = meanNormals()
    const errorOf = ({ data }) => {
      const angles = pixels.map(([x, y], i) => {
        const at = 4 * (y * size + x)
        const shown = [...data.subarray(at, at + 3)].map((byte) => byte / 127.5 - 1)
        return degreesBetween(shown, means[i])
      })
      return Math.hypot(...angles) / Math.sqrt(angles.length)
    }
    const [fading, keeping] = [errorOf(images.fading), errorOf(images.keeping)]
    t.diagnostic(`${fading} degrees from the mean where noise fades, ${keeping} where it does not`)
    assert.ok(keeping > 5, `${keeping} degrees: the noise is too weak to show anything`)
    assert.ok(fading < keeping / 2, `${fading} degrees instead of ${keeping}`)
  })
