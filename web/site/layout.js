/** The layout shared by all pages of the site: head, bar, search and content. */
import { folderAddress } from './folder-address.js'
import { escapeHtml } from './html.js'
import { entries } from './navigation.js'
import { withPolicy } from './policy.js'

/** @param url a page's address relative to the first page @returns the first page's address relative to that page */
export const rootOf = (url) => '../'.repeat(url.split('/').length - 1) || './'

const link =
  (root, here) =>
  ({ title, href }) =>
    `<a href="${root}${href}"${title === here ? ' aria-current="true"' : ''}>${title}</a>`

/**
 * Returns a whole page as HTML. `here` is the title of its entry in the bar, `kind` its body class, `script` the module of web/site
 * that it runs in addition to site.js, `preload` an image that is visible first.
 */
export function renderPage({ url, title, description, kind, here, script, preload }, content) {
  const root = rootOf(url)
  const scripts = ['site', script].filter(Boolean)
  return withPolicy(`<!doctype html>
<html lang="en" data-root="${root}">
  <head>
    <meta charset="utf-8" />
    ${url.endsWith('index.html') ? folderAddress : ''}
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="dark light" />
    <meta name="description" content="${escapeHtml(description)}" />
    <title>${escapeHtml(title)}</title>
    <link rel="icon" href="data:," />
    <link rel="stylesheet" href="${root}site/site.css" />
    ${preload ? `<link rel="preload" as="image" href="${root}${preload}" fetchpriority="high" />` : ''}
    <script>
      try { document.documentElement.dataset.theme = localStorage.theme ?? '' } catch {}
    </script>
    ${scripts.map((name) => `<script type="module" src="${root}site/${name}.js"></script>`).join('\n    ')}
  </head>
  <body class="${kind}">
    <a class="skip" href="#main">Skip to the page</a>
    <header class="bar">
      <a class="name" href="${root}">warpjet</a>
      <nav aria-label="Site">${entries.map(link(root, here)).join('')}</nav>
      <search>
        <input type="search" id="search" placeholder="Search" aria-label="Search the site" autocomplete="off"
          role="combobox" aria-expanded="false" aria-controls="found" aria-autocomplete="list" />
        <div id="found" role="listbox" aria-label="Found" hidden></div>
      </search>
      <button type="button" class="theme" aria-label="Light or dark"></button>
    </header>
    ${content}
  </body>
</html>
`)
}
