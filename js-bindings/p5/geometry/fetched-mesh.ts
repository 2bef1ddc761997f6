/**
 * Loads the mesh module for the page's main script: it is the file mesh.min.js beside that. A relative import would not do,
 * since a script from another server, such as a CDN, has no address of its own to start from.
 */
import { WarpError } from '../../errors/errors.js'
import { version } from '../../generated/version.js'
import { filesAreClosed } from '../../mesh/sources.js'

/** What mesh.min.js of this build must be, as the attribute `integrity` has it. By .scripts/vite.library.mjs. */
declare const meshIntegrity: string

// Only known while the script itself runs. One that stands in the page or in a bundle has no address.
const script =
  typeof document === 'object' ? (document.currentScript as HTMLScriptElement | null) : null
const address = script?.src ?? ''

/**
 * Whether the file beside this script is ours: not where the address only stands for the script, as a bare
 * `https://cdn.jsdelivr.net/npm/warpjet` does, beside which another package lies, nor where several files were made one.
 */
const isNamed = /^[^,?#]*\/p5\.warpjet\.min\.js([?#]|$)/.test(address)

/** For `method`, which a sketch called. */
export async function importMesh(method: string): Promise<typeof import('./with-mesh.js')> {
  const href = isNamed
    ? new URL('mesh.min.js', address).href
    : `https://cdn.jsdelivr.net/npm/warpjet@${version}/dist/mesh.min.js`
  try {
    if (!isNamed) await fetchChecked(href)
    return await import(/* @vite-ignore */ href)
  } catch {
    const why = href.startsWith('file:')
      ? filesAreClosed
      : isNamed
        ? "copy it there, from the package's folder dist"
        : 'check the connection, or copy it and this script, under their own names, from the package to a folder of yours'
    throw new WarpError(`${method}: it needs ${href}, which cannot be loaded; ${why}.`)
  }
}

/** `import` checks no hash, but takes the module that a tag has fetched before it. */
const fetchChecked = (src: string) =>
  new Promise((onload, onerror) => {
    const tag = document.createElement('script')
    const nonce = script?.nonce
    Object.assign(
      tag,
      { type: 'module', crossOrigin: 'anonymous', integrity: meshIntegrity, src, onload, onerror },
      nonce && { nonce },
    )
    document.head.append(tag)
  })
