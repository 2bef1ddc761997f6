/** Makes the search index: one entry per heading of a page, and one per example. */
import { examples } from './example-page.js'
import { toPlainText } from './html.js'
import { pages } from './navigation.js'

function partsOf({ file, html }) {
  const page = pages.find((page) => page.file === file)?.title ?? file
  return html.split(/(?=<h[123] id=)/).flatMap((part) => {
    const [whole, , id, heading] = /<h([123]) id="([^"]*)">([^]*?)<\/h\1>/.exec(part) ?? []
    if (!whole) return []
    const isFirst = part.includes('<h1')
    return {
      url: `docs/${file}.html${isFirst ? '' : `#${id}`}`,
      title: toPlainText(heading),
      page: isFirst ? (pages.find((page) => page.file === file)?.group ?? 'Docs') : page,
      text: toPlainText(part.replace(whole, '')),
    }
  })
}

export const searchIndex = (docs) => [
  ...docs.flatMap(partsOf),
  ...examples.map(({ name, title, figure, text }) => ({
    url: `gallery/${name}/`,
    title,
    page: 'Gallery',
    text: `${figure} ${text}`,
  })),
]
