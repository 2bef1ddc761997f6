/** Highlights source code as HTML. */
import hljs from 'highlight.js/lib/core'
import glsl from 'highlight.js/lib/languages/glsl'
import javascript from 'highlight.js/lib/languages/javascript'

hljs.registerLanguage('glsl', glsl)
hljs.registerLanguage('javascript', javascript)

export const highlight = (text, language) => hljs.highlight(text, { language }).value
