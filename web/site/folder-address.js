/**
 * Some hosts give x/index.html at the address x, without a slash. What such a page names lies in its folder, and would be looked for
 * beside that: the page gives itself the slash, before it names anything. As HTML, for the head of a page that is an index.html.
 */
export const folderAddress = `<script>
      if (!/(?:\\/|\\.html)$/.test(location.pathname))
        history.replaceState(null, '', location.pathname + '/' + location.search + location.hash)
    </script>`

/** Vite plugin: the same for pages that are files of HTML. */
export const folderAddresses = () => ({
  name: 'folder-addresses',
  transformIndexHtml: {
    order: 'pre',
    handler: (html, { path }) =>
      path.endsWith('/index.html')
        ? html.replace('<meta charset="utf-8" />', `$&\n    ${folderAddress}`)
        : html,
  },
})
