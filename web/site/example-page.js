/** Lays out the page of one example: the running sketch beside its source, with a button that copies a complete page. */
import { readFileSync } from 'node:fs'
import hljs from 'highlight.js'
import { sections } from '../catalogue.js'
import { findSliders } from '../sliders.js'
import { escapeHtml } from './html.js'
import { renderPage } from './layout.js'

export const examples = sections.flatMap(({ title: section, source, examples }) =>
  examples.map((example) => ({ ...example, section, source })),
)

const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')
const { devDependencies, version } = JSON.parse(read('package.json'))

/** Returns the script tags of the example's own page with CDN addresses. */
function tagsOf(name) {
  const page = read(`examples/${name}/index.html`)
  const scripts = /[^]*?(<script[^]*<\/script>)\s*<\/head>/.exec(page)[1].replaceAll(/^ {4}/gm, '')
  const cdn = 'https://cdn.jsdelivr.net/npm/'
  return scripts
    .replaceAll('../../dist/', `${cdn}warpjet@${version}/dist/`)
    .replaceAll(
      /\.\.\/\.\.\/node_modules\/([\w-]+)\//g,
      (_, name) => `${cdn}${name}@${devDependencies[name]}/`,
    )
}

/** Returns the HTML to copy: the script tags, then the sketch. */
function htmlToCopy(name, sketch) {
  const tags = tagsOf(name)
  const kind = tags.includes('importmap') ? ' type="module"' : ''
  return `${tags}\n<script${kind}>\n${sketch.trimEnd()}\n</script>\n`
}

/** Returns the files that a sketch loads from its own folder. */
const filesOf = (sketch) => [
  ...new Set([...sketch.matchAll(/'([\w-]+\.(?:obj|woff))'/g)].map(([, file]) => file)),
]

const renderControl = ({ label, from, to, value }, index) =>
  `<label for="slider-${index}">${escapeHtml(label)}</label>
<input type="range" id="slider-${index}" min="${from}" max="${to}" step="any" value="${value}" /><output>${value}</output>`

export function examplePage({ name, url, figure, title, text, section, source }) {
  const sketch = read(`examples/${name}/sketch.js`)
  const index = examples.findIndex((example) => example.name === name)
  const neighbour = (step) => examples[(index + step + examples.length) % examples.length]
  const link = (step, rel, word) =>
    `<a rel="${rel}" href="../${neighbour(step).name}/"><small>${word}</small>${escapeHtml(neighbour(step).title)}</a>`
  return renderPage(
    {
      url,
      title: `${title} · warpjet`,
      description: text,
      kind: 'example',
      here: 'Gallery',
      script: 'example',
      preload: `posters/${name}.webp`,
    },
    `<main id="main" tabindex="-1" data-name="${name}" data-title="${escapeHtml(title)}">
      <p class="back"><a href="../../#gallery">All examples</a></p>
      <header>
        <p class="figure">${escapeHtml(figure)}</p>
        <h1>${escapeHtml(title)}</h1>
        <p class="text">${escapeHtml(text)}</p>
        <p class="source">${escapeHtml(section)}. ${escapeHtml(source)}.</p>
      </header>
      <div class="pair">
        <div class="show">
          <div class="stage"><img src="../../posters/${name}.webp" width="480" height="360" alt="${escapeHtml(title)}" /></div>
          <div class="under"><output class="rate"></output><button type="button" class="pause" aria-pressed="false">Pause</button></div>
          <div class="sliders">${findSliders(name, sketch).map(renderControl).join('\n')}</div>
          <p class="ways">
            <a class="button" href="../../playground/#example=${name}">Open in the playground</a>
            <a class="button quiet" href="full.html">Full page</a>
            ${filesOf(sketch)
              .map(
                (file) =>
                  `<a class="button quiet" href="../../examples/${name}/${file}" download>${file}</a>`,
              )
              .join(' ')}
          </p>
        </div>
        <div class="block">
          <div class="tabs">
            <button type="button" value="sketch" aria-pressed="true">sketch.js</button>
            <button type="button" value="glsl" aria-pressed="false">GLSL</button>
            <button type="button" class="copy">Copy with its script tags</button>
          </div>
          <pre tabindex="0" aria-label="Sketch"><code>${hljs.highlight(sketch, { language: 'javascript' }).value}</code></pre>
        </div>
      </div>
      <script type="application/json" id="sketch">${JSON.stringify({ sketch, page: htmlToCopy(name, sketch), sliders: findSliders(name, sketch) }).replaceAll('<', '\\u003c')}</script>
      <nav class="beside" aria-label="Previous and next">${link(-1, 'prev', 'Previous')}${link(1, 'next', 'Next')}</nav>
    </main>`,
  )
}
