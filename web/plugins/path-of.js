/** Returns a request's path without its leading slash. A path that cannot be decoded, such as `/100%`, is returned unchanged. */
export function pathOf({ url }) {
  const path = url.split('?')[0].slice(1)
  try {
    return decodeURIComponent(path)
  } catch {
    return path
  }
}
