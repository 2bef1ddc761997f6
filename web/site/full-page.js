/** Lays out a page with one example as large as the window, below its description and a link back. */
import { escapeHtml } from './html.js'
import { renderPage } from './layout.js'

export const fullPage = ({ name, url, figure, title, text }) =>
  renderPage(
    {
      url,
      title: `${title}, full page · warpjet`,
      description: text,
      kind: 'full',
      here: 'Gallery',
      script: 'full',
      preload: `posters/${name}.webp`,
    },
    `<main id="main" tabindex="-1" data-name="${name}" data-title="${escapeHtml(title)}">
      <header>
        <p class="back"><a href="./">Sketch and sliders</a></p>
        <h1>${escapeHtml(title)} <small class="figure">${escapeHtml(figure)}</small></h1>
        <button type="button" class="pause" aria-pressed="false">Pause</button>
        <p class="text">${escapeHtml(text)}</p>
      </header>
      <div class="stage"><img src="../../posters/${name}.webp" width="480" height="360" alt="${escapeHtml(title)}" /></div>
      <output class="rate"></output>
    </main>`,
  )
