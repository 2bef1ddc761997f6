// In the playground's frame, before everything else: reports to the page what goes wrong, what is printed, what is blocked, the time,
// the frames, and the first picture.
{
  const { report, source, root, answers } = window.playground
  const place = new RegExp(`${source.replaceAll(/[.*+?^${}()|[\]\\/]/g, '\\$&')}:(\\d+):(\\d+)`)
  // clock.js puts the sketch's time in its place.
  const now = performance.now.bind(performance)
  const began = now()

  /** With the first place in the sketch that the error went through, if there is one. */
  function tell(error, line, column) {
    const text = String(error?.message ?? error).replaceAll(source, 'sketch.js')
    // warpjet says it itself, and knows of functions that it has rewritten.
    const [said, message, file, named] = /^(.*) \((\S+), line (\d+)\)$/s.exec(text) ?? [text, text]
    const isSaid = file && source.endsWith(file)
    const found = isSaid ? [said, named] : (place.exec(error?.stack ?? '') ?? [said, line, column])
    const isPlain = !error?.name || error.name === 'WarpError' || error.name === 'Error'
    report({
      kind: 'error',
      message: isPlain ? message : `${error.name}: ${message}`,
      line: found[1] && Number(found[1]),
      column: found[2] && Number(found[2]),
    })
  }
  // The page shows them, so that the browser's own console need not.
  addEventListener('error', (event) => {
    const { error, message, filename, lineno, colno } = event
    const isHere = filename === source
    event.preventDefault()
    tell(error ?? message, isHere ? lineno : undefined, isHere ? colno : undefined)
  })
  addEventListener('unhandledrejection', (event) => {
    event.preventDefault()
    tell(event.reason)
  })
  // An image or a script that is missing says so on itself alone.
  addEventListener(
    'error',
    ({ target }) => target?.tagName === 'SCRIPT' && tell(`${target.src} is not there.`),
    true,
  )

  addEventListener('securitypolicyviolation', ({ blockedURI }) => {
    if (/^https?:/.test(blockedURI)) report({ kind: 'blocked', address: blockedURI })
  })

  // Files of the site that no text names, such as one whose name is put together: the page has them.
  const wanted = []
  window.playground.findFile = (address) =>
    address?.startsWith(root)
      ? new Promise((resolve) => report({ kind: 'wanted', id: wanted.push(resolve) - 1, address }))
      : undefined
  answers.file = (id, blob) =>
    wanted[id](
      blob ? new Response(blob) : new Response(null, { status: 404, statusText: 'Not Found' }),
    )

  for (const level of ['log', 'info', 'warn', 'error']) {
    const print = console[level]
    console[level] = (...values) => {
      report({ kind: 'printed', level, text: values.map(textOf).join(' ') })
      if (level === 'log' || level === 'info') print.apply(console, values)
    }
  }
  function textOf(value) {
    if (typeof value !== 'object' || value === null) return String(value)
    if (value instanceof Error) return String(value)
    try {
      return JSON.stringify(value)
    } catch {
      return String(value)
    }
  }

  // Frames are counted where both hosts ask for them.
  const { requestAnimationFrame } = window
  let frames = 0
  const waiting = []
  window.requestAnimationFrame = (work) =>
    requestAnimationFrame((time) => {
      // What a slow machine drew before is no loop of the sketch's.
      alive = now()
      work(window.playground.clock?.frameTime(time) ?? time)
      frames++
      for (const take of waiting.splice(0)) take()
    })

  // A page that stands still runs no timer.
  const MOST = 5000
  let alive = now()
  let rounds = 0
  setInterval(() => (alive = now()), 200)

  /** Throws in a loop that seems to have no end. */
  window.playground.goOn = () => {
    if (++rounds % 1024 || now() - alive < MOST) return
    alive = now()
    throw new Error(
      'This loop went on for five seconds and was stopped: see that its condition becomes false.',
    )
  }
  /** Since the page began; of p5 those that it has drawn. */
  const count = () => window.frameCount ?? frames
  const findCanvas = () => document.querySelector('canvas.p5Canvas, canvas[data-engine], canvas')

  Object.assign(answers, {
    /** So many seconds of the canvas as a Blob. */
    async film(seconds) {
      const canvas = findCanvas()
      const type = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'].find((kind) =>
        window.MediaRecorder?.isTypeSupported(kind),
      )
      if (!type || !canvas?.captureStream)
        throw new Error('This browser records no WebM: save a picture, or take another browser.')
      const recorder = new MediaRecorder(canvas.captureStream(60), {
        mimeType: type,
        videoBitsPerSecond: 12e6,
      })
      const parts = []
      recorder.addEventListener('dataavailable', ({ data }) => parts.push(data))
      const stopped = new Promise((resolve, reject) => {
        recorder.addEventListener('stop', resolve)
        recorder.addEventListener('error', ({ error }) => reject(error))
      })
      recorder.start()
      setTimeout(() => recorder.state === 'recording' && recorder.stop(), 1000 * seconds)
      await stopped
      return new Blob(parts, { type: 'video/webm' })
    },
    /** The canvas as a Blob, right after it was drawn: later a browser may have emptied it. */
    snapshot: () =>
      new Promise((resolve) => {
        let isTaken = false
        const take = () => {
          if (isTaken) return
          isTaken = true
          const canvas = findCanvas()
          if (canvas) canvas.toBlob(resolve)
          else resolve()
        }
        waiting.push(take)
        setTimeout(take, 1000)
      }),
  })

  const REPORT_EVERY = 100 // ms
  const reportState = () =>
    report({ kind: 'state', frames: count(), millis: window.playground.clock?.now() ?? 0 })

  // p5 counts a frame before it draws it, and says later what went wrong in it.
  let seen = 0
  const look = () => {
    if (count() >= 1) seen++
    if (seen < 3) return requestAnimationFrame(look)
    reportState()
    window.playground.reportWarps?.()
    report({ kind: 'drawn', milliseconds: now() - began })
    setInterval(reportState, REPORT_EVERY)
  }
  requestAnimationFrame(look)
}
