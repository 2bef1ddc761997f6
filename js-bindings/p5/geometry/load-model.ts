/** `loadWarpModel`: a file as a p5.Geometry. */
import type { LoadModelOptions, Makers, WarpModel } from './model.js'
import { importMesh } from '#mesh'
import { withOwnErrors } from '../page/own-errors.js'

export type { LoadModelOptions, WarpModel } from './model.js'

/**
 * Found by what the sketch's own methods take, so that p5's types, those of @types/p5 and none at all will do.
 */
export type ModelOf<Sketch> = Sketch extends {
  model: (geometry: infer Geometry, ...others: never) => unknown
  texture: (picture: infer Picture, ...others: never) => unknown
}
  ? Geometry & Omit<WarpModel, 'texture'> & { texture?: Picture }
  : WarpModel

let made = 0

/** An empty model of this sketch: p5 keeps what it draws under the model's id. */
export function emptyModel({ Geometry }: Makers, renderer?: object): WarpModel {
  const model = new Geometry(undefined, undefined, undefined, renderer)
  model.gid = `warpjet|${made++}`
  model.warnings = []
  return model
}

/** Fills the model with what is in the file. */
export const fillModel = (
  model: WarpModel,
  p5: Makers,
  url: string | URL,
  options?: LoadModelOptions,
): Promise<void> =>
  withOwnErrors(async () => {
    const { fillP5Model } = await importMesh('loadWarpModel')
    await fillP5Model(model, p5, url, options)
  })

/** What p5 1.x counts while it preloads. */
export interface Preloading {
  _decrementPreload(): void
}

/**
 * For p5 1.x, where `loadModel` gives its model at once and fills it: the same, and it can be awaited. Awaiting ends with
 * the model, which therefore must not look like a promise any more by then.
 */
export function awaitable(
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
