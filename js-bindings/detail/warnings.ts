// Warnings on the console about what the option `detail` leaves as it is.

/** Maps a warp → the reasons that were given. */
const given = new WeakMap<object, Set<string>>()

/** A reason for all shapes of a warp. */
export const onlyOnGpu =
  'the offset calls a glsl.fn or reads an image, which only the GPU can evaluate'

/** Says why something is drawn with its own vertices, once per warp and reason. `name` describes it, and `method` is the user's call. */
export function warnOfDetail(warp: object, method: string, name: string, reason: string) {
  const reasons = given.get(warp) ?? new Set()
  if (reasons.has(reason)) return
  given.set(warp, reasons.add(reason))
  console.warn(
    `${method}: ${name} is drawn with its own vertices, although the option detail asks for more: ${reason}.`,
  )
}
