/** Runs on every page: the light or dark theme, the search, and the service worker for offline use. */
const { documentElement } = document
const root = new URL(documentElement.dataset.root, location.href)

/* Theme: the system's, until the visitor chooses one. */

const isDark = () =>
  documentElement.dataset.theme
    ? documentElement.dataset.theme === 'dark'
    : matchMedia('(prefers-color-scheme: dark)').matches

document.querySelector('.theme').addEventListener('click', () => {
  const theme = isDark() ? 'light' : 'dark'
  documentElement.dataset.theme = theme
  try {
    localStorage.theme = theme
  } catch {
    // Without storage, the choice lasts until the next page.
  }
})

/* The list of pages is closed at first in a narrow window; in a wide one, it scrolls to the current page. */

const contents = document.querySelector('.contents')
const here = contents?.querySelector('[aria-current]')
if (contents && matchMedia('(max-width: 59.99rem)').matches) contents.open = false
else if (here) contents.scrollTop = here.offsetTop - contents.clientHeight / 2

/* Search: the index is fetched when the search field gets the focus. */

const field = document.querySelector('#search')
const found = document.querySelector('#found')
let search

const loadSearch = () =>
  (search ??= import('./search.js').then(({ makeSearch }) => makeSearch(root)))

const chosenEntry = () => found.querySelector('[aria-selected="true"]')

function close() {
  found.hidden = true
  field.ariaExpanded = 'false'
  field.removeAttribute('aria-activedescendant')
}

function choose(entry) {
  if (chosenEntry()) chosenEntry().ariaSelected = 'false'
  if (!entry) return
  entry.ariaSelected = 'true'
  entry.scrollIntoView({ block: 'nearest' })
  field.setAttribute('aria-activedescendant', entry.id)
}

async function showResults() {
  const words = field.value.trim()
  if (!words) return close()
  const searchWords = await loadSearch()
  if (field.value.trim() !== words) return
  const entries = searchWords(words)
  found.replaceChildren(
    ...(entries.length ? entries : [{ title: 'Nothing found', page: 'Try another word' }]).map(
      ({ url, title, page, text }, index) => {
        const entry = document.createElement(url ? 'a' : 'p')
        if (url) entry.href = new URL(url, root)
        Object.assign(entry, {
          id: `found-${index}`,
          role: 'option',
          ariaSelected: 'false',
          tabIndex: -1,
        })
        for (const [tag, words] of [
          ['b', title],
          ['small', page],
          ['span', text],
        ]) {
          if (!words) continue
          entry.append(Object.assign(document.createElement(tag), { textContent: words }), ' ')
        }
        return entry
      },
    ),
  )
  found.hidden = false
  field.ariaExpanded = 'true'
  choose(found.querySelector('a'))
}

field.addEventListener('focus', loadSearch, { once: true })
field.addEventListener('input', showResults)
field.addEventListener('keydown', (event) => {
  const step = { ArrowDown: 'nextElementSibling', ArrowUp: 'previousElementSibling' }[event.key]
  if (step && chosenEntry()?.[step]) {
    choose(chosenEntry()[step])
    event.preventDefault()
  } else if (event.key === 'Enter' && chosenEntry()) chosenEntry().click()
  else if (event.key === 'Escape') close()
})
found.addEventListener('click', close)
addEventListener('click', ({ target }) => target.closest('search') || close())
addEventListener('keydown', (event) => {
  const isTyping = event.target.closest?.('input, textarea, select, [contenteditable]')
  if (event.key !== '/' || isTyping) return
  event.preventDefault()
  field.focus()
})

/* Offline use. */

addEventListener('load', async () => (await import('../offline.js')).keepForOffline(root))

/* Sliders between two pictures. */

for (const slider of document.querySelectorAll('.compare input')) {
  const show = () => slider.parentElement.style.setProperty('--share', `${slider.value}%`)
  slider.addEventListener('input', show)
  show()
}
