// Where the bytes of a model come from, in browsers and in Node.
import { WarpError, describe, shorten } from '../errors/errors.js'

/** Bytes, or something that has them. */
export type Bytes = ArrayBuffer | ArrayBufferView | Blob

/** Bytes, an address, or a file that the user chose or dropped. In Node a text may be a path. */
export type Source = Bytes | URL | string

/** The bytes of a further file that a .gltf names, such as "scene.bin"; nothing if there is none. */
export type Resolve = (uri: string) => Bytes | undefined | Promise<Bytes | undefined>

interface NodeModules {
  'node:fs/promises': {
    readFile(url: URL): Promise<Uint8Array>
    realpath(path: string): Promise<string>
  }
  'node:url': { pathToFileURL(path: string): URL; fileURLToPath(url: URL | string): string }
  'node:module': { createRequire(path: string): { resolve(name: string): string } }
}

declare const process:
  | {
      versions?: { node?: string }
      // Not import(), which bundlers follow, those for browsers into an error.
      getBuiltinModule<Name extends keyof NodeModules>(name: Name): NodeModules[Name]
      cwd(): string
    }
  | undefined

/** Node, or nothing. */
const node = () => (typeof process === 'object' && process.versions?.node ? process : undefined)

/** Why a browser gives nothing that lies at a file: address. */
export const filesAreClosed =
  'a page that was opened as a file may read no other file, so serve its folder, for example by: npx serve'

/** Nothing is there. */
class Missing extends WarpError {}

/** The bytes, in an array that may share its memory with the source. */
export async function readBytes(source: unknown, method: string): Promise<Uint8Array> {
  if (source instanceof URL) return fetchBytes(source, method)
  const bytes = await toBytes(source, method)
  if (bytes) return bytes
  throw new WarpError(
    `${method}: a URL, or bytes in an ArrayBuffer, a Uint8Array or a Blob, were expected, but ${describe(source)} came.`,
  )
}

async function toBytes(source: unknown, method: string): Promise<Uint8Array | undefined> {
  if (source instanceof Uint8Array) return source
  if (ArrayBuffer.isView(source))
    return new Uint8Array(source.buffer, source.byteOffset, source.byteLength)
  if (source instanceof ArrayBuffer) return new Uint8Array(source)
  if (typeof Blob === 'function' && source instanceof Blob)
    return new Uint8Array(
      await source.arrayBuffer().catch((error: unknown) => {
        // A file of the user that was moved or changed since it was chosen.
        const reason = error instanceof Error ? ` (${shorten(error.name)})` : ''
        throw new WarpError(`${method}: the Blob or File cannot be read${reason}.`)
      }),
    )
  return undefined
}

/** A text as a URL: relative to the page, or in Node a path unless it says otherwise; anything else as it is. */
export async function locate(source: unknown, method: string): Promise<unknown> {
  if (typeof source !== 'string') return source
  if (!/^([a-z][a-z\d+.-]*:\/\/|(file|data|blob):)/i.test(source)) {
    const path = node()?.getBuiltinModule('node:url').pathToFileURL(source)
    if (path) return path
  }
  const url = parsed(source, pageUrl())
  if (!url) throw new WarpError(`${method}: "${shorten(source)}" is no URL.`)
  return url
}

function pageUrl(): string | undefined {
  if (node()) return undefined
  return typeof document === 'object' ? document.baseURI : globalThis.location?.href
}

function parsed(text: string, base?: string | URL): URL | undefined {
  try {
    return new URL(text, base)
  } catch {
    return undefined
  }
}

async function fetchBytes(url: URL, method: string): Promise<Uint8Array> {
  const files = url.protocol === 'file:' && node()?.getBuiltinModule('node:fs/promises')
  if (files) return readFile(files, url, method)
  const sentence = (why: string) => `${method}: ${addressOf(url)} cannot be loaded; ${why}.`
  let response: Response
  try {
    response = await fetch(url)
  } catch {
    const unreachable = 'there is no such server, or it does not allow this page to read from it'
    throw new WarpError(sentence(url.protocol === 'file:' ? filesAreClosed : unreachable))
  }
  const { ok, status } = response
  if (!ok)
    throw new (status === 404 ? Missing : WarpError)(sentence(`the server answered ${status}`))
  try {
    return new Uint8Array(await response.arrayBuffer())
  } catch {
    throw new WarpError(sentence('the connection broke off'))
  }
}

/** Without what follows the file's name, which must be seen; data: has no end. */
function addressOf({ href }: URL): string {
  const address = href.split(/[?#]/)[0]!
  return address.length <= 160 ? address : `${address.slice(0, 60)}…${address.slice(-100)}`
}

async function readFile(
  files: NodeModules['node:fs/promises'],
  url: URL,
  method: string,
): Promise<Uint8Array> {
  try {
    return await files.readFile(url)
  } catch (error) {
    const { code } = error as { code?: string }
    // Percent signs that stand for nothing name no file.
    if (code === 'ENOENT' || error instanceof URIError)
      throw new Missing(`${method}: the file ${pathOf(url)} does not exist.`)
    throw new WarpError(`${method}: the file ${pathOf(url)} cannot be read.`)
  }
}

/** As people write it, unless its percent signs stand for nothing. */
function pathOf({ pathname }: URL): string {
  try {
    return decodeURIComponent(pathname)
  } catch {
    return pathname
  }
}

/** Whether no symbolic link leads from there out of the folder. */
async function staysIn(folder: string, url: URL): Promise<boolean> {
  const { realpath } = node()!.getBuiltinModule('node:fs/promises')
  const { fileURLToPath, pathToFileURL } = node()!.getBuiltinModule('node:url')
  try {
    const file = pathToFileURL(await realpath(fileURLToPath(url)))
    const home = pathToFileURL((await realpath(fileURLToPath(folder))) + '/')
    return file.href.startsWith(home.href)
  } catch {
    // It does not exist, or nobody may look there.
    return false
  }
}

/**
 * Resolves the further files of a model: only those beside or below it, so that an untrusted model reads nothing else. The
 * result is empty for a file that does not exist, since a model can do without its pictures; with `canDoWithout` also for one
 * that cannot be loaded for any other reason.
 */
export function resolveBeside(model: URL, method: string, canDoWithout = false): Resolve {
  // A data: or blob: URL has nothing beside it.
  const folder = parsed('.', model)?.href
  return async (uri) => {
    const url = parsed(uri, model)
    if (folder === undefined || !url?.href.startsWith(folder)) return undefined
    if (node() && url.protocol === 'file:' && !(await staysIn(folder, url))) return undefined
    try {
      return await fetchBytes(url, method)
    } catch (error) {
      if (error instanceof Missing || (canDoWithout && error instanceof WarpError)) return undefined
      throw error
    }
  }
}

/**
 * A package that is installed beside this library in Node, or that the page's import map names. Bundlers leave the import as it
 * is: webpack would fail where the package is missing, and where it is there, on what it imports of Node.
 */
export const importPackage = (name: string): Promise<unknown> =>
  import(/* @vite-ignore */ /* webpackIgnore: true */ name)

/** A package that is installed where Node was started, which need not be where this library is, as with npx. */
export async function importFromWorkingFolder(name: string): Promise<unknown> {
  const here = node()
  if (!here) return undefined
  const require = here.getBuiltinModule('node:module').createRequire(`${here.cwd()}/`)
  const url = here.getBuiltinModule('node:url').pathToFileURL(require.resolve(name))
  return import(/* @vite-ignore */ /* webpackIgnore: true */ url.href)
}
