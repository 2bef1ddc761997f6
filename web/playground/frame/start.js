// Runs in the playground's frame before everything else, and reports to the page: errors, console output, blocked addresses, the time,
// the number of frames, and the first picture.
{
  const { report, source, root, answers } = window.playground
  const positionPattern = new RegExp(
    `${source.replaceAll(/[.*+?^${}()|[\]\\/]/g, '\\$&')}:(\\d+):(\\d+)`,
  )
  // Saved here, because clock.js replaces performance.now by the sketch's time.
  const now = performance.now.bind(performance)
  const began = now()

  /** Reports an error with the first position in the sketch on its stack, if there is one. */
  function reportMistake(error, line, column) {
    const text = String(error?.message ?? error).replaceAll(source, 'sketch.js')
    // warpjet's own messages name the line, also in functions that it has rewritten.
    const [whole, message, file, lineInMessage] = /^(.*) \((\S+), line (\d+)\)$/s.exec(text) ?? [
      text,
      text,
    ]
    const hasLine = file && source.endsWith(file)
    const position = hasLine
      ? [whole, lineInMessage]
      : (positionPattern.exec(error?.stack ?? '') ?? [whole, line, column])
    const isPlain = !error?.name || error.name === 'WarpError' || error.name === 'Error'
    report({
      kind: 'error',
      message: isPlain ? message : `${error.name}: ${message}`,
      line: position[1] && Number(position[1]),
      column: position[2] && Number(position[2]),
    })
  }
  // The page shows errors, so keep them out of the browser's console.
  addEventListener('error', (event) => {
    const { error, message, filename, lineno, colno } = event
    const isHere = filename === source
    event.preventDefault()
    reportMistake(error ?? message, isHere ? lineno : undefined, isHere ? colno : undefined)
  })
  addEventListener('unhandledrejection', (event) => {
    event.preventDefault()
    reportMistake(event.reason)
  })
  // The error event of a missing script does not bubble, so listen in the capture phase.
  addEventListener(
    'error',
    ({ target }) => target?.tagName === 'SCRIPT' && reportMistake(`Cannot load ${target.src}.`),
    true,
  )

  addEventListener('securitypolicyviolation', ({ blockedURI }) => {
    if (/^https?:/.test(blockedURI)) report({ kind: 'blocked', address: blockedURI })
  })

  // Asks the page for files whose names are not literal in the sketch, such as concatenated ones.
  const fileRequests = []
  window.playground.findFile = (address) =>
    address?.startsWith(root)
      ? new Promise((resolve) =>
          report({ kind: 'wanted', id: fileRequests.push(resolve) - 1, address }),
        )
      : undefined
  answers.file = (id, blob) =>
    fileRequests[id](
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

  // Count frames in requestAnimationFrame, which both hosts use.
  const { requestAnimationFrame } = window
  let frames = 0
  const waiting = []
  window.requestAnimationFrame = (work) =>
    requestAnimationFrame((time) => {
      // Reset the loop guard, so that earlier slow drawing does not count as an endless loop.
      alive = now()
      work(window.playground.clock?.frameTime(time) ?? time)
      frames++
      for (const take of waiting.splice(0)) take()
    })

  // Max milliseconds of a loop. A page that hangs runs no timers, so `alive` stops being updated.
  const MAX_LOOP_TIME = 5000
  let alive = now()
  let rounds = 0
  setInterval(() => (alive = now()), 200)

  /** Throws if a loop seems to have no end. Guarded loops call it once per iteration. */
  window.playground.checkLoop = () => {
    if (++rounds % 1024 || now() - alive < MAX_LOOP_TIME) return
    alive = now()
    throw new Error(
      'This loop ran for five seconds and was stopped: check that its condition becomes false.',
    )
  }
  /** Returns the number of frames since the page was loaded; in p5, of frames that p5 has begun. */
  const countFrames = () => window.frameCount ?? frames
  const findCanvas = () => document.querySelector('canvas.p5Canvas, canvas[data-engine], canvas')

  Object.assign(answers, {
    /** Records the canvas for some seconds and returns a Blob. */
    async film(seconds) {
      const canvas = findCanvas()
      const type = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'].find((kind) =>
        window.MediaRecorder?.isTypeSupported(kind),
      )
      if (!type || !canvas?.captureStream)
        throw new Error('This browser cannot record WebM: save a picture, or use another browser.')
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
    /** Returns the picture in the canvas as a Blob. Takes it right after a frame: later, the browser may have cleared the canvas. */
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
    report({ kind: 'state', frames: countFrames(), millis: window.playground.clock?.now() ?? 0 })

  // p5 counts a frame before it draws it, and reports errors of the drawing later, so wait for three frames.
  let seen = 0
  const awaitPicture = () => {
    if (countFrames() >= 1) seen++
    if (seen < 3) return requestAnimationFrame(awaitPicture)
    reportState()
    window.playground.reportWarps?.()
    report({ kind: 'drawn', milliseconds: now() - began })
    setInterval(reportState, REPORT_EVERY)
  }
  requestAnimationFrame(awaitPicture)
}
