/**
 * The benchmark's first row as a sketch, with and without the warp. Opened as p5-sketch.html?p5=/p5.js&size=1200&millis=1200, the
 * page sets `window.sketch`, a promise of { version, vertices, draw }; p5.js opens it in an iframe. `draw(isWarped)` resolves when
 * the GPU is done.
 */
import { defaultEye } from './scene.js'
import { workloads } from './workloads.js'

const [workload] = workloads

const load = (src) =>
  new Promise((loaded, failed) => {
    const script = Object.assign(document.createElement('script'), { src, onload: loaded })
    script.onerror = () => failed(new Error(`Cannot load ${src} from the benchmark's server.`))
    document.head.append(script)
  })

const triples = (values) =>
  Array.from({ length: values.length / 3 }, (_, i) => [...values.subarray(3 * i, 3 * i + 3)])

/** @param move maps a position → the position that is drawn */
const createGeometry = (p5, name, { positions, normals, indices }, move) =>
  new p5.Geometry(1, 1, function () {
    const vector = (xyz) => new p5.Vector(...xyz)
    this.gid = name
    this.vertices = triples(positions).map((position) => vector(move(position)))
    this.vertexNormals = triples(normals).map(vector)
    this.uvs = triples(normals).flatMap(([x, y]) => [x, y])
    this.faces = triples(indices)
  })

/** Starts the sketch and resolves when its first frame is drawn. */
function open(p5, size, millis) {
  const version = p5.VERSION ?? p5.prototype.VERSION
  let unwarpedModel, warpedModel, warp
  let isWarped = false
  return new Promise((opened) => {
    new p5((sketch) => {
      sketch.millis = () => millis

      sketch.setup = () => {
        sketch.pixelDensity(1)
        sketch.createCanvas(size, size, sketch.WEBGL)
        // Match the benchmark's other canvases.
        sketch.setAttributes('antialias', false)
        sketch.noLoop()
        const mesh = workload.mesh()
        unwarpedModel = createGeometry(p5, 'unwarped', mesh, (p) => p)
        // p5 spends most of its time on pixels, so the pictures with and without the warp must cover the same pixels.
        warpedModel = createGeometry(p5, 'warped', mesh, (p) => {
          const offset = workload.offset(p, { millis })
          return p.map((value, i) => value + offset[i])
        })
        warp = sketch.createWarp(workload.warp, { normals: 'vertex' })
      }

      sketch.draw = () => {
        sketch.background('#141724')
        // Match the camera of scene.js; p5's y axis points down.
        sketch.perspective(0.75, 1, 10, 2000)
        sketch.camera(...defaultEye, 0, 0, 0, 0, 1, 0)
        sketch.ambientLight(100)
        sketch.directionalLight(sketch.color('#fff0dd'), -0.39, -0.62, -0.68)
        sketch.directionalLight(sketch.color('#4463d6'), 0.78, -0.17, 0.6)
        sketch.noStroke()
        sketch.fill('#ff8a5b')
        sketch.specularMaterial(90)
        sketch.shininess(40)
        // The warp applies until pop().
        sketch.push()
        if (isWarped) warp()
        sketch.model(isWarped ? unwarpedModel : warpedModel)
        sketch.pop()
        opened({ version, vertices: unwarpedModel.vertices.length, draw })
      }

      async function draw(withWarp) {
        isWarped = withWarp
        await sketch.redraw()
        const gl = sketch.drawingContext
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))
      }
    }, document.body)
  })
}

async function start() {
  const options = new URLSearchParams(location.search)
  await load(options.get('p5'))
  await load('/dist/p5.warpjet.min.js')
  return open(window.p5, Number(options.get('size')), Number(options.get('millis')))
}

window.sketch = start()
