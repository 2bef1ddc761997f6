/** The full page of an example: runs it as large as the window. */
import { makeStage } from '../stage.js'
import { setUpPauseButton } from './pause.js'

const find = (selector) => document.querySelector(selector)
const { name, title } = find('main').dataset
const page = `../../examples/${name}/gallery.html`
setUpPauseButton(
  find('.pause'),
  find('.rate'),
  makeStage(find('.stage'), { page, title }, () => {}),
)
