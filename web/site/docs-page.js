/** Lays out a page of the docs, with links to all pages at the side and to the previous and next one below. */
import { toPlainText } from './html.js'
import { renderPage } from './layout.js'
import { groups, pages } from './navigation.js'

const listEntry = (here) => (page) =>
  `<li><a href="${page.file}.html"${page.file === here ? ' aria-current="page"' : ''}>${page.title}</a></li>`

const listPages = (here) =>
  groups
    .map(
      ({ title, pages }) =>
        `<section><h2>${title}</h2><ul>${pages.map(listEntry(here)).join('')}</ul></section>`,
    )
    .join('')

function linkNeighbours(file) {
  const index = pages.findIndex((page) => page.file === file)
  const [before, after] = [pages[index - 1], index < 0 ? pages[0] : pages[index + 1]]
  const link = (page, rel, word) =>
    page
      ? `<a rel="${rel}" href="${page.file}.html"><small>${word}</small>${page.title}</a>`
      : '<span></span>'
  return `<nav class="beside" aria-label="Previous and next">${link(before, 'prev', 'Previous')}${link(after, 'next', 'Next')}</nav>`
}

/** Returns the beginning of a page's text, which search engines show as its description. */
const descriptionOf = (html) => {
  const [, first = ''] = /<p>([^]*?)<\/p>/.exec(html) ?? []
  return toPlainText(first).slice(0, 160)
}

export function docsPage({ file, url, html }) {
  const title = toPlainText(/<h1[^>]*>([^]*?)<\/h1>/.exec(html)?.[1] ?? file)
  return renderPage(
    {
      url,
      title: `${title} · warpjet`,
      description: descriptionOf(html),
      kind: 'docs',
      here: 'Docs',
    },
    `<div class="columns">
      <details class="contents" open>
        <summary>All pages</summary>
        <nav aria-label="Docs">${listPages(file)}</nav>
      </details>
      <main id="main" tabindex="-1">
        ${html}
        ${linkNeighbours(file)}
      </main>
    </div>`,
  )
}

/** The index page of the docs: the list of all pages. */
export const overview = () => `<h1>Docs</h1>
<p>New here? <a href="${pages[0].file}.html">The first warp</a> takes two minutes. Every piece of code with a “Run” link opens in the playground, where you can change it.</p>
<div class="overview">${groups
  .map(
    ({ title, pages }) =>
      `<section><h2>${title}</h2><ul>${pages.map(listEntry()).join('')}</ul></section>`,
  )
  .join('')}</div>`
