/** Vite plugin: silences the messages of Vite's client, so that the site's console stays empty. */
export const quietClient = () => ({
  name: 'quiet-client',
  apply: 'serve',
  transform: (code, id) =>
    id.includes('/vite/dist/client/client.mjs')
      ? { code: code.replaceAll('console.debug(', '(() => {})('), map: null }
      : undefined,
})
