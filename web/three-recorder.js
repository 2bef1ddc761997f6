// Runs in the page of a three.js example before its sketch, in the gallery only: counts frames, records the shader code of each warp
// for the page around it, and leaves the wheel to that page, unless the sketch fills its own page.
{
  window.frameCount = 0
  const records = (window.recordedCode = [])
  const { requestAnimationFrame } = window
  window.requestAnimationFrame = (work) =>
    requestAnimationFrame((time) => {
      work(time)
      window.frameCount++
    })

  /** Matches the statements of a warp, up to the new position, in a complete vertex shader of three.js. */
  const statements =
    /\{\nvec3 warpjetStart = transformed;[\s\S]*?\btransformed = (?:warpjetPosition;|\( inverse[^;]*;)/
  /** Matches a function that exactNormals writes, in a complete shader of WebGPURenderer. */
  const nodeFunction = /^(?:mat3|vec3) warpjet_\w+\s*\([^)]*\)\s*\{\n[\s\S]*?\nreturn [^\n]*;\n\}/m
  const { shaderSource } = WebGL2RenderingContext.prototype
  WebGL2RenderingContext.prototype.shaderSource = function (shader, text) {
    const [code] = statements.exec(text.slice(text.indexOf('void main'))) ?? []
    const [nodeCode] = nodeFunction.exec(text) ?? []
    for (const [maker, found] of [
      ['warp', code],
      ['exactNormals', nodeCode],
    ])
      if (found && !records.some((each) => each.code === found))
        records.push({ maker, code: found })
    return shaderSource.call(this, shader, text)
  }

  const isAlone = frameElement?.ownerDocument.body.matches('.full')
  const swipes = isAlone ? '' : 'canvas { touch-action: pan-y !important }'
  if (!isAlone)
    addEventListener('wheel', (event) => event.stopImmediatePropagation(), { capture: true })
  document.head.append(
    Object.assign(document.createElement('style'), {
      textContent: `${swipes} .lil-gui { --width: 180px }`,
    }),
  )
}
