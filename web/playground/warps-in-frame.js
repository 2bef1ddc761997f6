/** Evaluates warps of the visible sketch, by index. The sketch's frame does this, so its answers are validated. */
import { evaluatedOf, maskOf, shapesOf } from './messages.js'

export const makeWarpsInFrame = (stage) => ({
  evaluate: async (index, mesh, options) =>
    evaluatedOf(await stage.ask('evaluate', index, mesh, options), mesh),
  foldedOf: async (index, mesh, options) =>
    maskOf(await stage.ask('foldover', index, mesh, options), mesh.positions.length / 3),
  shapesOf: async (index) => shapesOf(await stage.ask('shapes', index)),
})
