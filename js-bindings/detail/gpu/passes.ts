// The compute passes for a warp and the attributes of a mesh, compiled in the background.
import type { HostWarp } from '../../compile/host-warp.js'
import { arrayNames } from '../../core/inputs/vertices.js'
import { details } from '../../wasm/detail.js'
import type { DetailBase } from '../detail-base.js'
import { blockSize, constantsOf } from './common-wgsl.js'
import { choosePass, placePass, totalPass } from './divide-wgsl.js'
import {
  evaluatePass,
  measurePass,
  worldNumbers,
  type SampleInput,
  type World,
} from './measure-wgsl.js'
import { tessellationTable } from './table.js'
import { VertexLayout } from './vertex-layout.js'
import { PackedNumbers, warpInWgsl } from './warp-wgsl.js'
import { usage, type GpuBuffer, type GpuDevice, type GpuPipeline } from './webgpu.js'
import { writePass } from './write-wgsl.js'

export type PassName = 'evaluate' | 'measure' | 'choose' | 'place' | 'total' | 'write'

export interface Passes {
  readonly pipelines: Readonly<Record<PassName, GpuPipeline>>
  readonly numbers: PackedNumbers
  readonly inputs: readonly SampleInput[]
  readonly layout: VertexLayout
  readonly table: GpuBuffer
  /** Maps a level → its number of pieces. */
  readonly pieceCounts: readonly number[]
}

export interface PassOptions {
  /** Absent if the offset is in the space of the mesh. */
  readonly world?: World | undefined
  /** `true` if each attribute of the divided mesh is an array of its own. Default: `false` */
  readonly isPlanar?: boolean
}

/** The pipelines and the table of a device, which all meshes share. */
interface DeviceCache {
  readonly pipelines: Map<string, Promise<GpuPipeline>>
  table?: Promise<GpuBuffer>
}

const caches = new WeakMap<GpuDevice, DeviceCache>()

/** Compiles the passes. Rejects if the limits of the device are too low, or if the warp reads an input that samples lack. */
export async function compilePasses(
  device: GpuDevice,
  warp: HostWarp,
  { attributes }: Pick<DetailBase, 'attributes'>,
  { world, isPlanar = false }: PassOptions,
): Promise<Passes> {
  const { maxStorageBuffersPerShaderStage, maxComputeInvocationsPerWorkgroup } = device.limits
  if (maxStorageBuffersPerShaderStage < 8 || maxComputeInvocationsPerWorkgroup < blockSize)
    throw new Error('the limits of the device are too low')
  const text = warpInWgsl(warp)
  if (!text) throw new Error('the warp reads an input that samples lack')
  let shared = caches.get(device)
  if (!shared) caches.set(device, (shared = { pipelines: new Map() }))
  const bound = details.get()
  const constants = constantsOf(bound)
  const pieceCounts = [...bound.pieceNumbers()]
  const numbers = new PackedNumbers([...text.numbers, ...(world ? worldNumbers(world) : [])])
  const inputs: SampleInput[] = [
    { input: 'position', size: 3 },
    ...attributes.flatMap(({ input, size }) => {
      const name = (['normal', 'uv', 'color'] as const).find((each) => arrayNames[each] === input)
      return name && warp.reads(name) ? [{ input: name, size }] : []
    }),
  ]
  const layout = new VertexLayout(
    [
      { size: 3, isUnit: false },
      ...attributes.map(({ size, isUnit = false }) => ({ size, isUnit })),
    ],
    isPlanar,
  )
  const codes: Record<PassName, string> = {
    evaluate: evaluatePass(text, numbers, inputs, world),
    measure: measurePass(constants),
    choose: choosePass(constants),
    place: placePass(constants),
    total: totalPass(),
    write: writePass(constants, layout),
  }
  shared.table ??= uploadTable(device).catch((error: unknown) => {
    delete shared.table
    throw error
  })
  const names = Object.keys(codes) as PassName[]
  const [table, ...pipelines] = await Promise.all([
    shared.table,
    ...names.map((name) => pipelineOf(device, shared.pipelines, name, codes[name])),
  ])
  return {
    pipelines: Object.fromEntries(names.map((name, i) => [name, pipelines[i]])) as never,
    numbers,
    inputs,
    layout,
    table,
    pieceCounts,
  }
}

function pipelineOf(
  device: GpuDevice,
  known: Map<string, Promise<GpuPipeline>>,
  name: string,
  code: string,
) {
  let pipeline = known.get(code)
  if (!pipeline) {
    const label = `warpjet detail: ${name}`
    const module = device.createShaderModule({ label, code })
    pipeline = device.createComputePipelineAsync({ label, layout: 'auto', compute: { module } })
    known.set(code, pipeline)
  }
  return pipeline
}

async function uploadTable(device: GpuDevice) {
  const words = await tessellationTable()
  const buffer = device.createBuffer({
    label: 'warpjet detail: tessellations',
    size: words.byteLength,
    usage: usage.storage | usage.copyTo,
  })
  device.queue.writeBuffer(buffer, 0, words)
  return buffer
}
