/** Makes a button copy a text. The clipboard exists only in secure contexts; elsewhere the button asks to copy by hand. */
export function setUpCopyButton(button, textOf) {
  const label = button.textContent
  button.addEventListener('click', async () => {
    const isDone = await navigator.clipboard?.writeText(textOf()).then(
      () => true,
      () => false,
    )
    button.textContent = isDone ? 'Copied' : 'Select and copy by hand'
    setTimeout(() => (button.textContent = label), 1500)
  })
}
