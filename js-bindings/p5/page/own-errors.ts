/** Errors of 'warpjet/mesh', which is a module of its own. */
import { WarpError } from '../../errors/errors.js'

/** The other module has a `WarpError` of its own. */
export async function withOwnErrors<Result>(work: () => Result): Promise<Awaited<Result>> {
  try {
    return await work()
  } catch (error) {
    const { name, message } = error as Error
    if (name !== 'WarpError') throw error
    throw new WarpError(message.replaceAll('loadMesh', 'loadWarpModel'))
  }
}
