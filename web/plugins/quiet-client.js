/** Vite's client tells the console that it is connected; the gallery's console is to stay empty. */
export const quietClient = () => ({
  name: 'quiet-client',
  apply: 'serve',
  transform: (code, id) =>
    id.includes('/vite/dist/client/client.mjs')
      ? { code: code.replaceAll('console.debug(', '(() => {})('), map: null }
      : undefined,
})
