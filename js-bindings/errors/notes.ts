// What is said once: nothing is wrong, but there is a better way.
let isNoted = false

/** That a warp's normals are approximate, and what makes them exact. */
export function noteApproximation(method: string, remedy: string) {
  if (isNoted) return
  isNoted = true
  console.warn(
    `${method}: the offset depends on normal or uv, which count as constant over the surface in the shader, so that normals there are only nearly right; ${remedy} makes them exact, and surfaceVariation: false silences this.`,
  )
}
