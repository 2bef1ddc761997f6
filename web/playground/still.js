/** Shows the example's poster and an explanation if the browser has no WebGL. */
import { make } from '../bench/dom.js'

export const hasWebGL = Boolean(document.createElement('canvas').getContext('webgl2'))

/** @param example the name of the chosen example, if any */
export const showStill = (place, example) =>
  place.replaceChildren(
    make('img', {
      className: 'still',
      src: example ? `../posters/${example}.webp` : '../site/hero.webp',
      alt: '',
    }),
    make('p', {
      className: 'empty',
      textContent: example
        ? 'This browser has no WebGL: here is a picture of the example.'
        : 'This browser has no WebGL and cannot draw your sketch: open this page in another one.',
    }),
  )
