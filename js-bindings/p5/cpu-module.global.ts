/** `cpu-module.ts` for the single scripts, which have it, or, slim, have none. */
import { runOnCpu } from '../compile/compile-warp.js'

export const importCpu = (): Promise<{ runOnCpu: typeof runOnCpu | undefined }> =>
  Promise.resolve({ runOnCpu })
