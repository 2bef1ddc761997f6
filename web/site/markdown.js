/** Renders the Markdown of the docs as HTML: headings with ids, highlighted code, and a “Run” link at code that runs. */
import hljs from 'highlight.js'
import markdownIt from 'markdown-it'
import { escapeHtml } from './html.js'
import { plotOf } from './plot.js'
import { linkTo, runnable } from './runnable.js'
import { markTables } from './tables.js'

export const slug = (text) =>
  text
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N}\s_-]/gu, '')
    .trim()
    .replaceAll(/\s/g, '-')

const languages = {
  svelte: 'xml',
  vue: 'xml',
  html: 'xml',
  jsx: 'javascript',
  js: 'javascript',
  sh: 'bash',
}

function highlightCode(text, language) {
  const grammar = hljs.getLanguage(languages[language] ?? language)
  return grammar
    ? hljs.highlight(text, { language: grammar.name.toLowerCase().split(',')[0] }).value
    : escapeHtml(text)
}

/** Returns the directive in the comments right before a block. It says how to run a block that does not run by itself. */
const findDirective = (tokens, index) =>
  [tokens[index - 1], tokens[index - 2]]
    .map(
      (token) =>
        /<!-- run\b([^]*?)-->/.exec(token?.type === 'html_block' ? token.content : '')?.[1],
    )
    .find(Boolean)

/** Finds the code blocks. Returns [{ text, language, sketch, line }], where `sketch` is undefined for those that do not run. */
export function blocksOf(markdown) {
  const tokens = markdownIt({ html: true }).parse(markdown, {})
  return tokens.flatMap((token, index) => {
    if (token.type !== 'fence') return []
    const { content: text, info: language, map } = token
    return [
      {
        text,
        language,
        line: map[0] + 1,
        sketch: runnable(text, language, findDirective(tokens, index)),
      },
    ]
  })
}

export function makeMarkdown() {
  const markdown = markdownIt({ html: true })
  markTables(markdown)
  const { rules } = markdown.renderer

  rules.heading_open = (tokens, index, options, env, self) => {
    const text = tokens[index + 1].children.map(({ content }) => content).join('')
    tokens[index].attrSet('id', slug(text))
    return self.renderToken(tokens, index, options)
  }

  rules.fence = (tokens, index) => {
    const { content, info } = tokens[index]
    const sketch = runnable(content, info, findDirective(tokens, index))
    const run = sketch ? `<a class="run" href="../playground/${linkTo(sketch)}">Run</a>` : ''
    return `<div class="block">${run}<pre tabindex="0"><code>${highlightCode(content, info)}</code></pre></div>\n`
  }

  rules.html_block = (tokens, index) => {
    const { content } = tokens[index]
    const [, call, from, to] = /^<!-- plot (.*) from (\S+) to (\S+) -->/.exec(content) ?? []
    if (call) return plotOf(call, Number(from), Number(to))
    return content.startsWith('<!--') ? '' : content
  }

  const link =
    rules.link_open ??
    ((tokens, index, options, env, self) => self.renderToken(tokens, index, options))
  rules.link_open = (tokens, index, ...rest) => {
    const href = tokens[index].attrGet('href')
    // The sources link to .md files, for readers of the repository or the package.
    tokens[index].attrSet('href', href.replace(/^([\w-]+)\.md(?=#|$)/, '$1.html'))
    return link(tokens, index, ...rest)
  }

  // Code such as `examples/bunny` becomes a link to the example's page.
  rules.code_inline = (tokens, index) => {
    const text = tokens[index].content
    const [, name] = /^examples\/([\w-]+)$/.exec(text) ?? []
    const code = `<code>${escapeHtml(text)}</code>`
    return name ? `<a href="../gallery/${name}/">${code}</a>` : code
  }

  const image = rules.image
  rules.image = (tokens, index, ...rest) => {
    tokens[index].attrSet('loading', 'lazy')
    return image(tokens, index, ...rest)
  }
  return markdown
}
