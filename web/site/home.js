/** The first page: its warp once the page stands, and the gallery's filter. */
import { copyButton } from './copy.js'

const find = (selector) => document.querySelector(selector)

copyButton(find('.install .copy'), () => find('.install code').textContent)

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
// A browser that comes back remembers what stood there.
filter()

// Pictures first, and whoever has begun to use the page.
const start = async () => (await import('./hero.js')).startHero(find('.hero .picture'))
const soon = () =>
  window.requestIdleCallback
    ? requestIdleCallback(start, { timeout: 3000 })
    : setTimeout(start, 200)
if (document.readyState === 'complete') soon()
else addEventListener('load', soon)
