// Runs in the playground's frame after the libraries, and lets the page stop and set the sketch's time. p5 keeps drawing, since it
// schedules frames by the browser's clock; three.js receives the time with each frame.
{
  const { clock: start } = window.playground
  const real = performance.now.bind(performance)
  let held = start.time
  let since = real()
  let isPlaying = start.isPlaying

  const now = () => (isPlaying ? held + real() - since : held)
  const clock = {
    now,
    frameTime: (time) => (window.p5 ? time : now()),
    set(time) {
      held = time
      since = real()
    },
    play(value) {
      clock.set(now())
      isPlaying = value
    },
  }
  window.playground.clock = clock
  window.playground.answers.setTime = clock.set
  window.playground.answers.play = clock.play

  if (window.p5) p5.prototype.millis = now
  else performance.now = now
}
