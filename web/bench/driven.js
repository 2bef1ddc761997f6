/** `window.bench`: the benchmark without a visible picture, for a script that drives the page. */
import './memory.js'
import { frameRate } from './frame-rate.js'
import { measureRow } from './measure.js'
import { measureP5, p5FrameRates } from './p5.js'
import { Scene } from './scene.js'
import { workloads } from './workloads.js'

const canvas = document.body.appendChild(document.createElement('canvas'))
let scene

const findWorkload = (name) => workloads.find((workload) => workload.name === name)

window.bench = {
  rows: workloads.map(({ name, nodes }) => ({ name, nodes })),

  /** Opens a canvas of `size` × `size` pixels and returns the name of the renderer. */
  open(size) {
    scene = new Scene(canvas, size)
    return scene.renderer
  },

  measure(name, settings) {
    // Hidden, because compositing a visible canvas after each frame takes time from the next one.
    canvas.hidden = true
    return measureRow(scene, findWorkload(name), settings)
  },

  /** The browser decides whether vsync caps the rate. @param steps the best h by method @returns frames per second by method */
  async frameRates(name, steps, duration) {
    canvas.hidden = false
    const workload = findWorkload(name)
    scene.load(workload.mesh())
    const rates = {}
    for (const [method, h] of Object.entries(steps)) {
      rates[method] = await frameRate(scene, workload, method, h, duration)
    }
    return rates
  },

  measureP5: (settings) => measureP5(settings),
  p5FrameRates: (settings) => p5FrameRates(settings),
}
