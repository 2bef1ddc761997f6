// Frame constants keep positions, normals and motion between frames correct after a week.
import assert from 'node:assert/strict'
import { before, describe, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { differingPixels, litPixels } from '../support/browser/pixels.js'
import { drawScenes, openHosts, p5HostsInThisRun } from '../support/browser/sketch.js'
import { openPipeline } from '../support/browser/transform-feedback.js'
import { isMeasured, measureAfterAWeek } from '../support/browser/uptime.js'
import { warps } from '../warps/index.js'

const { browsers, server } = await openHosts(p5HostsInThisRun)

describe('warpjetFrame0, … keep float32 accurate for a week:', () => {
  let gpu
  before(async () => (gpu = await openPipeline(browsers.WEBGL)))

  const everyday = ['sine-sphere', 'deformer-noise', 'airplane-twist']
  const measured = warps
    .filter(isMeasured)
    .filter(({ name }) => everyday.includes(name) || isRun('every warp after a week of uptime'))
  for (const warp of measured)
    test(warp.name, async () => {
      const { start, then, step } = await measureAfterAWeek(gpu, warp, { perFrame: true })
      // Errors are about as large as at the start. The largest errors, which are now at other vertices, grow at most by the factors 1.8
      // (positions) and 2.5 (angles).
      const [positions, angles] = [then.position / start.position, then.angle / start.angle]
      assert.ok(!(positions > 2), `positions are ${positions} times as far off as at the start`)
      assert.ok(!(angles > 3), `normals are ${angles} times as far off as at the start`)
      for (const { position, angle, notFinite } of [start, then]) {
        assert.equal(notFinite, 0)
        assert.ok(position <= 2e-5, `positions are ${position} off`)
        assert.ok(angle <= warp.degrees, `normals are ${angle}° off`)
      }
      assert.ok(step < 0.001, `the motion between frames is ${step} off`)
    })

  test('without frame constants, float32 is not accurate after a week', async () => {
    const { then, step } = await measureAfterAWeek(
      gpu,
      warps.find(({ name }) => name === 'sine-sphere'),
      {},
    )
    assert.ok(then.angle > 1 && step > 0.9, `${then.angle}° and ${step} off`)
  })
})

describe('createWarp after a week', () => {
  for (const [version, renderer, scripts] of p5HostsInThisRun)
    test(`p5 ${version}, ${renderer}`, async () => {
      const wave = (phase) =>
        `({ glsl, position, millis, uniforms }) => glsl.vec3(position.y.mult(4).add(${phase}).sin().mult(0.25), 0, 0)`
      const rough = (phase) =>
        `({ glsl, position, normal, millis, uniforms }) => normal.mult(position.mult(2).add(${phase}).noise().mult(0.4))`
      // The same phases reduced by the periods, 2π of a sine and 4,091 cells of noise, in double precision.
      const at = (millis) => (millis / 90) % (2 * Math.PI)
      const cell = (millis) => (millis / 300) % 4091
      const times = { early: 20, late: 6e8, next: 6e8 + 16 }
      const scene = (warp) => `noStroke(); lights(); ${warp}; fill('coral'); sphere(60, 48, 32)`
      const scenes = {}
      for (const [name, time] of Object.entries(times)) {
        scenes[name] = scene(`clock = ${time}; warps.millis()`)
        scenes[`${name}, own clock`] = scene(`clock = ${time}; warps.own()`)
        scenes[`${name}, right`] = scene(`warps.right({ phase: ${at(time)} })`)
        scenes[`${name} of noise`] = scene(`clock = ${time}; warps.noise()`)
        scenes[`${name} of noise, own clock`] = scene(`clock = ${time}; warps.ownNoise()`)
        scenes[`${name} of noise, right`] = scene(`warps.rightNoise({ phase: ${cell(time)} })`)
      }
      const images = await drawScenes(
        browsers[renderer],
        server,
        [...scripts, '/dist/p5.warpjet.min.js'],
        {
          renderer,
          setup: `
            window.clock = 0
            p5.prototype.millis = () => clock
            warps.millis = createWarp(${wave('millis.div(90)')})
            warps.own = createWarp(${wave('uniforms.time.div(0.09)')}, { uniforms: { time: () => clock / 1000 } })
            warps.right = createWarp(${wave('uniforms.phase')}, { uniforms: { phase: 0 } })
            warps.noise = createWarp(${rough('millis.div(300)')})
            warps.ownNoise = createWarp(${rough('uniforms.time.div(0.3)')}, { uniforms: { time: () => clock / 1000 } })
            warps.rightNoise = createWarp(${rough('uniforms.phase')}, { uniforms: { phase: 0 } })`,
          scenes,
        },
      )
      for (const name of Object.keys(times).flatMap((time) => [time, `${time} of noise`])) {
        const right = images[`${name}, right`]
        assert.ok(litPixels(right).length > 5000)
        for (const other of [name, `${name}, own clock`]) {
          const differing = differingPixels(images[other], right, 2)
          assert.ok(differing < 20, `${other}: ${differing} pixels differ`)
        }
      }
      for (const kind of ['', ' of noise'])
        assert.ok(
          differingPixels(images[`late${kind}`], images[`next${kind}`], 2) > 300,
          `nothing moves from frame to frame${kind}`,
        )
    })
})
