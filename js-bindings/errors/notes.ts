// Warnings on the console about things that are allowed, but have a better alternative.
let hasWarned = false

/** Warns, once on a page, that a warp's normals are approximate. `remedy` is the call that makes them exact. */
export function noteApproximation(method: string, remedy: string) {
  if (hasWarned) return
  hasWarned = true
  console.warn(
    `${method}: the offset depends on normal or uv, which the shader treats as constant over the surface, so that its normals are approximate; ${remedy} makes them exact, and surfaceVariation: false silences this.`,
  )
}
