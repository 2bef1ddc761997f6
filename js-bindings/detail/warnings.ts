// Prints warnings about what is not divided although the option `detail` asks for it.

/** Maps a warp → the reasons of its warnings. */
const printedReasons = new WeakMap<object, Set<string>>()

/** The reason why no shape of a warp is divided. */
export const onlyOnGpu =
  'the offset calls a glsl.fn or reads an image, which only the GPU can evaluate'

/**
 * Warns that something is drawn with its own vertices, once per warp and reason. `name` describes it; `method` is the function that the
 * user called.
 */
export function warnOfDetail(warp: object, method: string, name: string, reason: string) {
  const reasons = printedReasons.get(warp) ?? new Set()
  if (reasons.has(reason)) return
  printedReasons.set(warp, reasons.add(reason))
  console.warn(
    `${method}: ${name} is drawn with its own vertices, although the option detail asks for more: ${reason}.`,
  )
}
