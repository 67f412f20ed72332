/** Puts a query into the address of the page; the rest of the address stays. @param search - with its '?' */
export function writeAddress(search: string): void {
  // whole: a path such as //x/ alone would name another host
  const address = new URL(location.href);
  address.search = search;
  try {
    history.replaceState(history.state, '', address);
  } catch {
    // a browser may refuse a hundred changes in half a minute; the next one writes the whole state
  }
}
