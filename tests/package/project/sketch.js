// A p5 sketch that uses the compiler, deformers and mesh of the package.
import p5 from 'p5'
import 'warpjet/p5'
import { compileWarp } from 'warpjet'
import { chain, twist } from 'warpjet/deformers'
import { loadMesh } from 'warpjet/mesh'

// p5's check of variable names mistakes variables of a bundle for those of the sketch.
p5.disableFriendlyErrors = true

const triangle = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'

new p5((p) => {
  let distort, shape
  p.setup = async () => {
    p.createCanvas(60, 60, p.WEBGL)
    const sine = ({ glsl, position }) => glsl.vec3(position.y().sin().mult(0.5), 0, 0)
    distort = p.createWarp(chain(sine, twist({ length: 1 })))
    shape = await p.loadWarpModel(`data:text/plain,${encodeURIComponent(triangle)}`)
  }
  p.draw = async () => {
    if (!shape) return
    p.noLoop()
    p.background(255, 0, 0)
    distort()
    p.model(shape)
    const mesh = await loadMesh(new TextEncoder().encode(triangle))
    const warp = compileWarp(({ position }) => position.mult(0))
    const { positions } = warp.evaluate(mesh)
    document.title = `drawn ${positions.slice(3, 6)}`
  }
})
