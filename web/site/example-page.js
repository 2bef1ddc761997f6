/** The page of one example: it runs beside its sketch, with what it takes to run it elsewhere. */
import { readFileSync } from 'node:fs'
import hljs from 'highlight.js'
import { sections } from '../catalogue.js'
import { sliders } from '../sliders.js'
import { escaped } from './html.js'
import { frame } from './layout.js'

export const examples = sections.flatMap(({ title: section, source, examples }) =>
  examples.map((example) => ({ ...example, section, source })),
)

const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')
const { devDependencies, version } = JSON.parse(read('package.json'))

/** The tags of the example's own page, as they are anywhere else. */
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

/** A page to paste somewhere: its script tags, then its sketch. */
function copied(name, sketch) {
  const tags = tagsOf(name)
  const kind = tags.includes('importmap') ? ' type="module"' : ''
  return `${tags}\n<script${kind}>\n${sketch.trimEnd()}\n</script>\n`
}

/** What a sketch loads from its own folder. */
const filesOf = (sketch) => [
  ...new Set([...sketch.matchAll(/'([\w-]+\.(?:obj|woff))'/g)].map(([, file]) => file)),
]

const control = ({ label, from, to, value }, index) =>
  `<label for="slider-${index}">${escaped(label)}</label>
<input type="range" id="slider-${index}" min="${from}" max="${to}" step="any" value="${value}" /><output>${value}</output>`

export function examplePage({ name, url, figure, title, text, section, source }) {
  const sketch = read(`examples/${name}/sketch.js`)
  const index = examples.findIndex((example) => example.name === name)
  const at = (step) => examples[(index + step + examples.length) % examples.length]
  const link = (step, rel, word) =>
    `<a rel="${rel}" href="../${at(step).name}/"><small>${word}</small>${escaped(at(step).title)}</a>`
  return frame(
    {
      url,
      title: `${title} · warpjet`,
      description: text,
      kind: 'example',
      here: 'Gallery',
      script: 'example',
      preload: `posters/${name}.webp`,
    },
    `<main id="main" tabindex="-1" data-name="${name}" data-title="${escaped(title)}">
      <p class="back"><a href="../../#gallery">All examples</a></p>
      <header>
        <p class="figure">${escaped(figure)}</p>
        <h1>${escaped(title)}</h1>
        <p class="text">${escaped(text)}</p>
        <p class="source">${escaped(section)}. ${escaped(source)}.</p>
      </header>
      <div class="pair">
        <div class="show">
          <div class="stage"><img src="../../posters/${name}.webp" width="480" height="360" alt="${escaped(title)}" /></div>
          <div class="under"><output class="rate"></output><button type="button" class="pause" aria-pressed="false">Pause</button></div>
          <div class="sliders">${sliders(name, sketch).map(control).join('\n')}</div>
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
      <script type="application/json" id="sketch">${JSON.stringify({ sketch, page: copied(name, sketch), sliders: sliders(name, sketch) }).replaceAll('<', '\\u003c')}</script>
      <nav class="beside" aria-label="Before and after">${link(-1, 'prev', 'Before')}${link(1, 'next', 'Next')}</nav>
    </main>`,
  )
}
