// The page of company.browser.test.js, which runs a row given its topic and name.
import { run } from './lib.js'
import { rows as materials } from './materials.js'
import { rows as objects } from './objects.js'
import { rows as passes } from './passes.js'
import { rows as shaders } from './shaders.js'
import { rows as shadows } from './shadows.js'

const topics = { materials, shaders, objects, shadows, passes }

window.company = {
  names: Object.fromEntries(
    Object.entries(topics).map(([topic, rows]) => [topic, Object.keys(rows)]),
  ),
  run: (topic, name) => run(topics[topic][name]),
}
document.title = 'ready'
