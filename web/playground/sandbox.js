/** Makes the page that a sketch runs in: it has a unique opaque origin and a policy that keeps it from the network. */
import bootText from './frame/boot.js?raw'
import { hosts } from './hosts.js'
import { folder } from './site-files.js'

/** Fits the canvas into the frame. */
const fit =
  'canvas.p5Canvas { height: auto !important; max-height: 100vh; max-width: 100vw; width: auto !important }'

/**
 * p5.strands and warpjet's operators need `eval`. Everything else is loaded from blobs made in the frame, unless the user has
 * ticked the box that lets sketches load from other sites.
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

/** Makes a frame for a sketch in the document `owner`. It allows scripts only: no popups, forms, downloads or dialogs. */
export function makeSandbox(owner, host, options) {
  const frame = owner.createElement('iframe')
  frame.sandbox = 'allow-scripts'
  frame.title = 'The running sketch'
  frame.srcdoc = sandboxedPage(host, options)
  return frame
}
