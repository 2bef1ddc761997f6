// Decodes the compressed parts of a glTF.
import { shorten } from '../errors/errors.js'
import { adviceFor, type Codec, type MeshoptDecoder } from './decoders.js'
import { decodeDraco, type DracoModule, type DracoPlan } from './draco.js'
import type { Job } from './job.js'

/** Maps a codec to its decoder, or to `undefined` if none was found. */
export type FoundDecoders = Map<Codec, unknown>

/** The plan of a part, as documented in gltf/packed_part.hpp. */
type Plan = { extension: string; isOptional: boolean } & (
  | { codec: 'meshopt'; count: number; byteStride: number; mode: string; filter: string }
  | ({ codec: 'draco' } & DracoPlan)
)

/** Decodes all compressed parts of the job's file, or returns the codecs whose decoders we have not searched for yet. */
export function unpackParts(job: Job, found: FoundDecoders): Codec[] {
  const plans = job.act('findPacked').map((text) => JSON.parse(text) as Plan)
  const unknown = new Set(plans.map(({ codec }) => codec).filter((codec) => !found.has(codec)))
  if (unknown.size) return [...unknown]
  plans.forEach((plan, part) => {
    const decoder = found.get(plan.codec)
    if (decoder) job.unpack(part, decode(job, plan, decoder, job.packedBytes(part)))
    else if (!plan.isOptional)
      throw job.place.error(
        `the model is compressed by ${plan.extension}, but has no decoder; ${adviceFor(plan.codec)}.`,
      )
  })
  return []
}

function decode({ place }: Job, plan: Plan, decoder: unknown, bytes: Uint8Array): Uint8Array[] {
  try {
    if (plan.codec === 'draco') return decodeDraco(decoder as DracoModule, plan, bytes)
    const { count, byteStride, mode, filter } = plan
    const target = new Uint8Array(count * byteStride)
    if (count)
      (decoder as MeshoptDecoder).decodeGltfBuffer(target, count, byteStride, bytes, mode, filter)
    return [target]
  } catch (error) {
    const why = shorten(error instanceof Error ? error.message : String(error))
    throw place.error(
      `the data of ${plan.extension} cannot be decoded (${why}); export the model again.`,
    )
  }
}
