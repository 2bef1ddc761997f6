// What runs in the first page while site-start.mjs measures it: functions for the page, which know nothing of this file.

/**
 * Before the page's scripts. `window.seen`, in milliseconds: when filter and search begin to listen, when something is painted and when
 * the warp is drawn first, the tasks that keep others waiting (more than 50 ms), when a key was pressed and what passed until its
 * answer was painted.
 */
export function watch() {
  const seen = (window.seen = { tasks: [] })
  const { addEventListener } = EventTarget.prototype
  EventTarget.prototype.addEventListener = function (kind, ...rest) {
    addEventListener.call(this, kind, ...rest)
    if (kind !== 'input') return
    if (this.className === 'filter') seen.filter ??= performance.now()
    if (this.id === 'search') seen.search ??= performance.now()
  }
  const { drawElements } = WebGL2RenderingContext.prototype
  WebGL2RenderingContext.prototype.drawElements = function (...given) {
    drawElements.apply(this, given)
    seen.warp ??= performance.now()
  }
  addEventListener.call(document, 'DOMContentLoaded', () =>
    document.querySelector('#words').focus({ preventScroll: true }),
  )

  const observe = (type, look, options) =>
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) look(entry)
    }).observe({ type, buffered: true, ...options })

  observe('paint', ({ name, startTime }) => {
    if (name === 'first-contentful-paint') seen.paint = startTime
  })
  observe('longtask', ({ startTime, duration }) =>
    seen.tasks.push({
      start: startTime,
      end: startTime + duration,
      whose: 'no script: style, layout, or the browser itself',
    }),
  )
  // Of a frame that came late it is told which scripts had run for it.
  observe('long-animation-frame', ({ scripts }) => {
    for (const { startTime, duration, sourceURL, sourceFunctionName, invoker } of scripts)
      for (const task of seen.tasks)
        if (startTime < task.end && startTime + duration > task.start && duration > 10)
          task.whose = [invoker, sourceFunctionName, sourceURL].filter(Boolean).join(', ')
  })
  observe(
    'event',
    ({ name, startTime, duration }) => {
      if (!/^(?:keydown|keypress|input)$/.test(name)) return
      seen.pressed = Math.min(seen.pressed ?? startTime, startTime)
      seen.key = Math.max(seen.key ?? 0, startTime + duration - seen.pressed)
    },
    { durationThreshold: 16 },
  )
  // What is faster than that has no entry.
  addEventListener.call(window, 'keydown', ({ timeStamp }) =>
    requestAnimationFrame(() =>
      setTimeout(() => {
        seen.pressed ??= timeStamp
        seen.key ??= performance.now() - timeStamp
      }, 100),
    ),
  )
}

/** Milliseconds from words in a field until they are answered. */
export const answered = ([field, words, answer]) =>
  new Promise((resolve) => {
    const input = document.querySelector(field)
    input.focus()
    const began = performance.now()
    input.value = words
    input.dispatchEvent(new Event('input', { bubbles: true }))
    const look = () =>
      document.querySelector(answer)?.textContent.trim()
        ? resolve(performance.now() - began)
        : requestAnimationFrame(look)
    look()
  })
