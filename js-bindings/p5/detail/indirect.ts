/**
 * Draws by indirect calls on WEBGPU. p5 2.3 has none: it binds a buffer for each attribute from its start, and draws as many indices as the shape
 * has faces. Both are methods of the render pass, which we replace while p5 draws one shape; pipelines, uniforms and bind groups stay p5's.
 */
import type { GpuBuffer } from '../../detail/gpu/webgpu.js'
import type { Renderer } from '../host.js'

/** An attribute in a part of a buffer, which p5 passes to `setVertexBuffer` as if it were a buffer. */
export interface BufferPart {
  readonly buffer: GpuBuffer
  readonly offset: number
}

/** The members of a GPURenderPassEncoder that are used here. */
interface RenderPass {
  setVertexBuffer(slot: number, buffer: GpuBuffer | BufferPart, offset?: number): void
  drawIndexed(...numbers: number[]): void
  drawIndexedIndirect(numbers: GpuBuffer, offset: number): void
}

interface Passes {
  /** Begins a render pass if there is none. */
  _beginActiveRenderPass(): void
  activeRenderPass: RenderPass | null
}

export const canDrawIndirectly = (renderer: Renderer) =>
  '_beginActiveRenderPass' in renderer && 'activeRenderPass' in renderer

/** Calls `draw`, which draws one shape. The GPU reads the number of its indices from `drawn`. */
export function drawIndirectly(renderer: Renderer, drawn: GpuBuffer, draw: () => void) {
  const passes = renderer as unknown as Passes
  const begin = passes._beginActiveRenderPass
  let restore = () => {}
  passes._beginActiveRenderPass = () => {
    begin.call(renderer)
    restore()
    restore = replaceCalls(passes.activeRenderPass!, drawn)
  }
  try {
    draw()
  } finally {
    restore()
    passes._beginActiveRenderPass = begin
  }
}

/** Replaces methods of a render pass. Returns a function that restores them. */
function replaceCalls(pass: RenderPass, drawn: GpuBuffer): () => void {
  const { setVertexBuffer, drawIndexed } = pass
  pass.setVertexBuffer = (slot, given) =>
    'buffer' in given
      ? setVertexBuffer.call(pass, slot, given.buffer, given.offset)
      : setVertexBuffer.call(pass, slot, given)
  pass.drawIndexed = () => pass.drawIndexedIndirect(drawn, 0)
  return () => Object.assign(pass, { setVertexBuffer, drawIndexed })
}
