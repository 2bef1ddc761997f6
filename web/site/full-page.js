/** An example by itself, as large as the window, under what it is and the way back. */
import { escaped } from './html.js'
import { frame } from './layout.js'

export const fullPage = ({ name, url, figure, title, text }) =>
  frame(
    {
      url,
      title: `${title}, full page · warpjet`,
      description: text,
      kind: 'full',
      here: 'Gallery',
      script: 'full',
      preload: `posters/${name}.webp`,
    },
    `<main id="main" tabindex="-1" data-name="${name}" data-title="${escaped(title)}">
      <header>
        <p class="back"><a href="./">Sketch and sliders</a></p>
        <h1>${escaped(title)} <small class="figure">${escaped(figure)}</small></h1>
        <button type="button" class="pause" aria-pressed="false">Pause</button>
        <p class="text">${escaped(text)}</p>
      </header>
      <div class="stage"><img src="../../posters/${name}.webp" width="480" height="360" alt="${escaped(title)}" /></div>
      <output class="rate"></output>
    </main>`,
  )
