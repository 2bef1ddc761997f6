/** The choices above the editor: an example, the host that runs the sketch, and additional scripts. */
import { make } from '../bench/dom.js'
import { convert } from './convert.js'
import { exampleSketch, sections, starters } from './examples.js'
import { hosts, isThree, scripts } from './hosts.js'
import { builtIn, completeSketch, starter } from './offset.js'

const firstSketch = { text: starters.p5, host: 'p5', chosen: [] }
const isOffset = (host) => host === 'offset'

const makeOptions = (entries) =>
  entries.map(([value, textContent]) => make('option', { value, textContent }))

/** @param onError called with an error if an example cannot be loaded @returns { show, begin(name), addModel(name) } */
export function makeChoices(editor, onError) {
  const [example, host, model] = ['#example', '#host', '#model'].map((id) =>
    document.querySelector(id),
  )
  example.append(
    ...makeOptions([['', 'A wave']]),
    ...sections.map(({ title: label, examples }) =>
      make('optgroup', { label }, ...makeOptions(examples.map(({ name, title }) => [name, title]))),
    ),
  )
  host.append(...makeOptions(Object.entries(hosts).map(([name, { title }]) => [name, title])))

  function listModels(names) {
    const missing = names.filter((name) => ![...model.options].some(({ value }) => value === name))
    model.append(...makeOptions(missing.map((name) => [name, name.replace(/\.obj$/, '')])))
  }
  listModels(builtIn)
  model.addEventListener('change', () => editor.set({ model: model.value }))

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
  const note = make('span', {
    className: 'note',
    textContent: "Import 'warpjet/deformers' or 'warpjet/glsl'; operators are not available",
  })
  document.querySelector('.choices fieldset').append(note)

  /** Opens an example of the gallery; default: the first sketch. */
  async function begin(name = '') {
    try {
      editor.set(name ? await exampleSketch(name) : firstSketch)
      example.value = name
    } catch (error) {
      if (!editor.sketch().text) editor.set(firstSketch)
      onError(error)
    }
  }
  example.addEventListener('change', () => begin(example.value))

  host.addEventListener('change', () => {
    const { text, host: before } = editor.sketch()
    const now = host.value
    // A p5 sketch cannot be converted to three.js, so a starter replaces it; undo brings it back.
    if (isThree(now)) editor.set({ host: now, text: starters.three })
    else if (isOffset(now)) editor.set({ host: now, text: starter })
    else if (isOffset(before))
      editor.set({ host: now, text: convert(completeSketch(editor.sketch()).text, now) })
    else editor.set({ host: now, text: convert(isThree(before) ? starters.p5 : text, now) })
  })

  return {
    begin,
    /** Adds a dropped file, and applies an offset function to it. */
    addModel(name) {
      listModels([name])
      if (isOffset(editor.sketch().host)) editor.set({ model: name })
    },
    show() {
      const { host: name, chosen, model: chosenModel } = editor.sketch()
      host.value = name
      listModels([chosenModel])
      model.value = chosenModel
      model.closest('label').hidden = !isOffset(name)
      note.hidden = !isThree(name)
      for (const box of boxes) {
        box.checked = chosen.includes(box.name)
        box.closest('label').hidden = isThree(name)
      }
    },
  }
}
