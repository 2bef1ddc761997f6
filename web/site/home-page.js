/** Lays out the first page: a warp that follows the pointer, how to install warpjet, and the gallery. */
import { sections } from '../catalogue.js'
import { escapeHtml } from './html.js'
import { renderPage } from './layout.js'

export const scriptTag =
  '<script src="https://cdn.jsdelivr.net/npm/warpjet@0.1/dist/p5.warpjet.min.js"></script>'

const renderTile = (section) => (example) => {
  const { name, title, figure, text } = example
  const words = `${title} ${figure} ${section.title} ${text}`.toLowerCase()
  return `<li data-section="${escapeHtml(section.title)}" data-words="${escapeHtml(words)}"><a href="gallery/${name}/">
<img src="posters/${name}.webp" width="480" height="360" loading="lazy" decoding="async" alt="" />
<span><b>${escapeHtml(title)}</b> <i>${escapeHtml(figure)}</i></span></a></li>`
}

export const homePage = () =>
  renderPage(
    {
      url: 'index.html',
      title: 'warpjet: warp any mesh, with lighting that stays right',
      description:
        'Write where each point should go. warpjet differentiates the function and compiles it to a vertex shader, and every mesh that it bends is lit as if it had been modelled that way.',
      kind: 'home',
      here: 'Gallery',
      script: 'home',
      preload: 'site/hero.webp',
    },
    `<main id="main" tabindex="-1">
      <section class="hero">
        <div>
          <h1>warpjet</h1>
          <p class="lead">Write where each point should go. warpjet differentiates the function and compiles it to a
            vertex shader, and every mesh that it bends is lit as if it had been modelled that way.</p>
          <p>For p5.js, three.js, Babylon.js and any program on WebGL or WebGPU.</p>
          <div class="install"><code tabindex="0">${escapeHtml(scriptTag)}</code><button type="button" class="copy">Copy</button></div>
          <p class="ways">
            <a class="button" href="docs/tutorial-1-first-warp.html">Your first warp</a>
            <a class="button quiet" href="playground/">Playground</a>
            <code>npm i warpjet</code>
          </p>
        </div>
        <div class="picture">
          <img src="site/hero.webp" width="640" height="640" alt="A ball with flowing ridges, coral where they rise" fetchpriority="high" />
        </div>
      </section>
      <section id="gallery" aria-labelledby="gallery-title">
        <h2 id="gallery-title">Gallery</h2>
        <form class="filter" role="search" aria-label="Filter the gallery">
          <label>Show <input type="search" id="words" placeholder="twist, noise, cloth…" autocomplete="off" /></label>
          <label>of <select id="section"><option value="">everything</option>${sections
            .map(({ title }) => `<option>${escapeHtml(title)}</option>`)
            .join('')}</select></label>
          <output aria-live="polite"></output>
        </form>
        <ul class="tiles">
${sections.flatMap((section) => section.examples.map(renderTile(section))).join('\n')}
        </ul>
      </section>
    </main>
    <footer>
      <p>The method is Dave Pagurek van Mossel’s <i>Vertex Shader Domain Warping with Automatic Differentiation</i> (2024).
      Its cost compared with every other way: <a href="bench/results.html">measured</a>, and
      <a href="bench/">live on your machine</a>. MIT licence.</p>
    </footer>`,
  )
