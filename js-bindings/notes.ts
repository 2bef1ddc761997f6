// What is said once on a page: nothing is wrong, but there is a better way.
let isNoted = false

/** That a warp's normals are approximate; `advice` says what `method` could be given. */
export function noteApproximation(method: string, advice: string) {
  if (isNoted) return
  isNoted = true
  console.warn(
    `${method}: the offset depends on normal or uv, which here count as constant over the surface, so that normals are only nearly right; ${advice}, or say surfaceVariation: false if that will do.`,
  )
}
