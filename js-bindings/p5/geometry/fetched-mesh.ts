/**
 * Loads the mesh module for the page's main script, from the file mesh.min.js in the same folder. A relative import would
 * not work: in a script from another server, such as a CDN, it resolves against the page.
 */
import { WarpError } from '../../errors/errors.js'
import { version } from '../../generated/version.js'
import { filesAreClosed } from '../../mesh/sources.js'

/** The hash of mesh.min.js in this build, for the `integrity` attribute. Defined by .scripts/vite.library.mjs. */
declare const meshIntegrity: string

// Only available while the script itself runs. A script inline in the page or in a bundle has no address.
const script =
  typeof document === 'object' ? (document.currentScript as HTMLScriptElement | null) : null
const address = script?.src ?? ''

/**
 * True if mesh.min.js lies next to this script. False if the address combines several files, or is an alias such as
 * `https://cdn.jsdelivr.net/npm/warpjet`, whose siblings are other packages.
 */
const isNextToMesh = /^[^,?#]*\/p5\.warpjet\.min\.js([?#]|$)/.test(address)

/** `method` is the function that the sketch called, for messages. */
export async function importMesh(method: string): Promise<typeof import('./with-mesh.js')> {
  const href = isNextToMesh
    ? new URL('mesh.min.js', address).href
    : `https://cdn.jsdelivr.net/npm/warpjet@${version}/dist/mesh.min.js`
  try {
    if (!isNextToMesh) await fetchChecked(href)
    return await import(/* @vite-ignore */ href)
  } catch {
    const why = href.startsWith('file:')
      ? filesAreClosed
      : isNextToMesh
        ? "copy it there, from the package's folder dist"
        : 'check the connection, or copy it and this script from the package to your own folder, without renaming them'
    throw new WarpError(`${method}: cannot load ${href}; ${why}.`)
  }
}

/** Fetches a module by a script tag, which checks its hash. `import` checks no hash, but reuses a module that a tag has fetched. */
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
