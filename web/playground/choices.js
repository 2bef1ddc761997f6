/** What one chooses above the editor: an example, what the sketch runs in, and the scripts beside it. */
import { make } from '../bench/dom.js'
import { converted } from './convert.js'
import { exampleSketch, sections, starters } from './examples.js'
import { hosts, isThree, scripts } from './hosts.js'

const first = { text: starters.p5, host: 'p5', chosen: [] }

const options = (entries) =>
  entries.map(([value, textContent]) => make('option', { value, textContent }))

/** `complain` gets what is wrong with an example. → { show, begin(name) } */
export function makeChoices(editor, complain) {
  const [example, host] = ['#example', '#host'].map((id) => document.querySelector(id))
  example.append(
    ...options([['', 'A wave']]),
    ...sections.map(({ title: label, examples }) =>
      make('optgroup', { label }, ...options(examples.map(({ name, title }) => [name, title]))),
    ),
  )
  host.append(...options(Object.entries(hosts).map(([name, { title }]) => [name, title])))

  const boxes = Object.entries(scripts)
    .filter(([, { title }]) => title)
    .map(([name, { title }]) => {
      const box = make('input', { type: 'checkbox', name })
      document.querySelector('.choices fieldset').append(make('label', {}, box, title))
      box.addEventListener('change', () =>
        editor.set({ chosen: boxes.filter(({ checked }) => checked).map(({ name }) => name) }),
      )
      return box
    })

  /** An example of the gallery, or the first sketch. */
  async function begin(name = '') {
    try {
      editor.set(name ? await exampleSketch(name) : first)
      example.value = name
    } catch (error) {
      if (!editor.sketch().text) editor.set(first)
      complain(error)
    }
  }
  example.addEventListener('change', () => begin(example.value))

  host.addEventListener('change', () => {
    const { text, host: before } = editor.sketch()
    const now = host.value
    // A sketch of p5 is none of three.js: it is left where it is, one undo away.
    if (isThree(now)) editor.set({ host: now, text: starters.three })
    else editor.set({ host: now, text: converted(isThree(before) ? starters.p5 : text, now) })
  })

  return {
    begin,
    show() {
      const { host: name, chosen } = editor.sketch()
      host.value = name
      for (const box of boxes) {
        box.checked = chosen.includes(box.name)
        box.disabled = isThree(name)
      }
    },
  }
}
