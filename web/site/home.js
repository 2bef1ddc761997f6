/** The first page: starts its warp once the page has loaded, and filters the gallery. */
import { setUpCopyButton } from './copy.js'

const find = (selector) => document.querySelector(selector)

setUpCopyButton(find('.install .copy'), () => find('.install code').textContent)

const tiles = [...document.querySelectorAll('.tiles > li')]
const [words, section] = [find('#words'), find('#section')]

function filter() {
  const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean)
  for (const tile of tiles)
    tile.hidden =
      (section.value && tile.dataset.section !== section.value) ||
      !wanted.every((word) => tile.dataset.words.includes(word))
  const count = tiles.filter(({ hidden }) => !hidden).length
  find('.filter output').textContent = count === tiles.length ? '' : `${count} of ${tiles.length}`
}
find('.filter').addEventListener('input', filter)
find('.filter').addEventListener('submit', (event) => event.preventDefault())
// A browser may restore the fields' values when the visitor returns.
filter()

// Start only when idle: pictures and the visitor's input go first.
const start = async () => (await import('./hero.js')).startHero(find('.hero .picture'))
const startWhenIdle = () =>
  window.requestIdleCallback
    ? requestIdleCallback(start, { timeout: 3000 })
    : setTimeout(start, 200)
if (document.readyState === 'complete') startWhenIdle()
else addEventListener('load', startWhenIdle)
