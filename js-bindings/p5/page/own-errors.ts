/** Converts errors of 'warpjet/mesh', which is a separate module. */
import { WarpError } from '../../errors/errors.js'

/** Calls `work`, and converts a `WarpError` of the other module, which has its own copy of the class, to ours. */
export async function withOwnErrors<Result>(work: () => Result): Promise<Awaited<Result>> {
  try {
    return await work()
  } catch (error) {
    const { name, message } = error as Error
    if (name !== 'WarpError') throw error
    throw new WarpError(message.replaceAll('loadMesh', 'loadWarpModel'))
  }
}
