// Decoders of compressed models: given by the caller, or found.
import { WarpError, describe } from '../errors/errors.js'
import { checkOptions } from '../options/options.js'
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
 * package: in Node the installed one, in a page the one that an import map names. A project with a bundler gives its decoder.
 */
export interface Decoders {
  /** For `EXT_meshopt_compression` and `KHR_meshopt_compression`: `MeshoptDecoder` of the package meshoptimizer. */
  meshopt?: MeshoptDecoder | Promise<MeshoptDecoder>
  /**
   * For `KHR_draco_mesh_compression`: the package draco3dgltf, its `createDecoderModule`, the function `DracoDecoderModule` of
   * Draco's script, or the module that they make.
   */
  draco?:
    | DracoDecoderModule
    | Promise<DracoDecoderModule>
    | (() => DracoDecoderModule | Promise<DracoDecoderModule>)
    | { createDecoderModule(): Promise<unknown> }
}

export type Codec = keyof Decoders

interface Kind {
  global: string
  package: string
  /** Resolves to a ready decoder made from the caller's value; `undefined` if that is no decoder. */
  prepare(given: unknown): Promise<unknown>
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  (typeof value === 'object' || typeof value === 'function') && value !== null

const kinds: Record<Codec, Kind> = {
  meshopt: {
    global: 'MeshoptDecoder',
    package: 'meshoptimizer',
    async prepare(given) {
      const decoder = await given
      if (!isObject(decoder) || typeof decoder.decodeGltfBuffer !== 'function') return undefined
      await decoder.ready
      return decoder
    },
  },
  draco: {
    global: 'DracoDecoderModule',
    package: 'draco3dgltf',
    async prepare(given) {
      let module: unknown = await given
      // A CommonJS package is the default export of its module in Node.
      for (const name of ['default', 'createDecoderModule'])
        if (isObject(module) && !isDraco(module) && name in module) module = module[name]
      // Draco's factory changes the options that it is given.
      if (typeof module === 'function') module = await (module as (options: object) => unknown)({})
      return isDraco(module) ? module : undefined
    },
  },
}

/** A package's member of that name, if it has one. */
const memberOr = (found: unknown, name: string) =>
  isObject(found) && name in found ? found[name] : found

const isDraco = (value: unknown) => isObject(value) && typeof value.DecoderBuffer === 'function'

/** The ready decoder, or `undefined` if none was given or found. */
export async function findDecoder(
  method: string,
  codec: Codec,
  decoders: Decoders = {},
): Promise<unknown> {
  const kind = kinds[codec]
  const given: unknown = decoders[codec] ?? (globalThis as Record<string, unknown>)[kind.global]
  if (given !== undefined) {
    const decoder = await kind.prepare(given)
    if (decoder) return decoder
    const place = decoders[codec] ? `the option "decoders.${codec}"` : `the global ${kind.global}`
    throw new WarpError(
      `${method}: expected ${place} to be the decoder of the package ${kind.package}, got ${describe(given)}.`,
    )
  }
  for (const find of [importPackage, importFromWorkingFolder])
    try {
      const decoder = await kind.prepare(memberOr(await find(kind.package), kind.global))
      if (decoder) return decoder
    } catch {
      // The package is not installed, or a page has no way to it.
    }
  return undefined
}

/** The end of a message: how to get a decoder. */
export const adviceFor = (codec: Codec) => {
  const { global, package: name } = kinds[codec]
  return `install the package ${name}, hand its decoder over as loadMesh(model, { decoders: { ${codec}: … } }), or add its script, which defines ${global}`
}

export function checkDecoders(
  method: string,
  given: unknown,
): asserts given is Decoders | undefined {
  checkOptions(`${method}: decoders`, given, Object.keys(kinds))
}
