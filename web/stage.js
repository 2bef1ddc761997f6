/**
 * Runs examples only where somebody looks: a stage holds a frame while it is in view and is empty otherwise, since a
 * browser keeps about sixteen WebGL contexts, and thirteen sketches at once would make each of them slow.
 */
const REPORT_EVERY = 500 // ms

const performances = new WeakMap()

const inView = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting, intersectionRatio } of entries) {
      const { start, stop } = performances.get(target)
      if (!isIntersecting) stop()
      else if (intersectionRatio >= 0.3) start()
    }
  },
  { threshold: [0, 0.3] },
)

/** Fills `stage` with the example while it is in view. `report` gets { frames, rate, code } as long as it runs. */
export function perform(stage, { name, title }, report) {
  let frame, timer

  function start() {
    if (frame) return
    frame = document.createElement('iframe')
    frame.src = `examples/${name}/gallery.html`
    frame.title = title
    stage.append(frame)
    timer = setInterval(observer(frame, report), REPORT_EVERY)
  }

  function stop() {
    if (!frame) return
    clearInterval(timer)
    frame.remove()
    frame = undefined
    report({ frames: 0, rate: 0 })
  }

  performances.set(stage, { start, stop })
  inView.observe(stage)
}

/** Reads the frame's p5 counter and what the recorder kept. `rate` is in frames a second, 0 at first. */
function observer(frame, report) {
  let frames = 0
  let time
  return () => {
    const { frameCount = 0, recordedCode = [] } = frame.contentWindow
    if (frameCount === frames) return
    const now = performance.now()
    const rate = frames ? (1000 * (frameCount - frames)) / (now - time) : 0
    const code = recordedCode.map(({ maker, code }) => `// ${maker}\n${code}`).join('\n\n')
    report({ frames: frameCount, rate, code })
    frames = frameCount
    time = now
  }
}
