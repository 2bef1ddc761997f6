/**
 * Runs an example only while it is visible: a stage contains a frame while it is in view, and only a picture otherwise. For a new
 * sketch, the new frame starts hidden and replaces the old one once it has drawn.
 */
const REPORT_EVERY = 500 // ms

/** @param report called with { frames, rate, code } while the sketch runs @returns { setSketch(text), setPaused(isPaused) } */
export function makeStage(place, { page, title }, report) {
  let shown, coming, sketch, timer
  let isSeen = false
  let isPaused = true

  function begin() {
    coming?.remove()
    const frame = document.createElement('iframe')
    Object.assign(frame, { src: page, title, className: 'coming' })
    // If `sketch` is set, the frame's page runs it instead of its own sketch.
    if (sketch) frame.sketch = URL.createObjectURL(new Blob([sketch], { type: 'text/javascript' }))
    coming = frame
    place.append(frame)
    const poll = setInterval(() => {
      if (frame !== coming) return clearInterval(poll)
      if (!frame.contentWindow?.frameCount) return
      clearInterval(poll)
      shown?.remove()
      ;[shown, coming] = [frame, undefined]
      frame.className = 'shown'
      clearInterval(timer)
      timer = setInterval(makeObserver(frame, report), REPORT_EVERY)
    }, 50)
  }

  function end() {
    clearInterval(timer)
    for (const frame of [shown, coming]) frame?.remove()
    shown = coming = undefined
    report({ frames: 0, rate: 0 })
  }

  /** Starts or ends the frame if that is due. */
  function update() {
    const isWanted = isSeen && !isPaused
    if (isWanted && !shown && !coming) begin()
    if (!isWanted && (shown || coming)) end()
  }

  new IntersectionObserver(
    ([{ isIntersecting }]) => {
      isSeen = isIntersecting
      update()
    },
    { threshold: [0, 0.3] },
  ).observe(place)

  return {
    setSketch(text) {
      sketch = text
      if (shown || coming) begin()
    },
    setPaused(now) {
      isPaused = now
      update()
    },
  }
}

/** Reports the frame's counter and the recorded code. `rate` is in frames per second, 0 at first. */
function makeObserver(frame, report) {
  let frames = 0
  let time
  return () => {
    const { frameCount = 0, recordedCode = [] } = frame.contentWindow ?? {}
    if (frameCount === frames) return
    const now = performance.now()
    const rate = frames ? (1000 * (frameCount - frames)) / (now - time) : 0
    const code = recordedCode.map(({ maker, code }) => `// ${maker}\n${code}`).join('\n\n')
    report({ frames: frameCount, rate, code })
    frames = frameCount
    time = now
  }
}
