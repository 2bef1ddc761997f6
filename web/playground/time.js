/** The bar with the sketch's time: it goes on, stands still, and is set by hand. */
import { make } from '../bench/dom.js'

/** Milliseconds that the bar has at first, and by which it grows. */
const SPAN = 20_000
const UPDATE_EVERY = 100
const seconds = new Intl.NumberFormat('en', { minimumFractionDigits: 1, maximumFractionDigits: 1 })

/** `stage` has the sketch that is shown, and its time. → { start }, what the next sketch begins with. */
export function makeTime(place, stage) {
  // Who wants no motion gets a moment at which most warps show.
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
    stage.tell('play', value)
    // The page knows the time a moment later than the sketch.
    if (!value) stage.tell('setTime', time)
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
