/** The page that a sketch runs in: one of an origin that no other page has, with a policy that keeps it from the network. */
import bootText from './frame/boot.js?raw'
import { hosts } from './hosts.js'
import { folder } from './site-files.js'

/** Whole, whatever the window leaves for it. */
const fit =
  'canvas.p5Canvas { height: auto !important; max-height: 100vh; max-width: 100vw; width: auto !important }'

/**
 * `eval` is for p5.strands and warpjet's operators. Everything else comes from blobs that the frame has made, unless somebody has
 * ticked the box that lets sketches load from elsewhere.
 */
function policyOf({ mayLoad }) {
  const elsewhere = mayLoad ? ' https:' : ''
  const data = `blob: data:${elsewhere}`
  return [
    "default-src 'none'",
    `script-src 'unsafe-inline' 'unsafe-eval' blob:${elsewhere}`,
    "style-src 'unsafe-inline'",
    `img-src ${data}`,
    `media-src ${data}`,
    `font-src ${data}`,
    `connect-src ${data}`,
    'worker-src blob:',
    "frame-src 'none'",
    "form-action 'none'",
  ].join('; ')
}

const sandboxedPage = (host, options) => `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta http-equiv="Content-Security-Policy" content="${policyOf(options)}" />
    <meta name="viewport" content="width=device-width" />
    <base href="${folder}" />
    <title>Sketch</title>
    <style>
      ${hosts[host].style}
      ${fit}
    </style>
  </head>
  <body>
    <script data-page="${location.origin}">${bootText}</script>
  </body>
</html>
`

/** A frame for a sketch, for the document `owner`. Scripts alone are allowed: no popups, no forms, no downloads, no dialogs. */
export function makeSandbox(owner, host, options) {
  const frame = owner.createElement('iframe')
  frame.sandbox = 'allow-scripts'
  frame.title = 'The running sketch'
  frame.srcdoc = sandboxedPage(host, options)
  return frame
}
