/** A button that copies. Only safe origins have a clipboard; elsewhere it says so. */
export function copyButton(button, textOf) {
  const label = button.textContent
  button.addEventListener('click', async () => {
    const isDone = await navigator.clipboard?.writeText(textOf()).then(
      () => true,
      () => false,
    )
    button.textContent = isDone ? 'Copied' : 'Select it, and copy by hand'
    setTimeout(() => (button.textContent = label), 1500)
  })
}
