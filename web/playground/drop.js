/** Accepts files that are dropped onto the page; the sketch can load them by their names. */

/** @param take called with each file */
export function takeFiles(take) {
  // The number of elements that the dragged files have entered and not left: the events also occur for elements of the page.
  let depth = 0
  const drag = (change) => (event) => {
    // The editor handles dragged text.
    if (!event.dataTransfer?.types.includes('Files')) return
    event.preventDefault()
    depth = change === 0 ? 0 : depth + change
    document.body.classList.toggle('dragging', depth > 0)
  }
  addEventListener('dragenter', drag(1), true)
  addEventListener('dragleave', drag(-1), true)
  addEventListener('dragover', (event) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault()
  })
  addEventListener(
    'drop',
    (event) => {
      if (!event.dataTransfer?.types.includes('Files')) return
      drag(0)(event)
      // Otherwise the editor would insert the file's text.
      event.stopPropagation()
      for (const file of event.dataTransfer.files) take(file)
    },
    true,
  )
}
