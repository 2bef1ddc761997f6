/** Searches without a server, with an index in memory of the entries from search-index.js. */
import MiniSearch from 'minisearch'

const maxResults = 12
/** Stop words, which are ignored in queries and pages. */
const stopWords = new Set(
  'a an and are at by can do does for from how i in is it make my of on or the to use using what where which with'.split(
    ' ',
  ),
)

const processTerm = (term) => {
  const word = term.toLowerCase()
  return stopWords.has(word) ? null : stem(word)
}

/** Strips suffixes, so that "melting" finds "melt" and "spaces" finds "space". What remains is a prefix of every form of the word. */
const stem = (word) => (word.length > 4 ? word.replace(/(?:ing|s)$/, '') : word)

/** Ranks pages of the docs above their sections, and both above examples. */
const weight = (url) => (url.startsWith('gallery/') ? 0.4 : url.includes('#') ? 1 : 1.5)

/** Returns the text around the first found word. */
function excerpt(text, terms) {
  const lower = text.toLowerCase()
  const at = Math.min(
    ...terms.map((term) => lower.indexOf(term)).filter((at) => at >= 0),
    text.length,
  )
  const from = at < text.length ? Math.max(0, text.lastIndexOf(' ', Math.max(0, at - 40))) : 0
  return `${from ? '…' : ''}${text.slice(from, from + 130)}…`
}

/** Loads the index and returns search(words), which returns [{ url, title, page, text }], best first. */
export async function makeSearch(root) {
  const response = await fetch(new URL('site/search.json', root))
  const parts = await response.json()
  const index = new MiniSearch({
    idField: 'url',
    fields: ['title', 'page', 'text'],
    storeFields: ['url', 'title', 'page', 'text'],
    // Split at everything but letters, digits and underscores, so that the parts of `warpjet.bend` are words.
    tokenize: (text) => text.split(/[^\p{L}\p{N}_]+/u).filter(Boolean),
    processTerm,
    searchOptions: {
      boost: { title: 6, page: 2 },
      boostDocument: weight,
      prefix: (term) => term.length > 2,
      fuzzy: (term) => (term.length > 5 ? 0.2 : false),
    },
  })
  // Index in chunks, so that the page stays responsive to typing.
  await index.addAllAsync(parts, { chunkSize: 40 })
  return (words) => {
    const withAllWords = index.search(words, { combineWith: 'AND' })
    const results = withAllWords.length ? withAllWords : index.search(words)
    return results.slice(0, maxResults).map(({ url, title, page, text, terms }) => ({
      url,
      title,
      page,
      text: excerpt(text, terms),
    }))
  }
}
