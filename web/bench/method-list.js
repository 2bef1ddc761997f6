/** Lists the methods, each with its colour and description. */
import { make } from './dom.js'
import { notes } from './method-notes.js'

export function listMethods(list) {
  for (const [name, { color, text }] of Object.entries(notes))
    list.append(
      make(
        'div',
        {},
        make('dt', { textContent: name, style: `--color: ${color}` }),
        make('dd', { textContent: text }),
      ),
    )
}
