/** The time bar, which plays, pauses and sets the sketch's time. */
import { make } from '../bench/dom.js'

/** The initial range of the bar in milliseconds. Each time the sketch reaches the end of the range, the range grows by as much. */
const SPAN = 20_000
const UPDATE_EVERY = 100
const seconds = new Intl.NumberFormat('en', { minimumFractionDigits: 1, maximumFractionDigits: 1 })

/** @param stage runs the visible sketch and reports its time @returns { start }, which returns the next sketch's initial clock */
export function makeTime(place, stage) {
  // With reduced motion, the time is paused at a moment at which most warps are visible.
  let isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches
  let time = isPlaying ? 0 : 1000

  const button = make('button', { type: 'button', className: 'button play' })
  const bar = make('input', { type: 'range', min: 0, max: SPAN, step: 1, ariaLabel: 'Time' })
  const output = make('output')
  place.append(button, bar, output)

  function show() {
    if (isPlaying && !stage.isEmpty()) time = stage.state().millis
    if (time > bar.max) bar.max = SPAN * Math.ceil(time / SPAN)
    bar.value = time
    output.textContent = `${seconds.format(time / 1000)} s`
    bar.ariaValueText = output.textContent
  }
  function play(value) {
    isPlaying = value
    stage.send('play', value)
    // The page's time lags slightly behind the sketch's, so set the sketch to the displayed time.
    if (!value) stage.send('setTime', time)
    button.textContent = value ? 'Stop' : 'Play'
    show()
  }
  button.addEventListener('click', () => play(!isPlaying))
  bar.addEventListener('input', () => {
    time = Number(bar.value)
    play(false)
  })
  setInterval(() => isPlaying && show(), UPDATE_EVERY)
  play(isPlaying)

  return { start: () => ({ time, isPlaying }) }
}
