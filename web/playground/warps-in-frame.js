/** Evaluates the warps of the visible sketch, each by its index: they are in its frame, whose answers are checked. */
import { evaluatedOf, maskOf, shapesOf } from './messages.js'

export const makeWarpsInFrame = (stage) => ({
  evaluate: async (index, mesh, options) =>
    evaluatedOf(await stage.ask('evaluate', index, mesh, options), mesh),
  foldedOf: async (index, mesh, options) =>
    maskOf(await stage.ask('foldover', index, mesh, options), mesh.positions.length / 3),
  shapesOf: async (index) => shapesOf(await stage.ask('shapes', index)),
})
