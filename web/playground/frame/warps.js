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
          compileWarp(plainOffset(offset, options), {
            uniforms: moved?.uniforms,
            surfaceVariation,
          }),
        { space, surfaceVariation },
      )
      return warp
    }
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
