/** A button that opens a list of buttons; Escape and a press elsewhere close it. */
import { make } from '../bench/dom.js'

/** `items` are works by title. `failed` gets what they throw, `done` a word to show. */
export function makeMenu(place, title, items, { done, failed }) {
  const list = make('div', { className: 'list' })
  const menu = make(
    'details',
    { className: 'menu' },
    make('summary', { className: 'button', textContent: title }),
    list,
  )
  for (const [text, work] of Object.entries(items)) {
    const button = make('button', { type: 'button', textContent: text })
    button.addEventListener('click', async () => {
      menu.open = false
      try {
        done((await work()) ?? '')
      } catch (error) {
        failed(error)
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
  // A press into the sketch leaves this page.
  addEventListener('blur', () => (menu.open = false))
  place.append(menu)
}
