/** The button that stops a sketch and starts it. Whoever wants less motion says when it begins. */

/** `stage` as of makeStage; `place` gets a sentence where nothing can be drawn. */
export function pauseButton(button, place, stage) {
  function setPaused(isPaused) {
    button.ariaPressed = String(isPaused)
    button.textContent = isPaused ? 'Play' : 'Pause'
    stage.setPaused(isPaused)
  }
  button.addEventListener('click', () => setPaused(button.ariaPressed !== 'true'))
  // Asked here, since a file that pages share is one request more.
  if (document.createElement('canvas').getContext('webgl2'))
    return setPaused(matchMedia('(prefers-reduced-motion: reduce)').matches)
  button.hidden = true
  place.textContent = 'This browser has no WebGL: here is a picture of it.'
}
