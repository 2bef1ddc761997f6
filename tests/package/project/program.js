// Uses the package as in a Node program or on a server.
import { WarpError, compileWarp } from 'warpjet'
import { gen } from 'warpjet/autodiff'
import { twist } from 'warpjet/deformers'
import { bakeWarp, exportGLB, loadMesh } from 'warpjet/mesh'
import warpjet from 'warpjet/p5'
import { compileWarp as compileText } from 'warpjet/text'

/** Uses the package, and returns a message if everything works. */
export async function tryAll() {
  const mesh = await loadMesh('triangle.obj')
  const baked = bakeWarp(
    mesh,
    compileWarp(({ position }) => position.mult(0)),
  )
  const shader = compileText(twist()).code + gen((ad) => ad.param('x').sin().output('y'))
  const isRejected = await loadMesh('nothing.obj').catch((error) => error instanceof WarpError)
  const parts = [typeof warpjet, shader.length > 100, exportGLB(baked).length > 100, isRejected]
  return `moved ${baked.positions.slice(3, 6)} ${parts}`
}
