// Uses the shipped types together with p5's own, in a project with modules.
import p5 from 'p5'
import type { Distort, Loading, Warping } from 'warpjet/p5'

new p5((sketch) => {
  const p = sketch as typeof sketch & Warping & Loading
  let wave: Distort<{ amount: number }>
  let plane: Awaited<ReturnType<typeof load>>
  const load = async () =>
    p.addSurfaceVariation(await p.loadWarpModel('airplane.glb', { flipY: false }))

  p.setup = async () => {
    p.createCanvas(100, 100, p.WEBGL)
    wave = p.createWarp(({ position, uniforms }) => position.mult(uniforms.amount), {
      uniforms: { amount: 1 },
    })
    plane = await load()
    p.model(await p.loadWarpModel('airplane.glb'))
  }
  p.draw = () => {
    wave({ amount: 2 })
    if (plane.texture) p.texture(plane.texture)
    p.model(plane)
    const warnings: string[] = plane.warnings
    // @ts-expect-error the promise of the model must be awaited
    p.model(p.loadWarpModel('airplane.glb'))
    void warnings
  }
})
