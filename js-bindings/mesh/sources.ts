// Reads the bytes of models, in browsers and in Node.
import { WarpError, describe, shorten } from '../errors/errors.js'
import type { Place } from '../options/place.js'

/** Bytes in any form. */
export type Bytes = ArrayBuffer | ArrayBufferView | Blob

/** Bytes, a URL, or a file that the user chose or dropped. In Node a string may be a path. */
export type Source = Bytes | URL | string

/** Returns the bytes of a file that a .gltf refers to, such as "scene.bin"; `undefined` if it does not exist. */
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
      // Used in place of import(): bundlers for browsers would follow it, and fail.
      getBuiltinModule<Name extends keyof NodeModules>(name: Name): NodeModules[Name]
      cwd(): string
    }
  | undefined

/** Returns Node's `process`; `undefined` elsewhere. */
const node = () => (typeof process === 'object' && process.versions?.node ? process : undefined)

/** The reason why a page with a file: address cannot load anything, for messages. */
export const filesAreClosed =
  'a page that was opened as a file may read no other file, so serve its folder, for example by: npx serve'

/** A file does not exist. */
class MissingFileError extends WarpError {}

/** Returns the bytes, in an array that may share its memory with the source. */
export async function readBytes(source: unknown, place: Place): Promise<Uint8Array> {
  if (source instanceof URL) return fetchBytes(source, place)
  const bytes = await toBytes(source, place)
  if (bytes) return bytes
  throw place.expected(
    'a URL, or bytes in an ArrayBuffer, a Uint8Array or a Blob',
    describe(source),
  )
}

async function toBytes(source: unknown, place: Place): Promise<Uint8Array | undefined> {
  if (source instanceof Uint8Array) return source
  if (ArrayBuffer.isView(source))
    return new Uint8Array(source.buffer, source.byteOffset, source.byteLength)
  if (source instanceof ArrayBuffer) return new Uint8Array(source)
  if (typeof Blob === 'function' && source instanceof Blob)
    return new Uint8Array(
      await source.arrayBuffer().catch((error: unknown) => {
        // The file was moved or changed since the user chose it.
        const reason = error instanceof Error ? ` (${shorten(error.name)})` : ''
        throw place.error(`the Blob or File cannot be read${reason}.`)
      }),
    )
  return undefined
}

/** Converts a string to a URL: relative to the page or, in Node, a path unless it has a scheme. Returns other values unchanged. */
export async function locate(source: unknown, place: Place): Promise<unknown> {
  if (typeof source !== 'string') return source
  if (!/^([a-z][a-z\d+.-]*:\/\/|(file|data|blob):)/i.test(source)) {
    const path = node()?.getBuiltinModule('node:url').pathToFileURL(source)
    if (path) return path
  }
  const url = parseUrl(source, pageUrl())
  if (!url) throw place.expected('a URL', `"${shorten(source)}"`)
  return url
}

function pageUrl(): string | undefined {
  if (node()) return undefined
  return typeof document === 'object' ? document.baseURI : globalThis.location?.href
}

function parseUrl(text: string, base?: string | URL): URL | undefined {
  try {
    return new URL(text, base)
  } catch {
    return undefined
  }
}

async function fetchBytes(url: URL, place: Place): Promise<Uint8Array> {
  const fileSystem = url.protocol === 'file:' && node()?.getBuiltinModule('node:fs/promises')
  if (fileSystem) return readFile(fileSystem, url, place)
  const message = (reason: string) => `${place.method}: cannot load ${addressOf(url)}; ${reason}.`
  let response: Response
  try {
    response = await fetch(url)
  } catch {
    const unreachable = 'there is no such server, or it does not allow this page to read from it'
    throw new WarpError(message(url.protocol === 'file:' ? filesAreClosed : unreachable))
  }
  const { ok, status } = response
  if (!ok)
    throw new (status === 404 ? MissingFileError : WarpError)(
      message(`the server answered ${status}`),
    )
  try {
    return new Uint8Array(await response.arrayBuffer())
  } catch {
    throw new WarpError(message('the connection was interrupted'))
  }
}

/** Shortens a URL for messages: drops the query, and the middle of long ones such as data:, but keeps the file name. */
function addressOf({ href }: URL): string {
  const address = href.split(/[?#]/)[0]!
  return address.length <= 160 ? address : `${address.slice(0, 60)}…${address.slice(-100)}`
}

async function readFile(
  fileSystem: NodeModules['node:fs/promises'],
  url: URL,
  place: Place,
): Promise<Uint8Array> {
  try {
    return await fileSystem.readFile(url)
  } catch (error) {
    const { code } = error as { code?: string }
    // No file has a URL with invalid percent signs.
    if (code === 'ENOENT' || error instanceof URIError)
      throw new MissingFileError(`${place.method}: the file ${pathOf(url)} does not exist.`)
    throw place.error(`the file ${pathOf(url)} cannot be read.`)
  }
}

/** Returns the decoded path of a URL, or the path as it is if its percent signs are invalid. */
function pathOf({ pathname }: URL): string {
  try {
    return decodeURIComponent(pathname)
  } catch {
    return pathname
  }
}

/** Returns whether a file is in a folder or below, after following symbolic links. */
async function isInFolder(folder: string, url: URL): Promise<boolean> {
  const { realpath } = node()!.getBuiltinModule('node:fs/promises')
  const { fileURLToPath, pathToFileURL } = node()!.getBuiltinModule('node:url')
  try {
    const file = pathToFileURL(await realpath(fileURLToPath(url)))
    const root = pathToFileURL((await realpath(fileURLToPath(folder))) + '/')
    return file.href.startsWith(root.href)
  } catch {
    // The file does not exist, or may not be accessed.
    return false
  }
}

/**
 * Returns a function that loads the files to which a model refers, only in its folder or below, so that an untrusted model cannot read
 * others. That function returns `undefined` for a file that does not exist, since a model works without its images; with `isOptional`
 * also for a file that cannot be loaded for another reason.
 */
export function resolveBeside(model: URL, place: Place, isOptional = false): Resolve {
  // A data: or blob: URL has no folder.
  const folder = parseUrl('.', model)?.href
  return async (uri) => {
    const url = parseUrl(uri, model)
    if (folder === undefined || !url?.href.startsWith(folder)) return undefined
    if (node() && url.protocol === 'file:' && !(await isInFolder(folder, url))) return undefined
    try {
      return await fetchBytes(url, place)
    } catch (error) {
      if (error instanceof MissingFileError || (isOptional && error instanceof WarpError))
        return undefined
      throw error
    }
  }
}

/**
 * Imports a package that is installed next to this library in Node, or that the page's import map names. The comments in the call keep
 * bundlers from following the import: webpack would fail on a missing package, and on Node modules that an installed one imports.
 */
export const importPackage = (name: string): Promise<unknown> =>
  import(/* @vite-ignore */ /* webpackIgnore: true */ name)

/** Imports a package that is installed in Node's working directory; under npx, this library is installed elsewhere. */
export async function importFromWorkingFolder(name: string): Promise<unknown> {
  const process = node()
  if (!process) return undefined
  const require = process.getBuiltinModule('node:module').createRequire(`${process.cwd()}/`)
  const url = process.getBuiltinModule('node:url').pathToFileURL(require.resolve(name))
  return import(/* @vite-ignore */ /* webpackIgnore: true */ url.href)
}
