/**
 * Runs an example only while somebody looks: a stage holds a frame while it is in view, and its picture alone otherwise. With
 * another sketch, the new frame begins unseen and takes the place of the old one once it has drawn.
 */
const REPORT_EVERY = 500 // ms

/** `report` gets { frames, rate, code } as long as it runs. → { setSketch(text), setPaused(isPaused) } */
export function makeStage(place, { page, title }, report) {
  let shown, coming, sketch, timer
  let isSeen = false
  let isPaused = true

  function begin() {
    coming?.remove()
    const frame = document.createElement('iframe')
    Object.assign(frame, { src: page, title, className: 'coming' })
    // The recorder in the frame runs that in the place of the sketch there.
    if (sketch) frame.sketch = URL.createObjectURL(new Blob([sketch], { type: 'text/javascript' }))
    coming = frame
    place.append(frame)
    const look = setInterval(() => {
      if (frame !== coming) return clearInterval(look)
      if (!frame.contentWindow?.frameCount) return
      clearInterval(look)
      shown?.remove()
      ;[shown, coming] = [frame, undefined]
      frame.className = 'shown'
      clearInterval(timer)
      timer = setInterval(observer(frame, report), REPORT_EVERY)
    }, 50)
  }

  function end() {
    clearInterval(timer)
    for (const frame of [shown, coming]) frame?.remove()
    shown = coming = undefined
    report({ frames: 0, rate: 0 })
  }

  function follow() {
    const isWanted = isSeen && !isPaused
    if (isWanted && !shown && !coming) begin()
    if (!isWanted && (shown || coming)) end()
  }

  new IntersectionObserver(
    ([{ isIntersecting }]) => {
      isSeen = isIntersecting
      follow()
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
      follow()
    },
  }
}

/** Reads the frame's counter and what the recorder kept. `rate` is in frames a second, 0 at first. */
function observer(frame, report) {
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
