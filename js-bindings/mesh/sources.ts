// Where the bytes of a model come from, in browsers and in Node.
import { WarpError, describe, shorten } from '../errors.js'

/** Bytes, or something that has them. */
export type Bytes = ArrayBuffer | ArrayBufferView | Blob

/** Bytes, an address, or a file that the user chose or dropped. In Node a text may be a path. */
export type Source = Bytes | URL | string

/** The bytes of a further file that a .gltf names, such as "scene.bin"; nothing if there is none. */
export type Resolve = (uri: string) => Bytes | undefined | Promise<Bytes | undefined>

declare const process: { versions?: { node?: string }; cwd(): string } | undefined

/** Where a path of Node is looked for; nothing in a browser. */
const workingFolder = () =>
  typeof process === 'object' && process.versions?.node ? process.cwd() : undefined

// In a variable, or bundlers for browsers would look for it.
const fileSystem = 'node:fs/promises'

/** The bytes, in an array that may share its memory with the source. */
export async function readBytes(source: unknown, method: string): Promise<Uint8Array> {
  if (source instanceof URL) return fetchBytes(source, method)
  const bytes = await toBytes(source)
  if (bytes) return bytes
  throw new WarpError(
    `${method}: a URL, or bytes in an ArrayBuffer, a Uint8Array or a Blob, were expected, but ${describe(source)} came.`,
  )
}

async function toBytes(source: unknown): Promise<Uint8Array | undefined> {
  if (source instanceof Uint8Array) return source
  if (ArrayBuffer.isView(source))
    return new Uint8Array(source.buffer, source.byteOffset, source.byteLength)
  if (source instanceof ArrayBuffer) return new Uint8Array(source)
  if (typeof Blob === 'function' && source instanceof Blob)
    return new Uint8Array(await source.arrayBuffer())
  return undefined
}

/** A text as a URL: relative to the page, or in Node to the working directory; anything else as it is. */
export function locate(source: unknown, method: string): unknown {
  if (typeof source !== 'string') return source
  try {
    return new URL(source, baseUrl(source))
  } catch {
    throw new WarpError(`${method}: "${shorten(source)}" is no URL.`)
  }
}

function baseUrl(text: string): string | undefined {
  const folder = workingFolder()
  if (folder === undefined)
    return typeof document === 'object' ? document.baseURI : globalThis.location?.href
  return /^[a-z][a-z\d+.-]+:/i.test(text) ? undefined : `${pathUrl(folder)}/`
}

const pathUrl = (path: string) =>
  `file://${path
    .replaceAll('\\', '/')
    .replace(/^(?!\/)/, '/')
    .split('/')
    .map(encodeURIComponent)
    .join('/')}`

async function fetchBytes(url: URL, method: string): Promise<Uint8Array> {
  if (workingFolder() !== undefined && url.protocol === 'file:') return readFile(url, method)
  const failed = (why: string) =>
    new WarpError(`${method}: ${shorten(url.href)} cannot be loaded; ${why}.`)
  let response: Response
  try {
    response = await fetch(url)
  } catch {
    throw failed('there is no such server, or it does not allow this page to read from it')
  }
  if (!response.ok) throw failed(`the server answered ${response.status}`)
  return new Uint8Array(await response.arrayBuffer())
}

async function readFile(url: URL, method: string): Promise<Uint8Array> {
  const { readFile } = await import(/* @vite-ignore */ fileSystem)
  try {
    return await readFile(url)
  } catch (error) {
    const missing = (error as { code?: string }).code === 'ENOENT'
    throw new WarpError(
      `${method}: the file ${decodeURIComponent(url.pathname)} ${missing ? 'does not exist' : 'cannot be read'}.`,
    )
  }
}

/**
 * The further files of a model where it lies itself: only those beside or below it, so that a file from a stranger reads
 * nothing else.
 */
export function resolveBeside(model: URL, method: string): Resolve {
  const folder = new URL('.', model).href
  return async (uri) => {
    const url = new URL(uri, model)
    return url.href.startsWith(folder) ? fetchBytes(url, method) : undefined
  }
}
