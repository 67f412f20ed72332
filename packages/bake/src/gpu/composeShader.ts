/**
 * Replaces lines `#include "name"` by chunks; further includes of the same chunk are dropped.
 * @throws Error for a name that is not in `chunks`
 */
export function composeShader(source: string, chunks: Readonly<Record<string, string>>): string {
  const known = new Set<string>();
  const compose = (text: string): string =>
    text.replace(/^[ \t]*#include "(\w+)"[ \t]*$/gm, (_, name: string) => {
      if (!(name in chunks)) throw new Error(`No shader text is called ${name}.`);
      if (known.has(name)) return '';
      known.add(name);
      return compose(chunks[name]);
    });
  return compose(source);
}
