// In the playground's frame, after p5's libraries and before the sketch: keeps each warp that the sketch makes, for the tabs,
// and lets sliders take the place of uniforms that are plain numbers.
{
  const { playground } = window
  const warps = (playground.warps = [])
  const uniforms = (playground.uniforms = [])
  const { compile, compileWarp, gen } = window.warpjet
  // The page may have the script for GLSL, or not.
  const differentiate =
    Object.hasOwn(window.warpjet, 'differentiate') && window.warpjet.differentiate

  /** Each text once, as a sketch may make its warp again in every frame. */
  function keep(maker, make, more) {
    try {
      const made = make()
      const isKnown = warps.some(({ made: { code } }) => code === made.code)
      if (!isKnown) warps.push({ maker, made, ...more })
    } catch {
      // The sketch's own call says what is wrong.
    }
  }

  function withSliders(options) {
    if (!options?.uniforms || typeof options.uniforms !== 'object') return options
    const given = Object.entries(options.uniforms).map(([name, value]) => {
      if (typeof value !== 'number' || !Number.isFinite(value)) return [name, value]
      if (!uniforms.some((uniform) => uniform.name === name)) uniforms.push({ name, value })
      return [name, () => playground.valueOf(name, value)]
    })
    return { ...options, uniforms: Object.fromEntries(given) }
  }

  for (const methods of [p5.prototype, p5.Graphics.prototype]) {
    const { createWarp } = methods
    methods.createWarp = function (offset, options, ...rest) {
      const moved = withSliders(options)
      const warp = createWarp.call(this, offset, withView(moved), ...rest)
      const { surfaceVariation = true, space = 'local' } = options ?? {}
      keep(
        'createWarp',
        () =>
          withLines(
            compileWarp(plainOffset(offset, options), {
              uniforms: moved?.uniforms,
              surfaceVariation,
              debug: true,
            }),
          ),
        { space, surfaceVariation },
      )
      return warp
    }
  }
  // Only of the sketch, by its lines alone.
  const place = (text) => text.split(`${playground.source}:`)[1]?.match(/^\d+/)?.[0]
  const short = (text) =>
    text.code.replaceAll(/^( *)\/\/ From (.*)\n/gm, (_, indent, from) =>
      place(from) ? `${indent}// From line ${place(from)}\n` : '',
    )
  const withLines = (made) => ({
    ...made,
    code: short(made),
    emit(...how) {
      const text = made.emit(...how)
      return { ...text, code: short(text) }
    },
  })

  // The shape that was drawn last with a shader of the sketch's, and where it stood.
  const { Renderer3D, RendererGL } = p5
  const [renderers, method] = Renderer3D
    ? [Renderer3D.prototype, '_drawGeometry']
    : [RendererGL.prototype, 'drawBuffers']
  const draw = renderers[method]
  renderers[method] = function (given, ...rest) {
    const { userFillShader, uModelMatrix } = this.states ?? this
    const geometry = this.retainedMode?.geometry[given]?.model ?? given
    if (userFillShader && geometry?.faces?.length)
      playground.drawn = { geometry, matrix: [...(uModelMatrix.mat4 ?? uModelMatrix)] }
    return draw.call(this, given, ...rest)
  }

  /** As `compileWarp` takes it, which reads neither operators nor places. */
  function plainOffset(given, { scope, returns } = {}) {
    const operators = window[Symbol.for('warpjet.operators')]
    const offset = operators?.(given, scope) ?? given
    if (returns !== 'position') return offset
    return (inputs) => inputs.glsl.sub(offset(inputs), inputs.position)
  }
  const withView = (options) =>
    playground.view === 'normals' ? { ...options, type: 'normal' } : options

  window.warpjet = {
    ...warpjet,
    compile(callback, options) {
      const made = compile(callback, options)
      keep('compile', () => made)
      return made
    },
    compileWarp(offset, options) {
      const made = compileWarp(offset, options)
      keep('compileWarp', () => made)
      return made
    },
    gen(callback, settings) {
      const code = gen(callback, settings)
      keep('gen', () => ({ code }))
      return code
    },
    ...(differentiate && {
      differentiate(source, options) {
        const code = differentiate(source, options)
        keep('differentiate', () => ({ code }))
        return code
      },
    }),
  }
}
