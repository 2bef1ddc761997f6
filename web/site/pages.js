/** Generates the pages of the site: Eleventy renders the Markdown of web/docs, and the modules beside this one lay it out. */
import { fileURLToPath } from 'node:url'
import Eleventy from '@11ty/eleventy'
import { docsPage, overview } from './docs-page.js'
import { examplePage, examples } from './example-page.js'
import { fullPage } from './full-page.js'
import { homePage } from './home-page.js'
import { makeMarkdown } from './markdown.js'
import { searchIndex } from './search-index.js'

const docs = fileURLToPath(new URL('../docs', import.meta.url))

function configure(config) {
  config.setLibrary('md', makeMarkdown())
  config.setTemplateFormats(['md'])
  // Braces in the pages are code, not template expressions.
  config.addGlobalData('templateEngineOverride', 'md')
  config.addGlobalData(
    'permalink',
    () =>
      ({ page }) =>
        `docs/${page.fileSlug}.html`,
  )
  return { dir: { input: docs } }
}

async function renderDocs() {
  const eleventy = new Eleventy(docs, undefined, {
    quietMode: true,
    configPath: false,
    config: configure,
  })
  const rendered = await eleventy.toJSON()
  return rendered.map(({ url, content }) => ({
    file: /([\w-]+)\.html$/.exec(url)[1],
    html: content,
  }))
}

/** Returns a Map from path to content. Links are relative, so the pages work in any folder of any server. */
export async function sitePages() {
  const texts = await renderDocs()
  const files = new Map([['index.html', homePage()]])
  const index = { file: 'index', html: overview() }
  for (const { file, html } of [index, ...texts]) {
    const url = `docs/${file}.html`
    files.set(url, docsPage({ file, url, html }))
  }
  for (const example of examples) {
    const folder = `gallery/${example.name}`
    for (const [url, page] of [
      [`${folder}/index.html`, examplePage],
      [`${folder}/full.html`, fullPage],
    ])
      files.set(url, page({ ...example, url }))
  }
  files.set('site/search.json', JSON.stringify(searchIndex(texts)))
  return files
}
