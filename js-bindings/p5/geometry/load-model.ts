/** `loadWarpModel`: loads a file as a p5.Geometry. */
import { importMesh } from '#mesh'
import { withOwnErrors } from '../page/own-errors.js'
import type { LoadModelOptions, P5Constructors, WarpModel } from './model.js'

export type { LoadModelOptions, WarpModel } from './model.js'

/**
 * The type of a sketch's models, inferred from the parameters of the sketch's methods, so that it works with p5's own types, with those of
 * @types/p5 and without types.
 */
export type ModelOf<Sketch> = Sketch extends {
  model: (geometry: infer Geometry, ...others: never) => unknown
  texture: (picture: infer Picture, ...others: never) => unknown
}
  ? Geometry & Omit<WarpModel, 'texture'> & { texture?: Picture }
  : WarpModel

let modelCount = 0

/** Makes an empty model with its own id, under which p5 keeps the buffers of the model. */
export function emptyModel({ Geometry }: P5Constructors, renderer?: object): WarpModel {
  const model = new Geometry(undefined, undefined, undefined, renderer)
  model.gid = `warpjet|${modelCount++}`
  model.warnings = []
  return model
}

/** Reads a file into the model. */
export const fillModel = (
  model: WarpModel,
  p5: P5Constructors,
  url: string | URL,
  options?: LoadModelOptions,
): Promise<void> =>
  withOwnErrors(async () => {
    const { fillP5Model } = await importMesh('loadWarpModel')
    await fillP5Model(model, p5, url, options)
  })

/** The part of p5 1.x that counts pending loads in `preload()`. */
export interface Preloading {
  _decrementPreload(): void
}

/**
 * Makes the model a thenable, for p5 1.x: like p5's `loadModel`, ours returns the model at once and fills it later, but it can also be
 * awaited. The promise resolves to the model, which must not have a `then` by that time, or it would be awaited again.
 */
export function makeAwaitable(
  model: WarpModel,
  filling: Promise<void>,
  sketch: Preloading,
): Promise<WarpModel> {
  const filled = filling.then(() => {
    delete (model as { then?: unknown }).then
    sketch._decrementPreload()
    return model
  })
  return Object.defineProperty(model, 'then', {
    value: filled.then.bind(filled),
    configurable: true,
  }) as unknown as Promise<WarpModel>
}
