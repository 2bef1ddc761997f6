/**
 * Some hosts serve x/index.html at the address x, without a slash, so that relative addresses would be resolved against the parent
 * folder. This script, for the head of an index.html, adds the slash before any such address is used.
 */
export const folderAddress = `<script>
      if (!/(?:\\/|\\.html)$/.test(location.pathname))
        history.replaceState(null, '', location.pathname + '/' + location.search + location.hash)
    </script>`

/** Vite plugin: adds the script to pages that are HTML files. */
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
