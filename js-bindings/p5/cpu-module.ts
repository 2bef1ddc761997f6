/** What runs warps on the CPU, fetched when it is first needed: whoever bundles this makes it a file of its own. */
import type { runOnCpu } from '../compile/compile-warp.js'

export const importCpu = (): Promise<{ runOnCpu: typeof runOnCpu | undefined }> =>
  import('../compile/compile-warp.js')
