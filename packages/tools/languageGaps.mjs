/**
 * English texts that a language lacks. An entry of a registry that has no text of its own in the language is shown in
 * English, whole; one that is begun must be complete, as must be what stands outside of entries.
 *
 * @param {Iterable<string>} texts - that stand outside of entries
 * @param {Readonly<Record<string, readonly string[]>>} entries - texts of each entry, by a name such as 'technique forward'
 * @param {Readonly<Record<string, string>>} language - by their English texts
 * @returns {string[]}
 */
export function languageGaps(texts, entries, language) {
  /** @type {Map<string, Set<string>>} entries that have each text, '' for none */
  const owners = new Map();
  const add = (/** @type {string} */ owner, /** @type {string} */ text) => {
    const all = owners.get(text);
    if (all) all.add(owner);
    else owners.set(text, new Set([owner]));
  };
  for (const text of texts) add('', text);
  for (const [name, own] of Object.entries(entries)) for (const text of own) add(name, text);
  const isThere = (/** @type {string} */ text) => Object.hasOwn(language, text);
  const isEnglish = (/** @type {string} */ name) => {
    const own = (entries[name] ?? []).filter((text) => owners.get(text)?.size === 1);
    return own.length > 0 && !own.some(isThere);
  };
  const english = new Set(Object.keys(entries).filter(isEnglish));
  const isFree = (/** @type {Set<string>} */ names) => [...names].every((name) => english.has(name));
  return [...owners].filter(([text, names]) => !isThere(text) && !isFree(names)).map(([text]) => text);
}
