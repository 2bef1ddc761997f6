/** The gallery's page: the catalogue as cards, and a line of links to them. */
import './style.css'
import { makeCard } from './card.js'
import { sections } from './catalogue.js'

const sketches = import.meta.glob('../examples/*/sketch.js', {
  query: '?raw',
  import: 'default',
  eager: true,
})

const main = document.querySelector('main')
const nav = document.querySelector('nav')

for (const { title, source, examples, isCompact } of sections) {
  const section = document.createElement('section')
  if (isCompact) section.className = 'compact'
  const heading = document.createElement('h2')
  const reference = document.createElement('p')
  heading.textContent = title
  reference.textContent = source
  section.append(heading, reference)
  for (const example of examples) {
    section.append(makeCard(example, sketches[`../examples/${example.name}/sketch.js`]))
    const link = document.createElement('a')
    link.href = `#${example.name}`
    link.textContent = example.title
    nav.append(link)
  }
  main.append(section)
}
