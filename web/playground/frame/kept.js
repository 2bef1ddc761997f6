// In the playground's frame, behind the libraries: what its hosts have in common. Keeps each warp that the sketch makes, describes and
// evaluates it for the page's tabs, and lets sliders and colour fields take the place of its uniforms.
{
  const { playground } = window
  const { answers, report } = playground
  const warps = []
  const uniforms = []
  let isReported = false

  const languages = ['glsl300', 'glsl100', 'wgsl']
  const textOf = ({ code, declarations }) => ({ code, declarations })
  function textIn(made, language) {
    try {
      return textOf(made.emit ? made.emit(language) : made)
    } catch (error) {
      return { code: `// ${error.message}` }
    }
  }
  const describe = ({ maker, made, shapes, ...more }) => ({
    ...more,
    maker,
    hasShapes: Boolean(shapes),
    canEvaluate: Boolean(made.evaluate),
    reads: (made.uniforms ?? []).map(({ name }) => name),
    stats: made.stats && { ...made.stats },
    own: textOf(made),
    texts: Object.fromEntries(languages.map((language) => [language, textIn(made, language)])),
  })
  /** From the first picture on, and again when the sketch makes another warp later. */
  playground.reportWarps = () => {
    isReported = true
    report({ kind: 'made', warps: warps.map(describe), uniforms })
  }

  answers.evaluate = (index, mesh, options) => warps[index].made.evaluate(mesh, options)
  answers.foldover = (index, mesh, options) => warps[index].made.foldover(mesh, options)
  answers.shapes = (index) => warps[index].shapes()

  /** Maps the name of a moved slider → { source, value }. If the sketch has another value than `source`, that counts. */
  let { values } = playground
  answers.setValues = (now) => (values = now)
  const valueOf = (name, source) =>
    String(values[name]?.source) === String(source) ? values[name].value : source

  /** Each text once, as a sketch may make its warp again in every frame. */
  playground.keep = (maker, make, more) => {
    try {
      const made = make()
      const isKnown = warps.some(({ made: { code } }) => code === made.code)
      if (isKnown) return
      warps.push({ maker, made, ...more })
      if (isReported) playground.reportWarps()
    } catch {
      // The sketch's own call says what is wrong.
    }
  }

  // Only of the sketch, by its lines alone.
  const place = (text) => text.split(`${playground.source}:`)[1]?.match(/^\d+/)?.[0]
  const short = (text) =>
    text.code.replaceAll(/^( *)\/\/ From (.*)\n/gm, (_, indent, from) =>
      place(from) ? `${indent}// From line ${place(from)}\n` : '',
    )
  /** A warp that was compiled with `debug`, whose text names lines of the sketch. */
  playground.withLines = (made) => ({
    ...made,
    code: short(made),
    emit(...how) {
      const text = made.emit(...how)
      return { ...text, code: short(text) }
    },
  })

  /** warpjet's functions that make texts, such that what they make is kept. */
  playground.keeping = ({ compile, compileWarp, gen, differentiate }) => ({
    compile: (...how) => kept('compile', compile(...how)),
    compileWarp: (...how) => kept('compileWarp', compileWarp(...how)),
    gen: (...how) => keptText('gen', gen(...how)),
    ...(differentiate && {
      differentiate: (...how) => keptText('differentiate', differentiate(...how)),
    }),
  })
  function kept(maker, made) {
    playground.keep(maker, () => made)
    return made
  }
  function keptText(maker, code) {
    playground.keep(maker, () => ({ code }))
    return code
  }

  /** The numbers of a list, or of a vector of p5 or three.js. An image on the page has a place, too, and three's have a width. */
  function numbersOf(value) {
    if (Array.isArray(value) || ArrayBuffer.isView(value)) return [...value]
    if (!('x' in value) || ('width' in value && !value.toArray)) return []
    const names = value.isVector4 || value.isQuaternion ? 'xyzw' : 'xyz'
    return [...names].filter((name) => name in value).map((name) => value[name])
  }
  const two = (part) =>
    Math.round(255 * Math.min(1, Math.max(0, part)))
      .toString(16)
      .padStart(2, '0')
  const parts = (color) => [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16) / 255)

  /** What the page shows of a value: a number, two to four of them, or a colour such as '#ff8040'; nothing of any other. */
  function shown(value) {
    if (typeof value === 'number') return Number.isFinite(value) ? value : undefined
    if (typeof value !== 'object' || value === null) return
    if (value.getHexString) return `#${value.getHexString()}`
    if (value.setAlpha) return `#${value._array.slice(0, 3).map(two).join('')}`
    const numbers = numbersOf(value)
    const isVector = numbers.length > 1 && numbers.length < 5 && numbers.every(Number.isFinite)
    return isVector ? numbers : undefined
  }

  /** The value as a hand has moved it. Objects of three.js stay the same, since the sketch may have them, too. */
  function moved(value, now) {
    if (value.getHexString) return value.set(now)
    if (value.setAlpha) return [...parts(now), value._array[3]]
    return value.fromArray ? value.fromArray(now) : now
  }
  const copied = (value) =>
    typeof value === 'number' ? value : value.setAlpha ? [...value._array] : numbersOf(value)

  /**
   * The option `uniforms`, where values that can be shown have become functions. `isCopied`: the host reads a value once, and what
   * the sketch does with it later counts for nothing.
   */
  playground.withSliders = (options, { isCopied }) => {
    if (!options?.uniforms || typeof options.uniforms !== 'object') return options
    const given = Object.entries(options.uniforms).map(([name, value]) => {
      const source = shown(value)
      if (source === undefined) return [name, value]
      if (!uniforms.some((uniform) => uniform.name === name)) uniforms.push({ name, value: source })
      const still = isCopied ? copied(value) : value
      return [
        name,
        () => {
          const now = valueOf(name, source)
          return now === source ? still : moved(value, now)
        },
      ]
    })
    return { ...options, uniforms: Object.fromEntries(given) }
  }
}
