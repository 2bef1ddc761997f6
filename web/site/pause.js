/** Sets up the button that pauses a sketch and plays it again. With reduced motion, the sketch starts paused. */

/** @param place shows a message if the browser cannot draw @param stage the result of `makeStage` */
export function setUpPauseButton(button, place, stage) {
  function setPaused(isPaused) {
    button.ariaPressed = String(isPaused)
    button.textContent = isPaused ? 'Play' : 'Pause'
    stage.setPaused(isPaused)
  }
  button.addEventListener('click', () => setPaused(button.ariaPressed !== 'true'))
  // Duplicates playground/still.js, since a shared file would cost another request.
  if (document.createElement('canvas').getContext('webgl2'))
    return setPaused(matchMedia('(prefers-reduced-motion: reduce)').matches)
  button.hidden = true
  place.textContent = 'This browser has no WebGL: here is a picture of it.'
}
