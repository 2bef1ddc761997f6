// Runs in the playground's frame after the libraries, for all hosts. Records each warp that the sketch makes, describes and evaluates it
// for the page's tabs, and lets sliders and colour fields override its uniforms.
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
  /** Describes a recorded warp for the page. `maker` is the name of the function that made it, `made` the result. */
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
  /** Called at the first picture, and again whenever the sketch makes another warp later. */
  playground.reportWarps = () => {
    isReported = true
    report({ kind: 'made', warps: warps.map(describe), uniforms })
  }

  answers.evaluate = (index, mesh, options) => warps[index].made.evaluate(mesh, options)
  answers.foldover = (index, mesh, options) => warps[index].made.foldover(mesh, options)
  answers.shapes = (index) => warps[index].shapes()

  /**
   * Maps the name of a moved slider → { source, value }. `value` replaces the sketch's value only while the sketch's value equals `source`.
   */
  let { values } = playground
  answers.setValues = (now) => (values = now)
  const valueOf = (name, source) =>
    String(values[name]?.source) === String(source) ? values[name].value : source

  /** Records a warp unless its code is known: a sketch may make its warp again in every frame. */
  playground.record = (maker, make, more) => {
    try {
      const made = make()
      const isKnown = warps.some(({ made: { code } }) => code === made.code)
      if (isKnown) return
      warps.push({ maker, made, ...more })
      if (isReported) playground.reportWarps()
    } catch {
      // The sketch's own call throws the same error.
    }
  }

  // Keep only the comments that name lines of the sketch, shortened to the line numbers.
  const lineOf = (text) => text.split(`${playground.source}:`)[1]?.match(/^\d+/)?.[0]
  const shortenComments = (text) =>
    text.code.replaceAll(/^( *)\/\/ From (.*)\n/gm, (_, indent, from) =>
      lineOf(from) ? `${indent}// From line ${lineOf(from)}\n` : '',
    )
  /** Shortens the comments of a warp compiled with `debug`, whose code names lines of the sketch. */
  playground.withLines = (made) => ({
    ...made,
    code: shortenComments(made),
    emit(...args) {
      const text = made.emit(...args)
      return { ...text, code: shortenComments(text) }
    },
  })

  /** Wraps warpjet's functions that generate code, so that their results are recorded. */
  playground.recordAll = ({ compile, compileWarp, gen, differentiate }) => ({
    compile: (...args) => recordResult('compile', compile(...args)),
    compileWarp: (...args) => recordResult('compileWarp', compileWarp(...args)),
    gen: (...args) => recordCode('gen', gen(...args)),
    ...(differentiate && {
      differentiate: (...args) => recordCode('differentiate', differentiate(...args)),
    }),
  })
  function recordResult(maker, made) {
    playground.record(maker, () => made)
    return made
  }
  function recordCode(maker, code) {
    playground.record(maker, () => ({ code }))
    return code
  }

  /** Returns the numbers of a list, or of a vector of p5 or three.js. For an image, which may have an `x`, too, returns an empty list. */
  function numbersOf(value) {
    if (Array.isArray(value) || ArrayBuffer.isView(value)) return [...value]
    if (!('x' in value) || ('width' in value && !value.toArray)) return []
    const names = value.isVector4 || value.isQuaternion ? 'xyzw' : 'xyz'
    return [...names].filter((name) => name in value).map((name) => value[name])
  }
  const toHex = (part) =>
    Math.round(255 * Math.min(1, Math.max(0, part)))
      .toString(16)
      .padStart(2, '0')
  const parseHex = (color) => [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16) / 255)

  /** Converts a value to a number, two to four numbers, or a colour such as '#ff8040'; undefined if a control cannot show it. */
  function toControlValue(value) {
    if (typeof value === 'number') return Number.isFinite(value) ? value : undefined
    if (typeof value !== 'object' || value === null) return
    if (value.getHexString) return `#${value.getHexString()}`
    if (value.setAlpha) return `#${value._array.slice(0, 3).map(toHex).join('')}`
    const numbers = numbersOf(value)
    const isVector = numbers.length > 1 && numbers.length < 5 && numbers.every(Number.isFinite)
    return isVector ? numbers : undefined
  }

  /**
   * Returns the value `now` of a control in the form of the sketch's `value`. Changes objects of three.js in place, since the sketch may
   * use them.
   */
  function applyControl(value, now) {
    if (value.getHexString) return value.set(now)
    if (value.setAlpha) return [...parseHex(now), value._array[3]]
    return value.fromArray ? value.fromArray(now) : now
  }
  const copyValue = (value) =>
    typeof value === 'number' ? value : value.setAlpha ? [...value._array] : numbersOf(value)

  /**
   * Replaces the values of the option `uniforms` by functions, if controls can show the values. `isCopied` is true for a host that reads a
   * value once, so that later changes by the sketch have no effect.
   */
  playground.withSliders = (options, { isCopied }) => {
    if (!options?.uniforms || typeof options.uniforms !== 'object') return options
    const entries = Object.entries(options.uniforms).map(([name, value]) => {
      const source = toControlValue(value)
      if (source === undefined) return [name, value]
      if (!uniforms.some((uniform) => uniform.name === name)) uniforms.push({ name, value: source })
      const unmoved = isCopied ? copyValue(value) : value
      return [
        name,
        () => {
          const now = valueOf(name, source)
          return now === source ? unmoved : applyControl(value, now)
        },
      ]
    })
    return { ...options, uniforms: Object.fromEntries(entries) }
  }
}
