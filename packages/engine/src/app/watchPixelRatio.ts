/**
 * Calls a function whenever `devicePixelRatio` changes: the window is moved to another screen, or the page is zoomed.
 * @returns a function that removes the listener
 * @see
 *   https://developer.mozilla.org/en-US/docs/Web/API/Window/devicePixelRatio#monitoring_screen_resolution_or_zoom_level_changes
 */
export function watchPixelRatio(changed: () => void): () => void {
  const end = new AbortController();
  const watch = (): void => {
    const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    const notice = (): void => {
      watch();
      changed();
    };
    query.addEventListener('change', notice, { once: true, signal: end.signal });
  };
  watch();
  return () => end.abort();
}
