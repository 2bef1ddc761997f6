// Runs in an example's page before its sketch, in the gallery only. Keeps the shader text of each warp for the page
// around it; the callback is compiled a second time for that, with plain input names, which read better than p5's.
// And it leaves the mouse wheel and vertical swipes to that page, so that nobody gets stuck in a sketch. One that has the page
// for itself keeps them, and its picture is as large as fits.
{
  const recorded = (window.recordedCode = [])
  const { compile, compileWarp, gen } = warpjet
  // The page may have the script for GLSL, or not.
  const differentiate = Object.hasOwn(warpjet, 'differentiate') && warpjet.differentiate
  const keep = (maker, { code: statements, declarations }) => {
    const code = declarations ? `${statements}\n// Above main:\n${declarations}` : statements
    if (!recorded.some((record) => record.code === code)) recorded.push({ maker, code })
  }

  for (const methods of [p5.prototype, p5.Graphics.prototype]) {
    const { createWarp } = methods
    methods.createWarp = function (offset, ...options) {
      const { uniforms, surfaceVariation = true } = options[0] ?? {}
      keep('createWarp', compileWarp(offset, { uniforms, surfaceVariation }))
      return createWarp.call(this, offset, ...options)
    }
  }

  window.warpjet = {
    ...warpjet,
    compile(callback, options) {
      const compiled = compile(callback, options)
      keep('compile', compiled)
      return compiled
    },
    compileWarp(offset, options) {
      const compiled = compileWarp(offset, options)
      keep('compileWarp', compiled)
      return compiled
    },
    gen(callback, settings) {
      const code = gen(callback, settings)
      keep('gen', { code })
      return code
    },
    ...(differentiate && {
      differentiate(source, options) {
        const code = differentiate(source, options)
        keep('differentiate', { code })
        return code
      },
    }),
  }

  // Only with the script for GLSL: the hooks that it put in the place of the sketch's.
  const { exactNormals } = p5.prototype
  if (exactNormals)
    p5.prototype.exactNormals = function (shader) {
      const turned = exactNormals.call(this, shader)
      for (const [head, body] of Object.entries(turned.hooks.vertex))
        if (body !== shader.hooks.vertex[head]) keep('exactNormals', { code: head + body })
      return turned
    }

  const style = (textContent) =>
    document.head.append(Object.assign(document.createElement('style'), { textContent }))
  if (frameElement?.ownerDocument.body.matches('.full')) {
    const { createCanvas } = p5.prototype
    p5.prototype.createCanvas = function (...how) {
      const canvas = createCanvas.apply(this, how)
      const { width, height } = this
      const fitting = `min(100vw, 100vh * ${width} / ${height})`
      style(`.p5Canvas { height: auto !important; width: ${fitting} !important }`)
      // As sharp as the screen is.
      const scale = Math.min(innerWidth / width, innerHeight / height)
      this.pixelDensity(scale * devicePixelRatio)
      return canvas
    }
  } else {
    const { orbitControl } = p5.prototype
    p5.prototype.orbitControl = function () {
      // p5's own mark that it has taken the wheel.
      this.wheelDefaultDisabled = true
      return orbitControl.call(this, 1, 1, 0)
    }
    // Half a pixel too much would make the frame scroll, in place of the page.
    style('canvas { touch-action: pan-y !important } html { overflow: hidden }')
  }
}
