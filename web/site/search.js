/** Search without a server: an index in memory of what search-index.js wrote. */
import MiniSearch from 'minisearch'

const mostFound = 12
/** Words that a question has and no answer needs. */
const idle = new Set(
  'a an and are at by can do does for from how i in is it make my of on or the to use using what where which with'.split(
    ' ',
  ),
)

const processTerm = (term) => {
  const word = term.toLowerCase()
  return idle.has(word) ? null : stem(word)
}

/** So that melting finds melt, and spaces space: what is left is the beginning of each form. */
const stem = (word) => (word.length > 4 ? word.replace(/(?:ing|s)$/, '') : word)

/** An answer is a page of the docs sooner than a part of one, and either sooner than an example. */
const weight = (url) => (url.startsWith('gallery/') ? 0.4 : url.includes('#') ? 1 : 1.5)

/** How the text goes around the first of the words. */
function excerpt(text, terms) {
  const lower = text.toLowerCase()
  const at = Math.min(
    ...terms.map((term) => lower.indexOf(term)).filter((at) => at >= 0),
    text.length,
  )
  const from = at < text.length ? Math.max(0, text.lastIndexOf(' ', Math.max(0, at - 40))) : 0
  return `${from ? '…' : ''}${text.slice(from, from + 130)}…`
}

/** → search(words) → [{ url, title, page, text }], best first. */
export async function makeSearch(root) {
  const response = await fetch(new URL('site/search.json', root))
  const parts = await response.json()
  const index = new MiniSearch({
    idField: 'url',
    fields: ['title', 'page', 'text'],
    storeFields: ['url', 'title', 'page', 'text'],
    // A name of JavaScript is one word, and so are its parts.
    tokenize: (text) => text.split(/[^\p{L}\p{N}_]+/u).filter(Boolean),
    processTerm,
    searchOptions: {
      boost: { title: 6, page: 2 },
      boostDocument: weight,
      prefix: (term) => term.length > 2,
      fuzzy: (term) => (term.length > 5 ? 0.2 : false),
    },
  })
  // In pieces, so that what is typed meanwhile shows at once.
  await index.addAllAsync(parts, { chunkSize: 40 })
  return (words) => {
    const all = index.search(words, { combineWith: 'AND' })
    const some = all.length ? all : index.search(words)
    return some.slice(0, mostFound).map(({ url, title, page, text, terms }) => ({
      url,
      title,
      page,
      text: excerpt(text, terms),
    }))
  }
}
