// Draws frames of warped shapes with p5 2.x, for `npm run bench -- detail-frames`.
import '/dist/p5.js'
import { offerFrames, size } from '../detail-frames.js'

p5.disableFriendlyErrors = true

let draw, millis, triangles

const sketch = await new Promise((resolve) => {
  new p5((p) => {
    p.setup = async () => {
      p.pixelDensity(1)
      p.createCanvas(size, size, p.WEBGL)
      await p.setAttributes('antialias', false)
      p.noLoop()
      resolve(p)
    }
    p.draw = () => draw?.()
  })
})
sketch.millis = () => millis
const gl = sketch.drawingContext
const { drawElements } = gl
gl.drawElements = (mode, count, ...others) => {
  triangles = count / 3
  drawElements.call(gl, mode, count, ...others)
}

let shapeCount = 0

function shapeOf({ positions, normals, indices }) {
  const vectors = (numbers) =>
    Array.from({ length: numbers.length / 3 }, (_, i) =>
      sketch.createVector(...numbers.slice(3 * i, 3 * i + 3)),
    )
  return new p5.Geometry(1, 1, function () {
    this.gid = `mesh ${shapeCount++}`
    this.vertices = vectors(positions)
    this.vertexNormals = vectors(normals)
    this.uvs = this.vertices.flatMap(() => [0, 0])
    this.faces = Array.from({ length: indices.length / 3 }, (_, i) => [
      ...indices.slice(3 * i, 3 * i + 3),
    ])
  })
}

offerFrames((mesh, offset, options, extent) => {
  const shape = shapeOf(mesh)
  const warp = sketch.createWarp(offset, options)
  return {
    gl,
    frame(place, now) {
      millis = now
      draw = () => {
        sketch.background(0)
        sketch.noStroke()
        sketch.perspective(Math.PI / 3, 1, 0.03 * extent, 20 * extent)
        sketch.camera(...place, 0, 0, 0, 0, 1, 0)
        sketch.normalMaterial()
        warp()
        sketch.model(shape)
      }
      return sketch.redraw()
    },
    triangles: () => triangles,
    dispose: () => sketch.freeGeometry(shape),
  }
})
