/**
 * `mesh-module.ts` for the single script, which has 'warpjet/mesh' beside it. A relative import would not do: a script
 * from another server, such as a CDN, has no address of its own to start from.
 */
import { WarpError } from '../errors.js'
import { version } from '../generated/version.js'

// Only known while the script itself runs. One that stands in the page or in a bundle takes the package's copy.
const script =
  (typeof document === 'object' && (document.currentScript as HTMLScriptElement | null)?.src) ||
  `https://cdn.jsdelivr.net/npm/warpjet@${version}/dist/`

/** For `method`, which a sketch called. */
export async function importMesh(method: string): Promise<typeof import('../mesh.js')> {
  const { href } = new URL('mesh.js', script)
  try {
    return await import(/* @vite-ignore */ href)
  } catch {
    throw new WarpError(
      `${method}: it needs ${href}, which cannot be loaded; copy all of the package's dist folder to where the script is.`,
    )
  }
}
