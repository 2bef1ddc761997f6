// Decoders of compressed models, either passed by the caller or found on the page or in a package.
import { describe } from '../errors/errors.js'
import { anything, optional } from '../options/kinds.js'
import type { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import { importFromWorkingFolder, importPackage } from './sources.js'

/** `MeshoptDecoder` of the package meshoptimizer. */
export interface MeshoptDecoder {
  readonly ready: Promise<void>
  decodeGltfBuffer(
    target: Uint8Array,
    count: number,
    size: number,
    source: Uint8Array,
    mode: string,
    filter?: string,
  ): void
}

/** The module that `createDecoderModule` of the package draco3dgltf resolves to. */
export interface DracoDecoderModule {
  Decoder: unknown
  DecoderBuffer: unknown
  Mesh: unknown
}

/**
 * Decoders of compressed glTF files. The default of each is the page's global `MeshoptDecoder` or `DracoDecoderModule`, or the
 * package: in Node the installed one, in a page the one that an import map names. A project with a bundler must pass the decoder.
 */
export interface Decoders {
  /** For `EXT_meshopt_compression` and `KHR_meshopt_compression`: `MeshoptDecoder` of the package meshoptimizer. */
  meshopt?: MeshoptDecoder | Promise<MeshoptDecoder>
  /**
   * For `KHR_draco_mesh_compression`: the package draco3dgltf, its `createDecoderModule`, the function `DracoDecoderModule` of
   * Draco's script, or the module that these functions return.
   */
  draco?:
    | DracoDecoderModule
    | Promise<DracoDecoderModule>
    | (() => DracoDecoderModule | Promise<DracoDecoderModule>)
    | { createDecoderModule(): Promise<unknown> }
}

export type Codec = keyof Decoders

interface Source {
  global: string
  package: string
  /** Resolves to a ready decoder made from the caller's value; `undefined` if that is not a decoder. */
  prepare(value: unknown): Promise<unknown>
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  (typeof value === 'object' || typeof value === 'function') && value !== null

const sources: Record<Codec, Source> = {
  meshopt: {
    global: 'MeshoptDecoder',
    package: 'meshoptimizer',
    async prepare(value) {
      const decoder = await value
      if (!isObject(decoder) || typeof decoder.decodeGltfBuffer !== 'function') return undefined
      await decoder.ready
      return decoder
    },
  },
  draco: {
    global: 'DracoDecoderModule',
    package: 'draco3dgltf',
    async prepare(value) {
      let module: unknown = await value
      // A CommonJS package is the default export of its module in Node.
      for (const name of ['default', 'createDecoderModule'])
        if (isObject(module) && !isDraco(module) && name in module) module = module[name]
      // Draco's factory modifies the options passed to it.
      if (typeof module === 'function') module = await (module as (options: object) => unknown)({})
      return isDraco(module) ? module : undefined
    },
  },
}

/** Returns a package's member `name`, or else the package itself. */
const memberOr = (found: unknown, name: string) =>
  isObject(found) && name in found ? found[name] : found

const isDraco = (value: unknown) => isObject(value) && typeof value.DecoderBuffer === 'function'

/** The kind of the option `decoders`. */
export const decodersKind = optional(
  object({ meshopt: anything(), draco: anything() } satisfies KindsOf<Record<Codec, unknown>>),
)

/** Returns the ready decoder; `undefined` if none was passed or found. */
export async function findDecoder(
  place: Place,
  codec: Codec,
  decoders: Decoders = {},
): Promise<unknown> {
  const source = sources[codec]
  const value: unknown = decoders[codec] ?? (globalThis as Record<string, unknown>)[source.global]
  if (value !== undefined) {
    const decoder = await source.prepare(value)
    if (decoder) return decoder
    const where = decoders[codec]
      ? place.option('decoders').option(codec)
      : place.part(`the global ${source.global}`)
    throw where.expected(`the decoder of the package ${source.package}`, describe(value))
  }
  for (const find of [importPackage, importFromWorkingFolder])
    try {
      const decoder = await source.prepare(memberOr(await find(source.package), source.global))
      if (decoder) return decoder
    } catch {
      // The package is not installed, or not accessible to the page.
    }
  return undefined
}

/** Returns the end of a message: advice on how to get a decoder. */
export const adviceFor = (codec: Codec) => {
  const { global, package: name } = sources[codec]
  return `install the package ${name}, pass its decoder as loadMesh(model, { decoders: { ${codec}: … } }), or add its script, which defines ${global}`
}
