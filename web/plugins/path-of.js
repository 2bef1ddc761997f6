/** The path that a request is for, without the slash before it. One that cannot be decoded, such as `/100%`, stays as it is. */
export function pathOf({ url }) {
  const path = url.split('?')[0].slice(1)
  try {
    return decodeURIComponent(path)
  } catch {
    return path
  }
}
