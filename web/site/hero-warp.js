/** The warp of the first page. It is compiled when the site is built, so that the page does not load warpjet. */

/** Displaces the surface by drifting ridges of noise, and swells it under the pointer. */
export function hero({ glsl, position, uniforms, millis }) {
  const drift = glsl.vec3(0, millis.div(9000), 0)
  const bent = position.add(position.mult(1.3).add(drift).simplex().mult(0.35))
  const ridges = bent.y().mult(11).add(millis.div(1100)).sin().mult(0.055)
  const nearness = position.dist(uniforms.pointer)
  const swell = glsl.smoothstep(1.1, 0, nearness).mult(uniforms.strength)
  return position.mult(ridges.add(swell))
}

export const names = { position: 'aPosition', normal: 'aPosition', millis: 'uMillis' }
export const uniforms = { pointer: [0, 0, 1], strength: 0.3 }
