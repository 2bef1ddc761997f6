// Decodes the compressed parts of a glTF.
import { shorten } from '../errors/errors.js'
import { adviceFor, type Codec, type MeshoptDecoder } from './decoders.js'
import { decodeDraco, type DracoModule, type DracoPlan } from './draco.js'
import type { Job } from './job.js'

/** Maps each codec that was searched for → its decoder, or `undefined` if none was found. */
export type FoundDecoders = Map<Codec, unknown>

/** The parameters for decoding a compressed part, which src/mesh/gltf/packed_part.hpp documents. */
type Plan = { extension: string; isOptional: boolean } & (
  | { codec: 'meshopt'; count: number; byteStride: number; mode: string; filter: string }
  | ({ codec: 'draco' } & DracoPlan)
)

/**
 * Decodes all compressed parts of the job's file and returns an empty list. If the decoders of some codecs have not been searched for yet,
 * decodes nothing and returns these codecs.
 */
export function unpackParts(job: Job, decoders: FoundDecoders): Codec[] {
  const plans = job.act('findPacked').map((text) => JSON.parse(text) as Plan)
  const missing = new Set(plans.map(({ codec }) => codec).filter((codec) => !decoders.has(codec)))
  if (missing.size) return [...missing]
  plans.forEach((plan, part) => {
    const decoder = decoders.get(plan.codec)
    if (decoder) job.unpack(part, decode(job, plan, decoder, job.packedBytes(part)))
    else if (!plan.isOptional)
      throw job.place.error(
        `the model is compressed by ${plan.extension}, but no decoder for it was found; ${adviceFor(plan.codec)}.`,
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
    const reason = shorten(error instanceof Error ? error.message : String(error))
    throw place.error(
      `the data of ${plan.extension} cannot be decoded (${reason}); export the model again.`,
    )
  }
}
