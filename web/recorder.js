// Runs in an example's page before its sketch, in the gallery only. Records the shader code of each warp for the page around it. For
// this, it compiles the callback a second time, with plain input names, which read better than p5's. It also leaves the mouse wheel and
// vertical swipes to that page, so that visitors can scroll past a sketch. On a full page, the sketch keeps wheel and swipes, and its
// canvas is as large as fits the window.
{
  const records = (window.recordedCode = [])
  const { compile, compileWarp, gen } = warpjet
  // The page may lack the script for GLSL; reading `differentiate` without it throws.
  const differentiate = Object.hasOwn(warpjet, 'differentiate') && warpjet.differentiate
  const record = (maker, { code: statements, declarations }) => {
    const code = declarations ? `${statements}\n// Above main:\n${declarations}` : statements
    if (!records.some((each) => each.code === code)) records.push({ maker, code })
  }

  for (const methods of [p5.prototype, p5.Graphics.prototype]) {
    const { createWarp } = methods
    methods.createWarp = function (offset, ...options) {
      const { uniforms, surfaceVariation = true } = options[0] ?? {}
      record('createWarp', compileWarp(offset, { uniforms, surfaceVariation }))
      return createWarp.call(this, offset, ...options)
    }
  }

  window.warpjet = {
    ...warpjet,
    compile(callback, options) {
      const compiled = compile(callback, options)
      record('compile', compiled)
      return compiled
    },
    compileWarp(offset, options) {
      const compiled = compileWarp(offset, options)
      record('compileWarp', compiled)
      return compiled
    },
    gen(callback, settings) {
      const code = gen(callback, settings)
      record('gen', { code })
      return code
    },
    ...(differentiate && {
      differentiate(source, options) {
        const code = differentiate(source, options)
        record('differentiate', { code })
        return code
      },
    }),
  }

  // If the script for GLSL is loaded, record the hooks with which exactNormals replaces the sketch's.
  const { exactNormals } = p5.prototype
  if (exactNormals)
    p5.prototype.exactNormals = function (shader) {
      const result = exactNormals.call(this, shader)
      for (const [head, body] of Object.entries(result.hooks.vertex))
        if (body !== shader.hooks.vertex[head]) record('exactNormals', { code: head + body })
      return result
    }

  const style = (textContent) =>
    document.head.append(Object.assign(document.createElement('style'), { textContent }))
  if (frameElement?.ownerDocument.body.matches('.full')) {
    const { createCanvas } = p5.prototype
    p5.prototype.createCanvas = function (...args) {
      const canvas = createCanvas.apply(this, args)
      const { width, height } = this
      const fitting = `min(100vw, 100vh * ${width} / ${height})`
      style(`.p5Canvas { height: auto !important; width: ${fitting} !important }`)
      // Match the screen's resolution.
      const scale = Math.min(innerWidth / width, innerHeight / height)
      this.pixelDensity(scale * devicePixelRatio)
      return canvas
    }
  } else {
    const { orbitControl } = p5.prototype
    p5.prototype.orbitControl = function () {
      // p5 sets this property when it disables scrolling by the wheel. If the property is set already, p5 does not disable scrolling.
      this.wheelDefaultDisabled = true
      return orbitControl.call(this, 1, 1, 0)
    }
    // Half a pixel of overflow would make the frame scroll instead of the page.
    style('canvas { touch-action: pan-y !important } html { overflow: hidden }')
  }
}
