/** A button that opens a list of buttons; Escape and a click elsewhere close it. */
import { make } from '../bench/dom.js'

/** @param items maps title → action @param onDone called with an action's message @param onError called with its error */
export function makeMenu(place, title, items, { onDone, onError }) {
  const list = make('div', { className: 'list' })
  const menu = make(
    'details',
    { className: 'menu' },
    make('summary', { className: 'button', textContent: title }),
    list,
  )
  for (const [text, action] of Object.entries(items)) {
    const button = make('button', { type: 'button', textContent: text })
    button.addEventListener('click', async () => {
      menu.open = false
      try {
        onDone((await action()) ?? '')
      } catch (error) {
        onError(error)
      }
    })
    list.append(button)
  }
  menu.addEventListener('keydown', ({ key }) => {
    if (key !== 'Escape') return
    menu.open = false
    menu.querySelector('summary').focus()
  })
  addEventListener('pointerdown', ({ target }) => menu.contains(target) || (menu.open = false))
  // A click in the sketch's frame takes the focus away from this page.
  addEventListener('blur', () => (menu.open = false))
  place.append(menu)
}
