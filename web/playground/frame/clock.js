// In the playground's frame, after the libraries: the sketch's time can be stopped and set. p5 itself goes on drawing, since
// it looks at the browser's clock to know when; three.js gets the time with each frame.
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
