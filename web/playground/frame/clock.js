// Runs in the playground's frame after the libraries, and lets the page stop and set the sketch's time. p5 keeps drawing, since it
// schedules frames by the browser's clock; three.js receives the time with each frame.
{
  const { clock: start } = window.playground
  const realNow = performance.now.bind(performance)
  // The sketch's time when it was last set, and the real time then.
  let timeAtChange = start.time
  let changedAt = realNow()
  let isPlaying = start.isPlaying

  const now = () => (isPlaying ? timeAtChange + realNow() - changedAt : timeAtChange)
  const clock = {
    now,
    frameTime: (time) => (window.p5 ? time : now()),
    set(time) {
      timeAtChange = time
      changedAt = realNow()
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
