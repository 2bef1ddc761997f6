/** One example: the running sketch beside its source and the shader text that comes of it. */
import { highlight } from './highlighting.js'
import { perform } from './stage.js'

const template = document.querySelector('#card')

export function makeCard({ name, figure, title, text }, sketch) {
  const card = template.content.firstElementChild.cloneNode(true)
  const find = (selector) => card.querySelector(selector)
  card.id = name
  find('.figure').textContent = figure
  find('h3').textContent = title
  find('.text').textContent = text
  find('.play').href = `playground/index.html#example=${name}`
  find('.alone').href = `examples/${name}/index.html`
  for (const file of filesOf(sketch)) find('.show .bar').append(downloadLink(name, file))

  const source = sourceView(card, sketch)
  perform(find('.stage'), { name, title }, ({ frames, rate, code }) => {
    find('output').textContent = rate
      ? `frame ${frames} · ${rate.toFixed(rate < 10 ? 1 : 0)} fps`
      : ''
    if (code) source.setShader(code)
  })
  return card
}

/** What a sketch loads from its own folder. */
const filesOf = (sketch) =>
  new Set([...sketch.matchAll(/'([\w-]+\.(?:obj|woff))'/g)].map(([, file]) => file))

function downloadLink(name, file) {
  const link = document.createElement('a')
  link.href = `examples/${name}/${file}`
  link.download = link.textContent = file
  return link
}

/** The two tabs. The shader text comes later than the card, from the running sketch. */
function sourceView(card, sketch) {
  const code = card.querySelector('code')
  const tabs = [...card.querySelectorAll('button[value]')]
  const texts = { sketch, glsl: '// Made when the sketch starts.' }
  const languages = { sketch: 'javascript', glsl: 'glsl' }
  let shown

  function show(tab) {
    shown = tab
    code.innerHTML = highlight(texts[tab], languages[tab])
    for (const button of tabs) button.ariaPressed = String(button.value === tab)
  }
  for (const button of tabs)
    button.addEventListener('click', () => {
      show(button.value)
      code.parentElement.scrollTo(0, 0)
    })
  show('sketch')

  const copy = card.querySelector('.copy')
  copy.addEventListener('click', async () => {
    if (shown !== 'sketch') show('sketch')
    getSelection().selectAllChildren(code)
    // Only safe origins have a clipboard; elsewhere the text is at least selected.
    await navigator.clipboard?.writeText(sketch)
    if (navigator.clipboard) copy.textContent = 'Copied'
    setTimeout(() => (copy.textContent = 'Copy the sketch'), 1500)
  })

  return {
    setShader(text) {
      if (text === texts.glsl) return
      texts.glsl = text
      if (shown === 'glsl') show('glsl')
    },
  }
}
